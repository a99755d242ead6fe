// SPDX-License-Identifier: MIT
#ifndef TESTS_TRANSCRIPTION_H
#define TESTS_TRANSCRIPTION_H
/**
 * A proof's own formulas, which transcribe.py makes C of, beside the source that
 * they were written from: on a million random inputs, all bits the same.
 */
#include "random.h"
#include "suite.h"
#include <brink/exact.h>
#include <stdio.h>

enum { TRANSCRIPTION_INPUTS = 1000000, TRANSCRIPTION_SEED = 20261123 };

#define EACH_INPUT(s)                                                            \
    stream s = stream_of_seed(TRANSCRIPTION_SEED);                               \
    for (uint64_t left = suite_share(TRANSCRIPTION_INPUTS); left > 0; left--)

/** x y, not rounded: what the sums in Coq are sums of. */
typedef struct product {
    double x, y;
} product;

/** What a sum leaves when it is rounded: by the larger term, unlike two_sum. */
static inline double rest_of_sum(double x, double y)
{
    const double sum = x + y;
    return fabs(x) < fabs(y) ? x - (sum - y) : y - (sum - x);
}

static inline double rest_of_product(double x, double y)
{
    return fma(x, y, -(x * y));
}

/** A number of a script's range, even on a log scale. */
static inline double within(stream *s, const double range[2])
{
    const int negative = range[1] < 0;
    int low, high;
    frexp(range[negative], &low);
    frexp(range[!negative], &high);
    const double size = fabs(stream_scaled(s, low - 1, high - 1));
    return negative ? -size : size;
}

/** The same to the bit, or neither a number. */
static inline void same(double transcribed, double source, const char *what,
                        int n, const double *input)
{
    if (bits_of(transcribed) == bits_of(source) ||
        (isnan(transcribed) && isnan(source)))
        return;
    char inputs[400];
    int end = 0;
    for (int k = 0; k < n && end < 350; k++)
        end +=
            snprintf(inputs + end, sizeof inputs - (size_t)end, " %a", input[k]);
    ck_abort_msg("%s (seed %d): source %a, transcription %a, of%s", what,
                 TRANSCRIPTION_SEED, source, transcribed, inputs);
}

/** SAME(transcription, source, the numbers they are of); of truths as well. */
#define SAME(transcribed, source, ...)                                           \
    same((double)(transcribed), (double)(source), #source,                       \
         (int)(sizeof((double[]){__VA_ARGS__}) / sizeof(double)),                \
         (const double[]){__VA_ARGS__})

#define SAME_DD(transcribed, source, ...)                                        \
    do {                                                                         \
        const dd theirs = (transcribed), ours = (source);                        \
        SAME(theirs.hi, ours.hi, __VA_ARGS__);                                   \
        SAME(theirs.lo, ours.lo, __VA_ARGS__);                                   \
    } while (0)
#endif
