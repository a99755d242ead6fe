// SPDX-License-Identifier: MIT
// How many pairs of a batch are asked about one by one: as few as cannot be told
// at a glance.  A glance that told less would cost no digit, but time.
#include "counted_times.h"
#include "pairs.h"
#include "suite.h"

COUNT_CALLS(intersection_time)
COUNT_CALLS(intersection_time_fast)
COUNT_CALLS(disjoint_time)
COUNT_CALLS(disjoint_time_fast)

enum { MOST = 1024, SEED = 1 };

typedef void batch(size_t n, const double *rx, const double *ry, const double *rz,
                   const double *vx, const double *vy, const double *vz,
                   const double *sigma, double *t);

static batch *const plain[] = {brink_intersection_times, brink_disjoint_times};
static batch *const fast[] = {brink_intersection_times_fast,
                              brink_disjoint_times_fast};

static double x[7][MOST], t[MOST];

static void put(int i, const pair_case *p)
{
    for (int k = 0; k < 3; k++) {
        x[k][i] = p->r[k];
        x[3 + k][i] = p->v[k];
    }
    x[6][i] = p->sigma;
}

/** How many of the first n are asked about. */
static int asked(batch *many, int n)
{
    counted = 0;
    many((size_t)n, x[0], x[1], x[2], x[3], x[4], x[5], x[6], t);
    return counted;
}

typedef void family(stream *s, pair_case *p);
static const struct {
    const char *name;
    family *make;
} families[] = {{"dilute", family_dilute},
                {"hits", family_hits},
                {"neighbours", family_neighbours},
                {"captured", family_captured}};

START_TEST(what_is_not_on_the_surface_is_told_at_a_glance)
{
    for (int f = 0; f < (int)(sizeof families / sizeof *families); f++) {
        stream s = stream_of_seed(SEED);
        for (int i = 0; i < MOST; i++) {
            pair_case p;
            families[f].make(&s, &p);
            put(i, &p);
        }
        for (int k = 0; k < 2; k++) {
            const int of_plain = asked(plain[k], MOST),
                      of_fast = asked(fast[k], MOST);
            ck_assert_msg(of_plain == 0 && of_fast == 0,
                          "%s, seed %d: %d plain, %d fast", families[f].name,
                          SEED, of_plain, of_fast);
        }
    }
}
END_TEST

/** One pair in a batch alone, or as many of it as there are; told at a glance or
 *  not. */
static void expect(batch *many, pair_case p, int is_asked)
{
    static const int sizes[] = {1, 7, 8, 128, 129, MOST};
    for (int i = 0; i < MOST; i++)
        put(i, &p);
    for (int k = 0; k < (int)(sizeof sizes / sizeof *sizes); k++) {
        const int count = asked(many, sizes[k]);
        ck_assert_msg(count == is_asked * sizes[k],
                      "%a %a %a  %a %a %a  %a: %d of %d", p.r[0], p.r[1], p.r[2],
                      p.v[0], p.v[1], p.v[2], p.sigma, count, sizes[k]);
    }
}

START_TEST(batches_of_one_are_told_at_a_glance_as_well)
{
    const pair_case hit = {{3, 0.5, 0}, {-1, 0, 0}, 1};
    const pair_case missing = {{3, 0.5, 0}, {0, 1, 0}, 1};
    const pair_case inside = {{0.5, 0.25, 0}, {-1, 0, 0}, 1};
    for (int k = 0; k < 2; k++) {
        expect(plain[k], hit, 0);
        expect(fast[k], hit, 0);
        expect(plain[k], missing, 0);
        expect(fast[k], missing, 0);
        expect(plain[k], inside, 0);
        expect(fast[k], inside, 0);
    }
}
END_TEST

START_TEST(what_is_on_the_surface_is_asked_about)
{
    const pair_case contact = {{1, 0x1p-40, 0}, {-1, 0, 0}, 1};
    expect(brink_intersection_times, contact, 1);
    const pair_case inside = {{1, 0x1p-20, 0x1p-20}, {1, 0, 0}, 1 + 0x1p-40};
    expect(brink_disjoint_times, inside, 1);
}
END_TEST

/** Told past a limit: not at it, nor on this side of it. */
static void told_past(batch *many, pair_case (*make)(double), double limit,
                      double past)
{
    expect(many, make(limit * past), 0);
    expect(many, make(limit), 1);
    expect(many, make(limit / past), 1);
}

static pair_case small_passing(double sigma)
{
    return (pair_case){{4 * sigma, sigma, 0}, {0, -0x1p100, 0}, sigma};
}

static pair_case captured(double sigma)
{
    return (pair_case){{0.5 * sigma, 0, 0}, {1, 0, 0}, sigma};
}

/** r.r + sigma^2 = 1.8125 x^2. */
static pair_case passing(double length)
{
    return (pair_case){{length, 0.5 * length, 0}, {0, -1, 0}, 0.75 * length};
}

static pair_case closing(double length)
{
    return (pair_case){{length, 0.5 * length, 0}, {-1, -0.5, 0}, 0.75 * length};
}

START_TEST(what_is_in_range_is_told_at_a_glance)
{
    told_past(brink_disjoint_times, small_passing, 0x1p-450, 1.25);
    told_past(brink_disjoint_times, captured, 0x1p128, 0.8);
    const double least = 0x1p-128 / sqrt(1.8125);
    expect(brink_disjoint_times_fast, passing(1.1 * least), 0);
    expect(brink_disjoint_times_fast, passing(least / 1.1), 1);
    expect(brink_disjoint_times_fast, closing(1.1 * least), 0);
    expect(brink_disjoint_times_fast, closing(least / 1.1), 1);
}
END_TEST

START_TEST(points_are_told_at_a_glance)
{
    const pair_case parting = {{3, 0, 0}, {1, 0, 0}, 0};
    const pair_case closing_in = {{3, 0, 0}, {-1, 0, 0}, 0};
    const pair_case by = {{3, 1, 0}, {-1, 0, 0}, 0};
    expect(brink_intersection_times, parting, 0);
    expect(brink_intersection_times, by, 0);
    for (int k = 0; k < 2; k++) {
        expect(fast[k], parting, 0);
        expect(fast[k], closing_in, 0);
        expect(fast[k], by, 0);
    }
}
END_TEST

/* One glance has nothing to say of the first block, and is second from then on;
 * it alone knows the pairs of the next. */
START_TEST(both_glances_are_taken_whichever_is_first)
{
    const pair_case hit = {{3, 0.5, 0}, {-1, 0, 0}, 1};
    const pair_case parting = {{3, 0, 0}, {1, 0, 0}, 0};
    for (int i = 0; i < MOST; i++)
        put(i, i / 128 % 4 < 2 ? &hit : &parting);
    ck_assert_int_eq(asked(brink_intersection_times, MOST), 0);

    const pair_case passing_far = {
        {3 * 0x1p255, 0x1p255, 0}, {0, -1, 0}, 0x1p255};
    for (int i = 0; i < MOST; i++)
        put(i, i / 128 % 4 < 2 ? &hit : &passing_far);
    ck_assert_int_eq(asked(brink_disjoint_times, MOST), 0);
}
END_TEST

/** Leaves on the stack what a glance would take for open. */
static double leave_open_times(void)
{
    volatile double open[4096];
    for (int i = 0; i < 4096; i++)
        open[i] = -1;
    return open[4095];
}

START_TEST(what_is_behind_the_last_pair_is_not_looked_at)
{
    const pair_case hit = {{3, 0.5, 0}, {-1, 0, 0}, 1};
    const pair_case none = {{(double)NAN, 0, 0}, {0, 0, 0}, 1};
    for (int i = 0; i < MOST; i++)
        put(i, i == 0 ? &hit : &none);
    for (int k = 0; k < 2; k++) {
        leave_open_times();
        ck_assert_int_eq(asked(plain[k], 1), 0);
        leave_open_times();
        ck_assert_int_eq(asked(fast[k], 1), 0);
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE("event_time_one_by_one", 60,
                     what_is_not_on_the_surface_is_told_at_a_glance,
                     batches_of_one_are_told_at_a_glance_as_well,
                     what_is_on_the_surface_is_asked_about,
                     what_is_in_range_is_told_at_a_glance,
                     points_are_told_at_a_glance,
                     both_glances_are_taken_whichever_is_first,
                     what_is_behind_the_last_pair_is_not_looked_at);
}
