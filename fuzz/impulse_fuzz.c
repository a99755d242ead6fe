// SPDX-License-Identifier: MIT
#include <brink/impulse.h>

#include "../tests/impulse_paths.h"
#include "impulse_cases.h"

static aftermath step_of(const impact *p)
{
    aftermath a = before_impact(p, 0);
    a.crossed = brink_step_impulse(p->r, p->m1, p->m2, p->rise, way_of(p), a.v1,
                                   a.v2, &a.virial);
    return a;
}

static aftermath core_of(const impact *p)
{
    aftermath a = before_impact(p, 0);
    a.virial = brink_core_impulse(p->r, p->m1, p->m2, a.v1, a.v2);
    return a;
}

static aftermath rim_of(const impact *p)
{
    aftermath a = before_impact(p, 0);
    a.crossed = brink_rim_impulse(p->r, p->m1, p->m2, a.v1, a.v2);
    return a;
}

static int is_unchanged(const impact *p, const aftermath *a)
{
    return memcmp(a->v1, p->v1, sizeof a->v1) == 0 &&
           memcmp(a->v2, p->v2, sizeof a->v2) == 0;
}

static void expect_unchanged(const impact *p, const aftermath *a)
{
    if (!is_unchanged(p, a) || a->virial != 0 || a->crossed)
        impact_broken("nothing was to happen", p, a, 0);
}

// --- The contract --------------------------------------------------------------

static void keep_what_is_conserved(const impact *p, const aftermath *a,
                                   double rise)
{
    const oracle_pair before = pair_before(p), after = pair_after(p, a);
    const double energy = oracle_energy_error(&before, &after, rise);
    const double momentum = oracle_momentum_error(&before, &after);
    if (!(energy <= BRINK_IMPULSE_ENERGY_ULP))
        impact_broken("energy, off by so many ulp", p, a, energy);
    if (!(momentum <= BRINK_IMPULSE_MOMENTUM_ULP))
        impact_broken("momentum, off by so many ulp", p, a, momentum);
}

/** Whether it crosses, how fast it goes on and which way, and the virial: as the
 *  turn has it, which is exact. */
static void keep_to_turn(const impact *p, const aftermath *a,
                         const oracle_turn *turn)
{
    const oracle_pair before = pair_before(p), after = pair_after(p, a);
    if (a->crossed != turn->crosses)
        impact_broken("crossed, or reflected", p, a, 0);
    if (!oracle_turned(turn, p->r, &before, &after))
        impact_broken("velocities are rounded more than once", p, a, 0);
    const double virial = oracle_virial(turn, &before);
    // It is three numbers of double-double, cut to a double; nothing of the rest
    // is seen in a velocity.
    const double unit =
        oracle_size(p->r) * oracle_largest_momentum(&before, &after);
    if (isnormal(virial) &&
        !(fabs(a->virial - virial) <= 0x1p-52 * fabs(virial) + 0x1p-90 * unit))
        impact_broken("the virial", p, a, virial);
    keep_what_is_conserved(p, a, a->crossed ? p->rise : 0);
}

static void check_step(const impact *p)
{
    const oracle_pair before = pair_before(p);
    const aftermath a = step_of(p);
    oracle_turn turn;
    oracle_turn_make(&turn, p->r, p->rise, (int)p->way, &before);
    keep_to_turn(p, &a, &turn);
    oracle_turn_clear(&turn);
}

/** A core is a step that nothing crosses; those who go apart it leaves alone. */
static void check_core(const impact *p)
{
    const oracle_pair before = pair_before(p);
    const aftermath a = core_of(p);
    oracle_turn turn;
    oracle_turn_make(&turn, p->r, (double)INFINITY, BRINK_INWARD, &before);
    if (mpfr_sgn(turn.b) < 0)
        keep_to_turn(p, &a, &turn);
    else
        expect_unchanged(p, &a);
    if (!(a.virial >= 0))
        impact_broken("a core's virial", p, &a, 0);
    oracle_turn_clear(&turn);
}

/** Turned below the least angle, and then at it, inward, as exactly as rounded
 *  velocities can be: one that is off by an ulp of the speeds turns the relative
 *  velocity by so much of itself, and 2^-24 of the angle is 2^24 times that. */
static void check_rim(const impact *p)
{
    const aftermath a = rim_of(p);
    const oracle_rim was = oracle_rim_of(p->r, p->v1, p->v2);
    if (isnan(was.times))
        return; // at relative rest
    if (a.crossed != was.is_below && fabs(was.times - 1) > 0x1p-50)
        impact_broken("turned, or not", p, &a, was.times);
    if (!a.crossed) {
        expect_unchanged(p, &a);
        return;
    }
    keep_what_is_conserved(p, &a, 0);
    double relative[3];
    for (int k = 0; k < 3; k++)
        relative[k] = a.v1[k] - a.v2[k];
    const double speeds = oracle_size(a.v1) + oracle_size(a.v2);
    const double slack = 0x1p-52 * speeds / oracle_size(relative);
    const oracle_rim is = oracle_rim_of(p->r, a.v1, a.v2);
    const double then = sqrt(is.times);
    if (slack < 0x1p-30 && !is.is_inward)
        impact_broken("turned outward", p, &a, then);
    if (!(fabs(then - 1) * BRINK_RIM_ANGLE <= 2 * slack))
        impact_broken("turned to another angle", p, &a, then);
}

// --- Laws ----------------------------------------------------------------------

static void expect_same(const char *law, const impact *p, const aftermath *a,
                        const aftermath *b)
{
    int right = a->crossed == b->crossed && same(a->virial, b->virial);
    for (int k = 0; k < 3; k++)
        right = right && a->v1[k] == b->v1[k] && a->v2[k] == b->v2[k];
    if (!right)
        impact_broken(law, p, b, a->virial);
}

/** Every product is mirrored, too: the same bits. */
static void mirror(const impact *p, aftermath (*impulse)(const impact *),
                   stream *s)
{
    const aftermath a = impulse(p);
    const int axes = stream_int(s, 1, 7);
    impact q = *p;
    for (int k = 0; k < 3; k++)
        if (axes >> k & 1) {
            q.r[k] = -q.r[k];
            q.v1[k] = -q.v1[k];
            q.v2[k] = -q.v2[k];
        }
    aftermath b = impulse(&q);
    for (int k = 0; k < 3; k++)
        if (axes >> k & 1) {
            b.v1[k] = -b.v1[k];
            b.v2[k] = -b.v2[k];
        }
    expect_same("mirrored", p, &a, &b);
}

/** Whether a number may be given other units: at either time far from where
 *  doubles end. */
static int rescale(double *to, double x, int e)
{
    const double least = 0x1p-900, most = 0x1p900;
    *to = ldexp(x, e);
    return x == 0 || (fabs(x) > least && fabs(x) < most && fabs(*to) > least &&
                      fabs(*to) < most);
}

/** Powers of two are taken out before anything is rounded. */
static void scale(const impact *p, aftermath (*impulse)(const impact *),
                  stream *s)
{
    const int er = stream_int(s, -500, 500), ev = stream_int(s, -200, 200),
              em = stream_int(s, -200, 200);
    const aftermath a = impulse(p);
    impact q = {.way = p->way};
    aftermath want = {.crossed = a.crossed};
    int can = rescale(&q.m1, p->m1, em) && rescale(&q.m2, p->m2, em) &&
              rescale(&q.rise, p->rise, em + 2 * ev) &&
              rescale(&want.virial, a.virial, er + ev + em);
    for (int k = 0; k < 3; k++)
        can = can && rescale(&q.r[k], p->r[k], er) &&
              rescale(&q.v1[k], p->v1[k], ev) &&
              rescale(&q.v2[k], p->v2[k], ev) &&
              rescale(&want.v1[k], a.v1[k], ev) &&
              rescale(&want.v2[k], a.v2[k], ev);
    if (!can)
        return;
    const aftermath b = impulse(&q);
    if (a.virial == 0) // or too small for a double
        want.virial = b.virial;
    expect_same("in other units", &q, &want, &b);
}

static void keep_to_paths(const impact *p)
{
    for (int path = 1; path < PATHS_IN_ALL && can_try(path); path++) {
        const aftermath a = step_of(p);
        const int k =
            impulses_differ(path, p->r, p->m1, p->m2, p->rise, p->v1, p->v2);
        if (k >= 0)
            impact_broken("another path, other bits", p, &a, k);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const struct {
        impact (*some)(stream *);
        void (*check)(const impact *);
        aftermath (*impulse)(const impact *);
    } kinds[] = {
        {some_impact, check_step, step_of},
        {some_impact, check_core, core_of},
        {some_rim_impact, check_rim, rim_of},
        {some_rim_impact, check_step, step_of},
    };
    stream s = stream_of_bytes(data, size);
    const int kind = stream_int(&s, 0, 3);
    const impact p = kinds[kind].some(&s);
    if (is_at_one_place(&p))
        return 0;
    kinds[kind].check(&p);
    mirror(&p, kinds[kind].impulse, &s);
    scale(&p, kinds[kind].impulse, &s);
    keep_to_paths(&p);
    return 0;
}
