// SPDX-License-Identifier: MIT
// transcribed: exact.v
// with: -wp-fct two_sum,fast_two_sum,two_prod,dd_mul_d,is_told
// with: -inline-calls two_prod,fast_two_sum -wp-no-parasite -wp-no-filter
/** exact.h, as compiled, is what exact.v is about, operation by operation. */
#include "link_wp.h"

#include "exact_v.h"

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures hi: bits(\result.hi) == bits(exact_v_two_sum_hi(a, b));
  @ ensures lo: bits(\result.lo) == bits(exact_v_two_sum_lo(a, b));
  @*/
static dd two_sum(double a, double b);

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures hi: bits(\result.hi) == bits(exact_v_fast_two_sum_hi(a, b));
  @ ensures lo: bits(\result.lo) == bits(exact_v_fast_two_sum_lo(a, b));
  @*/
static dd fast_two_sum(double a, double b);

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures hi: bits(\result.hi) == bits(exact_v_two_prod_hi(a, b));
  @ ensures lo: bits(\result.lo) == bits(exact_v_two_prod_lo(a, b));
  @*/
static dd two_prod(double a, double b);

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures hi: bits(\result.hi) == bits(exact_v_dd_mul_d_hi(x.hi, x.lo, y));
  @ ensures lo: bits(\result.lo) == bits(exact_v_dd_mul_d_lo(x.hi, x.lo, y));
  @*/
static dd dd_mul_d(dd x, double y);

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures told: \result == 1 <==> exact_v_is_told(x.hi, x.lo);
  @*/
static int is_told(dd x);
