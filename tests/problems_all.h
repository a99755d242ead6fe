// SPDX-License-Identifier: MIT
#ifndef TESTS_PROBLEMS_ALL_H
#define TESTS_PROBLEMS_ALL_H
/** The problems, each in a file of its own. */
#include "problems.h"

extern const problem problem_quadratic;    // problem_quadratic.c
extern const problem problem_intersection; // problem_times.c
extern const problem problem_disjoint;
extern const problem problem_halfspace_time; // problem_halfspace_time.c
extern const problem problem_ball;           // problem_overlap.c
extern const problem problem_rate;
extern const problem problem_ball_at;
extern const problem problem_rate_at;
extern const problem problem_halfspace;
extern const problem problem_halfspace_rate;
extern const problem problem_halfspace_at;
extern const problem problem_step; // problem_impulse.c
extern const problem problem_core;
extern const problem problem_rim;
#endif
