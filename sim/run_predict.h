// SPDX-License-Identifier: MIT
#ifndef BRINK_RUN_PREDICT_H
#define BRINK_RUN_PREDICT_H
/**
 * What a particle's slot waits for: its first event with another particle, or its
 * next crossing if that is earlier; the event with the other is kept until then.
 * A pair's event is kept by the particle that was predicted last; where its
 * partner has changed since, it is stale and made anew when it comes up.  A stale
 * event is never later than what it stands for, so the earliest event of all is
 * always in some slot.
 */
#include "run.h"

/** Finds particle i's earliest event with anybody, and fills its slot.  It is
 * `offset` in the current year, as in both of these. */
void brink_predict(brink_run *run, uint32_t i, double offset);

/** The same when particle i has just come by `crossing`: only those ahead are new
 * to it, and the event it had stands unless one with them is earlier. */
void brink_predict_ahead(brink_run *run, uint32_t i, double offset,
                         brink_crossing crossing);
#endif
