// SPDX-License-Identifier: MIT
// Where the fast paths were not certain: the domain, scaling by powers of two,
// double-double, and exact numbers for the rest.  The answers are correctly
// rounded.
#include "path.h"

#include "event_time_sums.h"
#include "root.h"

static int in_domain(const double r[3], const double v[3], double sigma)
{
    for (int i = 0; i < 3; i++)
        if (!isfinite(r[i]) || !isfinite(v[i]))
            return 0;
    return isfinite(sigma) && sigma >= 0;
}

// --- Exact ---------------------------------------------------------------------

typedef struct exact_path {
    brink_dyadic a, b, c, d; // d = b^2 - a c, which needs no cross product here
} exact_path;

static void exact_path_make(exact_path *p, const double r[3], const double v[3],
                            double sigma)
{
    const double x[4] = {r[0], r[1], r[2], sigma};
    const double y[4] = {r[0], r[1], r[2], -sigma};
    brink_dyadic bb, ac;
    brink_dyadic_dot(&p->a, 3, v, v);
    brink_dyadic_dot(&p->b, 3, r, v);
    brink_dyadic_dot(&p->c, 4, x, y);
    brink_dyadic_mul(&bb, &p->b, &p->b);
    brink_dyadic_mul(&ac, &p->a, &p->c);
    brink_dyadic_sub(&p->d, &bb, &ac);
}

static double intersection_exact(const double r[3], const double v[3],
                                 double sigma)
{
    exact_path p;
    exact_path_make(&p, r, v, sigma);
    if (p.b.sign >= 0)
        return (double)INFINITY;
    if (p.c.sign <= 0)
        return 0;
    if (p.d.sign <= 0)
        return (double)INFINITY;
    return brink_dyadic_root(&p.a, &p.b, &p.c, &p.d, BRINK_LOWER);
}

static double disjoint_exact(const double r[3], const double v[3], double sigma)
{
    exact_path p;
    exact_path_make(&p, r, v, sigma);
    if (p.a.sign == 0)
        return (double)INFINITY;
    if (p.b.sign >= 0 && p.c.sign >= 0)
        return 0;
    if (p.d.sign > 0)
        return brink_dyadic_root(&p.a, &p.b, &p.c, &p.d, BRINK_UPPER);
    p.b.sign = -p.b.sign;
    return brink_dyadic_quotient(&p.b, &p.a);
}

// --- Double-double -------------------------------------------------------------

/** a, b, c, d to a few u^2 of their terms' sizes, which have been scaled to
 *  about 1, and their signs. */
typedef struct fine_path {
    dd a, b, c, d;
    double p, size, s;          // P, R, sigma^2 a + |r x v|^2
    int b_sign, c_sign, d_sign; // 2 where it is not certain
    int unit;                   // times are in units of 2^unit
} fine_path;

static int certain_sign(double x, double error)
{
    return x > error ? 1 : x < -error ? -1 : 2;
}

BRINK_INLINE dd fine_dot(const double x[3], const double y[3])
{
    dd xy = dd_add(two_prod(x[0], y[0]), two_prod(x[1], y[1]));
    return dd_add(xy, two_prod(x[2], y[2])); // error <= 7u^2 sum |x_i y_i|
}

BRINK_INLINE fine_path fine_path_of(const double r0[3], const double v0[3],
                                    double sigma0)
{
    const double lengths[4] = {r0[0], r0[1], r0[2], sigma0};
    int er = common_exponent(4, lengths), ev = common_exponent(3, v0);
    double fr = power_of_two(-er), fv = power_of_two(-ev);
    const double r[3] = {r0[0] * fr, r0[1] * fr, r0[2] * fr};
    const double v[3] = {v0[0] * fv, v0[1] * fv, v0[2] * fv};
    double sigma = sigma0 * fr;

    fine_path f;
    f.unit = er - ev;
    f.a = fine_dot(v, v);
    f.b = fine_dot(r, v);
    f.c = fine_c(r, sigma);
    dd w = {0, 0};
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        dd x = dd_add(two_prod(r[j], v[k]), dd_negate(two_prod(r[k], v[j])));
        w = dd_add(w, dd_mul(x, x)); // x to 3u^2, x x to 13u^2, w to 19u^2
    }
    dd ssa = dd_mul_d(dd_mul_d(f.a, sigma), sigma); // 11u^2
    f.d = dd_add(ssa, dd_negate(w));
    f.p = fabs(r[0] * v[0]) + fabs(r[1] * v[1]) + fabs(r[2] * v[2]);
    f.size = fma(sigma, sigma, dot_rounded(r, r));
    f.s = ssa.hi + w.hi;

    // 2^-101 = 32u^2; what underflows is less than 2^-1000.
    f.b_sign = certain_sign(f.b.hi, fma(0x1p-101, f.p, 0x1p-1000));
    f.c_sign = certain_sign(f.c.hi, fma(0x1p-101, f.size, 0x1p-1000));
    f.d_sign = certain_sign(f.d.hi, fma(0x1p-101, f.s, 0x1p-900));
    return f;
}

/** The double nearest to t 2^unit, where t is off by `error` of itself; -1 if
 *  it cannot be told, or is not in the normal range with all its bits. */
static double fine_rounded(dd t, double error, int unit)
{
    double slack = error * t.hi;
    if (!(t.hi + (t.lo + slack) == t.hi + (t.lo - slack)))
        return -1;
    double scaled = ldexp(t.hi, unit);
    int whole = t.hi > 0x1p-900 && scaled > 0x1p-1000 && scaled < 0x1p1000;
    return whole ? scaled : -1;
}

/** Error of sqrt(d) + |b|, relative: 32u^2 s / (2 d) at most, and 7u^2 p. */
static double error_of_sum(const fine_path *f, dd sum)
{
    return 0x1p-102 * (f->s / f->d.hi + f->p / sum.hi + 2);
}

double brink_intersection_time_slow(const double r[3], const double v[3],
                                    double sigma)
{
    if (!in_domain(r, v, sigma))
        return (double)NAN;
    fine_path f = fine_path_of(r, v, sigma);
    if (f.b_sign == 1)
        return (double)INFINITY;
    if (f.b_sign == -1 && f.c_sign == -1)
        return 0;
    if (f.b_sign == -1 && f.d_sign == -1)
        return (double)INFINITY;
    if (f.b_sign == -1 && f.c_sign == 1 && f.d_sign == 1) {
        dd sum = dd_add(dd_sqrt(f.d), dd_negate(f.b));
        double error = error_of_sum(&f, sum) + 0x1p-150 * f.size / f.c.hi;
        double t = fine_rounded(dd_div(f.c, sum), error + 0x1p-101, f.unit);
        if (t > 0)
            return t;
    }
    return intersection_exact(r, v, sigma);
}

double brink_disjoint_time_slow(const double r[3], const double v[3],
                                double sigma)
{
    if (!in_domain(r, v, sigma))
        return (double)NAN;
    fine_path f = fine_path_of(r, v, sigma);
    if (f.b_sign == 1 && f.c_sign == 1)
        return 0;
    double t = -1;
    if (f.b_sign == -1 && f.d_sign == -1) { // closest approach
        double error = 0x1p-103 * f.p / -f.b.hi;
        t = fine_rounded(dd_div(dd_negate(f.b), f.a), error + 0x1p-101, f.unit);
    } else if (f.d_sign == 1 && (f.b_sign == -1 || f.c_sign == -1)) {
        dd root = dd_sqrt(f.d);
        if (f.b.hi > 0) {
            dd sum = dd_add(root, f.b);
            double error = error_of_sum(&f, sum) + 0x1p-150 * f.size / -f.c.hi;
            dd time = dd_div(dd_negate(f.c), sum);
            t = fine_rounded(time, error + 0x1p-101, f.unit);
        } else {
            dd sum = dd_add(root, dd_negate(f.b));
            double error = error_of_sum(&f, sum);
            t = fine_rounded(dd_div(sum, f.a), error + 0x1p-101, f.unit);
        }
    }
    return t > 0 ? t : disjoint_exact(r, v, sigma);
}
