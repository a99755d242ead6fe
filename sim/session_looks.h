// SPDX-License-Identifier: MIT
#ifndef BRINK_SESSION_LOOKS_H
#define BRINK_SESSION_LOOKS_H
/**
 * How a session looks at its run, and what it leaves of that on disk: frames,
 * samples, checkpoints, results.
 *
 * What is looked at at a certain instant is looked at after all events up to and
 * at it, in however many pieces the run gets there: so it is the same however
 * often the run was stopped.
 */
#include "observe_record.h"
#include "run.h"
#include "scene.h"
#include "snapshot.h"
#include <signal.h>
#include <stdio.h>

typedef struct brink_session {
    brink_run run;
    brink_plan plan;
    brink_scene scene;
    brink_record record; // empty where the scene asks for no observations
    char dir[4096];
    FILE *trajectory; // NULL: the scene asks for none
    double max_wall;  // for this piece of the run
    // the signals that stop it, blocked and asked for between pieces
    sigset_t stops;
} brink_session;

/** Begins the observations that the scene asks for.  0; -1 after a complaint. */
int brink_looks_begin(brink_session *s);
/** The same, as far as the plan's checkpoint has got; it was read from `path`. */
int brink_looks_resume(brink_session *s, const char *path);

/** Opens the trajectory, if there is one, behind the last frame that the plan
 * knows of; what is behind that is cut off.  0; -1 after a complaint. */
int brink_looks_open_trajectory(brink_session *s);

/** When the run is to be looked at next, or its target. */
brink_instant brink_looks_next(const brink_session *s);

/** Looks at it if that is due, all events at the clock's instant executed.  0; -1
 * after a complaint. */
int brink_looks_take(brink_session *s);

/** A checkpoint.  0; -1 after a complaint. */
int brink_looks_save(brink_session *s);

/** summary.json, final.xyz, and the page of what was observed. */
int brink_looks_results(const brink_session *s, const char *stopped);
#endif
