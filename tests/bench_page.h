// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_PAGE_H
#define TESTS_BENCH_PAGE_H
/** Speed against error, as a page. */
#include <stdint.h>

typedef struct bench_settings {
    const char *out;          // the folder of kernels.html
    const char *instructions; // what instructions.sh wrote, or NULL
    const char *command;      // that made all this
    int cases;                // of each family
    double seconds;           // for the costs of a problem
    uint64_t seed;
} bench_settings;

/** Measures all there is and writes the page; 0, or -1 after a word to stderr. */
int bench_page(const bench_settings *s);
#endif
