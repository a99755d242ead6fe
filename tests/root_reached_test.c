// SPDX-License-Identifier: MIT
// How often the correctly rounded tiers come to exact arithmetic, and in it to
// the sign at a midpoint: as seldom as they should, and always where they must.
// The linker leads the calls of brink_dyadic_root, and those that make a midpoint
// in it, through here: so a slow path that nothing reached would show.
#include "pairs.h"
#include "quadratics.h"
#include "suite.h"
#include <brink/event_time.h>
#include <brink/quadratic.h>
#include <brink/root.h>

enum { CASES = 200000, SEED = 1 };

static int roots, midpoints, in_root;

// By the names that the linker's --wrap gives to what is called, and to who asks.
typedef double root_of(const brink_dyadic *a, const brink_dyadic *b,
                       const brink_dyadic *c, const brink_dyadic *d,
                       enum brink_which which);
typedef void integer_of(brink_dyadic *z, int64_t m, int e);
root_of real_root __asm__("__real_brink_dyadic_root");
root_of counted_root __asm__("__wrap_brink_dyadic_root");
integer_of real_integer __asm__("__real_brink_dyadic_integer");
integer_of counted_integer __asm__("__wrap_brink_dyadic_integer");

double counted_root(const brink_dyadic *a, const brink_dyadic *b,
                    const brink_dyadic *c, const brink_dyadic *d,
                    enum brink_which which)
{
    roots++;
    in_root = 1;
    const double x = real_root(a, b, c, d, which);
    in_root = 0;
    return x;
}

void counted_integer(brink_dyadic *z, int64_t m, int e)
{
    midpoints += in_root;
    real_integer(z, m, e);
}

static void solve(const char *name)
{
    for (int f = 0; f < QUADRATIC_FAMILIES; f++)
        if (strcmp(quadratic_families[f].name, name) == 0) {
            stream s = stream_of_seed(SEED);
            quadratic_case q;
            double x0, x1;
            for (int i = 0; i < CASES; i++) {
                quadratic_families[f].make(&s, &q);
                brink_quadratic_roots_cr(q.a, q.b, q.c, &x0, &x1);
            }
            return;
        }
    ck_abort_msg("there is no family %s", name);
}

// The rounding test leaves less than one root in a million open.
START_TEST(benign_roots_come_to_exact_arithmetic_seldom)
{
    solve("benign");
    ck_assert_int_le(roots, 2); // both roots of one quadratic
}
END_TEST

START_TEST(roots_beside_midpoints_are_decided_there)
{
    // a = 2^-k moves the root m - 1/b by 2^(1-k) of itself; where that is more
    // than 2^-85, so for k < 86 of 60 to 300, the 32 bits below m show it.
    solve("midpoint");
    ck_assert_int_ge(midpoints, (int)(0.85 * CASES));
}
END_TEST

START_TEST(square_roots_beside_midpoints_are_decided_there)
{
    // Both roots of x^2 = c, in every second case but for some hundred.
    solve("sqrt");
    ck_assert_int_ge(midpoints, (int)(0.98 * CASES));
}
END_TEST

static void meet(void (*make)(stream *, pair_case *))
{
    stream s = stream_of_seed(SEED);
    pair_case p;
    for (int i = 0; i < CASES; i++) {
        make(&s, &p);
        brink_intersection_time_cr(p.r, p.v, p.sigma);
    }
}

START_TEST(times_in_a_fluid_come_to_exact_arithmetic_seldom)
{
    meet(family_neighbours);
    ck_assert_int_le(roots, 1);
}
END_TEST

/** A time halfway between two doubles: (1 + k 2^-52) - 2^-53. */
static void make_tie(stream *s, pair_case *p)
{
    const double k = stream_int(s, 1, INT32_MAX);
    *p = (pair_case){{0, 1 + k * 0x1p-52, 0}, {0, -1, 0}, 0x1p-53};
}

START_TEST(times_halfway_are_decided_there)
{
    meet(make_tie);
    ck_assert_int_eq(roots, CASES);
    ck_assert_int_eq(midpoints, CASES);
}
END_TEST

int main(void)
{
    return RUN_SUITE("root_reached", 120,
                     benign_roots_come_to_exact_arithmetic_seldom,
                     roots_beside_midpoints_are_decided_there,
                     square_roots_beside_midpoints_are_decided_there,
                     times_in_a_fluid_come_to_exact_arithmetic_seldom,
                     times_halfway_are_decided_there);
}
