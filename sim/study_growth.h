// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_GROWTH_H
#define BRINK_STUDY_GROWTH_H
/**
 * How the energy that the states have strays from what it was, with the number of
 * events: a random walk, whose steps are the roundings of single events, goes
 * with their square root.
 *
 * What an energy is off at one moment says little of that.  But what it gains
 * between two sample points is, of a random walk, independent of all it gained
 * before, and goes with the square root of the events in between; so the gains
 * are what is fitted.
 */
#include "study_findings.h"

typedef struct brink_growth {
    double end;      // relative gain at the last sample, with its sign
    double exponent; // of |gain| against events between two sample points,
    double error;    // its standard error; both NaN from fewer than three gains
    double walk;     // root mean square of gain / sqrt(events): the walk's pace
} brink_growth;

brink_growth brink_growth_of(const brink_trial *t);

/** A heading, the figure and what is to be seen in it. */
void brink_growth_tell(brink_report *r, const brink_case *c);
#endif
