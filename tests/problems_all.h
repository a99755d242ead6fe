// SPDX-License-Identifier: MIT
#ifndef TESTS_PROBLEMS_ALL_H
#define TESTS_PROBLEMS_ALL_H
/** The problems, each in a file of its own. */
#include "problems.h"

extern const problem problem_quadratic;    // problem_quadratic.c
extern const problem problem_intersection; // problem_times.c
extern const problem problem_disjoint;
#endif
