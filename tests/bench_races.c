// SPDX-License-Identifier: MIT
#include "bench_races.h"
#include <math.h>

static int is_same(const race_course *a, const race_course *b)
{
    return a->edge == b->edge && a->density == b->density &&
           a->range == b->range && a->energy == b->energy;
}

const race_result *bench_race_over(const bench_races *r, race_course c)
{
    c = race_within(&c, r->most);
    for (int k = 0; k < r->held; k++)
        if (is_same(&r->result[k].course, &c))
            return &r->result[k];
    return NULL;
}

static int hold(bench_races *r, race_course c)
{
    if (bench_race_over(r, c) != NULL)
        return 0;
    c = race_within(&c, r->most);
    fprintf(stderr, "bench: %u particles, packing %.4g%s\n", race_particles(&c),
            race_packing(&c),
            c.range == 0   ? ""
            : c.energy < 0 ? ", square well"
                           : ", square shoulder");
    return race_hold(&r->result[r->held++], &c, r->seconds);
}

int bench_hold_races(bench_races *r)
{
    int failed = 0;
    for (int k = 0; k < COURSES && !failed; k++)
        failed = hold(r, bench_courses[k].course);
    for (int k = 0; k < SIZES && !failed; k++)
        failed = hold(r, bench_size(k));
    for (int k = 0; k < DENSITIES && !failed; k++)
        failed = hold(r, bench_density(k));
    return failed || hold(r, bench_well_12) ? -1 : 0;
}

double bench_size_spread(const bench_races *r, enum racer who)
{
    double least = (double)INFINITY, most = 0;
    for (int k = 0; k < SIZES; k++) {
        const double ns = race_ns(bench_race_over(r, bench_size(k)), who);
        least = fmin(least, ns);
        most = fmax(most, ns);
    }
    return most / least;
}
