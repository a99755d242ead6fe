// SPDX-License-Identifier: MIT
#ifndef TESTS_PAIRS_H
#define TESTS_PAIRS_H
/**
 * Families of pairs: what a kernel meets in a simulation, and what breaks
 * kernels.  Shared by the tests, the ulp tool and the bench.
 */
#include "pairs_cancelling.h"

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
        lengths = stream_int(s, -1080, 1018);
        times = stream_int(s, -1080, 1000);
    }
    for (int i = 0; i < 3; i++) {
        p->r[i] = ldexp(p->r[i], lengths);
        p->v[i] = ldexp(p->v[i], times);
        if (!isfinite(p->r[i]))
            p->r[i] = 0;
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

/** Where squares, products or the answer are on the edge of underflow. */
static inline void family_edge(stream *s, pair_case *p)
{
    static void (*const make[])(stream *, pair_case *) = {
        family_hits, family_captured, family_grazing, family_contact,
        family_cancelling};
    make[stream_int(s, 0, 4)](s, p);
    int lengths = stream_int(s, -560, -20), times = 0;
    switch (stream_int(s, 0, 3)) {
    case 0: // sigma^2 v^2, with sigma^2 as small as the fast ways take it
        lengths = stream_int(s, -452, -430);
        times = stream_int(s, -540, -525) - lengths;
        break;
    case 1: // sigma^2 alone, beside velocities that make up for it
        lengths = stream_int(s, -530, -440);
        times = stream_int(s, 100, 500);
        break;
    case 2: // r v
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
    {"far", family_far},
    {"upright", family_upright},
    {"triple", family_triple},
};
enum { PAIR_FAMILIES = sizeof pair_families / sizeof *pair_families };
#endif
