// SPDX-License-Identifier: MIT
#ifndef BRINK_RUN_PREDICT_H
#define BRINK_RUN_PREDICT_H
/**
 * What a particle's slot waits for: its first event with another particle, or,
 * if that is earlier, its next crossing of a cell's wall or its departure from
 * home; there it is predicted anew.
 *
 * A pair's event is kept by the particle that was predicted last; where its
 * partner has changed since, it is stale and made anew when it comes up.  A stale
 * event is never later than what it stands for, so the earliest event of all is
 * always in some slot.
 */
#include "run.h"

/** Fills particle i's slot, as of `offset` in the current year. */
void brink_predict(brink_run *run, uint32_t i, double offset);
#endif
