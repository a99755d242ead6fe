// SPDX-License-Identifier: MIT
#ifndef TESTS_STANDING_H
#define TESTS_STANDING_H
/** How the ways to an answer stand beside each other: good, and costly. */
#include "measure.h"

typedef struct standing {
    const method *method;
    sample *family; // one a family: counts, no errors
    sample all;     // of all families together, each the same number of cases
    double ns;      // a call on usual input
    double ratio;   // to the baseline's
} standing;

typedef struct contest {
    const problem *problem;
    standing *of; // one a method
} contest;

/** Measures all methods of a problem: `cases` a family, `seconds` for all costs.
 * 0, or -1 if memory is out. */
int contest_hold(contest *c, const problem *p, int cases, uint64_t seed,
                 double seconds);
void contest_free(contest *c);

/** What part of its answers were wrong. */
double standing_wrong(const standing *s);

/** Its largest error by a measure, wrong answers included. */
double standing_max(const standing *s, int measure);

/** What part of what was measured is farther off than x. */
double standing_above(const standing *s, int measure, double x);
#endif
