// SPDX-License-Identifier: MIT
#include "folder.h"
#include "report_gnuplot.h"
#include "suite.h"
#include <string.h>

static char trouble[600];

static char *draw(const char *folder, const char *script, int number)
{
    trouble[0] = '\0';
    return brink_gnuplot_draw(folder, "line", script, number, trouble,
                              sizeof trouble);
}

START_TEST(a_script_becomes_one_svg_element)
{
    char *svg = draw(new_folder(), "plot x\n", 1);
    ck_assert_msg(svg != NULL, "%s", trouble);
    ck_assert_int_eq(strncmp(svg, "<svg", 4), 0);
    ck_assert_ptr_nonnull(strstr(svg, "</svg>"));
    ck_assert_ptr_null(strstr(svg, "<title>Gnuplot</title>"));
    free(svg);
}
END_TEST

START_TEST(script_and_drawing_stay_in_the_folder)
{
    const char *folder = new_folder();
    free(draw(folder, "plot sin(x)\n", 1));
    char *script = whole_file(folder, "line.gnuplot");
    char *drawing = whole_file(folder, "line.svg");
    ck_assert_ptr_nonnull(strstr(script, "plot sin(x)\n"));
    ck_assert_ptr_nonnull(strstr(script, "set terminal svg"));
    ck_assert_ptr_nonnull(strstr(drawing, "</svg>"));
    free(script);
    free(drawing);
}
END_TEST

START_TEST(data_are_found_in_the_folder_without_a_path)
{
    const char *folder = new_folder();
    write_file(folder, "a.dat", "1 2\n2 3\n");
    char *svg = draw(folder, "plot 'a.dat'\n", 1);
    ck_assert_msg(svg != NULL, "%s", trouble);
    free(svg);
}
END_TEST

// Every id of drawing 1 begins with f1-, and every reference goes to such an id.
START_TEST(ids_differ_between_drawings)
{
    static const char *const before[] = {"id='", "id=\"", "href='#", "url(#"};
    char *svg = draw(new_folder(),
                     "plot x, x with points, 2*x with boxes fs pattern 1\n", 7);
    int found = 0;
    ck_assert_msg(svg != NULL, "%s", trouble);
    for (size_t k = 0; k < sizeof before / sizeof before[0]; k++)
        for (char *at = svg; (at = strstr(at, before[k])) != NULL; found++) {
            at += strlen(before[k]);
            ck_assert_msg(strncmp(at, "f7-", 3) == 0, "%.20s", at);
        }
    ck_assert_int_gt(found, 10);
    free(svg);
}
END_TEST

START_TEST(a_missing_gnuplot_names_the_package_to_install)
{
    const char *folder = new_folder();
    setenv("PATH", folder, 1);
    ck_assert_ptr_null(draw(folder, "plot x\n", 1));
    ck_assert_msg(strstr(trouble, "apt-get install gnuplot-nox") != NULL, "%s",
                  trouble);
}
END_TEST

START_TEST(what_gnuplot_complains_of_is_told)
{
    ck_assert_ptr_null(draw(new_folder(), "plot 'there-is-no-such.dat'\n", 1));
    ck_assert_msg(strstr(trouble, "there-is-no-such.dat") != NULL, "%s", trouble);
}
END_TEST

START_TEST(a_folder_that_is_not_there_is_told)
{
    ck_assert_ptr_null(draw("/there/is/no/such", "plot x\n", 1));
    ck_assert_msg(strstr(trouble, "/there/is/no/such") != NULL, "%s", trouble);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "gnuplot", 120, a_script_becomes_one_svg_element,
        script_and_drawing_stay_in_the_folder,
        data_are_found_in_the_folder_without_a_path, ids_differ_between_drawings,
        a_missing_gnuplot_names_the_package_to_install,
        what_gnuplot_complains_of_is_told, a_folder_that_is_not_there_is_told);
}
