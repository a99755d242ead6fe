// SPDX-License-Identifier: MIT
// The account of energy: nothing is lost from it, what can be paid is, and
// nothing else follows from what is owed.
#include <brink/impulse.h>

#include "impulse_cases.h"
#include <float.h>

typedef aftermath impulse(const impact *p, double owed);

static aftermath step_of(const impact *p, double owed)
{
    aftermath a = before_impact(p, owed);
    a.crossed = brink_step_impulse_balanced(
        p->r, p->m1, p->m2, p->rise, way_of(p), a.v1, a.v2, &a.virial, &a.owed);
    return a;
}

static aftermath core_of(const impact *p, double owed)
{
    aftermath a = before_impact(p, owed);
    a.virial =
        brink_core_impulse_balanced(p->r, p->m1, p->m2, a.v1, a.v2, &a.owed);
    return a;
}

static aftermath rim_of(const impact *p, double owed)
{
    aftermath a = before_impact(p, owed);
    a.crossed =
        brink_rim_impulse_balanced(p->r, p->m1, p->m2, a.v1, a.v2, &a.owed);
    return a;
}

/** The same without an account, as a step, a core, the rim. */
static aftermath without(const impact *p, impulse *balanced)
{
    aftermath a = before_impact(p, 0);
    if (balanced == step_of)
        a.crossed = brink_step_impulse(p->r, p->m1, p->m2, p->rise, way_of(p),
                                       a.v1, a.v2, &a.virial);
    else if (balanced == core_of)
        a.virial = brink_core_impulse(p->r, p->m1, p->m2, a.v1, a.v2);
    else
        a.crossed = brink_rim_impulse(p->r, p->m1, p->m2, a.v1, a.v2);
    return a;
}

static double energy_of(const impact *p)
{
    const double v1 = oracle_size(p->v1), v2 = oracle_size(p->v2);
    return p->m1 * v1 * v1 + p->m2 * v2 * v2;
}

/** Nothing, a rounding's worth, or up to more than there is. */
static double some_debt(stream *s, const impact *p)
{
    switch (stream_int(s, 0, 3)) {
    case 0:
        return 0;
    case 1:
        return stream_real(s, -2, 2) * DBL_EPSILON * energy_of(p);
    default:
        return stream_scaled(s, -70, 4) * energy_of(p);
    }
}

/** mu b'^2 / 2 r.r, the radial energy with which a pair goes on from a step, or
 *  0 where it does not meet it. */
static double radial_energy(const impact *p, double rise, int way)
{
    const oracle_pair before = pair_before(p);
    oracle_turn turn;
    mpfr_t after;
    oracle_turn_make(&turn, p->r, rise, way, &before);
    mpfr_init2(after, ORACLE_BITS);
    mpfr_add(after, turn.b, turn.change, ORACLE_N);
    mpfr_sqr(after, after, ORACLE_N);
    mpfr_div(after, after, turn.rr, ORACLE_N);
    mpfr_mul_d(after, after, p->m1, ORACLE_N);
    mpfr_mul_d(after, after, p->m2, ORACLE_N);
    mpfr_set_d(turn.rr, p->m1, ORACLE_N);
    mpfr_add_d(turn.rr, turn.rr, p->m2, ORACLE_N);
    mpfr_div(after, after, turn.rr, ORACLE_N);
    const double energy = mpfr_get_d(after, ORACLE_N) / 2;
    const int meets = turn.crosses || mpfr_sgn(turn.b) * way > 0;
    mpfr_clear(after);
    oracle_turn_clear(&turn);
    return meets ? energy : 0;
}

static void check(const impact *p, impulse *f, double owed)
{
    const aftermath a = f(p, owed), none = f(p, 0), plain = without(p, f);
    const oracle_pair before = pair_before(p), after = pair_after(p, &a);
    const double largest = oracle_largest_energy(&before, &after);
    const double bound = BRINK_IMPULSE_BALANCE * largest + 0x1p-49 * fabs(owed);
    const double rise = a.crossed && f == step_of ? p->rise : 0;
    const double off = oracle_off_balance(&before, owed, &after, a.owed, rise);
    if (!(off <= bound))
        impact_broken("the account is off", p, &a, off);
    if (a.crossed != none.crossed || none.crossed != plain.crossed)
        impact_broken("a debt decides", p, &a, owed);
    if (memcmp(none.v1, plain.v1, sizeof none.v1) != 0 ||
        memcmp(none.v2, plain.v2, sizeof none.v2) != 0)
        impact_broken("where nothing is owed", p, &none, 0);
}

/** What is left of a debt that could be paid, 2^-21 of the radial energy or less:
 *  half an ulp of each of six components, times the momentum. */
static void check_payment(const impact *p, impulse *f, double rise, int way,
                          stream *s)
{
    const double radial = radial_energy(p, rise, way);
    const double owed = stream_real(s, -1, 1) * 0x1p-21 * radial;
    const aftermath a = f(p, owed);
    const oracle_pair before = pair_before(p), after = pair_after(p, &a);
    const double largest = oracle_largest_energy(&before, &after);
    if (owed != 0 && !(fabs(a.owed) <= 6 * DBL_EPSILON * largest))
        impact_broken("what could be paid is not", p, &a, owed);
}

/** Far from where energies leave the range of doubles. */
static int is_moderate_impact(const impact *p)
{
    const double energy = energy_of(p);
    return energy > 0x1p-800 && energy < 0x1p800 && fabs(p->rise) < 0x1p800;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stream s = stream_of_bytes(data, size);
    const int kind = stream_int(&s, 0, 3);
    const impact p = kind ? some_impact(&s) : some_rim_impact(&s);
    if (is_at_one_place(&p) || !is_moderate_impact(&p))
        return 0;
    check(&p, step_of, some_debt(&s, &p));
    check(&p, core_of, some_debt(&s, &p));
    check(&p, rim_of, some_debt(&s, &p));
    check_payment(&p, step_of, p.rise, (int)p.way, &s);
    check_payment(&p, core_of, (double)INFINITY, BRINK_INWARD, &s);
    return 0;
}
