// SPDX-License-Identifier: MIT
#include "states.h"
#include "suite.h"
#include <gsl/gsl_rng.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { COUNT = 40 };

static const brink_potential terrace = {
    3, (const double[]){3, 2, 1}, (const double[]){-1, -3, (double)INFINITY}};
static const brink_potential shoulder = {1, (const double[]){2},
                                         (const double[]){0.5}};

// Two species: A with a terrace and a core, B with a shoulder to get on top of.
static void make(brink_system *s)
{
    const brink_species species[] = {{"A", 1, 1, COUNT / 2},
                                     {"B", 1, 2, COUNT / 2}};
    const brink_potential table[] = {terrace, shoulder, shoulder, shoulder};
    const double box[3] = {30, 30, 30};
    ck_assert_int_eq(brink_system_create(s, 3, box, 1, COUNT, 2, species, table),
                     0);
    for (uint32_t i = COUNT / 2; i < COUNT; i++)
        s->particle[i].species = 1;
}

START_TEST(only_captured_pairs_are_stored_and_both_know)
{
    brink_system s;
    brink_states t;
    make(&s);
    ck_assert_int_eq(brink_states_create(&t, &s), 0);
    ck_assert_int_eq(brink_states_level(&t, 3, 7), 0);
    ck_assert_int_eq(brink_states_apply(&t, &s, 3, 7, BRINK_CAPTURE), 0);
    ck_assert_int_eq(brink_states_level(&t, 3, 7), 1);
    ck_assert_int_eq(brink_states_level(&t, 7, 3), 1);
    ck_assert_uint_eq(t.links.used, 2);
    ck_assert_int_eq(brink_states_apply(&t, &s, 7, 3, BRINK_RELEASE), 0);
    ck_assert_uint_eq(t.links.used, 0);
    ck_assert_ptr_null(brink_states_is_valid(&t, &s));
    brink_states_destroy(&t);
    brink_system_destroy(&s);
}
END_TEST

START_TEST(an_illegal_event_is_refused_and_changes_nothing)
{
    brink_system s;
    brink_states t;
    make(&s);
    ck_assert_int_eq(brink_states_create(&t, &s), 0);
    ck_assert_int_eq(brink_states_apply(&t, &s, 0, 1, BRINK_RELEASE), 1);
    ck_assert_int_eq(brink_states_apply(&t, &s, 0, 1, BRINK_CORE), 1);
    ck_assert_int_eq(brink_states_level(&t, 0, 1), 0);
    ck_assert_int_eq(brink_states_apply(&t, &s, 0, 1, BRINK_CAPTURE), 0);
    ck_assert_int_eq(brink_states_apply(&t, &s, 0, 1, BRINK_CAPTURE), 0);
    ck_assert_int_eq(brink_states_apply(&t, &s, 0, 1, BRINK_CAPTURE),
                     1); // the core
    ck_assert_int_eq(brink_states_level(&t, 0, 1), 2);
    ck_assert_int_eq(brink_states_apply(&t, &s, 0, 1, BRINK_CORE), 0);
    ck_assert_int_eq(brink_states_level(&t, 0, 1), 2);
    brink_states_destroy(&t);
    brink_system_destroy(&s);
}
END_TEST

START_TEST(the_energy_is_a_count_times_the_energies)
{
    brink_system s;
    brink_states t;
    make(&s);
    ck_assert_int_eq(brink_states_create(&t, &s), 0);
    brink_states_set(&t, &s, 0, 1, 2);                 // A, A: -3
    brink_states_set(&t, &s, 1, 2, 1);                 // A, A: -1
    brink_states_set(&t, &s, 0, COUNT / 2, 1);         // A, B: 0.5
    brink_states_set(&t, &s, COUNT / 2, COUNT - 1, 1); // B, B: 0.5
    ck_assert(brink_states_energy(&t, &s) == -3.0);
    brink_states_set(&t, &s, 0, 1, 0);
    ck_assert(brink_states_energy(&t, &s) == 0.0);
    brink_states_destroy(&t);
    brink_system_destroy(&s);
}
END_TEST

// A random log of events against a square table of levels.
START_TEST(a_log_of_events_leaves_the_levels_of_a_plain_table)
{
    const unsigned long seed = 20260105;
    printf("seed %lu\n", seed);
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(rng, seed);
    brink_system s;
    brink_states t;
    int level[COUNT][COUNT];
    memset(level, 0, sizeof level);
    make(&s);
    ck_assert_int_eq(brink_states_create(&t, &s), 0);
    for (int step = 0; step < 100000; step++) {
        const uint32_t i = (uint32_t)gsl_rng_uniform_int(rng, COUNT);
        const uint32_t j = (uint32_t)gsl_rng_uniform_int(rng, COUNT);
        if (i == j)
            continue;
        // Full levels: A with A 0, 1, 2 and a core; otherwise 0 and 1.
        const int terraced = i < COUNT / 2 && j < COUNT / 2;
        const int in = gsl_rng_uniform(rng) < 0.5;
        const int before = level[i][j];
        const int legal = in ? before < (terraced ? 2 : 1) : before > 0;
        const int status =
            brink_states_apply(&t, &s, i, j, in ? BRINK_CAPTURE : BRINK_RELEASE);
        ck_assert_int_eq(status, !legal);
        if (legal)
            level[i][j] = level[j][i] = before + (in ? 1 : -1);
        ck_assert_int_eq(brink_states_level(&t, i, j), level[i][j]);
        if (step % 1000 == 0)
            ck_assert_ptr_null(brink_states_is_valid(&t, &s));
    }
    for (uint32_t i = 0; i < COUNT; i++)
        for (uint32_t j = 0; j < COUNT; j++)
            if (i != j)
                ck_assert_int_eq(brink_states_level(&t, i, j), level[i][j]);
    ck_assert_ptr_null(brink_states_is_valid(&t, &s));
    brink_states_destroy(&t);
    brink_system_destroy(&s);
    gsl_rng_free(rng);
}
END_TEST

// Three species, each pair of them with a potential of its own: level k of the
// pair (a, b), a <= b, has the energy 4^(3 a + b) 2^(k - 1), so that a sum tells
// which.
static double own_energy(int a, int b, int k)
{
    return ldexp(1.0, 2 * (a < b ? 3 * a + b : 3 * b + a) + k - 1);
}

START_TEST(every_pair_of_species_is_counted_at_its_own_energy)
{
    static const double distance[] = {3, 2};
    const brink_species species[] = {
        {"A", 1, 1, 2}, {"B", 1, 1, 2}, {"C", 1, 1, 2}};
    const double box[3] = {30, 30, 30};
    double energy[3][3][2];
    brink_potential table[9];
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) {
            energy[a][b][0] = own_energy(a, b, 1);
            energy[a][b][1] = own_energy(a, b, 2);
            // the last has the most levels
            table[3 * a + b] =
                (brink_potential){a + b == 0 ? 1 : 2, distance, energy[a][b]};
        }
    brink_system s;
    brink_states t;
    ck_assert_int_eq(brink_system_create(&s, 3, box, 1, 6, 3, species, table), 0);
    for (uint32_t i = 0; i < 6; i++)
        s.particle[i].species = i / 2;
    memset(&t, 0xff, sizeof t); // whatever was there before
    ck_assert_int_eq(brink_states_create(&t, &s), 0);
    double sum = 0;
    for (uint32_t i = 0; i < 6; i++)
        for (uint32_t j = 0; j < i; j++) {
            const int a = (int)j / 2, b = (int)i / 2;
            for (int level = 1; level <= (a + b == 0 ? 1 : 2); level++) {
                ck_assert_int_eq(brink_states_set(&t, &s, i, j, level), 0);
                ck_assert_double_eq(brink_states_energy(&t, &s),
                                    sum + own_energy(a, b, level));
                ck_assert_ptr_null(brink_states_is_valid(&t, &s));
            }
            if ((i + j) % 2)
                brink_states_set(&t, &s, j, i, 0);
            else
                sum += own_energy(a, b, a + b == 0 ? 1 : 2);
        }
    ck_assert_double_eq(brink_states_energy(&t, &s), sum);
    brink_states_destroy(&t);
    brink_states_destroy(&t); // of nothing
    brink_system_destroy(&s);
}
END_TEST

// The levels there is room for, of two species whose pairs have so many steps.
static int levels_of(int aa, int ab, int bb)
{
    // Behind the potentials are their distances: taken for one of them, the first
    // has more steps than any.
    static const double distance[] = {0x1.0000000001000p+2, 3, 2},
                        energy[] = {-1, -2, -3};
    const brink_potential table[] = {{aa, distance, energy},
                                     {ab, distance, energy},
                                     {ab, distance, energy},
                                     {bb, distance, energy}};
    const brink_species species[] = {{"A", 1, 1, 1}, {"B", 1, 1, 1}};
    const double box[3] = {30, 30, 30};
    brink_system s;
    brink_states t;
    ck_assert_int_eq(brink_system_create(&s, 3, box, 1, 2, 2, species, table), 0);
    ck_assert_int_eq(brink_states_create(&t, &s), 0);
    const int levels = t.levels;
    brink_states_destroy(&t);
    brink_system_destroy(&s);
    return levels;
}

START_TEST(there_are_the_levels_of_the_pair_that_has_most)
{
    ck_assert_int_eq(levels_of(1, 1, 1), 2);
    ck_assert_int_eq(levels_of(3, 1, 1), 4);
    ck_assert_int_eq(levels_of(1, 2, 3), 4);
    ck_assert_int_eq(levels_of(1, 3, 2), 4);
}
END_TEST

static void expect_fault(const brink_states *t, const brink_system *s,
                         const char *word)
{
    const char *fault = brink_states_is_valid(t, s);
    ck_assert_ptr_nonnull(fault);
    ck_assert_msg(strstr(fault, word) != NULL, "\"%s\", not \"%s\"", fault, word);
}

// One thing is put wrong at a time, and right again.
START_TEST(the_check_sees_what_is_wrong_and_says_so)
{
    brink_system s;
    brink_states t;
    make(&s);
    ck_assert_int_eq(brink_states_create(&t, &s), 0);
    brink_states_set(&t, &s, 0, 1, 2);
    brink_states_set(&t, &s, COUNT - 2, COUNT - 1, 1);
    ck_assert_ptr_null(brink_states_is_valid(&t, &s));
    brink_link *link = brink_lists_items(&t.links, 0);
    const int strange[] = {INT_MIN, -1, 0, 3, INT_MAX};
    for (int k = 0; k < 5; k++) { // A with A has 1, 2 and a core
        link->level = strange[k];
        expect_fault(&t, &s, "does not have");
    }
    link->level = 1;
    expect_fault(&t, &s, "disagree");
    link->level = 2;
    const uint32_t nobody[] = {0, COUNT, UINT32_MAX};
    for (int k = 0; k < 3; k++) {
        link->partner = nobody[k];
        expect_fault(&t, &s, "by itself or by nobody");
    }
    link->partner = 1;
    t.links.used--;
    expect_fault(&t, &s, "more than there are");
    t.links.used += 2;
    expect_fault(&t, &s, "belongs to nobody");
    t.links.used--;
    // every count of a pair of species is looked at: A A, A B, B A and B B
    for (int k = 0; k < 4 * t.levels; k++) {
        t.pairs[k]++;
        expect_fault(&t, &s, "miscounted");
        t.pairs[k] -= 2;
        expect_fault(&t, &s, "miscounted");
        t.pairs[k]++;
    }
    brink_states_set(&t, &s, 0, 2, 1); // and the second of a particle's links
    link = brink_lists_items(&t.links, 0);
    link[1].level = 0;
    expect_fault(&t, &s, "does not have");
    link[1].level = 1;
    ck_assert_ptr_null(brink_states_is_valid(&t, &s));
    brink_states_destroy(&t);
    brink_system_destroy(&s);
}
END_TEST

int main(void)
{
    return RUN_SUITE("states", 60, only_captured_pairs_are_stored_and_both_know,
                     an_illegal_event_is_refused_and_changes_nothing,
                     the_energy_is_a_count_times_the_energies,
                     a_log_of_events_leaves_the_levels_of_a_plain_table,
                     every_pair_of_species_is_counted_at_its_own_energy,
                     there_are_the_levels_of_the_pair_that_has_most,
                     the_check_sees_what_is_wrong_and_says_so);
}
