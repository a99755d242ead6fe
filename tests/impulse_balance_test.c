// SPDX-License-Identifier: MIT
/* The account of energy: nothing is lost from it, and what can be paid is. */
#include "impacts.h"
#include <float.h>
#include <gsl/gsl_math.h>

/** What an impact leaves. */
typedef struct aftermath {
    double v1[3], v2[3], owed;
    int crossed;
} aftermath;

typedef aftermath impulse(const impact *p, double owed);

static aftermath before(const impact *p, double owed)
{
    aftermath a = {.owed = owed};
    memcpy(a.v1, p->v1, sizeof a.v1);
    memcpy(a.v2, p->v2, sizeof a.v2);
    return a;
}

static aftermath step(const impact *p, double owed)
{
    aftermath a = before(p, owed);
    double virial;
    a.crossed = brink_step_impulse_balanced(p->r, p->m1, p->m2, p->rise, p->way,
                                            a.v1, a.v2, &virial, &a.owed);
    return a;
}

static aftermath core(const impact *p, double owed)
{
    aftermath a = before(p, owed);
    brink_core_impulse_balanced(p->r, p->m1, p->m2, a.v1, a.v2, &a.owed);
    return a;
}

static aftermath rim(const impact *p, double owed)
{
    aftermath a = before(p, owed);
    brink_rim_impulse_balanced(p->r, p->m1, p->m2, a.v1, a.v2, &a.owed);
    return a;
}

/** What may be owed: nothing, a rounding's worth, much, more than there is. */
static double random_debt(stream *s, const impact *p)
{
    const double energy = (p->m1 * gsl_pow_2(length_of(p->v1)) +
                           p->m2 * gsl_pow_2(length_of(p->v2)));
    switch (stream_int(s, 0, 3)) {
    case 0:
        return 0;
    case 1:
        return stream_real(s, -2, 2) * DBL_EPSILON * energy;
    default:
        return stream_scaled(s, -70, 4) * energy;
    }
}

static double largest_energy(const impact *p, const aftermath *a)
{
    const oracle_pair first = {p->m1, p->m2, p->v1, p->v2},
                      then = {p->m1, p->m2, a->v1, a->v2};
    return oracle_largest_energy(&first, &then);
}

static void keep_account(int i, const impact *p, impulse *f, double owed)
{
    const aftermath a = f(p, owed);
    const oracle_pair first = {p->m1, p->m2, p->v1, p->v2},
                      then = {p->m1, p->m2, a.v1, a.v2};
    const double bound =
        BRINK_IMPULSE_BALANCE * largest_energy(p, &a) + 0x1p-49 * fabs(owed);
    const double rise = a.crossed ? p->rise : 0;
    if (!(oracle_off_balance(&first, owed, &then, a.owed, rise) <= bound))
        stop("account", i, p, a.v1, a.v2);
    if (a.crossed != f(p, 0).crossed)
        stop("crossing for a debt", i, p, a.v1, a.v2);
}

START_TEST(nothing_is_lost_from_the_account)
{
    stream s = stream_of_seed(SEED);
    for (int i = 0; i < (int)suite_share(IMPACTS); i++) {
        impact p;
        random_impact(&s, &p);
        const double owed = random_debt(&s, &p);
        keep_account(i, &p, step, owed);
        keep_account(i, &p, core, owed);
        p.way = p.way == BRINK_INWARD ? BRINK_OUTWARD : BRINK_INWARD;
        keep_account(i, &p, step, owed);
    }
}
END_TEST
START_TEST(nothing_is_lost_on_the_rim)
{
    stream s = stream_of_seed(SEED);
    for (int i = 0; i < (int)suite_share(IMPACTS); i++) {
        impact p;
        pair_case on_rim;
        random_impact(&s, &p);
        family_rim(&s, &on_rim);
        memcpy(p.r, on_rim.r, sizeof p.r);
        for (int k = 0; k < 3; k++)
            p.v1[k] = p.v2[k] + on_rim.v[k];
        keep_account(i, &p, rim, random_debt(&s, &p));
    }
}
END_TEST

// What is left on the account when something was paid is what the last rounding
// took: half an ulp of each of six components, times the momentum.  `radial` is
// the energy along the line of centres that the pair goes on with.
static void pays_what_it_can(int i, const impact *p, impulse *f, double radial,
                             double share)
{
    const double owed = share * 0x1p-20 * radial;
    const aftermath a = f(p, owed);
    if (!(fabs(a.owed) <= 6 * DBL_EPSILON * largest_energy(p, &a)))
        stop("not paid", i, p, a.v1, a.v2);
    // Of more than there is to give and take nothing is paid.
    const double much = 0x1.1p-20 * radial;
    const aftermath none = f(p, much), plain = f(p, 0);
    if (!(fabs(none.owed - much) <= 6 * DBL_EPSILON * largest_energy(p, &none)) ||
        memcmp(none.v1, plain.v1, sizeof none.v1) != 0 ||
        memcmp(none.v2, plain.v2, sizeof none.v2) != 0)
        stop("paid too much", i, p, none.v1, none.v2);
}

START_TEST(what_can_be_paid_is)
{
    stream s = stream_of_seed(SEED);
    int paid = 0;
    for (int i = 0; i < (int)suite_share(IMPACTS); i++) {
        impact p;
        random_impact(&s, &p);
        p.way = BRINK_INWARD;
        double b = 0, rr = 0;
        for (int k = 0; k < 3; k++) {
            b += p.r[k] * (p.v1[k] - p.v2[k]);
            rr += p.r[k] * p.r[k];
        }
        const double mu = p.m1 / (p.m1 + p.m2) * p.m2;
        const double radial = mu * b * b / (2 * rr);
        const double share = stream_real(&s, -0.9, 0.9);
        if (b >= 0) { // going apart: nothing happens, and nothing is paid
            ck_assert(core(&p, share).owed == share);
            continue;
        }
        paid++;
        pays_what_it_can(i, &p, core, radial, share);
        p.rise = stream_real(&s, -1, 0.9) * radial;
        pays_what_it_can(i, &p, step, radial - p.rise, share);
    }
    ck_assert_int_gt(paid, (int)suite_share(IMPACTS) / 4);
}
END_TEST

int main(void)
{
    return RUN_SUITE("impulse, balance", 600, nothing_is_lost_from_the_account,
                     nothing_is_lost_on_the_rim, what_can_be_paid_is);
}
