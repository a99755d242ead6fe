// SPDX-License-Identifier: MIT
#ifndef TESTS_COST_H
#define TESTS_COST_H
/** What calls cost beside each other. */
#include "problems.h"

/**
 * Nanoseconds a call of each of `count` loops over the same inputs: they take turns in
 * this process for `seconds`, and the shortest turn of each counts, which on a
 * machine shared with others is what is left of the truth.  Slow loops take fewer of
 * the inputs, from the first on.
 */
void cost_compare(int count, loop *const loops[], const inputs *, answers *,
                  double seconds, double *ns);
#endif
