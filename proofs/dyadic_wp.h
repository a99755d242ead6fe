// SPDX-License-Identifier: MIT
/** What WP proves of dyadic.h's numbers (dyadic_wp.c), and builds on. */
#include "libm_wp.h"

#include "../kernels/dyadic.h"

// Places are far from an int's ends.
#define FAR 0x100000

/*@ // The brackets: limbs are counted from place low up to, not with, this one.
  @ logic integer top(brink_dyadic *a) = a->low + a->count;
  @
  @ predicate is_dyadic(brink_dyadic *a) =
  @     \valid_read(a) && 0 <= a->count <= BRINK_DYADIC_LIMBS &&
  @     -1 <= a->sign <= 1 && -FAR <= a->low <= FAR &&
  @     (a->count == 0 ==> a->sign == 0);
  @ predicate is_normal(brink_dyadic *a) =
  @     a->count > 0 ==> a->limb[a->count - 1] != 0;
  @ // Places from the lowest to the highest, and one more for the carry.
  @ predicate has_room_for_sum(brink_dyadic *a, brink_dyadic *b) =
  @     \max(top(a), top(b)) + 1 - \min(a->low, b->low) <= BRINK_DYADIC_LIMBS;
  @*/

/*@ requires is_dyadic(a);
  @ requires -64 * FAR <= from <= 64 * FAR && 0 <= count <= 53;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @*/
uint64_t brink_dyadic_bits(const brink_dyadic *a, int from, int count);

/*@ requires is_dyadic(a) && a->sign != 0;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures 32 * (top(a) - 1) <= \result <= 32 * top(a);
  @*/
int brink_dyadic_magnitude(const brink_dyadic *a);

/*@ requires \valid(z) && -32 * FAR <= e <= 32 * FAR;
  @ terminates \true;
  @ exits \false;
  @ assigns *z;
  @ ensures is_dyadic(z) && is_normal(z) && z->count <= 3;
  @ ensures 32 * z->low <= e < 32 * z->low + 32;
  @*/
void brink_dyadic_integer(brink_dyadic *z, int64_t m, int e);

/*@ requires \valid(z);
  @ terminates \true;
  @ exits \false;
  @ assigns *z;
  @ ensures is_dyadic(z) && is_normal(z) && -34 <= z->low && top(z) <= 33;
  @ ensures z->count <= 3;
  @*/
void brink_dyadic_double(brink_dyadic *z, double x);

/*@ requires is_dyadic(a) && is_dyadic(b) && \valid(z);
  @ requires \separated(z, a) && \separated(z, b);
  @ requires has_room_for_sum(a, b);
  @ terminates \true;
  @ exits \false;
  @ assigns *z;
  @ ensures is_dyadic(z) && z->low >= \min(a->low, b->low);
  @ ensures \old(is_normal(a) && is_normal(b)) ==> is_normal(z);
  @ ensures top(z) <= \max(top(a), top(b)) + 1;
  @*/
void brink_dyadic_add(brink_dyadic *z, const brink_dyadic *a,
                      const brink_dyadic *b);

/*@ requires is_dyadic(a) && is_dyadic(b) && \valid(z);
  @ requires \separated(z, a) && \separated(z, b);
  @ requires has_room_for_sum(a, b);
  @ terminates \true;
  @ exits \false;
  @ assigns *z;
  @ ensures is_dyadic(z) && z->low >= \min(a->low, b->low);
  @ ensures \old(is_normal(a) && is_normal(b)) ==> is_normal(z);
  @ ensures top(z) <= \max(top(a), top(b)) + 1;
  @*/
void brink_dyadic_sub(brink_dyadic *z, const brink_dyadic *a,
                      const brink_dyadic *b);

/*@ requires is_dyadic(a) && is_dyadic(b) && \valid(z);
  @ requires \separated(z, a) && \separated(z, b);
  @ requires a->count + b->count <= BRINK_DYADIC_LIMBS;
  @ requires -FAR <= a->low + b->low <= FAR;
  @ terminates \true;
  @ exits \false;
  @ assigns *z;
  @ ensures is_dyadic(z) && is_normal(z) && z->low == a->low + b->low;
  @ ensures z->count <= a->count + b->count;
  @*/
void brink_dyadic_mul(brink_dyadic *z, const brink_dyadic *a,
                      const brink_dyadic *b);

/*@ requires \valid(z) && 0 <= n <= 200;
  @ requires \valid_read(x + (0 .. n - 1)) && \valid_read(y + (0 .. n - 1));
  @ requires \separated(z, x + (0 .. n - 1)) && \separated(z, y + (0 .. n - 1));
  @ terminates \true;
  @ exits \false;
  @ assigns *z;
  @ ensures is_dyadic(z) && is_normal(z) && -68 <= z->low && top(z) <= 66 + n;
  @*/
void brink_dyadic_dot(brink_dyadic *z, int n, const double *x, const double *y);

/*@ requires is_dyadic(a);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @*/
double brink_dyadic_round(const brink_dyadic *a);

/*@ requires is_dyadic(a) && \valid(e);
  @ requires \separated(e, a);
  @ terminates \true;
  @ exits \false;
  @ assigns *e;
  @ ensures 32 * (top(a) - 1) <= *e <= 32 * top(a) || *e == 0;
  @*/
dd brink_dyadic_leading(const brink_dyadic *a, int *e);

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @*/
static inline dd fast_two_sum(double a, double b);

// Bits of a double, which WP does not see: trusted.

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @*/
static inline uint64_t bits_of(double x);

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures 0 <= \result <= 2047;
  @*/
static inline int biased_exponent(double x);
