// SPDX-License-Identifier: MIT
/**
 * What one would write, in any arithmetic: included once for each, with
 *     REAL        the type everything between input and output is computed in
 *     SQRT(x)     its square root
 *     NAME(f)     a name for f in it
 * Inputs are doubles, and answers are rounded to double at the end.  The formulas
 * are the stable ones: what is compared is arithmetic, not carelessness.
 */

// Not inlined, as the kernels are not: a call costs all of them the same.
#define FORMULA static __attribute__((noinline, unused))
#define INLINED static inline __attribute__((unused))

INLINED REAL NAME(dot)(const double x[3], const double y[3])
{
    return (REAL)x[0] * y[0] + (REAL)x[1] * y[1] + (REAL)x[2] * y[2];
}

INLINED REAL NAME(positive)(REAL x)
{
    return x > 0 ? x : 0;
}

// --- Quadratics ----------------------------------------------------------------

/** The roots for d = b^2 - 4 a c. */
INLINED int NAME(roots_for)(double a, double b, double c, REAL d, double *x0,
                            double *x1)
{
    if (a == 0) {
        if (b == 0)
            return 0;
        *x0 = (double)(-(REAL)c / b);
        return 1;
    }
    if (d < 0)
        return 0;
    const REAL q = b < 0 ? (SQRT(d) - b) / 2 : -(SQRT(d) + b) / 2;
    const double x = (double)(q / a), y = (double)(q == 0 ? 0 : c / q);
    *x0 = x < y ? x : y;
    *x1 = x < y ? y : x;
    return 2;
}

FORMULA int NAME(roots)(double a, double b, double c, double *x0, double *x1)
{
    return NAME(roots_for)(a, b, c, (REAL)b * b - 4 * (REAL)a * c, x0, x1);
}

// --- Event times ---------------------------------------------------------------

/** [S16] algorithm 1 from its a, b, c and arg. */
INLINED double NAME(intersection_for)(REAL b, REAL c, REAL arg)
{
    if (b >= 0 || arg <= 0)
        return (double)INFINITY;
    return (double)NAME(positive)(c / (SQRT(arg) - b));
}

/** [S16] algorithm 2 with its branches put right. */
INLINED double NAME(disjoint_for)(REAL a, REAL b, REAL c, REAL arg)
{
    if (a == 0)
        return (double)INFINITY;
    if (arg <= 0)
        return (double)NAME(positive)(-b / a);
    if (b > 0)
        return (double)NAME(positive)(-c / (SQRT(arg) + b));
    return (double)NAME(positive)((SQRT(arg) - b) / a);
}

FORMULA double NAME(intersection)(const double r[3], const double v[3],
                                  double sigma)
{
    const REAL a = NAME(dot)(v, v), b = NAME(dot)(r, v),
               c = NAME(dot)(r, r) - (REAL)sigma * sigma;
    return NAME(intersection_for)(b, c, b * b - a * c);
}

FORMULA double NAME(disjoint)(const double r[3], const double v[3], double sigma)
{
    const REAL a = NAME(dot)(v, v), b = NAME(dot)(r, v),
               c = NAME(dot)(r, r) - (REAL)sigma * sigma;
    return NAME(disjoint_for)(a, b, c, b * b - a * c);
}

/** Of the plane through c with normal n. */
FORMULA double NAME(halfspace_time)(const double r[3], const double v[3],
                                    const double n[3], const double c[3])
{
    REAL f = 0;
    for (int i = 0; i < 3; i++)
        f += n[i] * ((REAL)r[i] - c[i]);
    const REAL rate = NAME(dot)(n, v);
    return rate < 0 ? (double)NAME(positive)(f / -rate) : (double)INFINITY;
}

// --- Overlaps ------------------------------------------------------------------

FORMULA double NAME(ball)(const double r[3], double sigma)
{
    return (double)(NAME(dot)(r, r) - (REAL)sigma * sigma);
}

FORMULA double NAME(rate)(const double r[3], const double v[3])
{
    return (double)NAME(dot)(r, v);
}

FORMULA double NAME(halfspace_rate)(const double v[3], const double n[3])
{
    return (double)NAME(dot)(v, n);
}

FORMULA double NAME(ball_at)(const double r[3], const double v[3], double sigma,
                             double t)
{
    REAL f = 0;
    for (int i = 0; i < 3; i++) {
        const REAL x = r[i] + (REAL)v[i] * t;
        f += x * x;
    }
    return (double)(f - (REAL)sigma * sigma);
}

FORMULA double NAME(rate_at)(const double r[3], const double v[3], double t)
{
    REAL f = 0;
    for (int i = 0; i < 3; i++)
        f += v[i] * (r[i] + (REAL)v[i] * t);
    return (double)f;
}

FORMULA double NAME(halfspace)(const double r[3], const double n[3],
                               const double c[3])
{
    REAL f = 0;
    for (int i = 0; i < 3; i++)
        f += n[i] * ((REAL)r[i] - c[i]);
    return (double)f;
}

FORMULA double NAME(halfspace_at)(const double r[3], const double v[3],
                                  const double n[3], const double c[3], double t)
{
    REAL f = 0;
    for (int i = 0; i < 3; i++)
        f += n[i] * (r[i] + (REAL)v[i] * t - c[i]);
    return (double)f;
}

// --- Impulses ------------------------------------------------------------------

/** b = r.(v1 - v2) changed along the line of centres; the virial. */
INLINED REAL NAME(kick)(const double r[3], double m1, double m2, REAL change,
                        double v1[3], double v2[3])
{
    const REAL slope = change / NAME(dot)(r, r), mass = (REAL)m1 + m2;
    for (int i = 0; i < 3; i++) {
        v1[i] = (double)(v1[i] + m2 / mass * slope * r[i]);
        v2[i] = (double)(v2[i] - m1 / mass * slope * r[i]);
    }
    return m1 * (m2 / mass) * change;
}

INLINED REAL NAME(rate_between)(const double r[3], const double v1[3],
                                const double v2[3])
{
    REAL b = 0;
    for (int i = 0; i < 3; i++)
        b += r[i] * ((REAL)v1[i] - v2[i]);
    return b;
}

FORMULA double NAME(core)(const double r[3], double m1, double m2, double v1[3],
                          double v2[3])
{
    const REAL b = NAME(rate_between)(r, v1, v2);
    return (double)NAME(kick)(r, m1, m2, b < 0 ? -2 * b : 0, v1, v2);
}

FORMULA int NAME(step)(const double r[3], double m1, double m2, double rise,
                       int way, double v1[3], double v2[3], double *virial)
{
    const REAL b = NAME(rate_between)(r, v1, v2), s = way * b;
    const REAL loss =
        2 * (REAL)rise * NAME(dot)(r, r) * ((REAL)m1 + m2) / m1 / m2;
    const REAL rest = s * s - loss;
    REAL change = s > 0 ? -2 * s : 0;
    if (rest > 0)
        change = s > 0 ? -loss / (SQRT(rest) + s) : SQRT(rest) - s;
    *virial = (double)NAME(kick)(r, m1, m2, way * change, v1, v2);
    return rest > 0;
}

/** The rim rule of <brink/impulse.h>. */
FORMULA int NAME(rim)(const double r[3], double m1, double m2, double v1[3],
                      double v2[3])
{
    REAL v[3];
    for (int i = 0; i < 3; i++)
        v[i] = (REAL)v1[i] - v2[i];
    const REAL b = r[0] * v[0] + r[1] * v[1] + r[2] * v[2];
    const REAL rr = NAME(dot)(r, r), vv = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    const REAL rim = BRINK_RIM_ANGLE * SQRT(rr * vv);
    if (b <= -rim || b >= rim)
        return 0;
    const REAL stretch = SQRT((vv - rim * rim / rr) / (vv - b * b / rr));
    const REAL mass = (REAL)m1 + m2;
    for (int i = 0; i < 3; i++) {
        const REAL tangent = v[i] - b / rr * r[i];
        const REAL w = stretch * tangent - rim / rr * r[i] - v[i];
        v1[i] = (double)(v1[i] + m2 / mass * w);
        v2[i] = (double)(v2[i] - m1 / mass * w);
    }
    return 1;
}
#undef FORMULA
#undef INLINED
