// SPDX-License-Identifier: MIT
#ifndef TESTS_THERMO_H
#define TESTS_THERMO_H
/**
 * Pressure and energy of a run with error bars: it is cut into THERMO_BLOCKS
 * stretches of equal time, each many collision times long, and the error of the
 * mean is the blocks' standard deviation over sqrt(THERMO_BLOCKS).
 */
#include "run.h"

#define THERMO_BLOCKS 20

typedef struct mean {
    double value, error;
} mean;

typedef struct thermo {
    mean z;             // 1 + virial / (d N kT t)
    mean energy;        // potential, per particle
    double temperature; // k_B T
} thermo;

/** Over `events` or so; before that the run is given `settling` events to forget
 *  how it began. */
thermo thermo_measure(brink_run *run, uint64_t settling, uint64_t events);

/** A figure within 4 errors and `besides` of what is expected of it (one test in
 *  16 000 would fail by chance; with its seed fixed each one always passes or
 *  always fails); the error itself no more than `blunt`, for the whole of the
 *  work, lest a test pass for knowing nothing. */
void thermo_expect(const char *what, mean figure, double expected, double besides,
                   double blunt);
#endif
