// SPDX-License-Identifier: MIT
#ifndef TESTS_PAIRS_H
#define TESTS_PAIRS_H
/**
 * Families of pairs: what a kernel meets in a simulation, and what breaks
 * kernels.  Shared by the tests, the ulp tool and the bench.
 */
#include "random.h"
#include <string.h>

typedef struct pair_case {
    double r[3], v[3], sigma;
} pair_case;

static inline void fill_normal(stream *s, double x[3], double scale)
{
    for (int i = 0; i < 3; i++)
        x[i] = scale * stream_normal(s);
}

static inline double length_of(const double x[3])
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

static inline void resize(double x[3], double length)
{
    double factor = length / length_of(x);
    for (int i = 0; i < 3; i++)
        x[i] *= factor;
}

/** Partners somewhere in a box of 20 diameters: most never meet. */
static inline void family_dilute(stream *s, pair_case *p)
{
    for (int i = 0; i < 3; i++)
        p->r[i] = stream_real(s, -10, 10);
    fill_normal(s, p->v, 1);
    p->sigma = 1;
}

/** Aimed at the sphere from up to 20 diameters away. */
static inline void family_hits(stream *s, pair_case *p)
{
    double aim[3];
    fill_normal(s, p->r, 1);
    resize(p->r, stream_real(s, 1, 20));
    fill_normal(s, aim, 1);
    resize(aim, 0.99 * cbrt(stream_real(s, 0, 1)));
    double speed = stream_real(s, 0.1, 3) / length_of(p->r);
    for (int i = 0; i < 3; i++)
        p->v[i] = speed * (aim[i] - p->r[i]);
    p->sigma = 1;
}

/** Neighbours in a fluid: 1 to 1.6 diameters apart, any velocity. */
static inline void family_neighbours(stream *s, pair_case *p)
{
    fill_normal(s, p->r, 1);
    resize(p->r, stream_real(s, 1, 1.6));
    fill_normal(s, p->v, 1);
    p->sigma = 1;
}

/** Just after or before an event: on the surface to a few ulp. */
static inline void family_contact(stream *s, pair_case *p)
{
    fill_normal(s, p->r, 1);
    resize(p->r, 1 + stream_int(s, -4, 4) * 0x1p-52);
    fill_normal(s, p->v, 1);
    p->sigma = 1;
}

/** Inside, as captured pairs are. */
static inline void family_captured(stream *s, pair_case *p)
{
    fill_normal(s, p->r, 1);
    resize(p->r, cbrt(stream_real(s, 0, 1)));
    fill_normal(s, p->v, 1);
    p->sigma = 1;
}

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

/** On the rim, moving along an axis: b = r.v is a single product and certain
 *  however small, while c = r.r - sigma^2 cancels, to the last bit where r's
 *  part across the axis is (3, 4) m and sigma 5 m. */
static inline void family_axial(stream *s, pair_case *p)
{
    int axis = stream_int(s, 0, 2), along = (axis + 1) % 3;
    double m = (double)(stream_bits(s) >> 14); // 50 bits
    memset(p, 0, sizeof *p);
    p->sigma = ldexp(5 * m, -52);
    p->r[axis] = ldexp(3 * m, -52);
    p->r[(axis + 2) % 3] = ldexp(4 * m, -52);
    if (stream_int(s, 0, 1))
        p->r[axis] = stream_near(s, p->r[axis], 2);
    p->r[along] = stream_scaled(s, -80, -10);
    p->v[along] = stream_sign(s) * stream_real(s, 0.5, 2);
    if (stream_int(s, 0, 1))
        p->v[axis] = stream_scaled(s, -80, -10);
}

/** Small integers, exact contacts, tangents, r = 0, v = 0, sigma = 0 among
 *  them. */
static inline void family_integers(stream *s, pair_case *p)
{
    for (int i = 0; i < 3; i++) {
        p->r[i] = stream_int(s, -5, 5);
        p->v[i] = stream_int(s, -2, 2);
    }
    p->sigma = stream_int(s, 0, 7);
}

/** Exact tangents in integers: r = a vector of whole length perpendicular to v,
 *  less back v. */
static inline void family_tangent(stream *s, pair_case *p)
{
    double m = stream_int(s, 1, 4096), n = stream_int(s, 1, 4096);
    double k = stream_int(s, 1, 4096), back = stream_int(s, -4096, 4096);
    const double e[3] = {m * m - n * n, 2 * m * n, 0}, v[3] = {-e[1], e[0], k};
    for (int i = 0; i < 3; i++) {
        p->v[i] = v[i];
        p->r[i] = e[i] - back * v[i];
    }
    p->sigma = m * m + n * n; // |e|
    if (stream_int(s, 0, 2) == 0)
        p->sigma = stream_near(s, p->sigma, 1);
}

/** On a line: the time, (r - sigma) / v, can be a tie between two doubles. */
static inline void family_line(stream *s, pair_case *p)
{
    memset(p, 0, sizeof *p);
    int axis = stream_int(s, 0, 2);
    p->sigma = stream_real(s, 0.5, 2);
    p->r[axis] = stream_real(s, 2, 8) * stream_sign(s);
    p->v[axis] = (p->r[axis] > 0 ? -1 : 1) * (double)stream_int(s, 1, 3);
}

/** Scaled by 2^+-600 in any mixture. */
static inline void family_scaled(stream *s, pair_case *p)
{
    switch (stream_int(s, 0, 4)) {
    case 0:
        family_hits(s, p);
        break;
    case 1:
        family_captured(s, p);
        break;
    case 2:
        family_grazing(s, p);
        break;
    case 3:
        family_integers(s, p);
        break;
    default:
        family_contact(s, p);
    }
    int lengths = stream_int(s, -600, 600), times = stream_int(s, -600, 600);
    if (stream_int(s, 0, 3) == 0) { // down to and beyond the edges of the range
        lengths = stream_int(s, -1080, 1020);
        times = stream_int(s, -1080, 1000);
    }
    for (int i = 0; i < 3; i++) {
        p->r[i] = ldexp(p->r[i], lengths);
        p->v[i] = ldexp(p->v[i], times);
        if (!isfinite(p->v[i]))
            p->v[i] = 0;
    }
    p->sigma = ldexp(p->sigma, lengths);
}

/** Every number of a magnitude of its own, zeros and subnormals among them. */
static inline void family_wild(stream *s, pair_case *p)
{
    for (int i = 0; i < 7; i++) {
        double *x = i < 3 ? &p->r[i] : i < 6 ? &p->v[i - 3] : &p->sigma;
        *x = stream_int(s, 0, 5) == 0 ? 0 * stream_sign(s)
                                      : stream_scaled(s, -1080, 1024);
    }
    p->sigma = fabs(p->sigma);
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
 *  more than a c. */
static inline void family_skimming(stream *s, pair_case *p)
{
    double normal[3];
    fill_normal(s, normal, 1);
    resize(normal, 1);
    fill_normal(s, p->v, 1);
    double along =
        p->v[0] * normal[0] + p->v[1] * normal[1] + p->v[2] * normal[2];
    const double gap = stream_scaled(s, -50, -9); // c = 2 gap, all but
    for (int i = 0; i < 3; i++) {
        p->r[i] = (1 + gap) * normal[i];
        p->v[i] -= along * normal[i];
    }
    const double slope = sqrt(2 * fabs(gap) * stream_real(s, 0.9, 3));
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

/** Where squares, products or the answer are on the edge of underflow. */
static inline void family_edge(stream *s, pair_case *p)
{
    static void (*const make[])(stream *, pair_case *) = {
        family_hits, family_captured, family_grazing, family_contact,
        family_cancelling};
    make[stream_int(s, 0, 4)](s, p);
    int lengths = stream_int(s, -560, -20), times = 0;
    switch (stream_int(s, 0, 2)) {
    case 0: // sigma^2 v^2, with sigma^2 as small as the fast ways take it
        lengths = stream_int(s, -452, -430);
        times = stream_int(s, -540, -525) - lengths;
        break;
    case 1: // r v
        times = stream_int(s, -1080, -1000) - lengths;
        break;
    default: // r / v
        times = lengths + stream_int(s, 1010, 1076);
        times = times > 1000 ? 1000 : times;
    }
    for (int i = 0; i < 3; i++) {
        p->r[i] = ldexp(p->r[i], lengths);
        p->v[i] = ldexp(p->v[i], times);
    }
    p->sigma = ldexp(p->sigma, lengths);
}

typedef struct pair_family {
    const char *name;
    void (*make)(stream *, pair_case *);
} pair_family;

static const pair_family pair_families[] = {
    {"dilute", family_dilute},
    {"hits", family_hits},
    {"neighbours", family_neighbours},
    {"contact", family_contact},
    {"captured", family_captured},
    {"grazing", family_grazing},
    {"rim", family_rim},
    {"integers", family_integers},
    {"tangent", family_tangent},
    {"line", family_line},
    {"scaled", family_scaled},
    {"wild", family_wild},
    {"axial", family_axial},
    {"cancelling", family_cancelling},
    {"passing", family_passing},
    {"edge", family_edge},
    {"sideways", family_sideways},
    {"missing", family_missing},
    {"closing", family_closing},
    {"skimming", family_skimming},
    {"remainder", family_remainder},
};
enum { PAIR_FAMILIES = sizeof pair_families / sizeof *pair_families };
#endif
