// SPDX-License-Identifier: MIT
// What Coq is told impulse.c does is what it does.
#include "transcribed/impulse_change_v.h"
#include "transcribed/impulse_core_v.h"
#include "transcribed/impulse_crossing_v.h"
#include "transcribed/impulse_decision_v.h"
#include "transcribed/impulse_kick_v.h"
#include "transcribed/impulse_payment_v.h"
#include "transcribed/impulse_rim_v.h"
#include "transcribed/impulse_sums_v.h"

#define BRINK_PATH transcribed // its functions beside the library's
// NOLINTNEXTLINE(bugprone-suspicious-include): for what is static there
#include "../kernels/impulse.c"

/** A pair, its components of any sizes near one another, b at times all but 0. */
static void any_pair(stream *s, pair *p, double rise)
{
    double r[3], v1[3], v2[3];
    for (int k = 0; k < 3; k++) {
        r[k] = stream_scaled(s, -20, 20);
        v1[k] = stream_scaled(s, -20, 20);
        v2[k] = stream_scaled(s, -20, 20);
    }
    if (stream_int(s, 0, 1))
        v1[2] = v2[2] - (r[0] * (v1[0] - v2[0]) + r[1] * (v1[1] - v2[1])) / r[2];
    const double m1 = fabs(stream_scaled(s, -20, 20));
    const double m2 = fabs(stream_scaled(s, -20, 20));
    pair_make(p, r, m1, m2, rise, v1, v2, 0);
}

#define VECTOR(v)  (v)[0], (v)[1], (v)[2]
#define LENGTHS(p) VECTOR((p).r)
#define SPEEDS(p)  VECTOR((p).v1), VECTOR((p).v2)
#define MASSES(p)  (p).m1, (p).m2
#define NUMBERS(p) LENGTHS(p), SPEEDS(p), MASSES(p)

/** Some part of a speed's energy, or nothing, or what is too much to be paid. */
static double any_owed(stream *s, const pair *p, double speed)
{
    const double energy = p->mu.hi * speed * speed / (2 * p->rr.hi);
    return stream_int(s, 0, 7) ? stream_scaled(s, -60, -16) * energy : 0;
}

START_TEST(a_pair_is_that_of_the_proof)
{
    EACH_INPUT(s)
    {
        pair p;
        any_pair(&s, &p, 0);
        SAME_DD(impulse_decision_v_b(LENGTHS(p), SPEEDS(p)), p.b, NUMBERS(p));
        SAME_DD(impulse_decision_v_rr(LENGTHS(p)), p.rr, NUMBERS(p));
        SAME_DD(impulse_decision_v_k1(MASSES(p)), p.k1, NUMBERS(p));
        SAME_DD(impulse_sums_v_share(p.m1, p.m2), p.k1, NUMBERS(p));
        SAME_DD(impulse_sums_v_share(p.m2, p.m1), p.k2, NUMBERS(p));
        SAME_DD(impulse_decision_v_mu(MASSES(p)), p.mu, NUMBERS(p));
    }
}
END_TEST

/** A rise about as high as the pair can climb, or of any height. */
static enum brink_direction any_step(stream *s, pair *p, double *rise)
{
    any_pair(s, p, 0);
    *rise = stream_scaled(s, -80, 80);
    if (stream_int(s, 0, 1))
        *rise = stream_near(s, p->mu.hi * p->b.hi * p->b.hi / (2 * p->rr.hi), 3);
    return stream_int(s, 0, 1) ? BRINK_INWARD : BRINK_OUTWARD;
}

START_TEST(a_decision_is_that_of_the_proof)
{
    EACH_INPUT(s)
    {
        pair p;
        double rise;
        const enum brink_direction way = any_step(&s, &p, &rise);
        const crossing c = crossing_of(&p, ldexp(rise, p.em + 2 * p.ev), way);
        const double margin =
            impulse_decision_v_margin(LENGTHS(p), MASSES(p), rise, 0x1p900);
        SAME_DD(impulse_decision_v_loss(LENGTHS(p), MASSES(p), rise, 0x1p900),
                c.loss, NUMBERS(p), rise);
        SAME_DD(impulse_decision_v_rest(NUMBERS(p), way, rise, 0x1p900), c.rest,
                NUMBERS(p), rise, way);
        SAME(margin < fabs(c.rest.hi), is_decided(&c), NUMBERS(p), rise, way);
    }
}
END_TEST

/** Whatever the kick: a double-double. */
START_TEST(a_kick_is_that_of_the_proof)
{
    EACH_INPUT(s)
    {
        pair p;
        any_pair(&s, &p, 0);
        dd w[3];
        for (int k = 0; k < 3; k++) {
            const double hi = stream_scaled(&s, -20, 20);
            w[k] = two_sum(hi, stream_scaled(&s, -60, -53) * hi);
        }
        const double owed = p.owed = stream_scaled(&s, -60, 0);
        double v1[3] = {0}, v2[3] = {0};
        pair_kick(&p, w, v1, v2);
        SAME(impulse_kick_v_owed_after(MASSES(p), VECTOR(w), SPEEDS(p), owed),
             p.owed, NUMBERS(p), owed);
        for (int k = 0; k < 3; k++) {
            const dd one = impulse_sums_v_kicked(p.k1, w[k], p.v1[k]);
            const dd two = impulse_sums_v_kicked(p.k2, dd_negate(w[k]), p.v2[k]);
            SAME(one.hi, ldexp(v1[k], -p.ev), NUMBERS(p), w[k].hi, w[k].lo);
            SAME(two.hi, ldexp(v2[k], -p.ev), NUMBERS(p), w[k].hi, w[k].lo);
        }
    }
}
END_TEST

START_TEST(a_payment_is_that_of_the_proof)
{
    EACH_INPUT(s)
    {
        pair p;
        any_pair(&s, &p, 0);
        const double speed = fabs(stream_scaled(&s, -20, 20));
        const double owed = p.owed = any_owed(&s, &p, speed);
        SAME(impulse_payment_v_payment(p.rr.hi, p.mu.hi, owed, speed),
             pair_pay(&p, speed), p.rr.hi, p.mu.hi, owed, speed);
        SAME(impulse_payment_v_left_owed(p.rr.hi, p.mu.hi, owed, speed), p.owed,
             p.rr.hi, p.mu.hi, owed, speed);
    }
}
END_TEST

/** Velocities 0 in and out: what is changed is seen. */
static void same_change(const pair *given, dd change)
{
    pair p = *given, q = *given;
    const dd w[3] = {impulse_change_v_w0(LENGTHS(p), change),
                     impulse_change_v_w1(LENGTHS(p), change),
                     impulse_change_v_w2(LENGTHS(p), change)};
    double v1[3] = {0}, v2[3] = {0}, want1[3] = {0}, want2[3] = {0};
    pair_change(&p, change, v1, v2);
    pair_kick(&q, w, want1, want2);
    for (int k = 0; k < 3; k++) {
        SAME(want1[k], v1[k], NUMBERS(p), change.hi, change.lo, k);
        SAME(want2[k], v2[k], NUMBERS(p), change.hi, change.lo, k);
    }
}

START_TEST(a_core_is_that_of_the_proof)
{
    EACH_INPUT(s)
    {
        pair p;
        any_pair(&s, &p, 0);
        const enum brink_direction way =
            p.b.hi < 0 ? BRINK_INWARD : BRINK_OUTWARD;
        if (p.b.hi == 0) // nothing to do
            continue;
        const double owed = p.owed = any_owed(&s, &p, p.b.hi);
        const dd change = reflection(&p, way);
        SAME_DD(impulse_core_v_reflection(NUMBERS(p), way, owed), change,
                NUMBERS(p), way, owed);
        SAME(impulse_core_v_left(NUMBERS(p), way, owed), p.owed, NUMBERS(p), way,
             owed);
        same_change(&p, change);
    }
}
END_TEST

START_TEST(a_crossing_is_that_of_the_proof)
{
    EACH_INPUT(s)
    {
        pair p;
        double rise;
        const enum brink_direction way = any_step(&s, &p, &rise);
        const crossing c = crossing_of(&p, ldexp(rise, p.em + 2 * p.ev), way);
        const double owed = p.owed = any_owed(&s, &p, sqrt(fabs(c.rest.hi)));
        const dd change = crossed(&p, &c, way);
        const dd told =
            impulse_crossing_v_crossed(NUMBERS(p), way, rise, 0x1p900, owed);
        // + 0.0: 0 for -0
        SAME(told.hi + 0.0, change.hi + 0.0, NUMBERS(p), way, rise, owed);
        SAME(told.lo + 0.0, change.lo + 0.0, NUMBERS(p), way, rise, owed);
        SAME(impulse_crossing_v_left(NUMBERS(p), way, rise, 0x1p900, owed),
             p.owed, NUMBERS(p), way, rise, owed);
        if (change.hi != 0)
            same_change(&p, change);
    }
}
END_TEST

/** With a speed along r of some parts of the rim's: what any_pair() lacks. */
static void slow_down(stream *s, pair *p)
{
    double vv = 0;
    for (int k = 0; k < 3; k++)
        vv += (p->v1[k] - p->v2[k]) * (p->v1[k] - p->v2[k]);
    const double speed = stream_scaled(s, -40, -23) * sqrt(p->rr.hi * vv);
    double v1[3], v2[3];
    for (int k = 0; k < 3; k++) {
        v1[k] = p->v1[k] + (speed - p->b.hi) / p->rr.hi * p->r[k];
        v2[k] = p->v2[k];
    }
    pair_make(p, p->r, p->m1, p->m2, 0, v1, v2, 0);
}

START_TEST(a_rim_rule_is_that_of_the_proof)
{
    uint64_t turned = 0, all = suite_share(TRANSCRIPTION_INPUTS);
    EACH_INPUT(s)
    {
        pair p;
        any_pair(&s, &p, 0);
        slow_down(&s, &p);
        double owed = stream_scaled(&s, -60, 0), v1[3], v2[3], want1[3], want2[3];
        for (int k = 0; k < 3; k++) {
            v1[k] = want1[k] = p.v1[k];
            v2[k] = want2[k] = p.v2[k];
        }
        pair_make(&p, p.r, p.m1, p.m2, 0, v1, v2, owed);
        const int turns =
            fabs(p.b.hi) < impulse_rim_v_most(LENGTHS(p), SPEEDS(p)).hi;
        if (turns) {
            const dd w[3] = {impulse_rim_v_t0(LENGTHS(p), SPEEDS(p)),
                             impulse_rim_v_t1(LENGTHS(p), SPEEDS(p)),
                             impulse_rim_v_t2(LENGTHS(p), SPEEDS(p))};
            pair_kick(&p, w, want1, want2);
            turned++;
        }
        SAME(turns, brink_rim_impulse_balanced(p.r, p.m1, p.m2, v1, v2, &owed),
             NUMBERS(p));
        SAME(energy_owed(&p), owed, NUMBERS(p));
        for (int k = 0; k < 3; k++) {
            SAME(want1[k], v1[k], NUMBERS(p), k);
            SAME(want2[k], v2[k], NUMBERS(p), k);
        }
    }
    ck_assert(turned > all / 4 && turned < all);
}
END_TEST

int main(void)
{
    return RUN_SUITE("impulse, transcribed", 120, a_pair_is_that_of_the_proof,
                     a_decision_is_that_of_the_proof, a_kick_is_that_of_the_proof,
                     a_payment_is_that_of_the_proof, a_core_is_that_of_the_proof,
                     a_crossing_is_that_of_the_proof,
                     a_rim_rule_is_that_of_the_proof);
}
