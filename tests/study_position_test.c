// SPDX-License-Identifier: MIT
#include "folder.h"
#include "study_position.h"
#include "suite.h"
#include <string.h>

// 1.4e-7 of 3.2e8 events are 44.8.
START_TEST(near_is_from_half_to_twice)
{
    static const struct {
        uint64_t count;
        enum brink_standing standing;
    } cases[] = {{90, BRINK_FAR_MORE}, {89, BRINK_NEAR},     {45, BRINK_NEAR},
                 {23, BRINK_NEAR},     {22, BRINK_FAR_LESS}, {0, BRINK_FAR_LESS}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++)
        ck_assert_int_eq(brink_standing_of(cases[k].count, 320000000, 1.4e-7),
                         cases[k].standing);
}
END_TEST

START_TEST(what_was_not_seen_in_a_short_run_is_undecided)
{
    // 3 are the bound where none were seen: decided from 6 expected on.
    ck_assert_int_eq(brink_standing_of(0, 42000000, 1.4e-7), BRINK_UNDECIDED);
    ck_assert_int_eq(brink_standing_of(0, 43000000, 1.4e-7), BRINK_FAR_LESS);
}
END_TEST

static char *page_of(brink_case *c)
{
    const char *folder = new_folder();
    brink_report r;
    brink_report_open(&r, folder, "position");
    brink_position_tell(&r, c);
    ck_assert_int_eq(brink_report_close(&r, stderr), 0);
    return whole_file(folder, "index.html");
}

static const char well[] = "box: {number_density: 1.0e-3}\n"
                           "species: {A: {count: 32}}\n"
                           "potentials:\n"
                           "  - {between: [A, A], steps: [[3, -1], [1, .inf]]}\n";

START_TEST(the_page_says_what_comes_near_and_at_which_tolerance)
{
    brink_case *c = calloc(1, sizeof *c);
    ck_assert_int_eq(
        brink_scene_parse(well, strlen(well), "well", "", &c->scene, stderr), 0);
    strcpy(c->name, "well");
    brink_doubts *d = &c->trial[BRINK_METHOD_LOGICAL].doubts;
    d->events = 320000000;
    d->of[BRINK_DOUBT_EXECUTED].wrong = 100000000;
    d->of[BRINK_DOUBT_STORED].wrong = 50;
    // Twice as many within twice the tolerance: 44.8 are within 44.8 / 32 of
    // 2^-30, 2^(lb 1.4 - 30) = 1.3e-9.
    for (int k = 0; k < BRINK_GAPS; k++) {
        const uint64_t many = k < 36 ? UINT64_C(1) << (35 - k) : 0;
        d->of[BRINK_DOUBT_SYSTEM].within[k] = many;
        d->of[BRINK_DOUBT_NEXT].within[k] = many;
    }
    d->of[BRINK_DOUBT_SYSTEM].within[35] = d->of[BRINK_DOUBT_NEXT].within[35] = 2;
    char *page = page_of(c);
    ck_assert_ptr_nonnull(strstr(page, "comes: E. More frequent: D. Less "
                                       "frequent: A, B, C, F, G."));
    ck_assert_ptr_nonnull(strstr(page, "(1.56 ± 0.22)\u00a0×\u00a010⁻⁷"));
    ck_assert_ptr_nonnull(strstr(page, "within 1.3\u00a0×\u00a010⁻⁹ σ"));
    free(page);
    brink_scene_destroy(&c->scene);
    free(c);
}
END_TEST

int main(void)
{
    return RUN_SUITE("position", 60, near_is_from_half_to_twice,
                     what_was_not_seen_in_a_short_run_is_undecided,
                     the_page_says_what_comes_near_and_at_which_tolerance);
}
