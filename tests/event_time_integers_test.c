// SPDX-License-Identifier: MIT
// All pairs with coordinates from -3 to 3 and sigma from 0 to 5, against whole
// numbers: every sign is decided, and every root judged, without a rounding.
#include "oracle_integers.h"
#include "suite.h"
#include <brink/event_time.h>

enum { MOST = 3, KINDS = 2 * MOST + 1, SIGMAS = 6 };

typedef double time_kernel(const double r[3], const double v[3], double sigma);

/** f(t) = a t^2 + 2 b t + c and d = b^2 - a c of a pair. */
typedef struct path {
    double r[3], v[3], sigma;
    int a, b, c, d;
} path;

/** The pair number n of KINDS^6 * SIGMAS. */
static path path_of(int n)
{
    path p = {.sigma = n % SIGMAS};
    p.c = -(n % SIGMAS) * (n % SIGMAS);
    n /= SIGMAS;
    for (int i = 0; i < 3; i++) {
        const int x = n % KINDS - MOST, y = n / KINDS % KINDS - MOST;
        n /= KINDS * KINDS;
        p.r[i] = x;
        p.v[i] = y;
        p.a += y * y;
        p.b += x * y;
        p.c += x * x;
    }
    p.d = p.b * p.b - p.a * p.c;
    return p;
}

/** Whether t is the double nearest to when the pair meets. */
static int meets_at(const path *p, double t)
{
    if (p->b >= 0 || (p->c > 0 && p->d <= 0))
        return t == (double)INFINITY;
    if (p->c <= 0)
        return t == 0;
    return is_nearest_root(p->a, 2 * p->b, p->c, -1, t);
}

/** Whether t is the double nearest to when it parts. */
static int parts_at(const path *p, double t)
{
    if (p->a == 0)
        return t == (double)INFINITY;
    if (p->b >= 0 && p->c >= 0)
        return t == 0;
    if (p->d > 0)
        return is_nearest_root(p->a, 2 * p->b, p->c, 1, t);
    return is_nearest_root(p->a, p->b, 0, 1, t); // -b / a
}

static int is_right(int (*at)(const path *, double), const path *p, double t,
                    int ulps)
{
    int right = at(p, t);
    for (double x = t, y = t; !right && ulps > 0; ulps--) {
        x = nextafter(x, (double)INFINITY);
        y = nextafter(y, 0);
        right = at(p, x) || at(p, y);
    }
    // What is now, or never, is so for every tier.
    return right && !signbit(t) && (t == 0) == at(p, 0) &&
           isinf(t) == at(p, (double)INFINITY);
}

static const struct {
    const char *name;
    time_kernel *kernel;
    int (*at)(const path *, double);
    int ulps; // the nearest double, or so many beside it
} tiers[] = {
    {"intersection_cr", brink_intersection_time_cr, meets_at, 0},
    {"intersection", brink_intersection_time, meets_at, BRINK_EVENT_TIME_ULP},
    {"disjoint_cr", brink_disjoint_time_cr, parts_at, 0},
    {"disjoint", brink_disjoint_time, parts_at, BRINK_EVENT_TIME_ULP},
};

START_TEST(all_pairs_of_small_integers_are_right)
{
    int count = SIGMAS;
    for (int k = 0; k < 6; k++)
        count *= KINDS;
    for (int n = 0; n < count; n++) {
        const path p = path_of(n);
        const double t = tiers[_i].kernel(p.r, p.v, p.sigma);
        if (!is_right(tiers[_i].at, &p, t, tiers[_i].ulps))
            ck_abort_msg("%s, pair %d: %g %g %g  %g %g %g  %g: %a",
                         tiers[_i].name, n, p.r[0], p.r[1], p.r[2], p.v[0],
                         p.v[1], p.v[2], p.sigma, t);
    }
}
END_TEST

// Where r, v and sigma are small and whole the fast sums are exact, up to the
// roots: so here _fast knows events from none, and now from later, as well.
START_TEST(fast_events_of_small_integers_are_right)
{
    int count = SIGMAS;
    for (int k = 0; k < 6; k++)
        count *= KINDS;
    for (int n = 0; n < count; n++) {
        const path p = path_of(n);
        const double in = brink_intersection_time_fast(p.r, p.v, p.sigma);
        const double out = brink_disjoint_time_fast(p.r, p.v, p.sigma);
        if (isinf(in) != meets_at(&p, (double)INFINITY) ||
            (in == 0) != meets_at(&p, 0) ||
            isinf(out) != parts_at(&p, (double)INFINITY) ||
            (out == 0) != parts_at(&p, 0))
            ck_abort_msg("pair %d: %g %g %g  %g %g %g  %g: %a, %a", n, p.r[0],
                         p.r[1], p.r[2], p.v[0], p.v[1], p.v[2], p.sigma, in,
                         out);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("event_time_integers");
    TCase *all = tcase_create("all");
    tcase_set_timeout(all, 300);
    tcase_add_loop_test(all, all_pairs_of_small_integers_are_right, 0,
                        sizeof tiers / sizeof *tiers);
    tcase_add_test(all, fast_events_of_small_integers_are_right);
    suite_add_tcase(suite, all);
    return run_whole_suite(suite);
}
