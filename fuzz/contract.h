// SPDX-License-Identifier: MIT
#ifndef FUZZ_CONTRACT_H
#define FUZZ_CONTRACT_H
/**
 * The contract of a kernel, put to the exact oracle of tests/problem_*.c:
 * whether, always right; when and how much, within the bound that its header
 * states.
 */
#include "../tests/problems_all.h"
#include "fuzz.h"

/** A case of the problem: a family by the first byte, made by those that follow,
 *  then up to three of its first `movable` numbers moved by a few ulp. */
void contract_case(const problem *p, stream *s, int movable,
                   double x[PROBLEM_INPUTS]);

/** Puts that case, and the right answer to it, to all of the problem's kernels of
 *  this rank. */
void contract_check(const problem *p, enum rank rank,
                    const double x[PROBLEM_INPUTS], const truth *right);

/** The problem's first kernel of this rank, as a number for contract_answer. */
int contract_kernel(const problem *p, enum rank rank);

/** What the k-th method answers: outputs as the problem has them. */
int contract_answer(const problem *p, int k, const double x[PROBLEM_INPUTS],
                    double y[PROBLEM_OUTPUTS]);
#endif
