// SPDX-License-Identifier: MIT
// The door is at the end here: no condition under which a fast path answers holds
// for an input that is not finite or out of range; the slow paths look for those
// first.
#include "path.h"

#include "event_time.h"
#include "event_time_lanes.h"
#include "event_time_meeting.h"
#include "event_time_parting.h"

// --- Plain ---------------------------------------------------------------------

/** The time that a verdict means, which is certain. */
BRINK_INLINE double told_time(const meeting *m)
{
    const double never = (double)INFINITY;
    double t = if_negative(-m->d, time_of_meeting(m), never);
    return if_negative(m->b, if_negative(m->c, 0, t), never);
}

/** Of a pair that is not certain to miss. */
static BRINK_APART double intersection_time_near(const double r[3],
                                                 const double v[3], double sigma)
{
    if (sigma_in_range(sigma)) {
        sums m = sums_in_lanes(r, v, sigma);
        meeting told = meeting_of(&m);
        double t = told_time(&told); // as a rule it is
        if (is_certain(&told))
            return t;
        look_closer(&m, r, sigma); // on the surface, as likely as not
        told = meeting_of(&m);
        if (is_certain(&told))
            return told_time(&told);
    }
    return brink_intersection_time_slow(r, v, sigma);
}

double brink_intersection_time(const double r[3], const double v[3], double sigma)
{
    if (is_certain_to_miss(r, v, sigma))
        return (double)INFINITY;
    return intersection_time_near(r, v, sigma);
}

/** Of a far pair that is not certain to pass. */
static BRINK_APART double disjoint_time_far(const double r[3], const double v[3],
                                            double sigma)
{
    if (sigma_in_range(sigma)) {
        sums m = sums_in_lanes(r, v, sigma);
        discriminant d = discriminant_of(&m);
        double a = dot_rounded(v, v), b = sum_of(m.b), c = sum_of(m.c);
        if (d.certain)
            return later_root(a, b, c, sqrt(d.d));
    }
    return brink_disjoint_time_slow(r, v, sigma);
}

/** Of a pair that is near, or inside. */
static BRINK_APART double disjoint_time_near(const double r[3], const double v[3],
                                             double sigma)
{
    double a = dot_rounded(v, v), ss = sigma * sigma;
    if (are_in_range(a, ss) && sigma > 0) {
        near_sums m = near_sums_of(dots_in_lanes(r, v), sigma);
        discriminant d = discriminant_near(&m, a);
        double t = later_root(a, m.b, m.c, sqrt(fabs(d.d))); // as a rule it is
        if (d.certain)
            return t;
        look_closer_near(&m, r, sigma); // on the surface, as likely as not
        d = discriminant_near(&m, a);
        if (d.certain)
            return later_root(a, m.b, m.c, sqrt(fabs(d.d)));
    }
    return brink_disjoint_time_slow(r, v, sigma);
}

double brink_disjoint_time(const double r[3], const double v[3], double sigma)
{
    double rr = dot_rounded(r, r), ss = sigma * sigma;
    if (!is_far(rr, ss))
        return disjoint_time_near(r, v, sigma);
    double a = dot_rounded(v, v), b = dot_closely(r, v), c = rr - ss;
    if (passes(a, b, c) && is_passing_known(a, b, c) && sigma > 0x1p-450)
        return passing_time(a, b);
    return disjoint_time_far(r, v, sigma);
}

// --- Correctly rounded ---------------------------------------------------------

/** a, b, c to 11u^2 of their terms' sizes, c to 2^-74 of itself; sqrt(d) + |b| to
 *  2^-78 of itself, if d is large enough for that. */
typedef struct fine_sums {
    dd a, b, c, sum;
    int b_sign, c_sign; // 0 where it is not certain
    int passes_by, is_fine;
} fine_sums;

/**
 * Twice what discriminant_of carries: no rounding of d is left, which was off by
 * 150u^2 Q.  Where d > 2^-20 Q that is 2^-78 of d; the square root halves it, and
 * adds a few u^2 like the sum.  The signs are as certain as in meeting_of.
 */
BRINK_INLINE fine_sums fine_sums_of(const double r[3], const double v[3],
                                    double sigma)
{
    sums m = sums_in_lanes(r, v, sigma);
    if (!is_known(fabs(sum_of(m.c)), 0x1p25 * m.c_error))
        look_closer(&m, r, sigma);
    dd a = m.a, b = two_sum(m.b.hi, m.b.lo);
    dd c = two_sum(m.c.hi, m.c.lo); // their hi may have been less than their lo
    dd p = two_prod(b.hi, b.hi), q = two_prod(a.hi, c.hi);
    dd high = two_sum(p.hi, -q.hi);
    double low = fma(a.hi, c.lo, a.lo * c.hi);
    low = high.lo + fma(2 * b.hi, b.lo, (p.lo - q.lo) - low);
    double d = high.hi + low, size = a.hi * m.size;

    fine_sums f = {a, b, c, {0, 0}, 0, 0, 0, 0};
    int is_b_certain = p.hi > fma(0x1p-200, size, 0x1p-900);
    double c_error = 0x1p25 * m.c_error;
    f.b_sign = is_b_certain ? sign_of(b.hi) : 0;
    f.c_sign = is_known(c.hi, c_error) - is_known(-c.hi, c_error);
    int is_a_fine = a.hi > 0x1p-800;
    f.passes_by = is_a_fine && d < -fma(0x1p-90, size, 0x1p-800);
    f.is_fine = is_a_fine && d > fma(0x1p-20, size, 0x1p-800);

    double root = sqrt(f.is_fine ? d : 1);
    double root_low = (fma(-root, root, high.hi) + low) * (0.5 / root);
    f.sum = two_sum(root, fabs(b.hi));
    f.sum.lo += root_low + copysign(1, b.hi) * b.lo;
    return f;
}

/** x / y rounded, to 2^-74; or -1 where that cannot be told, or has not all
 *  its bits. */
BRINK_INLINE double quotient_told(dd x, dd y)
{
    double inverse = 1 / y.hi, t = x.hi * inverse; // the residual puts it right
    double residual = fma(-t, y.hi, x.hi) + fma(-t, y.lo, x.lo);
    dd told = fast_two_sum(t, residual * inverse);
    int has_all_bits = told.hi > 0x1p-800 && told.hi < 0x1p800;
    return is_told(told) && has_all_bits ? told.hi : -1;
}

double brink_intersection_time_cr(const double r[3], const double v[3],
                                  double sigma)
{
    if (is_certain_to_miss(r, v, sigma))
        return (double)INFINITY;
    if (sigma_in_range(sigma)) {
        fine_sums m = fine_sums_of(r, v, sigma);
        if (m.b_sign > 0 || m.passes_by)
            return (double)INFINITY;
        if (m.b_sign < 0 && m.c_sign < 0)
            return 0;
        if (m.b_sign < 0 && m.c_sign > 0 && m.is_fine) {
            double t = quotient_told(m.c, m.sum);
            if (t > 0)
                return t;
        }
    }
    return brink_intersection_time_slow(r, v, sigma);
}

/** Of a pair that is not far, or not certain to pass; -1 where it cannot be
 *  told. */
BRINK_INLINE double parting_time_told(const double r[3], const double v[3],
                                      double sigma)
{
    fine_sums m = fine_sums_of(r, v, sigma);
    if (m.b_sign > 0 && m.c_sign > 0)
        return 0;
    if (!m.is_fine || (m.b_sign >= 0 && m.c_sign >= 0))
        return -1;
    return m.b.hi > 0 ? quotient_told(dd_negate(m.c), m.sum)
                      : quotient_told(m.sum, m.a);
}

/** The moment of closest approach: b is off by 7u^2 P and P < 33 sqrt(a c), so by
 *  2^-75 of itself where b^2 > 2^-46 a c. */
BRINK_INLINE double passing_time_told(const double r[3], const double v[3],
                                      double ac)
{
    dd a = dot_of(v, v), b = dot_of(r, v);
    b = two_sum(b.hi, b.lo);
    if (!(b.hi * b.hi > 0x1p-46 * ac))
        return -1;
    return b.hi > 0 ? 0 : quotient_told(dd_negate(b), a);
}

double brink_disjoint_time_cr(const double r[3], const double v[3], double sigma)
{
    double a = dot_rounded(v, v), b = dot_rounded(r, v);
    double rr = dot_rounded(r, r), ss = sigma * sigma, c = rr - ss, t = -1;
    if (is_far(rr, ss) && passes(a, b, c) && are_in_range(a, rr) && sigma >= 0)
        t = passing_time_told(r, v, a * c);
    else if (sigma_in_range(sigma))
        t = parting_time_told(r, v, sigma);
    return t >= 0 ? t : brink_disjoint_time_slow(r, v, sigma);
}
