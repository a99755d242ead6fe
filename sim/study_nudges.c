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

double brink_nudge_try(brink_system *start, enum brink_method method,
                       double nudge, uint64_t events)
{
    const double epsilon = brink_largest_step(start);
    brink_rule rule = *brink_method_rule(method);
    rule.time_nudge = rule.time_nudge > 0 ? nudge : 0;
    rule.place_nudge = rule.place_nudge > 0 ? nudge : 0;
    brink_conventional c;
    if (brink_conventional_create(&c, start, &rule))
        return (double)NAN;
    const double begin = brink_energy_by_position(&c.house);
    const enum brink_run_status status = brink_conventional_advance(&c, events);
    const double off = fabs(brink_energy_by_position(&c.house) - begin) / epsilon;
    brink_conventional_destroy(&c);
    if (status == BRINK_RUN_NO_MEMORY)
        return (double)NAN;
    return status == BRINK_RUN_STUCK ? (double)INFINITY : off;
}
