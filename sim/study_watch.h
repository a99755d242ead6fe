// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_WATCH_H
#define BRINK_STUDY_WATCH_H
/**
 * Listening for the end: SIGTERM and SIGINT, held back and asked for between
 * pieces of work; and in a worker whether the process that started it is still
 * there.
 */
#include <signal.h>
#include <sys/types.h>

/** Events between two looks: some milliseconds, a look costs microseconds. */
#define BRINK_WATCH_EVENTS 1000

typedef struct brink_watch {
    sigset_t stops, before;
    pid_t parent; // of the process that watches, or 0: whoever that is
} brink_watch;

/** From here on SIGTERM and SIGINT wait until they are asked for, here and in
 * processes started from here; until brink_watch_end. */
void brink_watch_begin(brink_watch *w);
void brink_watch_end(const brink_watch *w);

/** Whether there was a stop; it is taken.  An orphan is stopped. */
int brink_watch_stopped(const brink_watch *w);

/** The same after waiting for one so many seconds at most. */
int brink_watch_wait(const brink_watch *w, double seconds);
#endif
