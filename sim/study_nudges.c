// SPDX-License-Identifier: MIT
#include "study_nudges.h"
#include "conventional.h"
#include <math.h>

int brink_nudge_is_used(enum brink_method method)
{
    const brink_rule *rule = brink_method_rule(method);
    return rule->time_nudge > 0 || rule->place_nudge > 0;
}

double brink_nudge_size(int k)
{
    static const double size[BRINK_NUDGES] = {1e-16, 1e-14, 1e-12, 1e-10,
                                              1e-8,  1e-6,  1e-4,  1e-2};
    return size[k];
}

// How far off the energy is after so many events; -1 if there was a stop before.
static double go_through(brink_conventional *c, uint64_t events, double epsilon,
                         const brink_watch *watch)
{
    const double begin = brink_energy_by_position(&c->house);
    enum brink_run_status status = BRINK_RUN_REACHED;
    for (uint64_t done = 0; done < events && status == BRINK_RUN_REACHED;) {
        const uint64_t left = events - done;
        done += left < BRINK_WATCH_EVENTS ? left : BRINK_WATCH_EVENTS;
        status = brink_conventional_advance(c, done);
        if (brink_watch_stopped(watch))
            return -1;
    }
    if (status == BRINK_RUN_NO_MEMORY)
        return (double)NAN;
    if (status == BRINK_RUN_STUCK)
        return (double)INFINITY;
    return fabs(brink_energy_by_position(&c->house) - begin) / epsilon;
}

int brink_nudge_try(brink_system *start, enum brink_method method, double nudge,
                    uint64_t events, const brink_watch *watch, double *off)
{
    const double epsilon = brink_largest_step(start);
    brink_rule rule = *brink_method_rule(method);
    rule.time_nudge = rule.time_nudge > 0 ? nudge : 0;
    rule.place_nudge = rule.place_nudge > 0 ? nudge : 0;
    brink_conventional c;
    *off = (double)NAN;
    if (brink_conventional_create(&c, start, &rule))
        return 0;
    *off = go_through(&c, events, epsilon, watch);
    brink_conventional_destroy(&c);
    return *off < 0 ? -1 : 0;
}
