// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_DOUBTS_H
#define BRINK_STUDY_DOUBTS_H
/**
 * How often position would have told a pair's state wrongly, counted beside a run
 * that goes by logical states and is looked at after every event.
 *
 * [S16] section 5 gives 1.4e-7 (square well) and 2.6e-7 (square shoulder) an
 * event for "inconsistencies during event processing" and does not say what is
 * counted.  These are the definitions that can be meant, each by itself.
 */
#include "run.h"

typedef struct brink_doubts {
    uint64_t events; // pair events looked at

    /** At execution: the position shows another level than the one the pair was
     * at just before the event. */
    uint64_t before;
    /** Right after it, where the pair is looked at again at once: another level
     * than the one it is at now.  (A transfer is in doubt on either side of it:
     * exactly one of `before` and `after` counts it.) */
    uint64_t after;
    /** At the next event of either particle, with somebody else: the pair looked
     * at again then.  And how often that was done. */
    uint64_t later, looks_later;
    /** The spheres of a hard core overlap by a rounding when they collide.  There
     * is no other state to be mistaken for, so none of the above counts it. */
    uint64_t overlaps;

    // per particle: whom it met last and was not looked at since
    uint32_t *partner;
} brink_doubts;

/** 0, -1 no memory. */
int brink_doubts_create(brink_doubts *d, uint32_t particles);
void brink_doubts_destroy(brink_doubts *d);

/** To be called after each event of the run. */
void brink_doubts_look(brink_doubts *d, const brink_run *run);
#endif
