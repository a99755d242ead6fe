// SPDX-License-Identifier: MIT
#ifndef BRINK_EXPLAIN_H
#define BRINK_EXPLAIN_H
/**
 * `brink explain`: one event of a run, from the prediction it came from to the
 * velocities after it, to be read from top to bottom.
 *
 * Events are numbered from 1, as `events` in summary.json counts them: pair
 * events, and no crossings of cells.  Particles are numbered from 0, as in a
 * trajectory.
 */
#include "run.h"
#include <stdio.h>

typedef struct brink_explain_orders {
    uint64_t event; // 0: not given
    int has_pair;   // then that pair is explained, as it is just before the event
    uint32_t pair[2];
    int has_seed; // seed and tier are a scene's; a folder has its own
    uint64_t seed;
    int has_tier;
    enum brink_tier tier;
} brink_explain_orders;

/** `of`: a scene, or the folder of a run.  The exit code: 0, or 2 after a
 * complaint to standard error. */
int brink_explain(FILE *out, const char *of, const brink_explain_orders *orders);
#endif
