// SPDX-License-Identifier: MIT
// How often times come to the slow paths: as seldom as the filters are meant to
// let them, for pairs as simulations have them.  The linker leads the calls
// through here: a filter that let everything pass would cost no digit, but time.
#include "pairs.h"
#include "suite.h"
#include <brink/event_time.h>

enum { CASES = 100000, SEED = 1 };

static int slow;

// By the names that the linker's --wrap gives to what is called, and to who asks;
// one for each instruction set that the kernels are compiled for.
typedef double time_of(const double r[3], const double v[3], double sigma);
#define COUNT(name)                                                              \
    time_of real_##name __asm__("__real_brink_" #name);                          \
    time_of counted_##name __asm__("__wrap_brink_" #name);                       \
    double counted_##name(const double r[3], const double v[3], double sigma)    \
    {                                                                            \
        slow++;                                                                  \
        return real_##name(r, v, sigma);                                         \
    }
#ifdef BRINK_DISPATCH
COUNT(intersection_time_slow_any)
COUNT(intersection_time_slow_fma)
COUNT(intersection_time_slow_avx512)
COUNT(disjoint_time_slow_any)
COUNT(disjoint_time_slow_fma)
COUNT(disjoint_time_slow_avx512)
#else
COUNT(intersection_time_slow)
COUNT(disjoint_time_slow)
#endif

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
        slow = 0;
        for (int i = 0; i < CASES; i++) {
            families[f].make(&s, &p);
            kernel(p.r, p.v, p.sigma);
        }
        const int one_in = families[f].is_contact ? few_at_contact : few;
        ck_assert_msg(slow <= CASES / one_in, "%s, seed %d: %d of %d",
                      families[f].name, SEED, slow, CASES);
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
        slow = 0;
        kernels[k](r, v, 2);
        ck_assert_int_eq(slow, 1);
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE("event_time_reached", 120,
                     plain_times_come_to_slow_paths_seldom,
                     correctly_rounded_times_come_to_slow_paths_seldom,
                     what_no_filter_can_tell_comes_to_slow_paths);
}
