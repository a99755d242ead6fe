// SPDX-License-Identifier: MIT
// Where double-double ends: on this side of a limit a plane is told by it, on
// the other it comes to exact numbers.  Half a limit would be taken for certain
// without a reason, twice of it costs time.
#include "counted_dots.h"
#include "pair.h"
#include "suite.h"
#include <brink/event_time.h>

enum { CASES = 20000, SEED = 1 };

typedef struct plane_case {
    double r[3], v[3], n[3], c[3];
} plane_case;

static int is_plane_exact(const plane_case *p)
{
    dots = 0;
    brink_halfspace_time(p->r, p->v, p->n, p->c);
    return dots > 0;
}

static void expect_plane(plane_case p, int is_exact)
{
    ck_assert_msg(is_plane_exact(&p) == is_exact,
                  "r %a %a %a  v %a %a %a  n %a %a %a  c %a %a %a: exact, or not",
                  p.r[0], p.r[1], p.r[2], p.v[0], p.v[1], p.v[2], p.n[0], p.n[1],
                  p.n[2], p.c[0], p.c[1], p.c[2]);
}

typedef plane_case plane_of(double x);

/** Told when x is past a limit, up or down: not at it, nor on this side of it. */
static void plane_told_past(plane_of *make, double limit, double past)
{
    expect_plane(make(limit * past), 0);
    expect_plane(make(limit), 1);
    expect_plane(make(limit / past), 1);
}

START_TEST(planes_come_to_exact_numbers_seldom)
{
    stream s = stream_of_seed(SEED);
    plane_case p;
    int exact = 0;
    for (int i = 0; i < CASES; i++) {
        fill_normal(&s, p.r, 1);
        fill_normal(&s, p.v, 1);
        fill_normal(&s, p.n, 1);
        fill_normal(&s, p.c, 1);
        exact += is_plane_exact(&p);
    }
    ck_assert_int_le(exact, CASES / 10000); // a rounding leaves one in 2^20 open
}
END_TEST

// n.v = x, or -x, of terms of 3 in all; n.(r - c) likewise.

static plane_case plane_left(double x)
{
    return (plane_case){{3, 2, 1}, {0.75, -0.75, x}, {2, 2, 1}, {0, 0, 0}};
}

static plane_case plane_gone_beyond(double x)
{
    return (plane_case){{-3, 2, 1}, {0.75, -0.75, -x}, {2, 2, 1}, {0, 0, 0}};
}

static plane_case beyond_plane(double x)
{
    return (plane_case){{0.5, -0.5, -x}, {-1, 0, 0}, {2, 2, 1}, {-0.25, 0.25, 0}};
}

static plane_case plane_left_faintly(double x)
{
    return (plane_case){{1, 0, 0}, {x, 0, 0}, {1, 0, 0}, {0, 0, 0}};
}

static plane_case plane_gone_beyond_faintly(double x)
{
    return (plane_case){{-1, 0, 0}, {-x, 0, 0}, {1, 0, 0}, {0, 0, 0}};
}

static plane_case faintly_beyond_plane(double x)
{
    return (plane_case){{-x, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 0}};
}

START_TEST(sides_of_planes_are_told_when_they_are_more_than_their_error)
{
    plane_told_past(plane_left, 0x1.8p-99, 1.1);
    plane_told_past(plane_gone_beyond, 0x1.8p-99, 1.1);
    plane_told_past(beyond_plane, 0x1.8p-99, 1.1);
    plane_told_past(plane_left_faintly, 0x1p-900, 1.25);
    plane_told_past(plane_gone_beyond_faintly, 0x1p-900, 1.25);
    plane_told_past(faintly_beyond_plane, 0x1p-900, 1.25);
}
END_TEST

/** n.(r - c) = x of terms of 2 + x. */
static plane_case before_plane(double x)
{
    return (plane_case){{1, -1, x}, {-1, 0, 0}, {1, 1, 1}, {0, 0, 0}};
}

static plane_case faintly_before_plane(double x)
{
    return (plane_case){{x, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 0}};
}

static plane_case far_from_plane(double x)
{
    return (plane_case){{x, 0, 0}, {-0x1p100, 0, 0}, {1, 0, 0}, {0, 0, 0}};
}

static plane_case fast_to_plane(double x)
{
    return (plane_case){{0x1p100, 0, 0}, {-x, 0, 0}, {1, 0, 0}, {0, 0, 0}};
}

static plane_case shortly_before_plane(double x)
{
    return (plane_case){{x, 0, 0}, {-0x1p200, 0, 0}, {1, 0, 0}, {0, 0, 0}};
}

static plane_case long_before_plane(double x)
{
    return (plane_case){{x, 0, 0}, {-0x1p-200, 0, 0}, {1, 0, 0}, {0, 0, 0}};
}

START_TEST(times_to_planes_are_told_when_they_have_all_their_bits)
{
    // x = 2^-25 (2 + x) as it is rounded
    plane_told_past(before_plane, 0x1p-24 + 0x1p-49 + 0x1p-74, 1.25);
    plane_told_past(faintly_before_plane, 0x1p-800, 1.25);
    plane_told_past(far_from_plane, 0x1p900, 0.8);
    plane_told_past(fast_to_plane, 0x1p900, 0.8);
    plane_told_past(shortly_before_plane, 0x1p-700, 1.25);
    plane_told_past(long_before_plane, 0x1p700, 0.8);
}
END_TEST

int main(void)
{
    return RUN_SUITE("event_time_halfspace_exact", 60,
                     planes_come_to_exact_numbers_seldom,
                     sides_of_planes_are_told_when_they_are_more_than_their_error,
                     times_to_planes_are_told_when_they_have_all_their_bits);
}
