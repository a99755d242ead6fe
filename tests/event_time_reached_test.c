// SPDX-License-Identifier: MIT
// How often times come to the slow paths: as seldom as the filters are meant to
// let them, for pairs as simulations have them, in whatever units.
#include "counted_times.h"
#include "pairs.h"
#include "suite.h"

COUNT_CALLS(intersection_time_slow)
COUNT_CALLS(disjoint_time_slow)

enum { CASES = 100000, SEED = 1 };

typedef void family(stream *s, pair_case *p);
static const struct {
    const char *name;
    family *make;
    int is_contact;
} families[] = {{"dilute", family_dilute, 0},
                {"hits", family_hits, 0},
                {"neighbours", family_neighbours, 0},
                {"captured", family_captured, 0},
                {"contact", family_contact, 1}};

/** Of all families no more than one in so many, and at contact. */
static void come_seldom(time_of *kernel, int few, int few_at_contact)
{
    for (int f = 0; f < (int)(sizeof families / sizeof *families); f++) {
        stream s = stream_of_seed(SEED);
        pair_case p;
        counted = 0;
        for (int i = 0; i < CASES; i++) {
            families[f].make(&s, &p);
            kernel(p.r, p.v, p.sigma);
        }
        const int one_in = families[f].is_contact ? few_at_contact : few;
        ck_assert_msg(counted <= CASES / one_in, "%s, seed %d: %d of %d",
                      families[f].name, SEED, counted, CASES);
    }
}

START_TEST(plain_times_come_to_slow_paths_seldom)
{
    come_seldom(brink_intersection_time, 25000, 25000);
    come_seldom(brink_disjoint_time, 25000, 25000);
}
END_TEST

// The rounding test leaves one in 2^(70 - 53) open; near a surface c is known to
// fewer digits.
START_TEST(correctly_rounded_times_come_to_slow_paths_seldom)
{
    come_seldom(brink_intersection_time_cr, 10000, 1000);
    come_seldom(brink_disjoint_time_cr, 10000, 500);
}
END_TEST

/** Small integers: contacts and tangents, which no filter can tell; and what is
 *  there to see that calls are counted. */
START_TEST(what_no_filter_can_tell_comes_to_slow_paths)
{
    static time_of *const kernels[] = {
        brink_intersection_time, brink_disjoint_time, brink_intersection_time_cr,
        brink_disjoint_time_cr};
    for (int k = 0; k < 4; k++) {
        const double r[3] = {5, 0, 2}, v[3] = {-1, 0, 0};
        counted = 0;
        kernels[k](r, v, 2);
        ck_assert_int_eq(counted, 1);
    }
}
END_TEST

// --- Units --------------------------------------------------------------------

static time_of *const all_kernels[] = {
    brink_intersection_time,    brink_intersection_time_fast,
    brink_intersection_time_cr, brink_disjoint_time,
    brink_disjoint_time_fast,   brink_disjoint_time_cr,
};

/** Whether a family's numbers are all far from the ends of the range. */
static int is_moderate_family(const char *name)
{
    return strcmp(name, "scaled") != 0 && strcmp(name, "wild") != 0 &&
           strcmp(name, "edge") != 0;
}

/** The pair in units of length and of time that are powers of two. */
static pair_case in_units(const pair_case *p, int length, int time)
{
    pair_case q = {.sigma = ldexp(p->sigma, length)};
    for (int i = 0; i < 3; i++) {
        q.r[i] = ldexp(p->r[i], length);
        q.v[i] = ldexp(p->v[i], length - time);
    }
    return q;
}

static void keep_in_units(const char *name, const pair_case *p, int kernel,
                          int length, int time)
{
    const pair_case q = in_units(p, length, time);
    counted = 0;
    const double t = all_kernels[kernel](p->r, p->v, p->sigma);
    const int before = counted;
    counted = 0;
    const double scaled = all_kernels[kernel](q.r, q.v, q.sigma);
    ck_assert_msg(scaled == ldexp(t, time) && counted == before,
                  "kernel %d, %s (seed %d): %a %a %a  %a %a %a  %a: %a, slow %d; "
                  "in 2^%d and 2^%d: %a, slow %d",
                  kernel, name, SEED, p->r[0], p->r[1], p->r[2], p->v[0], p->v[1],
                  p->v[2], p->sigma, t, before, length, time, scaled, counted);
}

/* Every bound is relative to what the pair's own numbers make: far from the ends
 * of the range no unit makes a difference, not to a bit, nor to the way there. */
START_TEST(units_of_powers_of_two_change_no_bit_and_no_way)
{
    static const int units[][2] = {{60, 0}, {-60, 0}, {0, 60}, {0, -60}};
    stream s = stream_of_seed(SEED);
    pair_case p;
    for (int f = 0; f < PAIR_FAMILIES; f++)
        for (int i = 0; is_moderate_family(pair_families[f].name) && i < 300;
             i++) {
            pair_families[f].make(&s, &p);
            for (int k = 0; k < 4 * 6; k++)
                keep_in_units(pair_families[f].name, &p, k / 4, units[k % 4][0],
                              units[k % 4][1]);
        }
}
END_TEST

int main(void)
{
    return RUN_SUITE("event_time_reached", 120,
                     plain_times_come_to_slow_paths_seldom,
                     correctly_rounded_times_come_to_slow_paths_seldom,
                     what_no_filter_can_tell_comes_to_slow_paths,
                     units_of_powers_of_two_change_no_bit_and_no_way);
}
