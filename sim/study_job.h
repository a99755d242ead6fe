// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_JOB_H
#define BRINK_STUDY_JOB_H
/**
 * One method on one scene as a worker does it, in a process of its own: its
 * trial, and where the method nudges what other nudges would have done.
 *
 * In the folder `out` it leaves, for a scene and method of the stem NAME,
 *
 *     NAME.dat      samples, a line each, as they are taken
 *     NAME/         checkpoints while the trial is under way: every so often, as
 *                   the scene has it, and when it is stopped
 *     NAME.result   the figures, once the trial has come to its end
 *
 * and goes on from those that it finds there, unless they are of another scene or
 * program.  Whoever else is at work on the same files is waited for.
 */
#include "study_findings.h"
#include "study_watch.h"

typedef struct brink_job {
    const char *out;
    brink_case *of;
    const brink_system *start; // for every worker a copy of its own
    enum brink_method method;
} brink_job;

/** In the worker: the exit code.  0: there is a result; BRINK_EXIT_STOPPED:
 * stopped before, and can go on; anything else: it could not be done, and why was
 * told to standard error. */
int brink_job_work(const brink_job *job, const brink_watch *watch);

/** Afterwards, elsewhere: puts the result into the case.  Where the worker left
 * none, it has crashed. */
void brink_job_take(const brink_job *job, int left_result);
#endif
