// SPDX-License-Identifier: MIT
// When a particle meets a plane: to the last bit.
#include "cases.h"
#include "oracle.h"
#include "pairs.h"
#include "suite.h"
#include <brink/event_time.h>

enum { CASES_A_FAMILY = 3000, SEED = 1 };

/** A particle and a plane. */
static void keep_halfspace(const char *family, int i, const double r[3],
                           const double v[3], const double n[3],
                           const double c[3])
{
    mpfr_t exact;
    mpfr_init2(exact, ORACLE_BITS);
    oracle_halfspace(exact, r, v, n, c);
    double t = brink_halfspace_time(r, v, n, c);
    if (t != mpfr_get_d(exact, ORACLE_N) || signbit(t))
        ck_abort_msg("%s %d (seed %d): r %a %a %a  v %a %a %a\n"
                     "n %a %a %a  c %a %a %a\ngot %a, exact %a",
                     family, i, SEED, r[0], r[1], r[2], v[0], v[1], v[2], n[0],
                     n[1], n[2], c[0], c[1], c[2], t,
                     mpfr_get_d(exact, ORACLE_N));
    mpfr_clear(exact);
}

START_TEST(a_plane_is_met_when_it_is)
{
    static const double origin[3] = {0, 0, 0};
    stream s = stream_of_seed(SEED);
    const int cases = (int)suite_share(PAIR_FAMILIES * CASES_A_FAMILY / 2);
    for (int i = 0; i < cases; i++) {
        pair_case p, q;
        const pair_family *family = &pair_families[i % PAIR_FAMILIES];
        family->make(&s, &p);
        family->make(&s, &q);
        keep_halfspace(family->name, i, p.r, p.v, q.v, q.r);
        // n.r and n.v as small as a family's r.v may be
        keep_halfspace(family->name, i, p.r, q.v, p.v, origin);
        keep_halfspace(family->name, i, q.r, p.r, p.v, origin);
    }
}
END_TEST

START_TEST(hard_planes_are_met_when_they_are)
{
    FILE *in = cases_open("event_time_halfspace");
    double x[12];
    for (int i = 0; cases_next(in, 12, x); i++)
        keep_halfspace("event_time_halfspace.wc", i, x, x + 3, x + 6, x + 9);
    fclose(in);
}
END_TEST

// n.(r - c) and n.v are whole numbers then, and their quotient is rounded once.
START_TEST(all_small_whole_planes_are_met_when_they_are)
{
    for (int m = 0; m < 27 * 27 * 27 * 27; m++) {
        double x[4][3]; // r v n c
        int f = 0, rate = 0;
        for (int k = 0, rest = m; k < 12; k++, rest /= 3)
            x[k / 3][k % 3] = rest % 3 - 1;
        for (int k = 0; k < 3; k++) {
            f += (int)(x[2][k] * (x[0][k] - x[3][k]));
            rate += (int)(x[2][k] * x[1][k]);
        }
        double right = (double)INFINITY;
        if (rate < 0)
            right = f <= 0 ? 0 : (double)f / -rate;
        const double t = brink_halfspace_time(x[0], x[1], x[2], x[3]);
        if (t != right || signbit(t))
            ck_abort_msg("r %g %g %g  v %g %g %g  n %g %g %g  c %g %g %g: %a",
                         x[0][0], x[0][1], x[0][2], x[1][0], x[1][1], x[1][2],
                         x[2][0], x[2][1], x[2][2], x[3][0], x[3][1], x[3][2], t);
    }
}
END_TEST

// n.(r - c) cancels to some 2^-106 of its terms: the third is what the first two
// make, to two doubles.  Or to a little more, of which digits must be left.
START_TEST(the_side_is_known_where_all_but_the_last_bits_cancel)
{
    stream s = stream_of_seed(SEED);
    mpfr_t f;
    mpfr_init2(f, ORACLE_BITS);
    for (int i = 0; i < (int)suite_share(10 * CASES_A_FAMILY); i++) {
        double r[3], v[3], n[3], c[3];
        mpfr_set_zero(f, 1);
        for (int k = 0; k < 3; k++) {
            r[k] = stream_real(&s, 0.5, 2);
            c[k] = stream_real(&s, -1, 1) * 0x1p-53;
            n[k] = k < 2 ? stream_real(&s, 0.5, 2) : 1;
            v[k] = -n[k];
            if (k < 2) {
                oracle_add(f, 1, n[k], r[k]);
                oracle_add(f, -1, n[k], c[k]);
            }
        }
        r[2] = -mpfr_get_d(f, ORACLE_N);
        mpfr_add_d(f, f, r[2], ORACLE_N);
        c[2] = mpfr_get_d(f, ORACLE_N);
        if (i % 2)
            c[2] += stream_scaled(&s, -70, -20);
        keep_halfspace("cancelling", i, r, v, n, c);
    }
    mpfr_clear(f);
}
END_TEST

START_TEST(times_all_but_halfway_between_two_doubles_are_told)
{
    // t = 1 + k 2^-52 + 2^-53 + tiny * tiny, where double-double loses the last
    for (int k = 0; k < 64; k++)
        for (int e = -52; e > -500; e -= 16)
            for (int way = -1; way <= 1; way += 2) {
                const double tiny = ldexp(1, e);
                const double r[3] = {1 + k * 0x1p-52, 0x1p-53, tiny};
                const double v[3] = {-1, 0, 0}, n[3] = {1, 1, way * tiny};
                const double c[3] = {0, 0, 0};
                ck_assert(brink_halfspace_time(r, v, n, c) ==
                          1 + (way > 0 ? k + 1 : k) * 0x1p-52);
            }
}
END_TEST

START_TEST(nothing_that_is_not_a_number_is_answered)
{
    const double bad[] = {(double)INFINITY, -(double)INFINITY, (double)NAN};
    for (int place = 0; place < 12; place++)
        for (int k = 0; k < 3; k++) {
            double x[12] = {1, 2, 3, -1, -2, -3, 1, 1, 1, 0, 0, 0};
            x[place] = bad[k];
            ck_assert(isnan(brink_halfspace_time(x, x + 3, x + 6, x + 9)));
        }
}
END_TEST

int main(void)
{
    return RUN_SUITE("event_time_halfspace", 600, a_plane_is_met_when_it_is,
                     hard_planes_are_met_when_they_are,
                     all_small_whole_planes_are_met_when_they_are,
                     the_side_is_known_where_all_but_the_last_bits_cancel,
                     times_all_but_halfway_between_two_doubles_are_told,
                     nothing_that_is_not_a_number_is_answered);
}
