// SPDX-License-Identifier: MIT
// The overlap functions give the same bits on every path: see path_test.c.
#include "overlap_paths.h"
#include "suite.h"

enum { CASES_A_FAMILY = 2000, SEED = 1 };

START_TEST(overlaps_are_the_same_on_every_path)
{
    const pair_family *family = &pair_families[_i];
    for (int path = 1; path < PATHS_IN_ALL && can_try(path); path++) {
        stream s = stream_of_seed(SEED);
        for (int i = 0; i < CASES_A_FAMILY; i++) {
            pair_case p, q;
            double y[2][QUANTITIES];
            family->make(&s, &p);
            family->make(&s, &q);
            const double t = stream_scaled(&s, -4, 4);
            quantities(0, &p, &q, t, y[0]);
            quantities(path, &p, &q, t, y[1]);
            for (int k = 0; k < QUANTITIES; k++)
                if (!same(y[0][k], y[1][k]))
                    ck_abort_msg(
                        "path %d, quantity %d, %s %d (seed %d): %a and %a\n"
                        "r %a %a %a  v %a %a %a  sigma %a  t %a\n"
                        "n %a %a %a  c %a %a %a",
                        path, k, family->name, i, SEED, y[0][k], y[1][k], p.r[0],
                        p.r[1], p.r[2], p.v[0], p.v[1], p.v[2], p.sigma, t,
                        q.v[0], q.v[1], q.v[2], q.r[0], q.r[1], q.r[2]);
        }
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("overlap_path");
    TCase *all = tcase_create("all");
    tcase_set_timeout(all, 600);
    tcase_add_loop_test(all, overlaps_are_the_same_on_every_path, 0,
                        PAIR_FAMILIES);
    suite_add_tcase(suite, all);
    return run_whole_suite(suite);
}
