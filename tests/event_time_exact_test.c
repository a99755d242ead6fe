// SPDX-License-Identifier: MIT
// Where double-double ends: on this side of a limit a pair is told by it, on
// the other it comes to exact numbers.  Half a limit would be taken for certain
// without a reason, twice of it costs time.
#include "counted_dots.h"
#include "pairs.h"
#include "suite.h"
#include <brink/event_time.h>

enum { CASES = 20000, SEED = 1 };

// In units of lengths that no fast path takes: radii of more than 2^450, or of
// less than 2^-450.

typedef double time_of(const double r[3], const double v[3], double sigma);

static pair_case in_lengths(pair_case p, int e)
{
    for (int i = 0; i < 3; i++)
        p.r[i] = ldexp(p.r[i], e);
    p.sigma = ldexp(p.sigma, e);
    return p;
}

static int is_exact_time(time_of *kernel, const pair_case *p)
{
    dots = 0;
    kernel(p->r, p->v, p->sigma);
    return dots > 0;
}

static void expect(time_of *kernel, pair_case p, int is_exact)
{
    ck_assert_msg(is_exact_time(kernel, &p) == is_exact,
                  "%a %a %a  %a %a %a  %a: exact, or not", p.r[0], p.r[1], p.r[2],
                  p.v[0], p.v[1], p.v[2], p.sigma);
}

typedef pair_case pair_of(double x);

static void told_past(time_of *kernel, pair_of *make, double limit, double past)
{
    expect(kernel, make(limit * past), 0);
    expect(kernel, make(limit), 1);
    expect(kernel, make(limit / past), 1);
}

START_TEST(times_in_long_units_come_to_exact_numbers_seldom)
{
    static const struct {
        const char *name;
        void (*make)(stream *s, pair_case *p);
    } families[] = {{"dilute", family_dilute},
                    {"hits", family_hits},
                    {"neighbours", family_neighbours},
                    {"captured", family_captured},
                    {"contact", family_contact}};
    for (int f = 0; f < 5; f++) {
        stream s = stream_of_seed(SEED);
        int exact = 0;
        for (int i = 0; i < CASES; i++) {
            pair_case p;
            families[f].make(&s, &p);
            p = in_lengths(p, 500);
            exact += is_exact_time(brink_intersection_time, &p);
            exact += is_exact_time(brink_disjoint_time, &p);
        }
        ck_assert_msg(exact <= CASES / 10000, "%s, seed %d: %d of %d",
                      families[f].name, SEED, exact, CASES);
    }
}
END_TEST

/* Scaled by the largest of them, whichever that is, no number overflows. */
START_TEST(pairs_of_any_mixture_of_sizes_are_told)
{
    for (int axis = 0; axis < 3; axis++) {
        pair_case leaving = {.sigma = 0x1p-40}, inside = {.sigma = 0x1p560};
        leaving.r[axis] = 0x1p1000;
        leaving.v[axis] = 4;
        inside.r[axis] = 0x1p-40;
        inside.v[axis] = -4;
        expect(brink_intersection_time, leaving, 0);
        expect(brink_intersection_time, inside, 0);
    }
}
END_TEST

// Which coordinates r.v cancels in.
static int first, second, third;

/** b = x of terms of 3.75, either way along the coordinates. */
static pair_case going(double x, double sigma)
{
    pair_case p = {.sigma = sigma};
    p.r[first] = 1.5;
    p.v[first] = 1.25;
    p.r[second] = 1.25;
    p.v[second] = -1.5;
    p.r[third] = 1;
    p.v[third] = x;
    return in_lengths(p, 500);
}

static pair_case leaving(double x)
{
    return going(x, 1);
}

static pair_case going_inside(double x)
{
    return going(-x, 4);
}

static pair_case leaving_faintly(double x)
{
    return in_lengths((pair_case){{1, x, 0}, {0, 1, 0}, 0.5}, 500);
}

START_TEST(rates_are_told_when_they_are_more_than_their_error)
{
    for (int order = 0; order < 6; order++) {
        first = order % 3;
        second = (first + 1 + order / 3) % 3;
        third = 3 - first - second;
        told_past(brink_intersection_time, leaving, 0x1.ep-100, 1.01);
        told_past(brink_intersection_time, going_inside, 0x1.ep-100, 1.01);
        told_past(brink_disjoint_time, leaving, 0x1.ep-100, 1.01);
    }
    told_past(brink_intersection_time, leaving_faintly, 0x1p-1000, 1.25);
}
END_TEST

/** c = -2^-98 (1 - x^2) of terms of 2. */
static pair_case just_inside(double x)
{
    return in_lengths(
        (pair_case){{1, 0x1p-24, x * 0x1p-49}, {-1, 0, 0}, 1 + 0x1p-49}, 500);
}

START_TEST(sides_are_told_when_they_are_more_than_their_error)
{
    expect(brink_intersection_time, just_inside(0.8), 0); // 1.44 2^-100
    expect(brink_intersection_time, just_inside(0.9), 1); // 0.76 2^-100
}
END_TEST

/** d is what (1 + e)^2 - 1 - z^2 is, of terms of 2 in all. */
static pair_case grazing(double e, double z)
{
    return in_lengths((pair_case){{4, 1, z}, {-1, 0, 0}, 1 + e}, 500);
}

/** d = x^2. */
static pair_case hit_faintly(double x)
{
    return in_lengths((pair_case){{1, 0, 0}, {-0x1p100, 0, 0}, x}, 1000);
}

START_TEST(meetings_are_told_when_d_is_more_than_its_error)
{
    static time_of *const kernels[] = {brink_intersection_time,
                                       brink_disjoint_time};
    for (int k = 0; k < 2; k++) {
        // d = -2, and -0.75, of 2^-100
        expect(kernels[k], grazing(0x1p-49, 0x1p-24 + 3 * 0x1p-76), 0);
        expect(kernels[k], grazing(9 * 0x1p-51, 0x1.8p-24 + 7 * 0x1p-76), 1);
    }
    told_past(brink_intersection_time, hit_faintly, 0x1p-450, 1.25);
}
END_TEST

static pair_case passing_soon(double x)
{
    return in_lengths((pair_case){{1, x, 0}, {0, -1, 0}, 0.5}, 500);
}

static pair_case short_time(double x)
{
    return (pair_case){{2 * x, 0, 0}, {-0x1p540, 0, 0}, x};
}

static pair_case long_time(double x)
{
    return (pair_case){{2 * x, 0, 0}, {-0x1p-540, 0, 0}, x};
}

START_TEST(times_are_told_when_they_have_all_their_bits)
{
    told_past(brink_disjoint_time, passing_soon, 0x1p-900, 1.25);
    told_past(brink_intersection_time, short_time, 0x1p-460, 1.25);
    told_past(brink_intersection_time, long_time, 0x1p460, 0.8);
}
END_TEST

// Times within a midpoint of two doubles by so many u^2 of them, u = 2^-53.  The
// error of the root and the sum is 2^-102 (s / d + p / sum + 2), that of what it
// is made into 2^-101, which is 32 u^2, and of c 2^-150 size / c.

static pair_case straight(double u2)
{
    return in_lengths(
        (pair_case){{1 + 0x1p-51, 0, 0}, {-1, 0, 0}, 0x1p-53 + u2 * 0x1p-106},
        500);
}

static pair_case leaving_inside(double u2)
{
    return in_lengths(
        (pair_case){{0x1p-53 + u2 * 0x1p-106, 0, 0}, {1, 0, 0}, 1 + 0x1p-51},
        500);
}

static pair_case passing(double u2)
{
    return in_lengths((pair_case){{1 + 0x1p-51, 1, 4},
                                  {-1, -(0x1p-53 + u2 * 0x1p-106), 0},
                                  0.5},
                      -500);
}

/** t = 2 - sqrt(1 - z^2) = 1 + z^2 / 2. */
static pair_case beside(double u2)
{
    const double z = 0x1p-26 * (1 + u2 * 0x1p-54);
    return in_lengths((pair_case){{2, 0.75, z}, {-1, 0, 0}, 1.25}, 500);
}

/** t = g + z^2 / 2 and g - z^2 / 2 for g = 5 2^-50, c = 2 g. */
static pair_case near_outside(double u2)
{
    const double z = 0x1p-50 * (1 + 1.25 * u2 * 0x1p-54);
    return in_lengths((pair_case){{1 + 5 * 0x1p-50, 0, z}, {-1, 0, 0}, 1}, 500);
}

static pair_case near_inside(double u2)
{
    const double z = 0x1p-50 * (1 + 1.25 * u2 * 0x1p-54);
    return in_lengths((pair_case){{1 - 5 * 0x1p-50, 0, z}, {1, 0, 0}, 1}, 500);
}

/** To 4 in 100, as roundings put in some u^2 themselves. */
static void told_about(time_of *kernel, pair_of *make, double limit)
{
    expect(kernel, make(1.04 * limit), 0);
    expect(kernel, make(limit / 1.04), 1);
}

START_TEST(times_beside_midpoints_are_told_when_their_error_is_less)
{
    told_about(brink_intersection_time, straight, 16 * (1 + 1 + 2) + 32);
    told_about(brink_disjoint_time, straight, 16 * (1 + 1 + 2) + 32);
    told_about(brink_disjoint_time, leaving_inside, 16 * (1 + 0 + 2) + 32);
    told_about(brink_disjoint_time, passing, 8 + 32);
    told_about(brink_intersection_time, beside, 16 * (2.125 + 2.0 / 3 + 2) + 32);
    const double of_c = 0x1p-44 * 2 / (10 * 0x1p-50); // 2^-150 in u^2
    told_about(brink_intersection_time, near_outside,
               16 * (1 + 0.5 + 2) + 32 + of_c);
    told_about(brink_disjoint_time, near_inside, 16 * (1 + 0.5 + 2) + 32 + of_c);
}
END_TEST

int main(void)
{
    return RUN_SUITE("event_time_exact", 60,
                     times_in_long_units_come_to_exact_numbers_seldom,
                     pairs_of_any_mixture_of_sizes_are_told,
                     rates_are_told_when_they_are_more_than_their_error,
                     sides_are_told_when_they_are_more_than_their_error,
                     meetings_are_told_when_d_is_more_than_its_error,
                     times_are_told_when_they_have_all_their_bits,
                     times_beside_midpoints_are_told_when_their_error_is_less);
}
