// SPDX-License-Identifier: MIT
#ifndef TESTS_QUADRATICS_H
#define TESTS_QUADRATICS_H
/** Families of quadratics, for tests, the ulp tool and the bench. */
#include "random.h"
#include <stddef.h>

typedef struct quadratic_case {
    double a, b, c;
} quadratic_case;

/** Coefficients of order one. */
static inline void quadratic_benign(stream *s, quadratic_case *q)
{
    q->a = stream_real(s, 0.5, 2);
    q->b = stream_real(s, -4, 4);
    q->c = stream_real(s, -2, 1);
}

/** From two roots of any ratio. */
static inline void quadratic_roots(stream *s, quadratic_case *q)
{
    double x = stream_scaled(s, -40, 40), y = stream_scaled(s, -40, 40);
    q->a = stream_scaled(s, -20, 20);
    q->b = -q->a * (x + y);
    q->c = q->a * (x * y);
}

/** Discriminant 0 up to a few ulp of its terms. */
static inline void quadratic_double_root(stream *s, quadratic_case *q)
{
    q->a = stream_scaled(s, -20, 20);
    q->b = stream_scaled(s, -20, 20);
    q->c = stream_near(s, q->b * q->b / (4 * q->a), 2);
}

/** (p x + q)^2 with p, q of 26 bits: the discriminant is 0 exactly, or nearly. */
static inline void quadratic_square(stream *s, quadratic_case *q)
{
    double x = stream_int(s, 1, 1 << 26), y = stream_int(s, -(1 << 26), 1 << 26);
    q->a = x * x;
    q->b = 2 * x * y;
    q->c = y * y;
    if (stream_int(s, 0, 1))
        q->c = stream_near(s, q->c, 1);
}

/** Small integers, zeros among them. */
static inline void quadratic_integers(stream *s, quadratic_case *q)
{
    q->a = stream_int(s, -6, 6);
    q->b = stream_int(s, -12, 12);
    q->c = stream_int(s, -6, 6);
}

/** One of the others times a power of two, up to the edges of the range. */
static inline void quadratic_scaled(stream *s, quadratic_case *q)
{
    static void (*const make[])(stream *, quadratic_case *) = {
        quadratic_benign, quadratic_roots, quadratic_double_root,
        quadratic_square, quadratic_integers};
    make[stream_int(s, 0, 4)](s, q);
    int all = stream_int(s, -1080, 1000), unit = stream_int(s, -540, 540);
    q->a = ldexp(q->a, all - unit); // x 2^unit is the new root
    q->b = ldexp(q->b, all);
    q->c = ldexp(q->c, all + unit);
    if (!isfinite(q->a) || !isfinite(q->b) || !isfinite(q->c))
        quadratic_scaled(s, q);
}

/** Each coefficient of a magnitude of its own. */
static inline void quadratic_wild(stream *s, quadratic_case *q)
{
    double *x[3] = {&q->a, &q->b, &q->c};
    for (int i = 0; i < 3; i++)
        *x[i] = stream_int(s, 0, 7) == 0 ? 0 * stream_sign(s)
                                         : stream_scaled(s, -1080, 1024);
}

/** Subnormal coefficients, or nearly. */
static inline void quadratic_subnormal(stream *s, quadratic_case *q)
{
    q->a = stream_scaled(s, -1080, -1000);
    q->b = stream_scaled(s, -1080, -1000);
    q->c = stream_scaled(s, -1080, -1000);
}

/** Near the largest doubles. */
static inline void quadratic_huge(stream *s, quadratic_case *q)
{
    q->a = stream_scaled(s, 1000, 1024);
    q->b = stream_scaled(s, 1000, 1024);
    q->c = stream_scaled(s, 1000, 1024);
}

/** A root within 2^-106 of itself of a midpoint m of two doubles: m b = 1 mod
 *  2^53, so b x = m b - 1, both sides exact doubles, has the root m - 1/b; and
 *  a x^2 with a so small that it hardly matters. */
static inline void quadratic_midpoint(stream *s, quadratic_case *q)
{
    uint64_t m, b, k;
    do {
        m = stream_bits(s) >> 10 | UINT64_C(1) << 53 | 1; // odd, of 54 bits
        b = m;
        for (int i = 0; i < 5; i++) // Newton's iteration for 1 / m, from 3 bits
            b *= 2 - m * b;
        b &= (UINT64_C(1) << 53) - 1;
        __extension__ unsigned __int128 product = (unsigned __int128)m * b;
        k = (uint64_t)(product >> 53);
    } while (k >> 53 != 0);
    q->b = (double)b;
    q->c = -ldexp((double)k, 53);
    q->a = ldexp(stream_sign(s), -stream_int(s, 60, 300));
}

/** x^2 = c within 2^-107 of the square of a midpoint, and (x + k)^2 = c. */
static inline void quadratic_sqrt_midpoint(stream *s, quadratic_case *q)
{
    int n = stream_int(s, 0, 1) ? 1 : 3, k = 1 << stream_int(s, 0, 20);
    q->a = 1; // (1 + n 2^-53)^2 = 1 + n 2^-52 + n^2 2^-106
    q->b = 0;
    q->c = -(1 + n * 0x1p-52);
    if (stream_int(s, 0, 1)) { // (x + k)^2: the root's fraction ends 2^-53 too
        q->b = 2 * k;
        q->c = (double)k * k + q->c;
    }
    double scale = ldexp(1, stream_int(s, -100, 100));
    q->a *= scale;
    q->b *= scale;
    q->c *= scale;
}

/** A root that is subnormal, or nearly, beside one that is not. */
static inline void quadratic_tiny_root(stream *s, quadratic_case *q)
{
    int near_one = stream_int(s, 0, 1);
    q->a = near_one ? stream_scaled(s, -2, 2) : stream_scaled(s, 500, 700);
    q->b = near_one ? stream_scaled(s, -2, 2) : stream_scaled(s, -60, -20);
    q->c = stream_scaled(s, -1074, -960);
}

/** A discriminant as small as 2^-106 of its terms, but not 0: that of x^2 - d is
 *  kept where x becomes x + k, or 1 / x, until the coefficients have 53 bits. */
static inline void quadratic_close(stream *s, quadratic_case *q)
{
    double a = 1, h = 0, c = -floor(fabs(stream_scaled(s, 0, 50)));
    for (;;) {
        const double k = stream_sign(s) * stream_int(s, 1, 9);
        const double next_h = h + k * a, next_c = c + k * (h + next_h);
        if (fabs(next_h) > 0x1p52 || fabs(next_c) > 0x1p53)
            break;
        h = next_h;
        c = a;
        a = next_c;
    }
    q->a = a;
    q->b = 2 * h;
    q->c = c;
}

/** Coefficients whose products have bits below the least double. */
static inline void quadratic_edge(stream *s, quadratic_case *q)
{
    const int e = stream_int(s, -515, -480), unit = stream_int(s, -4, 4);
    if (stream_int(s, 0, 1))
        quadratic_benign(s, q);
    else
        quadratic_double_root(s, q);
    q->a = ldexp(q->a, e - unit);
    q->b = ldexp(q->b, e);
    q->c = ldexp(q->c, e + unit);
}

typedef struct quadratic_family {
    const char *name;
    void (*make)(stream *, quadratic_case *);
} quadratic_family;

static const quadratic_family quadratic_families[] = {
    {"benign", quadratic_benign},      {"roots", quadratic_roots},
    {"double", quadratic_double_root}, {"square", quadratic_square},
    {"integers", quadratic_integers},  {"scaled", quadratic_scaled},
    {"wild", quadratic_wild},          {"subnormal", quadratic_subnormal},
    {"huge", quadratic_huge},          {"midpoint", quadratic_midpoint},
    {"sqrt", quadratic_sqrt_midpoint}, {"tiny", quadratic_tiny_root},
    {"close", quadratic_close},        {"edge", quadratic_edge},
};
enum {
    QUADRATIC_FAMILIES = sizeof quadratic_families / sizeof *quadratic_families
};
#endif
