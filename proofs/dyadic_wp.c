// SPDX-License-Identifier: MIT
// with: -wp-fct brink_dyadic_bits,any_below,brink_dyadic_magnitude,limb_at
// with: -wp-fct normalise,brink_dyadic_integer,brink_dyadic_double
// with: -wp-fct compare_magnitudes,combine,copy,add_signed,brink_dyadic_add
// with: -wp-fct brink_dyadic_sub,brink_dyadic_mul,product_of,add_product
// with: -wp-fct brink_dyadic_dot,brink_dyadic_round,brink_dyadic_leading
// with: -wp-no-smoke-dead-call
/**
 * The dyadic numbers, as compiled: every function ends, reads and writes no limb
 * that is not there, and overflows nothing; what it makes is a number: its
 * highest limb is not 0, and its sign is 0 where it has no limbs.  How many limbs
 * it may have is said in terms of its operands', so that what a caller needs can
 * be added up.
 */
#include "dyadic_wp.h"

/*@ requires is_dyadic(a);
  @ requires -64 * FAR <= end <= 64 * FAR;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == 0 || \result == 1;
  @*/
static int any_below(const brink_dyadic *a, int end);

/*@ requires is_dyadic(a);
  @ requires -64 * FAR <= place <= 64 * FAR;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures a->low <= place < top(a) ==> \result == a->limb[place - a->low];
  @ ensures !(a->low <= place < top(a)) ==> \result == 0;
  @*/
static uint32_t limb_at(const brink_dyadic *a, int place);

/*@ requires \valid(z) && 0 <= z->count <= BRINK_DYADIC_LIMBS;
  @ requires -1 <= z->sign <= 1 && -FAR <= z->low <= FAR;
  @ terminates \true;
  @ exits \false;
  @ assigns z->count, z->sign;
  @ ensures is_dyadic(z) && is_normal(z) && z->count <= \old(z->count);
  @ ensures z->sign == (z->count == 0 ? 0 : \old(z->sign));
  @ ensures \forall integer k; z->count <= k < \old(z->count) ==> z->limb[k] == 0;
  @*/
static void normalise(brink_dyadic *z);

/*@ requires is_dyadic(a) && is_dyadic(b);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures -1 <= \result <= 1;
  @*/
static int compare_magnitudes(const brink_dyadic *a, const brink_dyadic *b);

/*@ requires is_dyadic(a) && is_dyadic(b) && \valid(z);
  @ requires \separated(z, a) && \separated(z, b);
  @ requires (sign == 1 || sign == -1) && (way == 1 || way == -1);
  @ requires has_room_for_sum(a, b);
  @ terminates \true;
  @ exits \false;
  @ assigns *z;
  @ ensures is_dyadic(z) && is_normal(z) && z->low == \min(a->low, b->low);
  @ ensures top(z) <= \max(top(a), top(b)) + 1;
  @*/
static void combine(brink_dyadic *z, int sign, const brink_dyadic *a,
                    const brink_dyadic *b, int way);

/*@ requires is_dyadic(a) && \valid(z) && \separated(z, a);
  @ requires sign == a->sign || (sign == -a->sign);
  @ terminates \true;
  @ exits \false;
  @ assigns *z;
  @ ensures is_dyadic(z) && z->low == a->low && z->count == a->count;
  @ ensures \old(is_normal(a)) ==> is_normal(z);
  @ ensures z->sign == sign;
  @*/
static void copy(brink_dyadic *z, int sign, const brink_dyadic *a);

/*@ requires is_dyadic(a) && is_dyadic(b) && \valid(z);
  @ requires \separated(z, a) && \separated(z, b);
  @ requires sign == 1 || sign == -1;
  @ requires has_room_for_sum(a, b);
  @ terminates \true;
  @ exits \false;
  @ assigns *z;
  @ ensures is_dyadic(z) && z->low >= \min(a->low, b->low);
  @ ensures \old(is_normal(a) && is_normal(b)) ==> is_normal(z);
  @ ensures top(z) <= \max(top(a), top(b)) + 1;
  @*/
static void add_signed(brink_dyadic *z, const brink_dyadic *a,
                       const brink_dyadic *b, int sign);

/*@ requires \valid(z);
  @ terminates \true;
  @ exits \false;
  @ assigns *z;
  @ ensures is_dyadic(z) && is_normal(z) && -68 <= z->low && top(z) <= 66;
  @*/
static void product_of(brink_dyadic *z, double x, double y);

/*@ requires is_dyadic(z) && \valid(z);
  @ requires -68 <= z->low && top(z) <= 266;
  @ terminates \true;
  @ exits \false;
  @ assigns *z;
  @ ensures is_dyadic(z) && -68 <= z->low;
  @ ensures \old(is_normal(z)) ==> is_normal(z);
  @ ensures top(z) <= \max(\old(top(z)), 66) + 1;
  @*/
static void add_product(brink_dyadic *z, double x, double y);

#include "../kernels/dyadic.c"
