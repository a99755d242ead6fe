// SPDX-License-Identifier: MIT
/*
 * How everything here is compiled, checked where a compiler could do otherwise.
 * That the kernels refuse -ffast-math is checked by house_check.py, which tries.
 */
#include "suite.h"
#include <float.h>
#include <math.h>

/* Where the hardware has fma a compiler may contract; so give it one, whatever
 * the rest is compiled for. */
#if defined __x86_64__
#define WITH_FMA __attribute__((target("fma"), noinline))
#else
#define WITH_FMA __attribute__((noinline))
#endif

WITH_FMA static double product_and_sum(double a, double b, double c)
{
    return a * b + c;
}

START_TEST(a_product_and_a_sum_are_rounded_twice)
{
#if defined __x86_64__
    if (!__builtin_cpu_supports("fma"))
        return; // no such instruction: nothing to contract into
#endif
    // (1 + e)(1 - e) = 1 - e^2 rounds to 1; fma keeps -e^2.
    volatile double e = 0x1p-30;
    ck_assert_double_eq(product_and_sum(1 + e, 1 - e, -1), 0);
    ck_assert_double_eq(fma(1 + e, 1 - e, -1), -0x1p-60);
}
END_TEST

START_TEST(doubles_are_evaluated_as_doubles_and_subnormals_are_kept)
{
    ck_assert_int_eq(FLT_EVAL_METHOD, 0);
    volatile double least = DBL_TRUE_MIN, nan = (double)NAN;
    ck_assert_double_gt(least, 0);
    ck_assert_double_eq(least * 2, 0x1p-1073);
    ck_assert(nan != nan);
}
END_TEST

int main(void)
{
    return RUN_SUITE("build", 60, a_product_and_a_sum_are_rounded_twice,
                     doubles_are_evaluated_as_doubles_and_subnormals_are_kept);
}
