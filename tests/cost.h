// SPDX-License-Identifier: MIT
#ifndef TESTS_COST_H
#define TESTS_COST_H
/** What calls cost beside each other. */
#include "problems.h"

/**
 * How many inputs a comparison needs: a branch predictor of today learns the
 * course of a kernel over 16384 of them by heart, and then no branch costs
 * anything; over 65536 none does.  In use no input comes twice.
 */
enum { COST_INPUTS = 65536 };

/**
 * Nanoseconds a call of each of `count` loops over the same COST_INPUTS inputs.
 * They take turns in this process for `seconds`, each time over another part of
 * the inputs; of a part the shortest turn counts, which on a machine shared with
 * others is what is left of the truth.  Slow loops take fewer inputs of each
 * part.  0, or -1 if memory is out.
 */
int cost_compare(int count, loop *const loops[], const inputs *in, answers *out,
                 double seconds, double *ns);
#endif
