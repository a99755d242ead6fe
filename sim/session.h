// SPDX-License-Identifier: MIT
#ifndef BRINK_SESSION_H
#define BRINK_SESSION_H
/**
 * What one `brink run` or `brink resume` is: a run driven to its target piece by
 * piece, with checkpoints, trajectory frames and a line of progress in between,
 * and a summary at the end.  The first checkpoint is written before the first
 * event.
 *
 * DIR then holds checkpoint-*.brink (the last two), summary.json, final.xyz, and
 * trajectory.xyz where the scene asks for one.
 */
#include "run.h"
#include <stdint.h>

enum brink_exit {
    BRINK_EXIT_DONE = 0,
    BRINK_EXIT_USAGE = 2,   // usage or bad input
    BRINK_EXIT_WRONG = 3,   // the run found itself wrong, or cannot go on
    BRINK_EXIT_STOPPED = 75 // stopped early, with a checkpoint to resume from
};

typedef struct brink_orders { // what the command line says beyond the scene
    const char *out; // folder, or NULL: the scene's name without its ending
    int has_target;  // then `events` and `until` replace the scene's
    double events_per_particle; // > 0, or 0
    uint64_t events;
    double until;
    int has_seed;
    uint64_t seed;
    enum brink_tier tier;
    double max_wall; // seconds; +inf: no limit
} brink_orders;

/** Runs a scene; answers with the exit code.  Errors are told to standard error,
 * the results' place to standard output. */
int brink_session_run(const char *scene, const brink_orders *orders);

/** Goes on from the newest whole checkpoint of DIR to the target the run was
 * given. */
int brink_session_resume(const char *dir, double max_wall);

/** Reads, checks and sets up a scene without running it, and says what it is. */
int brink_session_check(const char *scene);
#endif
