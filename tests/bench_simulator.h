// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_SIMULATOR_H
#define TESTS_BENCH_SIMULATOR_H
/** The simulator beside a plain one, as a page. */
#include <stdint.h>

typedef struct bench_simulator_settings {
    const char *out;     // the folder of simulator.html
    const char *counts;  // what simulator_counts.sh wrote, or NULL
    const char *command; // that made all this
    double seconds;      // for a piece of brink's
    uint32_t particles;  // at most
} bench_simulator_settings;

/** Measures all there is and writes the page; 0, or -1 after a word to stderr. */
int bench_simulator(const bench_simulator_settings *s);
#endif
