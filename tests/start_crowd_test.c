// SPDX-License-Identifier: MIT
// The grid of cores against a look at every pair.
#include "start_crowd.h"
#include "suite.h"
#include <gsl/gsl_rng.h>
#include <math.h>
#include <string.h>

#define INF ((double)INFINITY)

// Two species, cores of 1 and 0.6 and 0.8 between them; the small ones are in a
// well that reaches 2, which is no core.
static const brink_potential potentials[] = {
    {1, (const double[]){1}, (const double[]){INF}},
    {1, (const double[]){0.8}, (const double[]){INF}},
    {1, (const double[]){0.8}, (const double[]){INF}},
    {2, (const double[]){2, 0.6}, (const double[]){-1, INF}}};

static void make(brink_system *s, int dimensions, const double length[3],
                 uint32_t count)
{
    const brink_species species[] = {{"A", 1.0, 1.0, count / 2},
                                     {"B", 1.0, 0.6, count - count / 2}};
    ck_assert_int_eq(brink_system_create(s, dimensions, length, 1.0, count, 2,
                                         species, potentials),
                     0);
    for (uint32_t i = 0; i < count; i++)
        s->particle[i].species = i >= count / 2;
}

static int overlap(const brink_system *s, uint32_t i, uint32_t j)
{
    const brink_potential *p = brink_system_potential(s, i, j);
    double r[3];
    brink_system_separation(s, i, j, 0.0, r);
    return sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]) <
           p->distance[p->count - 1];
}

START_TEST(the_crowd_finds_an_overlap_just_where_there_is_one)
{
    static const struct {
        int dimensions;
        double length[3];
        uint32_t count;
    } boxes[] = {{3, {9, 9, 9}, 60},  {3, {40, 4.5, 4.1}, 60},
                 {3, {4, 4, 4}, 12},  {2, {12, 12, 1}, 40},
                 {2, {90, 4, 1}, 40}, {3, {1e4, 4, 4}, 30}};
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    for (unsigned seed = 0; seed < 600; seed++) {
        const size_t k = seed % (sizeof boxes / sizeof *boxes);
        brink_system s;
        brink_crowd crowd;
        gsl_rng_set(random, seed);
        make(&s, boxes[k].dimensions, boxes[k].length, boxes[k].count);
        ck_assert_int_eq(brink_crowd_create(&crowd, &s), 0);
        for (uint32_t i = 0; i < s.count; i++) {
            for (int a = 0; a < s.dimensions; a++)
                s.particle[i].x[a] =
                    (uint64_t)gsl_rng_get(random) << 32 | gsl_rng_get(random);
            int expected = 0;
            for (uint32_t j = 0; j < i; j++)
                expected |= overlap(&s, i, j);
            const uint32_t found = brink_crowd_overlap(&crowd, i);
            ck_assert_msg((found != BRINK_ALONE) == expected,
                          "seed %u: particle %u, found %u, expected %d", seed, i,
                          found, expected);
            if (expected)
                ck_assert(found < i && overlap(&s, i, found));
            brink_crowd_add(&crowd, i);
        }
        brink_crowd_destroy(&crowd);
        brink_system_destroy(&s);
    }
    gsl_rng_free(random);
}
END_TEST

START_TEST(cores_that_touch_do_not_overlap)
{
    static const double length[3] = {16, 16,
                                     16}; // a power of two: positions are exact
    brink_system s;
    brink_crowd crowd;
    make(&s, 3, length, 4);
    ck_assert_int_eq(brink_crowd_create(&crowd, &s), 0);
    brink_crowd_add(&crowd, 0);
    s.particle[1].x[0] =
        brink_system_fraction(&s, 0, 15.0); // across the box's face
    ck_assert_uint_eq(brink_crowd_overlap(&crowd, 1), BRINK_ALONE);
    s.particle[1].x[0] += 128; // nearer by 128 units of 2^-60: an ulp below 1
    ck_assert_uint_eq(brink_crowd_overlap(&crowd, 1), 0);
    brink_crowd_destroy(&crowd);
    brink_system_destroy(&s);
}
END_TEST

int main(void)
{
    return RUN_SUITE("crowd", 60,
                     the_crowd_finds_an_overlap_just_where_there_is_one,
                     cores_that_touch_do_not_overlap);
}
