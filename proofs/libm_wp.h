// SPDX-License-Identifier: MIT
/**
 * What WP is told of <math.h>, where Frama-C's own leaves it open; trusted.
 * Included before the source it is for.
 */
#include <math.h>

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == 0 || \result == 1;
  @ ensures \result == 1 <==> \is_finite(x);
  @*/
int is_a_finite(double x);

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == 0 || \result == 1;
  @ ensures \result == 1 <==> \is_infinite(x);
  @*/
int is_an_infinity(double x);

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \is_NaN(\result);
  @*/
double no_number(void);

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @*/
int has_a_minus(double x);

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @*/
double scaled_by(double x, int e);

#undef isfinite
#undef isinf
#undef signbit
#undef NAN
#define isfinite(x) is_a_finite(x)
#define isinf(x)    is_an_infinity(x)
#define signbit(x)  has_a_minus(x)
#define ldexp(x, e) scaled_by(x, e)
#define NAN         no_number()
