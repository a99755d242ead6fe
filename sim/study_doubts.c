// SPDX-License-Identifier: MIT
#include "study_doubts.h"
#include "conventional_method.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

int brink_doubts_create(brink_doubts *d, uint32_t particles)
{
    memset(d, 0, sizeof *d);
    d->partner = malloc(particles * sizeof *d->partner);
    if (d->partner == NULL)
        return -1;
    memset(d->partner, 0xff, particles * sizeof *d->partner); // BRINK_NOBODY
    return 0;
}

void brink_doubts_destroy(brink_doubts *d)
{
    free(d->partner);
    d->partner = NULL;
}

static int shown(const brink_run *run, uint32_t i, uint32_t j)
{
    double r[3];
    brink_separation_now(run, i, j, r);
    return brink_level_by_position(brink_system_potential(&run->system, i, j), r);
}

// Particle i has had an event: the pair it was in before is looked at again.
static void look_back(brink_doubts *d, const brink_run *run, uint32_t i)
{
    const uint32_t j = d->partner[i];
    if (j == BRINK_NOBODY)
        return;
    d->looks_later++;
    d->later += shown(run, i, j) != brink_states_level(&run->states, i, j);
    d->partner[i] = d->partner[j] = BRINK_NOBODY;
}

void brink_doubts_look(brink_doubts *d, const brink_run *run)
{
    const brink_happening *last = &run->last;
    const uint32_t i = last->i, j = last->j;
    const int level = shown(run, i, j);
    d->events++;
    d->before += level != last->level_before;
    d->after += level != last->level_after;
    if (last->kind == BRINK_CORE) {
        double r[3];
        brink_separation_now(run, i, j, r);
        d->overlaps += brink_step_level_at(
                           brink_system_potential(&run->system, i, j), r) > level;
    }
    if (d->partner[i] != j) {
        look_back(d, run, i);
        look_back(d, run, j);
        d->partner[i] = j;
        d->partner[j] = i;
    }
}
