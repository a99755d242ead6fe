// SPDX-License-Identifier: MIT
// The door is at the end here: no condition under which a fast path answers holds
// for an input that is not finite or out of range; the slow paths look for those
// first.
#include "path.h"

#include "event_time.h"
#include "event_time_lanes.h"
#include "event_time_parting.h"

// --- Plain ---------------------------------------------------------------------

/** Of a pair that approaches and is touching; -1 where it is not certain. */
BRINK_INLINE double touching_time(const double r[3], const double v[3],
                                  double sigma)
{
    sums m = sums_in_lanes(r, v, sigma);
    double a = dot_rounded(v, v), t = meeting_time_touching(&m, a, 1);
    if (t < 0 && !is_known(sum_of(m.c), 8 * m.c_error)) { // on the surface
        look_closer(&m, r, sigma);
        t = meeting_time_touching(&m, a, 1);
    }
    return t;
}

double brink_intersection_time(const double r[3], const double v[3], double sigma)
{
    rate b = rate_of(r, v);
    if (sigma_in_range(sigma)) {
        if (is_positive(b))
            return (double)INFINITY;
        if (is_negative(b)) {
            double t = is_touching(r, sigma) ? touching_time(r, v, sigma) : -1;
            if (t >= 0)
                return t;
            if (passes_by(chord_of(r, v, sigma)))
                return (double)INFINITY;
            sums m = sums_in_lanes(r, v, sigma);
            t = meeting_time(&m, dot_of(v, v), 1);
            if (t >= 0)
                return t;
        }
    }
    return brink_intersection_time_slow(r, v, sigma);
}

/** Of a far pair that is not certain to pass. */
static BRINK_APART double disjoint_time_far(const double r[3], const double v[3],
                                            double sigma)
{
    if (sigma_in_range(sigma)) {
        sums m = sums_in_lanes(r, v, sigma);
        discriminant d = discriminant_of(dot_of(v, v), &m);
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
    int c_sign, is_fine; // 0 where the sign is not certain; where d is not
} fine_sums;

/**
 * Twice what discriminant_of carries: no rounding of d is left, which was off by
 * 150u^2 Q.  Where d > 2^-20 Q that is 2^-78 of d; the square root halves it, and
 * adds a few u^2 like the sum.
 */
BRINK_INLINE fine_sums fine_sums_of(const double r[3], const double v[3],
                                    double sigma)
{
    sums m = sums_in_lanes(r, v, sigma);
    if (!is_known(fabs(sum_of(m.c)), 0x1p25 * m.c_error))
        look_closer(&m, r, sigma);
    dd a = dot_of(v, v), b = two_sum(m.b.hi, m.b.lo);
    dd c = two_sum(m.c.hi, m.c.lo); // their hi may have been less than their lo
    dd p = two_prod(b.hi, b.hi), q = two_prod(a.hi, c.hi);
    dd high = two_sum(p.hi, -q.hi);
    double low = fma(a.hi, c.lo, a.lo * c.hi);
    low = high.lo + fma(2 * b.hi, b.lo, (p.lo - q.lo) - low);
    double d = high.hi + low, least = fma(0x1p-20 * a.hi, m.size, 0x1p-800);
    int is_fine = a.hi > 0x1p-800 && d > least;
    double c_error = 0x1p25 * m.c_error;
    int c_sign = is_known(c.hi, c_error) - is_known(-c.hi, c_error);

    double root = sqrt(is_fine ? d : 1);
    double root_low = (fma(-root, root, high.hi) + low) * (0.5 / root);
    dd sum = two_sum(root, fabs(b.hi));
    sum.lo += root_low + copysign(1, b.hi) * b.lo;
    return (fine_sums){a, b, c, sum, c_sign, is_fine};
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
    rate b = rate_of(r, v);
    if (sigma_in_range(sigma)) {
        if (is_positive(b))
            return (double)INFINITY;
        if (is_negative(b)) {
            if (passes_by(chord_of(r, v, sigma)))
                return (double)INFINITY;
            fine_sums m = fine_sums_of(r, v, sigma);
            if (m.c_sign < 0)
                return 0;
            double t = m.is_fine && m.c_sign > 0 ? quotient_told(m.c, m.sum) : -1;
            if (t > 0)
                return t;
        }
    }
    return brink_intersection_time_slow(r, v, sigma);
}

double brink_disjoint_time_cr(const double r[3], const double v[3], double sigma)
{
    rate b = rate_of(r, v);
    if (sigma_in_range(sigma)) {
        int outside = is_far_outside(r, sigma);
        if (outside && is_positive(b))
            return 0;
        double t = -1;
        if (outside && is_negative(b) && passes_by(chord_of(r, v, sigma))) {
            dd fine_b = dot_of(r, v);
            fine_b = two_sum(fine_b.hi, fine_b.lo);
            if (b.value < -0x1p31 * b.error) // |b| > 2^-20 P: 7u^2 P are not much
                t = quotient_told(dd_negate(fine_b), dot_of(v, v));
        } else {
            fine_sums m = fine_sums_of(r, v, sigma);
            if (m.c_sign > 0 && is_positive(b))
                return 0;
            if (m.is_fine && (is_negative(b) || m.c_sign < 0))
                t = m.b.hi > 0 ? quotient_told(dd_negate(m.c), m.sum)
                               : quotient_told(m.sum, m.a);
        }
        if (t > 0)
            return t;
    }
    return brink_disjoint_time_slow(r, v, sigma);
}
