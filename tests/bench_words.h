// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_WORDS_H
#define TESTS_BENCH_WORDS_H
/** Figures of the bench as people read them. */
#include "standing.h"
#include "study_words.h"

/** An error: 0.42, 2.8, 39, 1.6 × 10⁸; ∞ where something is wrong. */
brink_words bench_error(double ulps);

/** How many of all its answers were wrong: "17 %", "0.02 %", "3 of 120 000",
 * "none". */
brink_words bench_wrong(const standing *s);

/** A part of a whole: 17 %, 0.0083 %. */
brink_words bench_percent(double part);

/** A ratio: 1.02, 4.7, 38, 5 600. */
brink_words bench_ratio(double ratio);

/** What one sees in a contest, to be freed; NULL: no memory. */
char *bench_sentences(const contest *c);

/** The same in one sentence. */
char *bench_headline(const contest *c);
#endif
