// SPDX-License-Identifier: MIT
#include "folder.h"
#include "report_gnuplot.h"
#include "study_plot.h"
#include "suite.h"
#include <math.h>
#include <string.h>

// A case whose methods all ended at the same point, with so large an error.
static brink_case crowded(double error, enum brink_outcome outcome)
{
    brink_case c = {.path = "a.yaml", .name = "a", .events = 5000};
    for (int k = 0; k < BRINK_METHODS; k++)
        c.trial[k] =
            (brink_trial){.method = (enum brink_method)k,
                          .outcome = outcome,
                          .events = outcome == BRINK_OUTCOME_NONE ? 0 : 900,
                          .energy_error = error};
    return c;
}

// The script drawn, with data as the workers write them.
static char *draw(const brink_case *c, const char *data)
{
    const char *folder = new_folder();
    char name[100], trouble[600] = "";
    for (int k = 0; k < BRINK_METHODS; k++) {
        brink_findings_file(c, (enum brink_method)k, ".dat", name, sizeof name);
        write_file(folder, name, data);
    }
    char *script = brink_energy_plot(c);
    ck_assert_ptr_nonnull(script);
    char *svg =
        brink_gnuplot_draw(folder, "plot", script, 1, trouble, sizeof trouble);
    ck_assert_msg(svg != NULL, "%s\n%s", trouble, script);
    free(script);
    return svg;
}

static int count(const char *text, const char *what)
{
    int n = 0;
    for (; (text = strstr(text, what)) != NULL; text++)
        n++;
    return n;
}

START_TEST(every_curve_is_labelled_with_its_name)
{
    const brink_case c = crowded(1e-3, BRINK_OUTCOME_DONE);
    char *svg =
        draw(&c, "# head\n1\t1\t0\t1\n10\t2\t1e-16\t1\n900\t3\t1e-3\t1\n");
    for (int k = 0; k < BRINK_METHODS; k++)
        ck_assert_ptr_nonnull(
            strstr(svg, brink_method_rule((enum brink_method)k)->name));
    free(svg);
}
END_TEST

START_TEST(what_was_stopped_says_where)
{
    const brink_case c = crowded(1e-3, BRINK_OUTCOME_STANDS_STILL);
    char *svg = draw(&c, "# head\n1\t1\t0\t1\n900\t3\t1e-3\t1\n");
    ck_assert_int_eq(count(svg, "stood still after 900 events"), BRINK_METHODS);
    free(svg);
}
END_TEST

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// Where the labels stand, in decades from the lowest up; and where the plot ends
// below.  Read from the script.
static double find_labels(const brink_case *c, double at[BRINK_METHODS])
{
    char *script = brink_energy_plot(c);
    const double bottom = strtod(strstr(script, "set yrange [10**(") + 17, NULL);
    int found = 0;
    for (const char *line = script; line != NULL; line = strchr(line, '\n')) {
        line += *line == '\n';
        const char *where = strstr(line, "10**(");
        if (strncmp(line, "set label", 9) != 0 ||
            strstr(line, "''") == strchr(line, '\''))
            continue;
        ck_assert_int_lt(found, BRINK_METHODS);
        at[found++] = strtod(where + 5, NULL);
    }
    ck_assert_int_eq(found, BRINK_METHODS);
    qsort(at, BRINK_METHODS, sizeof *at, by_size);
    free(script);
    return bottom;
}

START_TEST(labels_lie_in_the_plot_and_not_on_one_another)
{
    static const double errors[] = {0, 1e-16, 1e-3, 0.9, 12};
    for (int k = 0; k < 10; k++) {
        const brink_case c =
            crowded(errors[k / 2],
                    k % 2 ? BRINK_OUTCOME_DONE : BRINK_OUTCOME_STANDS_STILL);
        double at[BRINK_METHODS];
        ck_assert_double_lt(find_labels(&c, at), at[0]);
        for (int m = 1; m < BRINK_METHODS; m++)
            // 14 px of text in a plot of some 420 px for 21 decades: 0.7 of one.
            ck_assert_double_ge(at[m] - at[m - 1], 0.7);
        ck_assert_double_le(at[BRINK_METHODS - 1], 1);
    }
}
END_TEST

START_TEST(trials_that_crashed_before_their_first_sample_are_drawn)
{
    const brink_case c = crowded(0, BRINK_OUTCOME_NONE);
    char *svg = draw(&c, "# head\n");
    ck_assert_int_eq(count(svg, "crashed"), BRINK_METHODS);
    free(svg);
}
END_TEST

int main(void)
{
    return RUN_SUITE("energy_plot", 120, every_curve_is_labelled_with_its_name,
                     what_was_stopped_says_where,
                     labels_lie_in_the_plot_and_not_on_one_another,
                     trials_that_crashed_before_their_first_sample_are_drawn);
}
