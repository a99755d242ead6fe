// SPDX-License-Identifier: MIT
// Where the filters and the fast paths end: on this side of a limit a pair is
// told, on the other it comes to the slow path.  A limit is what a proof or a
// bound in kernels/event_time*.h allows; one that is drawn narrower costs time,
// one that is drawn wider takes for certain what need not be.
#include "counted_times.h"
#include "pair.h"
#include "suite.h"

COUNT_CALLS(intersection_time_slow)
COUNT_CALLS(disjoint_time_slow)

/** Whether a kernel comes to the slow path of this pair, once. */
static void expect(time_of *kernel, pair_case p, int is_slow)
{
    counted = 0;
    const double t = kernel(p.r, p.v, p.sigma);
    ck_assert_msg(counted == is_slow,
                  "%a %a %a  %a %a %a  %a: %a, slow %d, not %d", p.r[0], p.r[1],
                  p.r[2], p.v[0], p.v[1], p.v[2], p.sigma, t, counted, is_slow);
}

typedef pair_case pair_of(double x);

/** Told when x is past a limit, up or down: not at it, nor on this side of it.
 *  Where x is squared, 1.25 and 0.8 become less than 2 and more than a half. */
static void told_past(time_of *kernel, pair_of *make, double limit, double past)
{
    expect(kernel, make(limit * past), 0);
    expect(kernel, make(limit), 1);
    expect(kernel, make(limit / past), 1);
}

/** The same of a limit that is no double. */
static void told_beyond(time_of *kernel, pair_of *make, double limit, double past)
{
    expect(kernel, make(limit * past), 0);
    expect(kernel, make(limit / past), 1);
}

static const double up = 1.25, down = 0.8;

// --- Signs --------------------------------------------------------------------
//
// Q = a R is at hand as it is written down here, u is 2^-53.

/** b = x, c = x^2, d = 0; Q = 4, where b need be more than 2^-100 of its root. */
static pair_case leaving(double x)
{
    return (pair_case){{1, x, 0}, {0, 1, 1}, 1};
}

/** The same, coming: d = -x^2, which need be more than 2^-90 Q. */
static pair_case missing(double x)
{
    return (pair_case){{1, x, 0}, {0, -1, 1}, 1};
}

/** As small that b^2 and Q are beside 2^-900: b = x. */
static pair_case leaving_faintly(double x)
{
    return (pair_case){{0x1p-440, x, 0}, {0, 1, 0}, 0x1p-440};
}

/** d = -x^2, beside 2^-900 and 2^-800. */
static pair_case missing_faintly(double x)
{
    return (pair_case){{0x1p-440, x, 0}, {0, -1, 1}, 0x1p-440};
}

static pair_case missing_less_faintly(double x)
{
    return (pair_case){{0x1p-390, x, 0}, {0, -1, 1}, 0x1p-390};
}

START_TEST(pairs_that_leave_are_told_when_their_rate_is_more_than_its_error)
{
    told_past(brink_intersection_time, leaving, 0x1p-99, up);
    told_past(brink_intersection_time_cr, leaving, 0x1p-99, up);
    told_past(brink_intersection_time, leaving_faintly, 0x1p-450, up);
    told_past(brink_intersection_time_cr, leaving_faintly, 0x1p-450, up);
}
END_TEST

START_TEST(pairs_that_miss_are_told_when_it_is_by_more_than_its_error)
{
    told_past(brink_intersection_time, missing, 0x1p-44, up);
    told_past(brink_intersection_time_cr, missing, 0x1p-44, up);
    told_past(brink_intersection_time, missing_faintly, 0x1p-450, up);
    told_past(brink_intersection_time_cr, missing_less_faintly, 0x1p-400, up);
}
END_TEST

/** Inside by x^4, as 1 + 2 x^2 = (1 + x^2)^2 - x^4, if x has few bits; R = 2. */
static pair_case just_inside(double x)
{
    return (pair_case){{1, x, x}, {1, 0, 0}, 1 + x * x};
}

/** Outside by x^2, and coming; R = 2. */
static pair_case just_outside(double x)
{
    return (pair_case){{1, x, 0}, {-1, 0, 0}, 1};
}

/** Outside by all but 2 x, so that nobody has to look closer. */
static pair_case outside(double x)
{
    return (pair_case){{1 + x, 0, 0}, {-1, 0.5, 0.25}, 1};
}

// 2^53 / 2.85 is 1.40625 2^51.
START_TEST(surfaces_are_told_apart_from_when_the_gap_is_more_than_its_error)
{
    expect(brink_disjoint_time, just_inside(0x1.2p-22), 0); // x^4 = 1.6 2^-88
    expect(brink_disjoint_time, just_inside(0x1p-22),
           1); // and 1.4 2^-88 are asked
    told_beyond(brink_intersection_time_cr, just_outside,
                sqrt(1.40625 * 0x1p51 * 0x1p25 * 0x1p-150 * 2), up);
    for (double x = 0x1p-31; x < 0x1p-24; x *= 1.5)
        expect(brink_intersection_time_cr, outside(x), 0);
}
END_TEST

// --- Discriminants ------------------------------------------------------------

/** d = 1, Q = x^2 + 2.125. */
static pair_case narrow(double x)
{
    return (pair_case){{x, 0.75, 0}, {-1, 0, 0}, 1.25};
}

/** d = (x / 16)^2. */
static pair_case hit_faintly(double x)
{
    return (pair_case){{4 * x, 0, 0}, {-0x1p-4, 0, 0}, x};
}

START_TEST(pairs_that_meet_are_told_when_d_is_more_than_its_error)
{
    told_past(brink_intersection_time, narrow, sqrt(0x1p44 - 2.125), down);
    told_past(brink_disjoint_time, narrow, sqrt(0x1p44 - 2.125), down);
    told_past(brink_intersection_time_cr, narrow, sqrt(0x1p20 - 2.125), down);
    told_past(brink_disjoint_time_cr, narrow, sqrt(0x1p20 - 2.125), down);
    told_past(brink_intersection_time, hit_faintly, 0x1p-446, up);
    told_past(brink_intersection_time_cr, hit_faintly, 0x1p-396, up);
}
END_TEST

// --- The range ----------------------------------------------------------------

static pair_case small_hit(double sigma)
{
    return (pair_case){{3 * sigma, 0, 0}, {-0x1p100, 0, 0}, sigma};
}

static pair_case large_hit(double sigma)
{
    return (pair_case){{3 * sigma, 0, 0}, {-1, 0, 0}, sigma};
}

static pair_case small_passing(double sigma)
{
    return (pair_case){{4 * sigma, sigma, 0}, {0, -0x1p100, 0}, sigma};
}

static pair_case captured(double sigma)
{
    return (pair_case){{0.5 * sigma, 0, 0}, {1, 0, 0}, sigma};
}

START_TEST(radii_are_told_of_when_their_squares_are_in_range)
{
    told_past(brink_intersection_time, small_hit, 0x1p-450, up);
    told_past(brink_intersection_time, large_hit, 0x1p450, down);
    told_past(brink_disjoint_time, small_passing, 0x1p-450, up);
    told_past(brink_disjoint_time, captured, 0x1p128, down);
    expect(brink_disjoint_time, captured(0x1p-128), 0);
    expect(brink_disjoint_time, captured(0x1p-128 * down), 1);
}
END_TEST

/** a = x^2 to a double, though no power of two; far outside. */
static pair_case slow_miss(double x)
{
    return (pair_case){{0x1.8p21, 0, 0}, {-0x1p-500, x, 0}, 0x1p20};
}

static pair_case slow_hit(double x)
{
    return (pair_case){{0x1.8p21, 0, 0}, {-x, 0, 0}, 0x1p20};
}

static pair_case slow_passing(double x)
{
    return (pair_case){{0x1p21, 0x1p10, 0}, {0, -x, 0}, 0x1p20};
}

START_TEST(speeds_are_told_of_when_their_squares_are_in_range)
{
    told_past(brink_intersection_time, slow_miss, 0x1p-450, up);
    told_past(brink_intersection_time_cr, slow_miss, 0x1p-400, up);
    told_past(brink_intersection_time, slow_hit, 0x1p-450, up);
    told_past(brink_intersection_time_cr, slow_hit, 0x1p-400, up);
    told_past(brink_disjoint_time, slow_passing, 0x1p-450, up);
}
END_TEST

/** t = x 2^-400. */
static pair_case short_time(double x)
{
    return (pair_case){{2 * x, 0, 0}, {-0x1p400, 0, 0}, x};
}

/** t = x 2^399. */
static pair_case long_time(double x)
{
    return (pair_case){{2 * x, 0, 0}, {-0x1p-399, 0, 0}, x};
}

START_TEST(times_are_told_to_the_last_bit_when_they_have_all_their_bits)
{
    told_past(brink_intersection_time_cr, short_time, 0x1p-400, up);
    told_past(brink_intersection_time_cr, long_time, 0x1p401, down);
}
END_TEST

// --- Passing by ---------------------------------------------------------------

/** b = x and a c = 0.75, but for x^2. */
static pair_case passing(double x)
{
    return (pair_case){{1, x, 0}, {0, -1, 0}, 0.5};
}

/** The same with lengths of 2^-50: a c is not what a and c are one by one. */
static pair_case passing_nearby(double x)
{
    return (pair_case){{0x1p-50, x * 0x1p-50, 0}, {0, -1, 0}, 0x1p-51};
}

/** b = 1 and a c = x^2, exactly. */
static pair_case passing_widely(double x)
{
    return (pair_case){{x, 1, 0}, {0, -1, 0}, 1};
}

static pair_case passing_faintly(double x)
{
    return (pair_case){{0x1p-439, x, 0}, {0, -1, 0}, 0x1p-440};
}

START_TEST(closest_approaches_are_told_when_the_rate_is_more_than_its_error)
{
    told_beyond(brink_disjoint_time, passing, sqrt(0.75) * 0x1p-40, 1.1);
    told_beyond(brink_disjoint_time, passing_nearby, sqrt(0.75) * 0x1p-40, 1.1);
    told_past(brink_disjoint_time, passing_widely, 0x1p40, down);
    told_past(brink_disjoint_time, passing_faintly, 0x1p-450, up);
    told_beyond(brink_disjoint_time_cr, passing, sqrt(0.75) * 0x1p-23, 1.1);
    told_beyond(brink_disjoint_time_cr, passing_nearby, sqrt(0.75) * 0x1p-23,
                1.1);
    told_past(brink_disjoint_time_cr, passing_widely, 0x1p23, down);
}
END_TEST

// --- What needs no radius, and no range ---------------------------------------

START_TEST(what_parts_or_passes_by_is_told_of_points_as_well)
{
    const pair_case parting = {{3, 1, 0}, {1, 0, 0}, 0};
    const pair_case by = {{3, 1, 0}, {-1, 0, 0}, 0};
    expect(brink_intersection_time, parting, 0);
    expect(brink_intersection_time_cr, parting, 0);
    expect(brink_intersection_time, by, 0);
    expect(brink_intersection_time_cr, by, 0);
    expect(brink_disjoint_time_cr, parting, 0);
    expect(brink_disjoint_time_cr, by, 0);
}
END_TEST

START_TEST(what_parts_is_told_where_squares_are_beyond_the_filters)
{
    const pair_case parting = {{0x1p200, 0, 0}, {1, 0.5, 0}, 0x1p199};
    expect(brink_intersection_time, parting, 0);
    expect(brink_intersection_time_cr, parting, 0);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "event_time_limits", 60,
        pairs_that_leave_are_told_when_their_rate_is_more_than_its_error,
        pairs_that_miss_are_told_when_it_is_by_more_than_its_error,
        surfaces_are_told_apart_from_when_the_gap_is_more_than_its_error,
        pairs_that_meet_are_told_when_d_is_more_than_its_error,
        radii_are_told_of_when_their_squares_are_in_range,
        speeds_are_told_of_when_their_squares_are_in_range,
        times_are_told_to_the_last_bit_when_they_have_all_their_bits,
        closest_approaches_are_told_when_the_rate_is_more_than_its_error,
        what_parts_or_passes_by_is_told_of_points_as_well,
        what_parts_is_told_where_squares_are_beyond_the_filters);
}
