// SPDX-License-Identifier: MIT
#ifndef FUZZ_LAWS_H
#define FUZZ_LAWS_H
/**
 * What must be so of a kernel whatever its answer is: laws of geometry and of
 * units, put to two calls of it.  They owe nothing to the oracle.
 */
#include "contract.h"

/**
 * A problem with one answer, whose inputs are vectors first and then scalars.
 *
 *     units    a letter an input:  L a length, R a radius, which is not negative,
 *              V a velocity, N a normal's, T a time, - not looked at
 *     answer   the letters of which the answer's unit is the product
 */
typedef struct lawful {
    const problem *problem;
    const char *units, *answer;
} lawful;

/**
 * All that holds for kernels of this rank:
 *
 *     mirrored in any axes, in all three of them as seen from the partner: the
 *              same bits
 *     axes exchanged, lengths, velocities and normals times powers of two: the
 *              same where the kernel rounds correctly or answers with a sign;
 *              otherwise to twice its bound
 *     zeros of the other sign: the same, as the bound above
 *              neither of these two of _fast, which near the surface may answer
 *              either way
 *     outside the domain: NaN, and as a sign 0
 *     a time: never negative, never -0
 */
void laws_check(const lawful *l, enum rank rank, const double x[PROBLEM_INPUTS],
                stream *s);
#endif
