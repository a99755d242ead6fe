// SPDX-License-Identifier: MIT
#include "pairs.h"
#include "suite.h"
#include <brink/event_time.h>
#include <string.h>

enum { MOST = 400, SEED = 1 };

typedef void batch(size_t n, const double *rx, const double *ry, const double *rz,
                   const double *vx, const double *vy, const double *vz,
                   const double *sigma, double *t);
typedef double scalar(const double r[3], const double v[3], double sigma);

static const struct tier {
    const char *name;
    batch *many;
    scalar *one;
} tiers[] = {
    {"intersection", brink_intersection_times, brink_intersection_time},
    {"intersection_fast", brink_intersection_times_fast,
     brink_intersection_time_fast},
    {"disjoint", brink_disjoint_times, brink_disjoint_time},
    {"disjoint_fast", brink_disjoint_times_fast, brink_disjoint_time_fast},
};
enum { TIERS = sizeof tiers / sizeof *tiers };

/** Pairs as a structure of arrays, with room to start at any alignment. */
typedef struct arrays {
    double x[7][MOST + 8], t[MOST + 8];
} arrays;

static void set_pair(arrays *a, int i, const pair_case *p)
{
    for (int k = 0; k < 3; k++) {
        a->x[k][i] = p->r[k];
        a->x[3 + k][i] = p->v[k];
    }
    a->x[6][i] = p->sigma;
}

static void fill(arrays *a, stream *s, const pair_family *family)
{
    for (int i = 0; i < MOST + 8; i++) {
        pair_case p;
        family->make(s, &p);
        if (stream_int(s, 0, 99) == 0) // outside the domain
            *(stream_int(s, 0, 1) ? &p.r[1] : &p.sigma) = (double)NAN;
        set_pair(a, i, &p);
    }
}

static void call(const struct tier *tier, const arrays *a, int from, int n,
                 double *t)
{
    tier->many((size_t)n, a->x[0] + from, a->x[1] + from, a->x[2] + from,
               a->x[3] + from, a->x[4] + from, a->x[5] + from, a->x[6] + from, t);
}

static double one_by_one(const struct tier *tier, const arrays *a, int i)
{
    const double r[3] = {a->x[0][i], a->x[1][i], a->x[2][i]};
    const double v[3] = {a->x[3][i], a->x[4][i], a->x[5][i]};
    return tier->one(r, v, a->x[6][i]);
}

/** The same bits, but for which NaN it is. */
static int same(double x, double y)
{
    return memcmp(&x, &y, sizeof x) == 0 || (isnan(x) && isnan(y));
}

static void expect(const struct tier *tier, const char *family, const arrays *a,
                   int from, int n, const double *t)
{
    for (int i = 0; i < n; i++) {
        double right = one_by_one(tier, a, from + i);
        if (!same(t[i], right))
            ck_abort_msg(
                "%s, %s, %d of %d from %d (seed %d):\n%a %a %a  %a %a %a  %a\n"
                "in a batch %a, alone %a",
                tier->name, family, i, n, from, SEED, a->x[0][from + i],
                a->x[1][from + i], a->x[2][from + i], a->x[3][from + i],
                a->x[4][from + i], a->x[5][from + i], a->x[6][from + i], t[i],
                right);
    }
}

START_TEST(batches_of_any_size_and_alignment_are_the_scalar_kernel)
{
    static arrays a;
    stream s = {SEED};
    for (int f = 0; f < PAIR_FAMILIES; f++)
        for (int round = 0; round < 40; round++) {
            fill(&a, &s, &pair_families[f]);
            int from = stream_int(&s, 0, 7);
            int n = round < 34 ? round
                               : stream_int(&s, 0, MOST); // all tails of a vector
            for (int k = 0; k < TIERS; k++) {
                memset(a.t, 0, sizeof a.t);
                call(&tiers[k], &a, from, n, a.t + from);
                expect(&tiers[k], pair_families[f].name, &a, from, n, a.t + from);
                for (int i = 0; i < MOST + 8; i++) // nothing else is written
                    ck_assert((i >= from && i < from + n) || a.t[i] == 0);
            }
        }
}
END_TEST

START_TEST(the_times_may_be_written_over_any_of_the_inputs)
{
    static arrays a, before;
    stream s = {SEED};
    for (int f = 0; f < PAIR_FAMILIES; f++)
        for (int k = 0; k < TIERS; k++)
            for (int over = 0; over < 7; over++) {
                fill(&a, &s, &pair_families[f]);
                before = a;
                call(&tiers[k], &a, 0, MOST, a.x[over]);
                expect(&tiers[k], pair_families[f].name, &before, 0, MOST,
                       a.x[over]);
            }
}
END_TEST

START_TEST(inputs_may_be_one_array)
{
    // r = v = (x, x, x): going straight outward
    double x[20], t[20];
    for (int i = 0; i < 20; i++)
        x[i] = i - 10;
    brink_disjoint_times(20, x, x, x, x, x, x, x, t);
    for (int i = 0; i < 20; i++) {
        const double r[3] = {x[i], x[i], x[i]};
        ck_assert(same(t[i], brink_disjoint_time(r, r, x[i])));
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE("event_time_batch", 600,
                     batches_of_any_size_and_alignment_are_the_scalar_kernel,
                     the_times_may_be_written_over_any_of_the_inputs,
                     inputs_may_be_one_array);
}
