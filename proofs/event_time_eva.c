// SPDX-License-Identifier: MIT
// with: -warn-special-float nan -eva-use-spec choose,twice_below
/**
 * No invalid operation, and so no NaN, where a time is made: for every input in a
 * box as large as the doors let through and more, by cases of sign, each time is
 * not negative; only where it is too large for a double is it +inf.  Eva raises
 * an alarm at any operation that might give NaN, 0 / 0 above all.
 */
#include "libm_eva.h"

#include "../kernels/exact.h"

/*@ // A choice by masks of bits, which Eva does not see through.
  @ requires \is_finite(x) && \is_finite(y);
  @ assigns \result \from first, x, y;
  @ behavior first:
  @   assumes first != 0;
  @   ensures \is_finite(\result) && \result == x;
  @ behavior second:
  @   assumes first == 0;
  @   ensures \is_finite(\result) && \result == y;
  @ complete behaviors;
  @ disjoint behaviors;
  @*/
static double choose(int first, double x, double y);

/*@ // A difference that is not negative is not rounded to a negative number; Eva
  @ // does not see that its terms have to do with each other.
  @ requires \is_finite(x) && -0x1p1000 <= x <= 0x1p1000;
  @ assigns \result \from x;
  @ ensures \is_finite(\result) && 0 <= \result <= 0x1p1001;
  @*/
static double twice_below(double x);

#include "../kernels/event_time_fast.h"
#include "../kernels/event_time_meeting.h"

#define LARGEST 0x1p500
#define LEAST   0x1p-1074

/** A number of that sign, 1, 0 or -1. */
static double any(int sign)
{
    if (sign > 0)
        return Frama_C_double_interval(LEAST, LARGEST);
    if (sign < 0)
        return Frama_C_double_interval(-LARGEST, -LEAST);
    return 0;
}

/** The later root and the closest approach: any signs of b and c, and a > 0. */
static void parting(int b_sign, int c_sign)
{
    double a = any(1), b = any(b_sign), c = any(c_sign);
    double root = Frama_C_double_interval(0, LARGEST);
    double later = later_root(a, b, c, root);
    //@ assert later_root: later >= 0;
    double passing = passing_time(a, b);
    //@ assert passing: passing >= 0;
    double rim = root_of_chord(Frama_C_double_interval(-LARGEST, LARGEST));
    //@ assert chord: rim >= 0;
    double d = any(1) * any(1);
    double far = (sqrt(fabs(smaller(-d, 0))) - any(-1)) / a;
    //@ assert far: far >= 0;
}

/** Of a pair that meets later: from outside, b < 0, whatever d is. */
static void coming(void)
{
    meeting m = {any(-1), any(1), Frama_C_double_interval(-LARGEST, LARGEST),
                 0,       0,      1};
    double later = time_of_meeting(&m);
    //@ assert later: later >= 0;
}

/** The fast time of meeting, of any b and d, and w, which it does not ask. */
static void meeting_fast(int b_sign)
{
    outline o = {any(1), any(b_sign), Frama_C_double_interval(-LARGEST, LARGEST),
                 0};
    double t = meeting_time_fast(&o);
    //@ assert fast: t >= 0;
}

/** The numbers themselves: of any pair whose components are at most 2^100. */
static void outlines(void)
{
    double r[3], v[3], sigma = Frama_C_double_interval(0, 0x1p100);
    for (int i = 0; i < 3; i++) {
        r[i] = Frama_C_double_interval(-0x1p100, 0x1p100);
        v[i] = Frama_C_double_interval(-0x1p100, 0x1p100);
    }
    outline o = outline_of(r, v, sigma);
    //@ assert \is_finite(o.a) && \is_finite(o.b);
    //@ assert \is_finite(o.w) && \is_finite(o.minus_d);
}

int main(void)
{
    for (int b = -1; b <= 1; b++) {
        for (int c = -1; c <= 1; c++)
            parting(b, c);
        meeting_fast(b);
    }
    coming();
    outlines();
    return 0;
}
