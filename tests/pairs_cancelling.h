// SPDX-License-Identifier: MIT
#ifndef TESTS_PAIRS_CANCELLING_H
#define TESTS_PAIRS_CANCELLING_H
/** Pairs of whose r.v, r.r - sigma^2 or discriminant little or nothing is left:
 *  families for pairs.h. */
#include "pair.h"

/** Passing the sphere within a few ulp of its rim. */
static inline void family_grazing(stream *s, pair_case *p)
{
    double e[3], f[3];
    fill_normal(s, p->v, 1);
    fill_normal(s, f, 1);
    e[0] = p->v[1] * f[2] - p->v[2] * f[1];
    e[1] = p->v[2] * f[0] - p->v[0] * f[2];
    e[2] = p->v[0] * f[1] - p->v[1] * f[0];
    resize(e, 1); // perpendicular to v, up to rounding
    double back = stream_real(s, -0.5, 4);
    for (int i = 0; i < 3; i++)
        p->r[i] = e[i] - back * p->v[i];
    p->sigma = stream_near(s, 1, 2);
}

/** On the rim at r = sigma (1 + a few ulp), hardly moving outward or inward. */
static inline void family_rim(stream *s, pair_case *p)
{
    family_grazing(s, p);
    double b = p->r[0] * p->v[0] + p->r[1] * p->v[1] + p->r[2] * p->v[2];
    double vv = p->v[0] * p->v[0] + p->v[1] * p->v[1] + p->v[2] * p->v[2];
    for (int i = 0; i < 3; i++) // moved to the closest approach
        p->r[i] = stream_near(s, p->r[i] - b / vv * p->v[i], 2);
}

/** Passing the rim as closely as the coordinates' last digits let it, from up to
 *  2^40 diameters away. */
static inline void family_far(stream *s, pair_case *p)
{
    family_grazing(s, p);
    const double back = fabs(stream_scaled(s, 2, 40));
    for (int i = 0; i < 3; i++)
        p->r[i] -= back * p->v[i];
}

/** b = r.v is the product of two small numbers, behind two large products that
 *  cancel entirely; and r.r - sigma^2 likewise, or nearly. */
static inline void family_cancelling(stream *s, pair_case *p)
{
    double a = stream_real(s, 0.5, 1), d = stream_real(s, 0.5, 1);
    int way = stream_int(s, 0, 2);
    p->r[way] = a;
    p->r[(way + 1) % 3] = stream_scaled(s, -80, 0);
    p->r[(way + 2) % 3] = a;
    p->v[way] = d;
    p->v[(way + 1) % 3] = stream_scaled(s, -80, 0);
    p->v[(way + 2) % 3] = stream_int(s, 0, 3) ? -d : stream_near(s, -d, 2);
    p->sigma = stream_near(s, length_of(p->r), 4);
}

/** Passing outside, all but at the closest approach: b is next to nothing. */
static inline void family_passing(stream *s, pair_case *p)
{
    family_grazing(s, p);
    double b = p->r[0] * p->v[0] + p->r[1] * p->v[1] + p->r[2] * p->v[2];
    double vv = p->v[0] * p->v[0] + p->v[1] * p->v[1] + p->v[2] * p->v[2];
    double rest = stream_scaled(s, -54, -10);
    for (int i = 0; i < 3; i++)
        p->r[i] -= (b / vv + rest) * p->v[i];
    p->sigma = stream_real(s, 0.1, 0.99);
}

/** Moving all but along the surface, at any distance from it: r.v is next to
 *  nothing beside |r| |v|, or nothing but what its rounded sum leaves over. */
static inline void family_sideways(stream *s, pair_case *p)
{
    fill_normal(s, p->r, 1);
    fill_normal(s, p->v, 1);
    double b = p->r[0] * p->v[0] + p->r[1] * p->v[1] + p->r[2] * p->v[2];
    double rr = p->r[0] * p->r[0] + p->r[1] * p->r[1] + p->r[2] * p->r[2];
    double rest = stream_scaled(s, -70, -2);
    for (int i = 0; i < 3; i++)
        p->v[i] += (rest - b / rr) * p->r[i];
    p->sigma = sqrt(rr) * (1 + stream_scaled(s, -54, -1));
}

/** As cancelling, but far from the sphere, so that b is the time's numerator. */
static inline void family_missing(stream *s, pair_case *p)
{
    family_cancelling(s, p);
    p->sigma *= stream_real(s, 0.1, 0.9);
}

/** r.v is 0 but for what one number was rounded by: in integers of up to 53 bits
 *  r_0 v_0 + r_1 v_1 = 1, the determinant of a product of shears, and r_2 v_2 =
 *  n (-1 / n). */
static inline void family_upright(stream *s, pair_case *p)
{
    double x = 1, y = 0, z = 0, w = 1; // x w - y z = 1
    while (fabs(x) + fabs(y) < 0x1p50 && fabs(z) + fabs(w) < 0x1p50) {
        const double k = stream_sign(s) * stream_int(s, 1, 7), old_x = x,
                     old_y = y;
        x = z + k * x;
        y = w + k * y;
        z = -old_x;
        w = -old_y;
    }
    const int n = 2 * stream_int(s, 1, 50) + 1;
    *p = (pair_case){{x, y, n}, {w, -z, -1.0 / n}, 0};
    p->sigma = length_of(p->r) * (1 + stream_scaled(s, -54, -1));
}

/** r.r - sigma^2 is what one number was rounded by: x^2 + y^2 + 3 = sigma^2, kept
 *  by the matrices by which Pythagorean triples come from one another, until they
 *  have 53 bits; and the root of 3. */
static inline void family_triple(stream *s, pair_case *p)
{
    double x = 0, y = 1, z = 2;
    while (z < 0x1p53 / 5.9) { // 3 + 2 sqrt(2) is the most it grows by
        const double a = x * stream_sign(s), b = y * stream_sign(s), c = z;
        x = a - 2 * b + 2 * c;
        y = 2 * a - b + 2 * c;
        z = 2 * a - 2 * b + 3 * c;
    }
    p->r[0] = x;
    p->r[1] = y;
    p->r[2] = stream_near(s, sqrt(3), 1);
    p->sigma = z;
    fill_normal(s, p->v, 1);
}

/** One coordinate closes the gap that the others leave to sigma^2, but for 2^-108
 *  to 2^-45 of it, of either sign. */
static inline void family_closing(stream *s, pair_case *p)
{
    const int first = stream_int(s, 0, 2);
    p->sigma = stream_real(s, 1, 2);
    const double x = 0.9 * fabs(stream_scaled(s, -12, 0));
    const double y = nextafter(sqrt(fma(p->sigma, p->sigma, -x * x)), 0);
    const double ss = p->sigma * p->sigma, xx = x * x, yy = y * y;
    // What is left over, to 64 bits: differences of the leading parts are exact.
    const long double low_ss = (long double)fma(p->sigma, p->sigma, -ss);
    const long double low_xx = (long double)fma(x, x, -xx);
    const long double low_yy = (long double)fma(y, y, -yy);
    const long double gap =
        (long double)(ss - xx - yy) + (low_ss - low_xx - low_yy);
    p->r[first] = x * stream_sign(s);
    p->r[(first + 1) % 3] = y * stream_sign(s);
    const long double beyond = gap + (long double)stream_scaled(s, -108, -45);
    p->r[(first + 2) % 3] = (double)sqrtl(fabsl(beyond));
    fill_normal(s, p->v, 1);
}

/** Just outside, or inside, and so nearly along the surface that b^2 is not much
 *  more than a c, or hardly at all. */
static inline void family_skimming(stream *s, pair_case *p)
{
    double normal[3];
    fill_normal(s, normal, 1);
    resize(normal, 1);
    fill_normal(s, p->v, 1);
    double along =
        p->v[0] * normal[0] + p->v[1] * normal[1] + p->v[2] * normal[2];
    const double gap = stream_scaled(s, -53, -9); // c = 2 gap, all but
    const double more = stream_int(s, 0, 1) ? stream_real(s, 0.9, 3)
                                            : 1 + stream_scaled(s, -30, -1);
    for (int i = 0; i < 3; i++) {
        p->r[i] = (1 + gap) * normal[i];
        p->v[i] -= along * normal[i];
    }
    const double slope = sqrt(2 * fabs(gap) * more);
    const double speed = length_of(p->v), way = stream_int(s, 0, 3) ? -1 : 1;
    for (int i = 0; i < 3; i++)
        p->v[i] += way * slope * speed * normal[i];
    p->sigma = 1;
}

/** x y + z w, when that cancels: to a few ulp. */
static inline double two_products(double x, double y, double z, double w)
{
    double p = x * y, q = z * w;
    return (p + q) + (fma(x, y, -p) + fma(z, w, -q));
}

/** r.v and r.r - sigma^2 cancel to 2^-53 in two of their terms, and what is left
 *  once more, to some 2^-106: less than sums know that carry their errors. */
static inline void family_remainder(stream *s, pair_case *p)
{
    double *r = p->r, *v = p->v, left;
    do {
        r[0] = stream_real(s, 0.25, 1);
        r[1] = fabs(stream_scaled(s, -20, 0));
        p->sigma = nextafter(sqrt(r[0] * r[0] + r[1] * r[1]), 4);
        left = two_products(p->sigma - r[0], p->sigma + r[0], -r[1], r[1]);
    } while (left <= 0);
    r[2] = stream_near(s, sqrt(left), 2);
    v[0] = stream_real(s, 0.5, 1) * stream_sign(s);
    v[1] = -r[0] * v[0] / r[1];
    v[2] = stream_near(s, -two_products(r[0], v[0], r[1], v[1]) / r[2], 2);
    int way = stream_int(s, 0, 3); // one of the two alone, or both
    if (way == 0)
        fill_normal(s, v, 1);
    if (way == 1)
        p->sigma *= 1 - fabs(stream_scaled(s, -40, 0));
}
#endif
