// SPDX-License-Identifier: MIT
#ifndef MADE_H
#define MADE_H
/** Systems and runs as a scene's text says, for the suites; with another seed than the
 *  scene's.  Any error is printed and ends the program. */
#include "run.h"

void made_system(brink_system *system, const char *scene, uint64_t seed);
void made_run(brink_run *run, const char *scene, uint64_t seed);

/** The last whole number up to n * share, at least 1, where the environment variable
 *  BRINK_TEST_SHARE says how much of a long test's work is to be done; n without. */
uint64_t made_share(uint64_t n);
#endif
