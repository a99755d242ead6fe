// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_NUDGES_H
#define BRINK_STUDY_NUDGES_H
/**
 * How much a nudging method depends on how much it nudges: the same start with
 * nudges from far too small to far too large.
 */
#include "conventional_method.h"
#include "study_watch.h"

#define BRINK_NUDGES 8

/** Whether a method nudges at all. */
int brink_nudge_is_used(enum brink_method method);

/** 1e-16, 1e-14, ... 1e-2, in the units of brink_rule. */
double brink_nudge_size(int k);

/**
 * Runs a start, which is taken over, for so many events by a method with another
 * nudge.
 *
 * Returns   0 and in *off how far the energy is off at the end, in parts of the
 *           largest finite step: where all steps are equal a whole number, to
 *           within rounding, one for each state told wrongly and not made good by
 *           another; +inf if time stood still before; NaN if memory was out.
 *           -1 if the watch was told to stop
 */
int brink_nudge_try(brink_system *start, enum brink_method method, double nudge,
                    uint64_t events, const brink_watch *watch, double *off);
#endif
