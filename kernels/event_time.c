// SPDX-License-Identifier: MIT
// The door is at the end here: no condition under which a fast path answers holds
// for an input that is not finite or out of range, and the slow paths look for
// those first.
#include "isa.h"

#include "event_time.h"
#include "event_time_lanes.h"

// --- Plain
// ---------------------------------------------------------------------------

double brink_intersection_time(const double r[3], const double v[3], double sigma)
{
    rate b = rate_of(r, v);
    if (sigma_in_range(sigma)) {
        if (is_positive(b))
            return (double)INFINITY;
        if (is_negative(b)) {
            if (passes_by(chord_of(r, v, sigma)))
                return (double)INFINITY;
            sums m = sums_in_lanes(r, v, sigma);
            double t = meeting_time(&m, dot_of(v, v), 1);
            if (t >= 0)
                return t;
        }
    }
    return brink_intersection_time_slow(r, v, sigma);
}

double brink_disjoint_time(const double r[3], const double v[3], double sigma)
{
    rate b = rate_of(r, v);
    if (sigma_in_range(sigma)) {
        int outside = is_far_outside(r, sigma);
        if (outside && is_positive(b))
            return 0;
        if (outside && is_negative(b) && passes_by(chord_of(r, v, sigma)))
            return -sum_of(dot_of(r, v)) /
                   dot_rounded(v, v); // as parting_time has it
        sums m = sums_in_lanes(r, v, sigma);
        double t = parting_time(&m, dot_rounded(v, v), b, 0);
        if (t >= 0)
            return t;
    }
    return brink_disjoint_time_slow(r, v, sigma);
}

// --- Fast
// ----------------------------------------------------------------------------

double brink_intersection_time_fast(const double r[3], const double v[3],
                                    double sigma)
{
    double b = dot_rounded(r, v);
    if (is_in_range(b) && sigma_in_range(sigma))
        return (double)INFINITY;
    double rr = dot_rounded(r, r), ss = sigma * sigma, c = rr - ss;
    chord k = chord_of(r, v, sigma);
    if (!(are_in_range(k.a, rr, ss) && sigma > 0))
        return brink_intersection_time_slow(r, v, sigma);
    if (b >= 0)
        return (double)INFINITY;
    if (c <= 0)
        return 0;
    if (k.d <= 0)
        return (double)INFINITY;
    double sum = sqrt(k.d) - b;
    return is_too_late(b, c, k, sum) ? -b / k.a : c / sum;
}

double brink_disjoint_time_fast(const double r[3], const double v[3],
                                double sigma)
{
    static const chord none = {0, 0, 0};
    double b = dot_rounded(r, v), c = dot_rounded(r, r) - sigma * sigma;
    if (sigma_in_range(sigma)) {
        if (is_in_range(b) && c >= 0 && c < 0x1p1000)
            return 0;
        chord outside = c < 0 ? none : chord_of(r, v, sigma);
        double t = parting_time_fast(dot_rounded(v, v), b, c, outside);
        if (t >= 0)
            return t;
    }
    return brink_disjoint_time_slow(r, v, sigma);
}

// --- Correctly rounded
// ---------------------------------------------------------------

/** a, b, c with |lo| <= u |hi|. */
typedef struct fine_sums {
    dd a, b, c;
    double size;
} fine_sums;

BRINK_INLINE fine_sums fine_sums_of(const double r[3], const double v[3],
                                    double sigma)
{
    sums m = sums_in_lanes(r, v, sigma);
    dd a = dot_of(v, v);
    return (fine_sums){two_sum(a.hi, a.lo), two_sum(m.b.hi, m.b.lo),
                       two_sum(m.c.hi, m.c.lo), m.size};
}

/** d where it is larger than 2^-20 Q, otherwise 0; error <= 2^-79 of it: 5u^2 Q
 * for either product, 32u^2 Q for what a, b, c are off. */
BRINK_INLINE dd fine_discriminant(const fine_sums *m)
{
    dd d = dd_add(dd_mul(m->b, m->b), dd_negate(dd_mul(m->a, m->c)));
    double least = fma(0x1p-20 * m->a.hi, m->size, 0x1p-800);
    return m->a.hi > 0x1p-800 && d.hi > least ? d : (dd){0, 0};
}

/** t rounded; or -1 where that cannot be told, or t has not all its bits. */
BRINK_INLINE double rounded(dd t)
{
    return is_told(t) && t.hi > 0x1p-900 && t.hi < 0x1p900 ? t.hi : -1;
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
            if (m.c.hi < -0x1p-102 * m.size)
                return 0;
            // c is off by 11u^2 R <= 2^-74 c
            dd d = fine_discriminant(&m),
               sum = dd_add(dd_sqrt(d), dd_negate(m.b));
            double t = rounded(dd_div(m.c, sum));
            if (m.c.hi > 0x1p-28 * m.size && d.hi > 0 && t > 0)
                return t;
        }
    }
    return brink_intersection_time_slow(r, v, sigma);
}

double brink_disjoint_time_cr(const double r[3], const double v[3], double sigma)
{
    rate b = rate_of(r, v);
    if (sigma_in_range(sigma)) {
        if (is_far_outside(r, sigma)) {
            if (is_positive(b))
                return 0;
        }
        fine_sums m = fine_sums_of(r, v, sigma);
        double t = -1;
        if (is_negative(b) && passes_by(chord_of(r, v, sigma))) {
            if (b.value <
                -0x1p31 * b.error) // |b| > 2^-20 P, so 7u^2 P are not much
                t = rounded(dd_div(dd_negate(m.b), m.a));
        } else {
            dd d = fine_discriminant(&m), root = dd_sqrt(d);
            if (d.hi > 0 && (is_negative(b) || m.c.hi < -0x1p-28 * m.size))
                t = rounded(m.b.hi > 0
                                ? dd_div(dd_negate(m.c), dd_add(root, m.b))
                                : dd_div(dd_add(root, dd_negate(m.b)), m.a));
        }
        if (t > 0)
            return t;
    }
    return brink_disjoint_time_slow(r, v, sigma);
}
