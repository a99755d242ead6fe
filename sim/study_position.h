// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_POSITION_H
#define BRINK_STUDY_POSITION_H
/**
 * How often position is wrong, by every definition of that, beside what [S16]
 * found.
 */
#include "study_findings.h"

/** What [S16] section 5 found an event, for its well or its shoulder; else 0. */
double brink_paper_frequency(const brink_scene *s);

/** How a count of so many in so many events compares with a frequency. */
enum brink_standing {
    BRINK_FAR_MORE,  // over twice as frequent
    BRINK_NEAR,      // from half of it to twice
    BRINK_FAR_LESS,  // less than half; not seen: at 95 % confidence
    BRINK_UNDECIDED, // not seen, in too few events to say
    BRINK_STANDINGS
};
enum brink_standing brink_standing_of(uint64_t count, uint64_t events,
                                      double frequency);

/** A heading, tables, and where the scene is one of [S16]'s what comes near. */
void brink_position_tell(brink_report *r, const brink_case *c);
#endif
