// SPDX-License-Identifier: MIT
// A pair by itself, with no run, on paper.
#include "explain_pair.h"
#include "explained.h"
#include "suite.h"
#include <math.h>
#include <stdlib.h>

static const double shoulder_distance[] = {3, 1},
                    shoulder_energy[] = {1, (double)INFINITY};
static const brink_potential shoulder = {2, shoulder_distance, shoulder_energy};

static char *meeting(brink_explained *pair, enum brink_direction way)
{
    char *text;
    size_t size;
    double owed = 0;
    FILE *out = open_memstream(&text, &size);
    brink_explain_pair(out, pair);
    brink_explain_surfaces(out, pair);
    brink_explain_meeting(out, pair, way, &owed);
    fclose(out);
    return text;
}

START_TEST(every_answer_has_its_reason)
{
    const struct {
        double v;
        int level;
        enum brink_direction way;
        const char *answer;
        int after;
    } cases[] = {
        {-3, 0, BRINK_INWARD, "crossed: the former is larger (kind: capture)", 1},
        {-1, 0, BRINK_INWARD, "stays outside (kind: bounce)", 0},
        {1, 1, BRINK_OUTWARD, "crossed: the former is larger (kind: release)", 0},
        {-1, 1, BRINK_INWARD, "a hard core; nothing suffices (kind: core)", 1},
        {1, 0, BRINK_OUTWARD, "refused: from this level there is no such step",
         0},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        brink_explained pair = {.r = {3, 0, 0},
                                .v1 = {cases[k].v, 0, 0},
                                .m1 = 1,
                                .m2 = 1,
                                .potential = &shoulder,
                                .level = cases[k].level};
        char *page = meeting(&pair, cases[k].way);
        expect_words(page, "the decision", "answer", cases[k].answer);
        ck_assert_int_eq(pair.level, cases[k].after);
        free(page);
    }
}
END_TEST

/* On the inside of a well, all but along it: what it takes to be turned
 * inward. */
START_TEST(the_rim_rule_is_named)
{
    static const double energy[] = {-1, (double)INFINITY};
    static const brink_potential well = {2, shoulder_distance, energy};
    brink_explained pair = {.r = {3, 0, 0},
                            .v1 = {1e-12, 1, 0},
                            .m1 = 1,
                            .m2 = 1,
                            .potential = &well,
                            .level = 1};
    char *page = meeting(&pair, BRINK_OUTWARD);
    expect_words(page, "the decision", "answer",
                 "by the rim rule (kind: bounce)");
    free(page);
    pair.v1[0] = 0.5;
    page = meeting(&pair, BRINK_OUTWARD);
    expect_words(page, "the decision", "answer", "stays inside (kind: bounce)");
    free(page);
}
END_TEST

/* r = (5, 0, 0), v = (-1, 0, 0), sigma = 3: f = 16, roots 2 and 8; all exact. */
START_TEST(a_ball_has_its_signs_roots_and_times)
{
    const double r[3] = {5, 0, 0}, v[3] = {-1, 0, 0};
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    brink_explain_ball(out, r, v, 3);
    fclose(out);
    expect_words(text, "f =", "f =", "sign  1: outside");
    expect_words(text, "f =", "rate =", "sign -1: approaching");
    ck_assert_double_eq(number_of(text, "f =", "f ="), 16);
    ck_assert_double_eq(number_of(text, "f =", "b^2 - a c"), 9);
    ck_assert_double_eq(number_of(text, "f =", "roots of"), 2);
    ck_assert_double_eq(number_of(text, "f =", "intersection time"), 2);
    ck_assert_double_eq(number_of(text, "f =", "disjoint time"), 8);
    // 16 / (5 + 3) = 2 from a distance of 3, whose ulp is 2^-51.
    ck_assert_double_eq(number_of(text, "f =", "    in ulp"), 0x1p52);
    free(text);
}
END_TEST

START_TEST(a_plane_has_its_sign_and_time)
{
    const double r[3] = {0, 0, 5}, v[3] = {1, 0, -2}, n[3] = {0, 0, 2},
                 c[3] = {9, 9, 1};
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    brink_explain_halfspace(out, r, v, n, c);
    fclose(out);
    expect_words(text, "f =", "f =", "sign  1: outside");
    expect_words(text, "f =", "rate =", "sign -1: approaching");
    ck_assert_double_eq(number_of(text, "f =", "halfspace time"), 2);
    free(text);
}
END_TEST
int main(void)
{
    return RUN_SUITE("explain_pair", 60, every_answer_has_its_reason,
                     the_rim_rule_is_named, a_ball_has_its_signs_roots_and_times,
                     a_plane_has_its_sign_and_time);
}
