// SPDX-License-Identifier: MIT
#ifndef BRINK_RUN_AHEAD_H
#define BRINK_RUN_AHEAD_H
/**
 * Memory asked for some events ahead.  What an event touches lies anywhere in
 * memory, and one thing tells where the next is: the calendar an entry, the entry
 * two particles, these their neighbours.  A processor that comes to it would wait
 * for each in turn; the calendar knows whom the coming days are about.  Nothing
 * of what a run computes depends on this.
 */
#include "run.h"

/** To be called as each event is taken. */
void brink_look_ahead(brink_run *run);
#endif
