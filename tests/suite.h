// SPDX-License-Identifier: MIT
#ifndef SUITE_H
#define SUITE_H
/**
 * What every Check program ends with:
 *
 *     int main(void)
 *     {
 *         return RUN_SUITE("calendar", 60, empty_has_no_next, ...);
 *     }
 *
 * Each test runs in a process of its own and is given so many seconds.  A suite
 * of several cases, or of tests in a loop, ends with run_whole_suite.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#define RUN_SUITE(name, seconds, ...)                                            \
    run_suite(name, seconds, (const TTest *const[]){__VA_ARGS__},                \
              sizeof((const TTest *const[]){__VA_ARGS__}) /                      \
                  sizeof(const TTest *))

/** Runs a suite, and frees it: what main returns. */
static inline int run_whole_suite(Suite *suite)
{
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    const int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}

static inline int run_suite(const char *name, double seconds,
                            const TTest *const *tests, size_t count)
{
    Suite *suite = suite_create(name);
    TCase *tcase = tcase_create(name);
    tcase_set_timeout(tcase, seconds);
    for (size_t k = 0; k < count; k++)
        tcase_add_test(tcase, tests[k]);
    suite_add_tcase(suite, tcase);
    return run_whole_suite(suite);
}

/** How much of a long test's work is to be done: n, or that part of it which the
 * environment variable BRINK_TEST_SHARE says; see tests/CMakeLists.txt. */
static inline uint64_t suite_share(uint64_t n)
{
    const char *share = getenv("BRINK_TEST_SHARE");
    return share ? (uint64_t)((double)n * strtod(share, NULL)) : n;
}
#endif
