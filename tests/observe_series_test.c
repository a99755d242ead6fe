// SPDX-License-Identifier: MIT
/*
 * Block averages against series whose error is known: independent normal numbers,
 * and a chain in which each remembers the one before.
 */
#include "observe_series.h"
#include "random.h"
#include "suite.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

START_TEST(few_samples_have_a_mean_and_no_error)
{
    brink_series s = {0};
    ck_assert(isnan(brink_series_mean(&s)));
    for (int k = 1; k < BRINK_SERIES_BLOCKS; k++) {
        brink_series_add(&s, k);
        ck_assert_double_eq(brink_series_mean(&s), (k + 1) / 2.0);
        ck_assert(isnan(brink_series_error(&s)));
    }
    brink_series_add(&s, 0);
    ck_assert(brink_series_error(&s) > 0);
}
END_TEST

// 0, 1, 0, 1 ...: blocks of two are all alike, and their means are without error;
// of n single ones the error is sqrt(1/4 n / (n (n - 1))).
START_TEST(of_all_levels_the_largest_error_counts)
{
    brink_series s = {0};
    for (int k = 0; k < 64; k++)
        brink_series_add(&s, k % 2);
    ck_assert_double_eq(brink_series_mean(&s), 0.5);
    ck_assert_double_eq_tol(brink_series_error(&s), sqrt(0.25 / 63), 1e-15);
    ck_assert_double_eq(s.level[1].scatter, 0);
    ck_assert_double_eq(s.level[3].mean, 0.5);
}
END_TEST

// Every level's mean and scatter are those of its blocks, summed up one by one.
START_TEST(a_level_holds_the_means_of_its_blocks)
{
    enum { N = 1000 };
    double x[N];
    brink_series s = {0};
    stream random = stream_of_seed(5);
    for (int k = 0; k < N; k++) {
        x[k] = stream_normal(&random);
        brink_series_add(&s, x[k]);
    }
    for (int l = 0; l < 10; l++) {
        const int length = 1 << l, blocks = N / length;
        double mean = 0, scatter = 0;
        for (int k = 0; k < blocks * length; k++)
            mean += x[k] / (blocks * length);
        for (int b = 0; b < blocks; b++) {
            double block = 0;
            for (int k = 0; k < length; k++)
                block += x[b * length + k] / length;
            scatter += (block - mean) * (block - mean);
        }
        // sums of at most 1000 numbers of size 1: 1000 roundings of 1000 eps
        ck_assert_double_eq_tol(s.level[l].mean, mean, 1e6 * 0x1p-53);
        ck_assert_double_eq_tol(s.level[l].scatter, scatter, 1e6 * 0x1p-53);
    }
}
END_TEST

// x' = a x + sqrt(1 - a^2) noise: of variance 1, and of n the mean has the error
// sqrt((1 + a) / (1 - a) / n), up to (memory 1 / (1 - a)) / n.
static void chain(double a, int n, uint64_t seed)
{
    const double expected = sqrt((1 + a) / (1 - a) / n);
    brink_series s = {0};
    stream random = stream_of_seed(seed);
    double x = stream_normal(&random);
    for (int k = 0; k < n; k++) {
        brink_series_add(&s, x);
        x = a * x + sqrt(1 - a * a) * stream_normal(&random);
    }
    const double error = brink_series_error(&s);
    printf("memory of %g: error %.5f, expected %.5f, mean %.5f\n", 1 / (1 - a),
           error, expected, brink_series_mean(&s));
    // Blocks of 1024, of which there are 256, make it 5 % too small at a memory
    // of 100 and are good to 4.4 %: 3/4 is five of those below.  Of 16 blocks,
    // whose scatter is chi squared with 15 degrees of freedom, one in 5 million
    // makes it twice too large.
    ck_assert_msg(error > 0.75 * expected && error < 2 * expected,
                  "seed %" PRIu64 ": %a, expected %a", seed, error, expected);
    ck_assert_msg(fabs(brink_series_mean(&s)) < 5 * expected,
                  "seed %" PRIu64 ": mean %a, error %a", seed,
                  brink_series_mean(&s), expected);
}

START_TEST(the_error_is_that_of_the_mean_however_long_the_memory)
{
    const uint64_t seed = (uint64_t)time(NULL);
    chain(0, 1 << 18, seed);
    chain(0.9, 1 << 18, seed);
    chain(0.99, 1 << 18, seed);
}
END_TEST

START_TEST(written_and_read_it_goes_on_as_if_nothing_had_been)
{
    stream random = stream_of_seed(6);
    for (int at = 0; at < 70; at++) {
        brink_series whole, half = {0};
        stream r = random;
        for (int k = 0; k < at; k++)
            brink_series_add(&half, stream_normal(&r));
        whole = half;
        FILE *file = tmpfile();
        brink_codec c;
        brink_codec_write_to(&c, file);
        brink_series_code(&c, &half);
        brink_codec_seal(&c);
        rewind(file);
        brink_series read = {0};
        brink_codec_read_from(&c, file);
        brink_series_code(&c, &read);
        brink_codec_seal(&c);
        ck_assert_ptr_null(c.fault);
        fclose(file);
        for (int k = 0; k < 70; k++) {
            const double x = stream_normal(&r);
            brink_series_add(&whole, x);
            brink_series_add(&read, x);
        }
        ck_assert_mem_eq(&whole, &read, sizeof whole);
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE("observe, series", 60, few_samples_have_a_mean_and_no_error,
                     of_all_levels_the_largest_error_counts,
                     a_level_holds_the_means_of_its_blocks,
                     the_error_is_that_of_the_mean_however_long_the_memory,
                     written_and_read_it_goes_on_as_if_nothing_had_been);
}
