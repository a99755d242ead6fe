// SPDX-License-Identifier: MIT
// Double-double throughout, each velocity rounded once at the end: the bounds of
// the header are those of that last rounding.  With M = m1 + m2,
//     v1' = v1 + m2 / M (b' - b) / r.r r,    v2' = v2 - m1 / M (b' - b) / r.r r.
// What that last rounding of x + y to x leaves out, y, is known; the energy m x y
// of it is what the _balanced functions account for.
#include "path.h"

#include "dyadic.h"
#include "impulse.h"

/** A pair with its lengths, velocities and masses scaled to about 1, exactly. */
typedef struct pair {
    double r[3], v1[3], v2[3]; // times 2^-er, 2^-ev, 2^-ev
    double m1, m2;             // times 2^-em
    int er, ev, em;
    dd v[3];       // v1 - v2, exact
    dd b, rr;      // r.v, r.r, to 8u^2 of sum |r_i v_i|, of r.r
    dd k1, k2, mu; // m2 / (m1 + m2), m1 / (m1 + m2), m1 m2 / (m1 + m2): <= 2^-100
    double owed;   // energy, times 2^-em-2ev
} pair;

static void scale(double out[3], const double x[3], int e)
{
    for (int i = 0; i < 3; i++)
        out[i] = x[i] * power_of_two(e);
}

/** `rise` is counted in where it is a fall: its speed is what the pair gains. */
static void pair_make(pair *p, const double r[3], double m1, double m2,
                      double rise, const double v1[3], const double v2[3],
                      double owed)
{
    const double speeds[6] = {v1[0], v1[1], v1[2], v2[0], v2[1], v2[2]};
    const double masses[2] = {m1, m2};
    p->er = common_exponent(3, r);
    p->ev = common_exponent(6, speeds);
    p->em = common_exponent(2, masses);
    int ev_fall = (common_exponent(1, &rise) - p->em) / 2;
    if (rise < 0 && ev_fall > p->ev)
        p->ev = ev_fall;
    scale(p->r, r, -p->er);
    scale(p->v1, v1, -p->ev);
    scale(p->v2, v2, -p->ev);
    p->b = p->rr = (dd){0, 0};
    for (int i = 0; i < 3; i++) {
        p->v[i] = two_sum(p->v1[i], -p->v2[i]);
        p->b = dd_add(p->b, dd_mul_d(p->v[i], p->r[i]));
        p->rr = dd_add(p->rr, two_prod(p->r[i], p->r[i]));
    }
    p->m1 = m1 *= power_of_two(-p->em);
    p->m2 = m2 *= power_of_two(-p->em);
    p->owed = ldexp(owed, -p->em - 2 * p->ev);
    dd sum = two_sum(m1, m2);
    p->k1 = dd_div((dd){m2, 0}, sum);
    p->k2 = dd_div((dd){m1, 0}, sum);
    p->mu = dd_mul_d(p->k1, m1);
}

/** v1 += k1 w, v2 -= k2 w, each rounded once; the energy that this takes is owed.
 */
static void pair_kick(pair *p, const dd w[3], double v1[3], double v2[3])
{
    double unit = power_of_two(p->ev), taken1 = 0, taken2 = 0;
    for (int i = 0; i < 3; i++) {
        dd w1 = dd_mul(p->k1, w[i]), w2 = dd_mul(p->k2, dd_negate(w[i]));
        w1 = dd_add_d(w1, p->v1[i]);
        w2 = dd_add_d(w2, p->v2[i]);
        taken1 += w1.hi * w1.lo; // of (hi + lo)^2 / 2; lo^2 is 2^-53 of it
        taken2 += w2.hi * w2.lo;
        v1[i] = w1.hi * unit;
        v2[i] = w2.hi * unit;
    }
    p->owed += p->m1 * taken1 + p->m2 * taken2;
}

/** What is owed, paid: the change d of a speed (times |r|) that is `after`
 *  without it, from  mu ((after + d)^2 - after^2) / 2 rr = owed.  Where d is not
 *  small it is left for others to pay. */
static double pair_pay(pair *p, double after)
{
    double square = after * after, gain = 2 * p->owed * p->rr.hi / p->mu.hi;
    if (!(fabs(gain) < 0x1p-20 * square))
        return 0;
    p->owed = 0;
    return gain / (after + sqrt(square + gain));
}

/** Changes b by `change` along the line of centres; returns the virial. */
static double pair_change(pair *p, dd change, double v1[3], double v2[3])
{
    if (change.hi == 0) // at r = 0 there is no line of centres either
        return 0;
    dd w[3], slope = dd_div(change, p->rr);
    for (int i = 0; i < 3; i++)
        w[i] = dd_mul_d(slope, p->r[i]);
    pair_kick(p, w, v1, v2);
    return ldexp(dd_mul(p->mu, change).hi, p->em + p->er + p->ev);
}

/** From b to -|b| along `way`. */
static dd reflection(pair *p, enum brink_direction way)
{
    double s = p->b.hi * (int)way;
    if (s > 0)
        return dd_add_d(dd_mul_d(p->b, -2), -(int)way * pair_pay(p, s));
    return (dd){0, 0};
}

static double energy_owed(const pair *p)
{
    return ldexp(p->owed, p->em + 2 * p->ev);
}

double brink_core_impulse_balanced(const double r[3], double m1, double m2,
                                   double v1[3], double v2[3], double *owed)
{
    pair p;
    pair_make(&p, r, m1, m2, 0, v1, v2, *owed);
    double virial = pair_change(&p, reflection(&p, BRINK_INWARD), v1, v2);
    *owed = energy_owed(&p);
    return virial;
}

double brink_core_impulse(const double r[3], double m1, double m2, double v1[3],
                          double v2[3])
{
    double owed = 0;
    return brink_core_impulse_balanced(r, m1, m2, v1, v2, &owed);
}

/** sign(m1 m2 b^2 - 2 rise r.r (m1 + m2)), exact. */
static int exact_surplus(const double r[3], double m1, double m2, double rise,
                         const double v1[3], const double v2[3])
{
    const double rr[6] = {r[0], r[1], r[2], r[0], r[1], r[2]};
    const double v[6] = {v1[0], v1[1], v1[2], -v2[0], -v2[1], -v2[2]};
    const double mass[2] = {m1, m2}, twice[2] = {2, 2};
    brink_dyadic b, bb, x, y, z, radial, needed;
    brink_dyadic_dot(&b, 6, rr, v);
    brink_dyadic_mul(&bb, &b, &b);
    brink_dyadic_dot(&x, 1, &m1, &m2);
    brink_dyadic_mul(&radial, &x, &bb);

    brink_dyadic_dot(&x, 3, r, r);
    brink_dyadic_dot(&y, 2, mass, twice);
    brink_dyadic_mul(&z, &x, &y);
    brink_dyadic_double(&x, rise);
    brink_dyadic_mul(&needed, &x, &z);
    brink_dyadic_sub(&z, &radial, &needed);
    return z.sign;
}

/** The speed s along `way` times |r|, and s'^2 = s^2 - loss: what a rise leaves
 *  of its square. */
typedef struct crossing {
    dd s, loss, rest;
} crossing;

static crossing crossing_of(const pair *p, double rise, enum brink_direction way)
{
    crossing c;
    c.s = dd_mul_d(p->b, (int)way);
    // A rise of 2^900 is out of reach: it stands for all that are higher.
    const double scaled_rise = fmin(ldexp(rise, -p->em - 2 * p->ev), 0x1p900);
    c.loss = dd_div(dd_mul_d(p->rr, 2 * scaled_rise), p->mu);
    c.rest = dd_add(dd_mul(c.s, c.s), dd_negate(c.loss));
    return c;
}

/** Whether the rest has the sign that is meant.  Components of r, v1, v2 are less
 *  than 4 here, so P = sum |r_i v_i| < 96; b is off by 12u^2 P, s^2 and the sum
 *  by 34u^2 P^2 < 2^-87, loss by 45u^2 < 2^-98 of itself. */
static int is_decided(const crossing *c)
{
    return fabs(c->rest.hi) > 0x1p-87 + 0x1p-98 * fabs(c->loss.hi);
}

/** From s to s' with what is owed, along `way`. */
static dd crossed(pair *p, const crossing *c, enum brink_direction way)
{
    const dd zero = {0, 0}, after = c->rest.hi > 0 ? dd_sqrt(c->rest) : zero;
    dd change;
    // s' - s = -loss / (s' + s), where nothing cancels; but where all that is
    // left is lost in roundings, s' is 0 and loss / s may be anything.
    if (c->s.hi > 0 && c->rest.hi > 0)
        change = dd_div(dd_negate(c->loss), dd_add(after, c->s));
    else
        change = dd_add(after, dd_negate(c->s));
    change = dd_add_d(change, pair_pay(p, after.hi));
    return dd_mul_d(change, (int)way);
}

int brink_step_impulse_balanced(const double r[3], double m1, double m2,
                                double rise, enum brink_direction way,
                                double v1[3], double v2[3], double *virial,
                                double *owed)
{
    pair p;
    pair_make(&p, r, m1, m2, rise, v1, v2, *owed);
    const crossing c = crossing_of(&p, rise, way);
    const int crosses = is_decided(&c)
                            ? c.rest.hi > 0
                            : exact_surplus(r, m1, m2, rise, v1, v2) > 0;
    const dd change = crosses ? crossed(&p, &c, way) : reflection(&p, way);
    *virial = pair_change(&p, change, v1, v2);
    *owed = energy_owed(&p);
    return crosses;
}

int brink_step_impulse(const double r[3], double m1, double m2, double rise,
                       enum brink_direction way, double v1[3], double v2[3],
                       double *virial)
{
    double owed = 0;
    return brink_step_impulse_balanced(r, m1, m2, rise, way, v1, v2, virial,
                                       &owed);
}

int brink_rim_impulse_balanced(const double r[3], double m1, double m2,
                               double v1[3], double v2[3], double *owed)
{
    pair p;
    pair_make(&p, r, m1, m2, 0, v1, v2, *owed);
    dd vv = {0, 0};
    for (int i = 0; i < 3; i++)
        vv = dd_add(vv, dd_mul(p.v[i], p.v[i]));
    dd rim = dd_mul_d(dd_sqrt(dd_mul(p.rr, vv)), BRINK_RIM_ANGLE);
    if (!(fabs(p.b.hi) < rim.hi))
        return 0;

    // v = b/rr r + tangent; afterwards -rim/rr r + stretch * tangent, of equal
    // length: stretch^2 = (vv - rim^2/rr) / (vv - b^2/rr)
    dd bb = dd_div(dd_mul(p.b, p.b), p.rr), rim2 = dd_div(dd_mul(rim, rim), p.rr);
    dd stretch =
        dd_sqrt(dd_div(dd_add(vv, dd_negate(rim2)), dd_add(vv, dd_negate(bb))));
    dd along = dd_div(p.b, p.rr), inward = dd_negate(dd_div(rim, p.rr));
    dd w[3];
    for (int i = 0; i < 3; i++) {
        dd radial = dd_mul_d(along, p.r[i]);
        dd tangent = dd_add(p.v[i], dd_negate(radial));
        dd after = dd_add(dd_mul(stretch, tangent), dd_mul_d(inward, p.r[i]));
        w[i] = dd_add(after, dd_negate(p.v[i]));
    }
    pair_kick(&p, w, v1, v2);
    *owed = energy_owed(&p);
    return 1;
}

int brink_rim_impulse(const double r[3], double m1, double m2, double v1[3],
                      double v2[3])
{
    double owed = 0;
    return brink_rim_impulse_balanced(r, m1, m2, v1, v2, &owed);
}
