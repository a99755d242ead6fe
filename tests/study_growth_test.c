// SPDX-License-Identifier: MIT
#include "random.h"
#include "study_growth.h"
#include "suite.h"
#include <inttypes.h>
#include <time.h>

// Samples at the points of a trial, of an energy that gains so between them.
static brink_trial strayed(double (*gain)(stream *, double events), stream *s)
{
    brink_trial t = {0};
    uint64_t events = 0;
    double kept = 0;
    while (events < 100000000) {
        const uint64_t next = brink_trial_next_sample(events);
        kept += gain(s, (double)(next - events));
        events = next;
        t.sample[t.samples++] = (brink_sample){.events = events, .kept = kept};
    }
    return t;
}

// Of the walk's law: the sum of twelve uniform numbers is nearly normal.
static double walk(stream *s, double events)
{
    double normal = -6;
    for (int k = 0; k < 12; k++)
        normal += stream_real(s, 0, 1);
    return 1e-19 * sqrt(events) * normal;
}

static double drift(stream *s, double events)
{
    (void)s;
    return 1e-19 * events;
}

// The error is a standard one: of a walk 6 of them are exceeded once in 10^8.
START_TEST(a_random_walk_has_the_exponent_one_half)
{
    stream s = stream_of_seed((uint64_t)time(NULL));
    const uint64_t seed = s.state;
    const brink_trial t = strayed(walk, &s);
    const brink_growth g = brink_growth_of(&t);
    ck_assert_msg(fabs(g.exponent - 0.5) < 6 * g.error,
                  "seed %" PRIu64 ": %g +- %g", seed, g.exponent, g.error);
    // ln |normal| scatters by 1.11, 150 gains, log events by 5: some 0.02.
    ck_assert_msg(g.error < 0.05, "seed %" PRIu64 ": %g", seed, g.error);
    // A mean of 150 squares: the root of it is known to 1 / sqrt(300).
    ck_assert_msg(fabs(g.walk / 1e-19 - 1) < 6 / sqrt(300),
                  "seed %" PRIu64 ": %a", seed, g.walk);
    ck_assert_double_eq(g.end, t.sample[t.samples - 1].kept);
}
END_TEST

START_TEST(a_drift_has_the_exponent_one)
{
    const brink_trial t = strayed(drift, NULL);
    const brink_growth g = brink_growth_of(&t);
    // Each gain is a difference of two sums that are up to 1e8 of its unit: so
    // many roundings of the first are some 1e-8 of itself, in a logarithm.
    ck_assert_double_eq_tol(g.exponent, 1, 1e-7);
}
END_TEST

START_TEST(of_two_gains_no_exponent_is_told)
{
    brink_trial t = {.samples = 2};
    t.sample[0] = (brink_sample){.events = 1, .kept = 1e-17};
    t.sample[1] = (brink_sample){.events = 9, .kept = 3e-17};
    ck_assert(isnan(brink_growth_of(&t).exponent));
    t.samples = 0;
    ck_assert_double_eq(brink_growth_of(&t).walk, 0);
}
END_TEST

int main(void)
{
    return RUN_SUITE("growth", 60, a_random_walk_has_the_exponent_one_half,
                     a_drift_has_the_exponent_one,
                     of_two_gains_no_exponent_is_told);
}
