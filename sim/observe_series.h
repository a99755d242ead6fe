// SPDX-License-Identifier: MIT
#ifndef BRINK_OBSERVE_SERIES_H
#define BRINK_OBSERVE_SERIES_H
/**
 * The mean of correlated samples and its error, by block averages (Flyvbjerg,
 * Petersen, J. Chem. Phys. 91 (1989) 461), in memory that goes with the logarithm
 * of their number.
 *
 * Level l holds the means of blocks of 2^l successive samples.  As blocks outgrow
 * the time over which samples remember each other, the error that their scatter
 * gives for the mean rises to its true value and stays.  Taken is the largest of
 * all levels with BRINK_SERIES_BLOCKS blocks or more: never below the plateau's
 * height, and by the scatter of the last levels a little above it.
 */
#include "codec.h"

#define BRINK_SERIES_LEVELS 48 // 2^48 samples
// An error that n blocks give is itself good to 1 / sqrt(2 (n - 1)): 18 % of it.
#define BRINK_SERIES_BLOCKS 16

typedef struct brink_series_level {
    double mean;    // of the blocks so far
    double scatter; // sum of the squares of their deviations from it (Welford)
    double pending; // the last block where their number is odd
} brink_series_level;

typedef struct brink_series {
    uint64_t count; // of samples; level l has count >> l blocks
    brink_series_level level[BRINK_SERIES_LEVELS];
} brink_series;

void brink_series_add(brink_series *s, double sample);

/** NaN without samples. */
double brink_series_mean(const brink_series *s);
/** Standard error of the mean; NaN where there are too few samples to tell. */
double brink_series_error(const brink_series *s);

/** To or from a file; reading, *s is all zero before. */
void brink_series_code(brink_codec *c, brink_series *s);
#endif
