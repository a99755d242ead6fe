// SPDX-License-Identifier: MIT
#ifndef SYSTEMS_H
#define SYSTEMS_H
/** Small systems for suites, made from the text of a scene. */
#include "run.h"

/** A system from a scene's text; the test fails with the scene's errors
 * otherwise. */
void make_system(brink_system *system, const char *scene);

/** The same, as a run before its first event. */
void make_run(brink_run *run, const char *scene);

/** Two particles of mass 1 in a box of 64, r and v apart. */
void make_pair(brink_run *run, const brink_potential *potential,
               const double r[3], const double v[3]);

/** Advances to `events` in all; the test fails if the run stops for another
 * reason. */
void advance(brink_run *run, uint64_t events);

/** 1 where two runs agree in every bit of the state that a checkpoint holds, 0
 * where they do not. */
int same_state(const brink_run *a, const brink_run *b);

extern const char hard_spheres[], square_well[], square_shoulder[], three_steps[],
    mixture[], discs_well[], small_box[];

/** Crowded enough for lists of neighbours. */
extern const char crowded_spheres[], crowded_mixture[];
#endif
