// SPDX-License-Identifier: MIT
// Values, and signs at a later time: an estimate that carries its rounding errors
// along and knows the size of its terms; where that is not certain, the same in
// dyadics.  u = 2^-53; error bounds are to first order.
#include "path.h"

#include "dyadic.h"
#include "overlap.h"

/** A value, off by 2^-98 of the size of its terms summed, and 2^-800, before it
 *  was rounded to one double. */
typedef struct estimate {
    double value, size;
} estimate;

/** Off by 2^-98 of the size, which is 2^-55 of the value, a quarter of an ulp,
 *  and by half an ulp when it was rounded. */
BRINK_INLINE int is_precise(estimate e)
{
    return e.size < 0x1p1000 && fabs(e.value) > fma(0x1p-43, e.size, 0x1p-700);
}

BRINK_INLINE int is_certain(estimate e)
{
    return e.size < 0x1p1000 && fabs(e.value) > fma(0x1p-97, e.size, 0x1p-700);
}

// --- Estimates -----------------------------------------------------------------
//
// What a rounding leaves behind is at most u of the size at each of the sums, and
// is added up in doubles: with four terms of three parts that is fewer than 110
// roundings of u times u of the size.

BRINK_INLINE dd gather(dd sum, dd term)
{
    dd s = two_sum(sum.hi, term.hi);
    return (dd){s.hi, sum.lo + (s.lo + term.lo)};
}

/** r + v t - c, and |r| + |v t| + |c|.  The little that is added to that stands
 *  for the low part of v t, which may be lost: less than 2^-1074, but it is
 *  multiplied by what may be large. */
typedef struct place {
    dd x;
    double size;
} place;

BRINK_INLINE place place_of(double r, double v, double c, double t)
{
    dd way = two_prod(v, t);
    double size = fabs(r) + fabs(way.hi) + fabs(c) + 0x1p-960;
    return (place){gather(two_sum(r, -c), way), size};
}

/** x^2 but for lo^2, which is less than 9u^2 of the size. */
BRINK_INLINE dd square(dd x)
{
    dd p = two_prod(x.hi, x.hi);
    return (dd){p.hi, fma(2 * x.hi, x.lo, p.lo)};
}

BRINK_INLINE dd times(double n, dd x)
{
    dd p = two_prod(n, x.hi);
    return (dd){p.hi, fma(n, x.lo, p.lo)};
}

/** r.r - sigma^2 */
BRINK_INLINE estimate ball_now(const double r[3], double sigma)
{
    dd x = two_prod(r[0], r[0]), y = two_prod(r[1], r[1]);
    dd z = two_prod(r[2], r[2]), s = two_prod(-sigma, sigma);
    dd rr = gather(gather(x, y), z);
    return (estimate){sum_of(gather(rr, s)), rr.hi - s.hi};
}

/** x.y */
BRINK_INLINE estimate dot(const double x[3], const double y[3])
{
    dd p = two_prod(x[0], y[0]), q = two_prod(x[1], y[1]);
    dd r = two_prod(x[2], y[2]);
    double size = fabs(p.hi) + fabs(q.hi) + fabs(r.hi);
    return (estimate){sum_of(gather(gather(p, q), r)), size};
}

/** n.(r - c) */
BRINK_INLINE estimate plane_now(const double n[3], const double r[3],
                                const double c[3])
{
    dd x = times(n[0], two_sum(r[0], -c[0]));
    dd y = times(n[1], two_sum(r[1], -c[1]));
    dd z = times(n[2], two_sum(r[2], -c[2]));
    double size = fabs(x.hi) + fabs(y.hi) + fabs(z.hi);
    return (estimate){sum_of(gather(gather(x, y), z)), size};
}

/** |r + v t|^2 - sigma^2 */
BRINK_INLINE estimate ball(const double r[3], const double v[3], double sigma,
                           double t)
{
    place x = place_of(r[0], v[0], 0, t), y = place_of(r[1], v[1], 0, t);
    place z = place_of(r[2], v[2], 0, t);
    dd s = two_prod(-sigma, sigma);
    dd rr = gather(gather(square(x.x), square(y.x)), square(z.x));
    double size = fma(x.size, x.size, fma(y.size, y.size, z.size * z.size));
    return (estimate){sum_of(gather(rr, s)), size - s.hi};
}

/** n.(r + v t - c) */
BRINK_INLINE estimate plane(const double n[3], const double r[3],
                            const double v[3], const double c[3], double t)
{
    place x = place_of(r[0], v[0], c[0], t), y = place_of(r[1], v[1], c[1], t);
    place z = place_of(r[2], v[2], c[2], t);
    dd xy = gather(times(n[0], x.x), times(n[1], y.x));
    double size =
        fma(fabs(n[0]), x.size, fma(fabs(n[1]), y.size, fabs(n[2]) * z.size));
    return (estimate){sum_of(gather(xy, times(n[2], z.x))), size};
}

// --- Exact ---------------------------------------------------------------------

static const double zero[3] = {0, 0, 0};

static int are_finite(const double x[3])
{
    return isfinite(x[0]) && isfinite(x[1]) && isfinite(x[2]);
}

/** 0, and f is not made, outside the domain. */
static int ball_exact(brink_dyadic *f, const double r[3], const double v[3],
                      double sigma, double t)
{
    if (!are_finite(r) || !are_finite(v) || !isfinite(sigma) || !isfinite(t))
        return 0;
    const double x[4] = {r[0], r[1], r[2], sigma};
    const double y[4] = {r[0], r[1], r[2], -sigma};
    brink_dyadic a, b, c, time, sum, product; // (a t + b + b) t + c
    brink_dyadic_dot(&a, 3, v, v);
    brink_dyadic_dot(&b, 3, r, v);
    brink_dyadic_dot(&c, 4, x, y);
    brink_dyadic_double(&time, t);
    brink_dyadic_mul(&product, &a, &time);
    brink_dyadic_add(&sum, &product, &b);
    brink_dyadic_add(&product, &sum, &b);
    brink_dyadic_mul(&sum, &product, &time);
    brink_dyadic_add(f, &sum, &c);
    return 1;
}

static int plane_exact(brink_dyadic *f, const double n[3], const double r[3],
                       const double v[3], const double c[3], double t)
{
    if (!are_finite(n) || !are_finite(r) || !are_finite(v) || !are_finite(c) ||
        !isfinite(t))
        return 0;
    const double x[6] = {n[0], n[1], n[2], n[0], n[1], n[2]};
    const double y[6] = {r[0], r[1], r[2], -c[0], -c[1], -c[2]};
    brink_dyadic start, rate, time, way;
    brink_dyadic_dot(&start, 6, x, y);
    brink_dyadic_dot(&rate, 3, n, v);
    brink_dyadic_double(&time, t);
    brink_dyadic_mul(&way, &rate, &time);
    brink_dyadic_add(f, &start, &way);
    return 1;
}

static BRINK_APART double ball_value(const double r[3], const double v[3],
                                     double sigma, double t)
{
    brink_dyadic f;
    return ball_exact(&f, r, v, sigma, t) ? brink_dyadic_round(&f) : (double)NAN;
}

static BRINK_APART int ball_sign(const double r[3], const double v[3],
                                 double sigma, double t)
{
    brink_dyadic f;
    return ball_exact(&f, r, v, sigma, t) ? f.sign : 0;
}

static BRINK_APART double plane_value(const double n[3], const double r[3],
                                      const double v[3], const double c[3],
                                      double t)
{
    brink_dyadic f;
    return plane_exact(&f, n, r, v, c, t) ? brink_dyadic_round(&f) : (double)NAN;
}

static BRINK_APART int plane_sign(const double n[3], const double r[3],
                                  const double v[3], const double c[3], double t)
{
    brink_dyadic f;
    return plane_exact(&f, n, r, v, c, t) ? f.sign : 0;
}

// --- The functions -------------------------------------------------------------

double brink_ball_overlap(const double r[3], double sigma)
{
    estimate e = ball_now(r, sigma);
    return is_precise(e) ? e.value : ball_value(r, zero, sigma, 0);
}

double brink_ball_overlap_at(const double r[3], const double v[3], double sigma,
                             double t)
{
    estimate e = ball(r, v, sigma, t);
    return is_precise(e) ? e.value : ball_value(r, v, sigma, t);
}

int brink_ball_overlap_sign_at(const double r[3], const double v[3], double sigma,
                               double t)
{
    estimate e = ball(r, v, sigma, t);
    return is_certain(e) ? sign_of(e.value) : ball_sign(r, v, sigma, t);
}

double brink_ball_overlap_rate(const double r[3], const double v[3])
{
    estimate e = dot(r, v);
    return is_precise(e) ? e.value : plane_value(v, r, zero, zero, 0);
}

double brink_ball_overlap_rate_at(const double r[3], const double v[3], double t)
{
    return brink_halfspace_overlap_at(r, v, v, zero, t);
}

int brink_ball_overlap_rate_sign_at(const double r[3], const double v[3],
                                    double t)
{
    return brink_halfspace_overlap_sign_at(r, v, v, zero, t);
}

double brink_halfspace_overlap(const double r[3], const double n[3],
                               const double c[3])
{
    estimate e = plane_now(n, r, c);
    return is_precise(e) ? e.value : plane_value(n, r, zero, c, 0);
}

double brink_halfspace_overlap_rate(const double v[3], const double n[3])
{
    return brink_ball_overlap_rate(n, v);
}

double brink_halfspace_overlap_at(const double r[3], const double v[3],
                                  const double n[3], const double c[3], double t)
{
    estimate e = plane(n, r, v, c, t);
    return is_precise(e) ? e.value : plane_value(n, r, v, c, t);
}

int brink_halfspace_overlap_sign_at(const double r[3], const double v[3],
                                    const double n[3], const double c[3],
                                    double t)
{
    estimate e = plane(n, r, v, c, t);
    return is_certain(e) ? sign_of(e.value) : plane_sign(n, r, v, c, t);
}
