// SPDX-License-Identifier: MIT
// The door is at the end here: no condition under which a fast path answers holds
// for an input that is not finite or out of range, and the slow paths look for
// those first.
#include "event_time.h"
#include "path.h"
#include "paths.h"

#define PARAMETERS (const double r[3], const double v[3], double sigma)
#define ARGUMENTS  (r, v, sigma)

/** d where it is larger than 2^-44 Q, otherwise 0; error <= 2.4u d.  The products
 * are exact; what follows their leading parts is below 18u Q and takes fewer than
 * ten roundings, which with what a, b, c are off makes 150u^2 Q, or 0.3u of 2^-44
 * Q. */
BRINK_INLINE double discriminant_of(const sums *m)
{
    dd p = two_prod(m->b.hi, m->b.hi), q = two_prod(m->a.hi, m->c.hi);
    double rest = fma(m->a.hi, m->c.lo, m->a.lo * m->c.hi);
    rest = fma(2 * m->b.hi, m->b.lo, (p.lo - q.lo) - rest);
    double d = (p.hi - q.hi) + rest; // two roundings
    int whole =
        m->a.hi > 0x1p-900 && d > fma(0x1p-44 * m->a.hi, m->size, 0x1p-900);
    return whole ? d : 0;
}

BRINK_INLINE double brink_intersection_time_body PARAMETERS
{
    rate b = rate_of(r, v);
    int in_range = sigma_in_range(sigma);
    if (b.value > b.error && in_range)
        return (double)INFINITY; // receding
    if (b.value < -b.error && in_range) {
        if (passes_by(chord_of(r, v, sigma)))
            return (double)INFINITY;
        sums m = sums_of(r, v, sigma);
        double c = sum_of(m.c), d = discriminant_of(&m);
        if (c < -0x1p-102 * m.size)
            return 0; // overlapping and approaching
        // c is off by 1u + 12u^2 R / c <= 4u; sqrt(d), half of the sum at most,
        // by 2.2u; b by 1u; sum and quotient are rounded: 4 + (2.2 + 1) / 2 + 2
        // < 8.
        if (c > 0x1p-51 * m.size && d > 0)
            return c / (sqrt(d) - sum_of(m.b));
    }
    return brink_intersection_time_slow(r, v, sigma);
}

/** d where it is larger than 2^-20 Q, otherwise 0; error <= 2^-79 of it: 5u^2 Q
 * for either product, 36u^2 Q for what a, b, c are off. */
BRINK_INLINE dd discriminant_dd(const sums *m)
{
    dd d = dd_add(dd_mul(m->b, m->b), dd_negate(dd_mul(m->a, m->c)));
    int whole =
        m->a.hi > 0x1p-800 && d.hi > fma(0x1p-20 * m->a.hi, m->size, 0x1p-800);
    return whole ? d : (dd){0, 0};
}

/** The double nearest to t, which is known to 2^-72 of itself; -1 if it cannot be
 * told, or is so large or small that t has not all its bits. */
BRINK_INLINE double rounded(dd t)
{
    double slack = 0x1p-72 * t.hi;
    int told = t.hi + (t.lo + slack) == t.hi + (t.lo - slack);
    return told && t.hi > 0x1p-900 && t.hi < 0x1p900 ? t.hi : -1;
}

BRINK_INLINE double brink_intersection_time_cr_body PARAMETERS
{
    rate b = rate_of(r, v);
    int in_range = sigma_in_range(sigma);
    if (b.value > b.error && in_range)
        return (double)INFINITY;
    if (b.value < -b.error && in_range) {
        if (passes_by(chord_of(r, v, sigma)))
            return (double)INFINITY;
        sums m = normalised(sums_of(r, v, sigma));
        dd d = discriminant_dd(&m);
        if (m.c.hi < -0x1p-102 * m.size)
            return 0;
        if (m.c.hi > 0x1p-28 * m.size && d.hi > 0) { // c: 12u^2 R <= 2^-74 c
            double t = rounded(dd_div(m.c, dd_add(dd_sqrt(d), dd_negate(m.b))));
            if (t > 0)
                return t;
        }
    }
    return brink_intersection_time_slow(r, v, sigma);
}

BRINK_INLINE double brink_intersection_time_fast_body PARAMETERS
{
    double b = dot_rounded(r, v);
    int in_range = sigma_in_range(sigma);
    if (b > 0x1p-900 && b < 0x1p1000 && in_range)
        return (double)INFINITY;
    if (b < -0x1p-900 && in_range) {
        double c = dot_rounded(r, r) - sigma * sigma;
        chord k = chord_of(r, v, sigma);
        if (k.a > 0x1p-900 && k.s < 0x1p1000 && c < 0x1p1000) {
            if (c <= 0)
                return 0;
            if (k.d <= 0)
                return (double)INFINITY;
            // On the rim c and d are nothing but their errors, which need not
            // agree: the pair is there no later than at its closest approach.
            double sum = sqrt(k.d) - b;
            return k.a * c <= -b * sum ? c / sum : -b / k.a;
        }
    }
    return brink_intersection_time_slow(r, v, sigma);
}

BRINK_INLINE double brink_disjoint_time_body PARAMETERS
{
    rate rough = rate_of(r, v);
    sums m = sums_of(r, v, sigma);
    double a = sum_of(m.a), b = sum_of(m.b), c = sum_of(m.c);
    int approaching = rough.value < -rough.error;
    if (sigma_in_range(sigma)) {
        if (rough.value > rough.error && c > 0x1p-102 * m.size)
            return 0; // outside and parting
        if (approaching && passes_by(chord_of(r, v, sigma)))
            return -b /
                   a; // closest approach; |b| > 4u P, so it is off by 1u + 2u
        // sqrt(d) and b are off by 2.2u and 1u, c by 1u + 12u^2 R / c <= 2.5u, a
        // by 1u; sum and quotient are rounded: 2.5 + 2.2 + 2 < 8.
        double d = discriminant_of(&m);
        if (d > 0 && (approaching || c < -0x1p-50 * m.size))
            return b > 0 ? -c / (sqrt(d) + b) : (sqrt(d) - b) / a;
    }
    return brink_disjoint_time_slow(r, v, sigma);
}

BRINK_INLINE double brink_disjoint_time_cr_body PARAMETERS
{
    rate rough = rate_of(r, v);
    sums m = normalised(sums_of(r, v, sigma));
    int approaching = rough.value < -rough.error;
    if (sigma_in_range(sigma)) {
        if (rough.value > rough.error && m.c.hi > 0x1p-102 * m.size)
            return 0;
        double t = -1;
        if (approaching && passes_by(chord_of(r, v, sigma))) {
            if (rough.value < -0x1p31 * rough.error) // |b| > 2^-20 P
                t = rounded(dd_div(dd_negate(m.b), m.a));
        } else {
            dd d = discriminant_dd(&m), s = dd_sqrt(d);
            if (d.hi > 0 && (approaching || m.c.hi < -0x1p-28 * m.size))
                t = rounded(m.b.hi > 0 ? dd_div(dd_negate(m.c), dd_add(s, m.b))
                                       : dd_div(dd_add(s, dd_negate(m.b)), m.a));
        }
        if (t > 0)
            return t;
    }
    return brink_disjoint_time_slow(r, v, sigma);
}

BRINK_INLINE double brink_disjoint_time_fast_body PARAMETERS
{
    double b = dot_rounded(r, v), c = dot_rounded(r, r) - sigma * sigma;
    if (sigma_in_range(sigma) && c < 0x1p1000) {
        if (b > 0x1p-900 && b < 0x1p1000 && c >= 0)
            return 0;
        double a = dot_rounded(v, v);
        if (c >= 0 && b < -0x1p-900) {
            chord k = chord_of(r, v, sigma);
            if (k.a > 0x1p-900 && k.s < 0x1p1000)
                return ((k.d > 0 ? sqrt(k.d) : 0) - b) / a;
        }
        double d = fma(b, b, -a * c);
        if (c < 0 && a > 0x1p-900 && d > 0x1p-900 && d < 0x1p1000)
            return b > 0 ? -c / (sqrt(d) + b) : (sqrt(d) - b) / a;
    }
    return brink_disjoint_time_slow(r, v, sigma);
}

BRINK_SCALAR_PATHS(double, brink_intersection_time, PARAMETERS, ARGUMENTS)
BRINK_SCALAR_PATHS(double, brink_intersection_time_cr, PARAMETERS, ARGUMENTS)
BRINK_SCALAR_PATHS(double, brink_intersection_time_fast, PARAMETERS, ARGUMENTS)
BRINK_SCALAR_PATHS(double, brink_disjoint_time, PARAMETERS, ARGUMENTS)
BRINK_SCALAR_PATHS(double, brink_disjoint_time_cr, PARAMETERS, ARGUMENTS)
BRINK_SCALAR_PATHS(double, brink_disjoint_time_fast, PARAMETERS, ARGUMENTS)
