// SPDX-License-Identifier: MIT
#ifndef BRINK_SNAPSHOT_H
#define BRINK_SNAPSHOT_H
/**
 * A run as bytes, every bit of it: positions, velocities, levels, cells, homes,
 * clock, pending events, tallies, and the scene it came from.  Logical states are
 * stored and win over positions [S16 section 6]; pending events are stored
 * because to predict them anew would be to round anew.
 */
#include "run.h"
#include <stdio.h>

#define BRINK_SNAPSHOT_VERSION 4

/** What a run was asked for and how far its output has got. */
typedef struct brink_plan {
    uint64_t events;     // target: pair and wall events in all, or UINT64_MAX
    double until;        // target: time, or +inf
    uint64_t seed;       // of the start, for the record
    uint64_t frames;     // trajectory frames written
    uint64_t frame_end;  // bytes of the trajectory up to there
    double wall_seconds; // spent so far, all pieces together
    char *scene;         // the scene's text
    uint64_t scene_size;
    char *record; // what was observed so far, as bytes of those who look
    uint64_t record_size;
} brink_plan;

/** Writes run and plan; the file is flushed.  NULL, or what went wrong. */
const char *brink_snapshot_write(FILE *file, const brink_run *run,
                                 const brink_plan *plan);

/** Reads them.  NULL, or what is wrong with the file: *run and *plan are empty
 * then. Otherwise the memory is the caller's: brink_run_destroy and
 * brink_plan_destroy. */
const char *brink_snapshot_read(FILE *file, brink_run *run, brink_plan *plan);
void brink_plan_destroy(brink_plan *plan);
#endif
