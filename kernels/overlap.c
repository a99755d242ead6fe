// SPDX-License-Identifier: MIT
// All of it is two expressions, the ball's and the plane's: a rate is the
// distance from a plane with the velocity for a normal.  Each is written down
// twice, in double-double with the size of its terms, and in dyadics.
#include "overlap.h"
#include "dyadic.h"

/** What there is to an expression; what it does not need is 0. */
typedef struct scene {
    const double *r, *v, *n, *c;
    double sigma, t;
} scene;

static const double zero[3] = {0, 0, 0};

/** A value in double-double, and the size of its terms summed.  Its error is
 *  less than 2^-98 of that size. */
typedef struct estimate {
    dd value;
    double size;
} estimate;

typedef struct expression {
    estimate (*estimate)(const scene *);
    void (*exact)(brink_dyadic *, const scene *);
} expression;

/** r + v t - c to 3u^2 of itself; |r| + |v t| + |c| in *size, or infinity
 *  where v t is so small that its low part may be lost. */
static dd place(const scene *s, int i, double *size)
{
    dd step = two_prod(s->v[i], s->t), start = two_sum(s->r[i], -s->c[i]);
    int lost = fabs(step.hi) < 0x1p-900 && s->v[i] != 0 && s->t != 0;
    *size =
        lost ? (double)INFINITY : fabs(s->r[i]) + fabs(step.hi) + fabs(s->c[i]);
    return dd_add(start, step);
}

// --- |r + v t|^2 - sigma^2 -----------------------------------------------------

static estimate ball_estimate(const scene *s)
{
    estimate e = {dd_negate(two_prod(s->sigma, s->sigma)), s->sigma * s->sigma};
    for (int i = 0; i < 3; i++) {
        double size;
        dd x = place(s, i, &size);
        e.value = dd_add(e.value, dd_mul(x, x)); // 10u^2, and 3u^2 a sum
        e.size += size * size;
    }
    return e;
}

/** a t^2 + 2 b t + c as (a t + b + b) t + c. */
static void ball_exact(brink_dyadic *f, const scene *s)
{
    const double *r = s->r;
    const double x[4] = {r[0], r[1], r[2], s->sigma};
    const double y[4] = {r[0], r[1], r[2], -s->sigma};
    brink_dyadic a, b, c, t, sum, product;
    brink_dyadic_dot(&a, 3, s->v, s->v);
    brink_dyadic_dot(&b, 3, r, s->v);
    brink_dyadic_dot(&c, 4, x, y);
    brink_dyadic_double(&t, s->t);
    brink_dyadic_mul(&product, &a, &t);
    brink_dyadic_add(&sum, &product, &b);
    brink_dyadic_add(&product, &sum, &b);
    brink_dyadic_mul(&sum, &product, &t);
    brink_dyadic_add(f, &sum, &c);
}

static const expression ball = {ball_estimate, ball_exact};

// --- n.(r + v t - c) -----------------------------------------------------------

static estimate plane_estimate(const scene *s)
{
    estimate e = {{0, 0}, 0};
    for (int i = 0; i < 3; i++) {
        double size;
        dd x = place(s, i, &size);
        e.value = dd_add(e.value, dd_mul_d(x, s->n[i])); // 5u^2, and 3u^2 a sum
        e.size += fabs(s->n[i]) * size;
    }
    return e;
}

static void plane_exact(brink_dyadic *f, const scene *s)
{
    const double *n = s->n, *r = s->r, *c = s->c;
    const double x[6] = {n[0], n[1], n[2], n[0], n[1], n[2]};
    const double y[6] = {r[0], r[1], r[2], -c[0], -c[1], -c[2]};
    brink_dyadic start, rate, t, way;
    brink_dyadic_dot(&start, 6, x, y);
    brink_dyadic_dot(&rate, 3, n, s->v);
    brink_dyadic_double(&t, s->t);
    brink_dyadic_mul(&way, &rate, &t);
    brink_dyadic_add(f, &start, &way);
}

static const expression plane = {plane_estimate, plane_exact};

// --- Value and sign ------------------------------------------------------------

/** Of a number that is not 0: its sign bit. */
static int sign_of(double x)
{
    return -(int)(bits_of(x) >> 63) | 1;
}

static double value_of(const expression *f, const scene *s)
{
    estimate e = f->estimate(s);
    // An error of 2^-98 of the size is then 2^-55 of the value, a quarter of an
    // ulp, and the rounding to one double another half.  Underflow costs less
    // than 2^-900.
    if (e.size < 0x1p1000 && fabs(e.value.hi) > fma(0x1p-43, e.size, 0x1p-700))
        return e.value.hi;
    brink_dyadic exact;
    f->exact(&exact, s);
    return brink_dyadic_round(&exact);
}

static __attribute__((noinline)) int sign_of_expression(const expression *f,
                                                        const scene *s)
{
    estimate e = f->estimate(s);
    if (e.size < 0x1p1000 && fabs(e.value.hi) > fma(0x1p-97, e.size, 0x1p-700))
        return sign_of(e.value.hi);
    brink_dyadic exact;
    f->exact(&exact, s);
    return exact.sign;
}

double brink_ball_overlap(const double r[3], double sigma)
{
    return value_of(&ball, &(scene){r, zero, zero, zero, sigma, 0});
}

int brink_ball_overlap_sign(const double r[3], double sigma)
{
    // r.r is off by 3u of itself, sigma^2 by 1u, each product by 2^-1075 at the
    // least; the difference has the sign that they have.
    double rr = r[0] * r[0] + r[1] * r[1] + r[2] * r[2], ss = sigma * sigma;
    double f = rr - ss, error = 0x1p-51 * (rr + ss) + 0x1p-1000;
    if (fabs(f) > error)
        return sign_of(f);
    return sign_of_expression(&ball, &(scene){r, zero, zero, zero, sigma, 0});
}

double brink_ball_overlap_rate(const double r[3], const double v[3])
{
    return value_of(&plane, &(scene){r, zero, v, zero, 0, 0});
}

int brink_ball_overlap_rate_sign(const double r[3], const double v[3])
{
    double x = r[0] * v[0], y = r[1] * v[1], z = r[2] * v[2];
    double f = x + y + z, size = fabs(x) + fabs(y) + fabs(z); // 3u of the size
    if (fabs(f) > 0x1p-51 * size + 0x1p-1000)
        return sign_of(f);
    return sign_of_expression(&plane, &(scene){r, zero, v, zero, 0, 0});
}

double brink_ball_overlap_at(const double r[3], const double v[3], double sigma,
                             double t)
{
    return value_of(&ball, &(scene){r, v, zero, zero, sigma, t});
}

int brink_ball_overlap_sign_at(const double r[3], const double v[3], double sigma,
                               double t)
{
    return sign_of_expression(&ball, &(scene){r, v, zero, zero, sigma, t});
}

double brink_ball_overlap_rate_at(const double r[3], const double v[3], double t)
{
    return value_of(&plane, &(scene){r, v, v, zero, 0, t});
}

int brink_ball_overlap_rate_sign_at(const double r[3], const double v[3],
                                    double t)
{
    return sign_of_expression(&plane, &(scene){r, v, v, zero, 0, t});
}

double brink_halfspace_overlap(const double r[3], const double n[3],
                               const double c[3])
{
    return value_of(&plane, &(scene){r, zero, n, c, 0, 0});
}

int brink_halfspace_overlap_sign(const double r[3], const double n[3],
                                 const double c[3])
{
    return sign_of_expression(&plane, &(scene){r, zero, n, c, 0, 0});
}

double brink_halfspace_overlap_rate(const double v[3], const double n[3])
{
    return brink_ball_overlap_rate(n, v);
}

int brink_halfspace_overlap_rate_sign(const double v[3], const double n[3])
{
    return brink_ball_overlap_rate_sign(n, v);
}

double brink_halfspace_overlap_at(const double r[3], const double v[3],
                                  const double n[3], const double c[3], double t)
{
    return value_of(&plane, &(scene){r, v, n, c, 0, t});
}

int brink_halfspace_overlap_sign_at(const double r[3], const double v[3],
                                    const double n[3], const double c[3],
                                    double t)
{
    return sign_of_expression(&plane, &(scene){r, v, n, c, 0, t});
}
