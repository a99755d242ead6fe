// SPDX-License-Identifier: MIT
/**
 * What WP needs to say that a function of the kernels is a formula, operation by
 * operation in binary64: no number is rounded that the formula does not round.
 * Included before the source it is for; trusted.
 *
 * Two terms of WP are the same double if they are the same term.  So a number
 * that a function of libm gives is boxed: boxes are equal if what is in them is,
 * whereas equal doubles need only be equal as real numbers.
 */
#include <math.h>

typedef struct boxed {
    double x;
} boxed;

/*@ axiomatic Libm {
  @   logic boxed root_of(double x);
  @   logic boxed size_of(double x);
  @   logic boxed fma_of(double x, double y, double z);
  @   logic integer bits(double x); // all 64
  @ }
  @*/

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == root_of(x);
  @*/
boxed a_root(double x);

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == size_of(x);
  @*/
boxed a_size(double x);

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == fma_of(x, y, z);
  @*/
boxed a_fused(double x, double y, double z);

#define sqrt(a)      (a_root(a).x)
#define fabs(a)      (a_size(a).x)
#define fma(a, b, c) (a_fused(a, b, c).x)

#include "../kernels/exact.h"
