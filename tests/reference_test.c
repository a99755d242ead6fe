// SPDX-License-Identifier: MIT
/* The reference simulator on cases one can do by hand.  That it and the simulator
 * agree is the business of sequence_test.c. */
#include "reference.h"
#include "suite.h"
#include <float.h>
#include <gsl/gsl_rng.h>
#include <math.h>

enum { BITS = 256, CROWD = 8 };

static const brink_potential hard = {1, (const double[]){1},
                                     (const double[]){(double)INFINITY}};
static const brink_potential well = {2, (const double[]){2, 1},
                                     (const double[]){-1, (double)INFINITY}};

typedef struct body {
    double x[3], v[3];
} body;

static void make(brink_system *s, double length, const brink_potential *potential,
                 uint32_t n, const body *bodies)
{
    const brink_species species = {"A", 1, 1, n};
    const double box[3] = {length, length, length};
    ck_assert_int_eq(brink_system_create(s, 3, box, 1, n, 1, &species, potential),
                     0);
    for (uint32_t i = 0; i < n; i++)
        for (int k = 0; k < 3; k++) {
            s->particle[i].x[k] = brink_system_fraction(s, k, bodies[i].x[k]);
            s->particle[i].v[k] = bodies[i].v[k];
        }
}

static void expect(reference *w, enum brink_event_kind kind, uint32_t i,
                   uint32_t j, double time)
{
    reference_event e;
    ck_assert_int_eq(reference_next(w, &e), 1);
    ck_assert_int_eq(e.kind, kind);
    ck_assert_uint_eq(e.i, i);
    ck_assert_uint_eq(e.j, j);
    ck_assert_msg(e.time == time, "at %a, not %a", e.time, time);
}

START_TEST(two_that_meet_head_on_exchange_velocities_and_meet_again_round_the_box)
{
    brink_system s;
    reference w;
    make(&s, 8, &hard, 2,
         (const body[]){{{2, 4, 4}, {1, 0, 0}}, {{5, 4, 4}, {-1, 0, 0}}});
    reference_create(&w, &s, BITS);
    for (int n = 0; n < 4;
         n++) // apart from 1 to 7 = 8 - 1 at a relative speed of 2
        expect(&w, BRINK_CORE, 0, 1, 1 + 3 * n);
    ck_assert_int_eq(mpfr_cmp_d(w.v[0][0], 1), 0);
    ck_assert_int_eq(mpfr_cmp_d(w.v[1][0], -1), 0);
    reference_destroy(&w);
    brink_system_destroy(&s);
}
END_TEST

START_TEST(a_cradle_hands_its_motion_on_in_order)
{
    brink_system s;
    reference w;
    make(&s, 16, &hard, 4,
         (const body[]){{{1, 1, 1}, {1, 0, 0}},
                        {{3, 1, 1}, {0, 0, 0}},
                        {{4, 1, 1}, {0, 0, 0}},
                        {{6, 1, 1}, {0, 0, 0}}});
    reference_create(&w, &s, BITS);
    expect(&w, BRINK_CORE, 0, 1, 1);
    expect(&w, BRINK_CORE, 1, 2, 1); // they touched
    expect(&w, BRINK_CORE, 2, 3, 2);
    expect(&w, BRINK_CORE, 0, 3, 2 + 11); // from 6 to one short of 2 + 16
    reference_destroy(&w);
    brink_system_destroy(&s);
}
END_TEST

START_TEST(what_touches_and_parts_or_passes_by_or_is_at_rest_has_no_event)
{
    static const body cases[][2] = {
        {{{2, 4, 4}, {-1, 0, 0}},
         {{3, 4, 4}, {-0.5, 0, 0}}},                      // touches and parts,
                                                          // to meet round the box
        {{{2, 4, 4}, {0, 1, 0}}, {{5, 4, 4}, {0, 1, 0}}}, // same velocity
        {{{2, 4, 4}, {1, 0, 0}}, {{5, 5, 4}, {1, 0, 0}}},
        {{{2, 4, 4}, {0, 0, 0}}, {{5, 4, 4}, {0, 0, 0}}},
        {{{2, 4, 4}, {1, 0, 0}}, {{5, 5, 4}, {-1, 0, 0}}}, // exactly tangent
    };
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        brink_system s;
        reference w;
        reference_event e;
        make(&s, 8, &hard, 2, cases[n]);
        reference_create(&w, &s, BITS);
        if (n == 0)
            expect(&w, BRINK_CORE, 0, 1, 6 / 0.5);
        else
            ck_assert_msg(!reference_next(&w, &e), "case %zu, at %a", n, e.time);
        reference_destroy(&w);
        brink_system_destroy(&s);
    }
}
END_TEST

START_TEST(a_well_speeds_up_what_it_captures_and_gives_it_back)
{
    // Reduced mass 1/2, relative speed 2: radial energy 1 outside, 2 inside,
    // where the relative speed is 2 sqrt 2.  That takes 1 / sqrt 2 from 2 to 1
    // and back.
    brink_system s;
    reference w;
    make(&s, 16, &well, 2,
         (const body[]){{{2, 4, 4}, {1, 0, 0}}, {{6, 4, 4}, {-1, 0, 0}}});
    reference_create(&w, &s, BITS);
    expect(&w, BRINK_CAPTURE, 0, 1, 1);
    expect(&w, BRINK_CORE, 0, 1, 1 + sqrt(0.125));
    expect(&w, BRINK_RELEASE, 0, 1, 1 + sqrt(0.5));
    ck_assert_int_eq(w.level[1], 0);
    reference_destroy(&w);
    brink_system_destroy(&s);
}
END_TEST

START_TEST(a_pair_made_inside_a_well_too_deep_for_it_bounces_there)
{
    brink_system s;
    reference w;
    make(&s, 16, &well, 2, // from 1.5 to 2 at 1, 2 to 1 and back
         (const body[]){{{4, 4, 4}, {0, 0, 0}}, {{5.5, 4, 4}, {1, 0, 0}}});
    reference_create(&w, &s, BITS);
    ck_assert_int_eq(w.level[1], 1);
    expect(&w, BRINK_BOUNCE, 0, 1, 0.5);
    expect(&w, BRINK_CORE, 0, 1, 1.5);
    expect(&w, BRINK_BOUNCE, 0, 1, 2.5);
    ck_assert_int_eq(w.level[1], 1);
    reference_destroy(&w);
    brink_system_destroy(&s);
}
END_TEST

START_TEST(a_shoulder_is_climbed_by_what_has_more_than_its_height)
{
    // Radial energy exactly 1, as above.
    const double rise[] = {1, 1 - DBL_EPSILON / 2};
    for (int n = 0; n < 2; n++) {
        const brink_potential shoulder = {
            2, (const double[]){2, 1},
            (const double[]){rise[n], (double)INFINITY}};
        brink_system s;
        reference w;
        make(&s, 16, &shoulder, 2,
             (const body[]){{{2, 4, 4}, {1, 0, 0}}, {{6, 4, 4}, {-1, 0, 0}}});
        reference_create(&w, &s, BITS);
        expect(&w, n == 0 ? BRINK_BOUNCE : BRINK_CAPTURE, 0, 1, 1);
        reference_destroy(&w);
        brink_system_destroy(&s);
    }
}
END_TEST

/** Eight at the corners of a cube of 2 in a box of 5, up to 0.4 off, so no closer
 * than 1.2 and not all farther than 2; three of the four corners of a face in
 * each other's well. */
static void make_crowd(brink_system *s)
{
    body bodies[CROWD];
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    for (int i = 0; i < CROWD; i++)
        for (int k = 0; k < 3; k++) {
            bodies[i].x[k] = 2 * (i >> k & 1) + 0.4 * gsl_rng_uniform(rng);
            bodies[i].v[k] = 2 * gsl_rng_uniform(rng) - 1;
        }
    gsl_rng_free(rng);
    make(s, 5, &well, CROWD, bodies);
}

static void energy(reference *w, mpfr_t sum)
{
    mpfr_set_zero(sum, 1);
    for (uint32_t i = 0; i < CROWD; i++) {
        for (int k = 0; k < 3; k++)
            mpfr_fma(sum, w->v[i][k], w->v[i][k], sum, MPFR_RNDN);
        for (uint32_t j = i + 1; j < CROWD; j++) // twice -1 for a captured pair
            mpfr_sub_si(sum, sum, 2 * w->level[i * CROWD + j], MPFR_RNDN);
    }
}

START_TEST(energy_is_kept_to_the_precision)
{
    /* 2 K is at most 24 to begin with, and 2 more for each of 28 pairs captured.
     * An event computes what it adds to the velocities from some 20 roundings,
     * each of which moves 2 K by less than 4 * 80 units of 2^-BITS.  300 events,
     * and the sums: under 2^22. */
    brink_system s;
    reference w;
    mpfr_t before, after;
    make_crowd(&s);
    reference_create(&w, &s, BITS);
    mpfr_inits2(BITS, before, after, (mpfr_ptr)0);
    energy(&w, before);
    unsigned counts[4] = {0};
    for (int n = 0; n < 300; n++) {
        reference_event e;
        ck_assert(reference_next(&w, &e));
        counts[e.kind]++;
    }
    for (int kind = 0; kind < 4; kind++)
        ck_assert_uint_gt(counts[kind], 0);
    energy(&w, after);
    mpfr_sub(after, after, before, MPFR_RNDN);
    double lost = mpfr_get_d(after, MPFR_RNDN);
    ck_assert_msg(fabs(lost) < ldexp(1, 22 - BITS), "lost %a", lost);
    mpfr_clears(before, after, (mpfr_ptr)0);
    reference_destroy(&w);
    brink_system_destroy(&s);
}
END_TEST

START_TEST(reversed_it_goes_back_to_where_it_began)
{
    /* 100 events of 8 particles: 25 each, each of which magnifies a deviation by
     * the free path over the diameter and then some; under 2^5 as the box is 5
     * wide.  Of 512 bits there and back take 250: more than the 64 that positions
     * begin with are left, so they must come back to the bit. */
    enum { EVENTS = 100 };
    brink_system s;
    reference w;
    reference_event there[EVENTS], back;
    mpfr_t left, x;
    mpfr_inits2(512, left, x, (mpfr_ptr)0);
    make_crowd(&s);
    reference_create(&w, &s, 512);
    for (int n = 0; n < EVENTS; n++)
        ck_assert(reference_next(&w, &there[n]));
    mpfr_set(left, w.time, MPFR_RNDN);
    for (uint32_t i = 0; i < CROWD; i++)
        for (int k = 0; k < 3; k++)
            mpfr_neg(w.v[i][k], w.v[i][k], MPFR_RNDN);
    for (int n = EVENTS - 1; n >= 0; n--) {
        static const enum brink_event_kind mirror[] = {
            BRINK_CORE, BRINK_RELEASE, BRINK_CAPTURE, BRINK_BOUNCE};
        ck_assert(reference_next(&w, &back));
        ck_assert_int_eq(back.kind, mirror[there[n].kind]);
        ck_assert_uint_eq(back.i, there[n].i);
        ck_assert_uint_eq(back.j, there[n].j);
    }
    mpfr_mul_2ui(left, left, 1, MPFR_RNDN); // what is left of twice the way
    mpfr_sub(left, left, w.time, MPFR_RNDN);
    for (uint32_t i = 0; i < CROWD; i++)
        for (int k = 0; k < 3; k++) {
            mpfr_fma(x, w.v[i][k], left, w.x[i][k], MPFR_RNDN);
            mpfr_div_d(x, x, s.length[k], MPFR_RNDN);
            mpfr_mul_2ui(x, x, 64, MPFR_RNDN);
            ck_assert_uint_eq(mpfr_get_uj(x, MPFR_RNDN), s.particle[i].x[k]);
        }
    mpfr_clears(left, x, (mpfr_ptr)0);
    reference_destroy(&w);
    brink_system_destroy(&s);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "reference", 120,
        two_that_meet_head_on_exchange_velocities_and_meet_again_round_the_box,
        a_cradle_hands_its_motion_on_in_order,
        what_touches_and_parts_or_passes_by_or_is_at_rest_has_no_event,
        a_well_speeds_up_what_it_captures_and_gives_it_back,
        a_pair_made_inside_a_well_too_deep_for_it_bounces_there,
        a_shoulder_is_climbed_by_what_has_more_than_its_height,
        energy_is_kept_to_the_precision, reversed_it_goes_back_to_where_it_began);
}
