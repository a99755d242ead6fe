// SPDX-License-Identifier: MIT
#ifndef BRINK_EVENT_TIME_FAST_H
#define BRINK_EVENT_TIME_FAST_H
/**
 * The fast times: to some eps of the surface, of whatever magnitude the pair is;
 * not installed.  Names and bounds as in event_time_sums.h.
 */
#include "event_time_parting.h"

// --- Meeting -------------------------------------------------------------------

/**
 * a, b, d, and the w = |r x v|^2 that is in it, each rounded a few times.
 *
 * The time (-b - sqrt(d)) / a, or 0 if that is negative, puts the pair within 8
 * eps (sigma + |v| t) of the surface.  What cancels is lost beside sigma and |v|
 * t: where the pair is, it is off by 3u |r| for b and by u sigma for the root, of
 * a number that is off as if sigma and the closest approach were, by 4.5u sigma
 * for the squares and 2u |r| for the cross product, whose error is u |r_i v_j| a
 * product.  a, the sum and the quotient make 5u |v| t.  With |r| <= sigma + |v| t
 * all are 10.5u sigma + 10u |v| t, or 5.3 eps.
 */
typedef struct outline {
    double a, b, minus_d, w;
} outline;

BRINK_INLINE outline outline_of(const double r[3], const double v[3],
                                double sigma)
{
    double x = fma(r[1], v[2], -(r[2] * v[1]));
    double y = fma(r[2], v[0], -(r[0] * v[2]));
    double z = fma(r[0], v[1], -(r[1] * v[0]));
    double a = dot_rounded(v, v), w = fma(x, x, fma(y, y, z * z));
    double b = fma(r[0], v[0], fma(r[1], v[1], fma(r[2], v[2], 0))); // not -0
    return (outline){a, b, fma(-(sigma * sigma), a, w), w};
}

/** Whether |v|^2 and |r|^2 |v|^2 = b^2 + w, and with them all that is made of
 *  them, are within 2^-256 and 2^256, and sigma is a radius.  If it is so large
 *  that its square is infinite all is well: so is d, and the time 0. */
BRINK_INLINE int is_in_range_fast(const outline *o, double sigma)
{
    return are_in_range(o->a, fma(o->b, o->b, o->w)) & is_radius(sigma);
}

/** Of a pair that is in range: which of them meet is nothing to be foreseen, so
 *  no branch. */
BRINK_INLINE double meeting_time_fast(const outline *o)
{
    const double never = (double)INFINITY;
    double t = fabs(smaller(o->b + sqrt(fabs(o->minus_d)), 0)) / o->a;
    return if_negative(o->b, if_negative(o->minus_d, t, never), never);
}

// --- Parting -------------------------------------------------------------------
//
// How far from the surface the pair can be at the time answered, in u: 16 sigma
// + 16 |v| t are allowed.  It moves outward at a speed of sqrt(d) / sigma <= |v|,
// and an error e of a t^2 + 2 b t + c is e / (2 sigma).
//
//     far           as for the time of meeting
//     near, b > 0   a root of the polynomial of a, b, c as they are rounded:
//                   3 a t^2 + 6 |r| |v| t + 4 sigma^2, so 6 |v| t + 2 sigma, as
//                   |v| t <= 2 sigma.  a c, d, root, sum and quotient: 4 |v| t
//     near, b <= 0  b: 3 |r| < 3.1 sigma; c: 2.1 sigma; a and a c in d: 2 sigma;
//                   d: 0.6 sigma; and 6 |v| t as above
//
// To first order an error of the time does not displace a pair that passes by.

/** sqrt(max(0, d)), never a branch; smaller() would keep a loop from becoming
 *  vectors. */
BRINK_INLINE double root_of_chord(double d)
{
    return sqrt(0.5 * twice_below(-d));
}

/** Of a pair that is in range. */
BRINK_INLINE double parting_time_fast(const double r[3], const double v[3],
                                      double sigma)
{
    double a = dot_rounded(v, v), b = dot_rounded(r, v);
    double rr = dot_rounded(r, r), ss = sigma * sigma, c = rr - ss;
    if (!is_far(rr, ss))
        return later_root(a, b, c, root_of_chord(fma(b, b, -a * c)));
    if (passes(a, b, c))
        return passing_time(a, b);
    return (sqrt(fabs(smaller(outline_of(r, v, sigma).minus_d, 0))) - b) / a;
}

// --- Out of range --------------------------------------------------------------

/** A pair in units of its own: powers of two by which its lengths and
 *  velocities become of order 1. */
typedef struct scaled_pair {
    double r[3], v[3], sigma;
    int unit; // times are in units of 2^unit, |unit| <= 2 * 1022
} scaled_pair;

BRINK_INLINE double largest_of(const double x[3])
{
    return larger(larger(fabs(x[0]), fabs(x[1])), fabs(x[2]));
}

/** 0 where the pair is not in the domain. */
BRINK_INLINE int scale_pair(scaled_pair *p, const double r[3], const double v[3],
                            double sigma)
{
    double length = larger(sigma, largest_of(r)), speed = largest_of(v);
    int er = common_exponent(1, &length), ev = common_exponent(1, &speed);
    double fr = power_of_two(-er), fv = power_of_two(-ev), sum = 0;
    for (int i = 0; i < 3; i++) {
        p->r[i] = r[i] * fr;
        p->v[i] = v[i] * fv;
        sum += p->r[i] + p->v[i];
    }
    p->sigma = sigma * fr;
    p->unit = er - ev;
    return (sum - sum == 0) & (sigma >= 0) & (p->sigma < 4);
}
#endif
