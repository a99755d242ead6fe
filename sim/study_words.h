// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_WORDS_H
#define BRINK_STUDY_WORDS_H
/**
 * Numbers as people read them, in UTF-8.  Each is a value that can be used at
 * once: brink_words_grouped(n).text.
 */
#include <stdint.h>

typedef struct brink_words {
    char text[64];
} brink_words;

/** 686000 as 686 000, with narrow spaces that do not break. */
brink_words brink_words_grouped(uint64_t n);

/** 1.4e-7 as 1.4 × 10⁻⁷, its spaces unbreakable; 0, inf, nan as they are. */
brink_words brink_words_scientific(double x);

/** A frequency with its counting (Poisson) error; where none were seen, the bound
 * below which it is with 95 % confidence, -ln 0.05 / of. */
brink_words brink_words_frequency(uint64_t count, uint64_t of);

/** Seconds as 12.3 s, 4.5 min or 6.7 h. */
brink_words brink_words_duration(double seconds);

/** As a file is called: other characters than letters and digits become '-'; of a
 * long text the beginning. */
brink_words brink_words_slug(const char *text);
#endif
