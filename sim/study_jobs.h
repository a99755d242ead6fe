// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_JOBS_H
#define BRINK_STUDY_JOBS_H
/**
 * Jobs in processes of their own, as many at a time as the machine has cores, in
 * their order.
 */
#include "study_job.h"

/**
 * Does them all and puts their results into their cases; who left none has
 * crashed, and is reported as such.
 *
 * Returns   0; BRINK_EXIT_STOPPED after SIGTERM or SIGINT: every worker has then
 *           left what is needed to go on; BRINK_EXIT_WRONG: no memory
 */
int brink_jobs_run(const brink_job *jobs, int count);
#endif
