// SPDX-License-Identifier: MIT
#include "study_trial.h"
#include <math.h>
#include <string.h>
#include <time.h>

uint64_t brink_trial_next_sample(uint64_t events)
{
    const double ratio = pow(10, 1.0 / 20);
    const uint64_t next = (uint64_t)((double)events * ratio);
    return next > events ? next : events + 1;
}

const brink_run *brink_attempt_run(const brink_attempt *a)
{
    return a->trial.method == BRINK_METHOD_LOGICAL ? &a->run
                                                   : &a->conventional.house;
}

static int create(brink_attempt *a, brink_system *start)
{
    if (a->trial.method != BRINK_METHOD_LOGICAL)
        return brink_conventional_create(&a->conventional, start,
                                         brink_method_rule(a->trial.method));
    return brink_run_create(&a->run, start, BRINK_TIER_PLAIN) ||
           brink_doubter_create(&a->doubter, &a->run);
}

void brink_attempt_destroy(brink_attempt *a)
{
    brink_run_destroy(&a->run);
    brink_doubter_destroy(&a->doubter);
    brink_conventional_destroy(&a->conventional);
}

// Kinetic energy and counted levels, in twice the precision: what a run of 10^8
// events loses is less than a rounding of their sum.
static brink_sum energy_kept(const brink_run *run)
{
    const brink_system *s = &run->system;
    brink_sum all = {0};
    brink_sum_add(&all, brink_states_energy(&run->states, s));
    for (int k = 0; k < s->species_count; k++) {
        brink_sum squares = {0};
        for (uint32_t i = 0; i < s->count; i++)
            if (s->particle[i].species == (uint32_t)k)
                for (int a = 0; a < s->dimensions; a++)
                    brink_sum_product(&squares, s->particle[i].v[a],
                                      s->particle[i].v[a]);
        const double half = s->species[k].mass / 2;
        brink_sum_product(&all, half, squares.sum);
        brink_sum_product(&all, half, squares.carry);
    }
    return all;
}

// Part of what there was at the start, unless that was nothing.
static double relative(double energy, double begin)
{
    return begin < 0 || begin > 0 ? energy / fabs(begin) : energy;
}

static void sample(brink_attempt *a)
{
    brink_trial *t = &a->trial;
    const brink_run *run = brink_attempt_run(a);
    const brink_sum kept = energy_kept(run);
    const double gained =
        (kept.sum - t->kept_begin.sum) + (kept.carry - t->kept_begin.carry);
    t->energy_end = brink_energy_by_position(run);
    t->energy_error =
        fabs(relative(t->energy_end - t->energy_begin, t->energy_begin));
    t->energy_worst = fmax(t->energy_worst, t->energy_error);
    t->events = brink_tally_events(&run->tally);
    t->time = brink_run_time(run);
    t->tally = run->tally;
    t->last = run->last;
    t->doubts = a->doubter.seen;
    t->sample[t->samples++] = (brink_sample){
        .events = t->events,
        .time = t->time,
        .energy = t->energy_end,
        .error = t->energy_error,
        .kept = relative(gained, brink_sum_value(&t->kept_begin)),
    };
}

static enum brink_outcome judge(const brink_trial *t,
                                enum brink_run_status status, uint64_t events)
{
    static const enum brink_outcome ends[] = {
        [BRINK_RUN_AT_REST] = BRINK_OUTCOME_AT_REST,
        [BRINK_RUN_QUIET] = BRINK_OUTCOME_AT_REST,
        [BRINK_RUN_STUCK] = BRINK_OUTCOME_STANDS_STILL,
        [BRINK_RUN_REFUSED] = BRINK_OUTCOME_REFUSED,
        [BRINK_RUN_NO_MEMORY] = BRINK_OUTCOME_NO_MEMORY,
    };
    const double off = fabs(t->energy_end - t->energy_begin);
    if (status != BRINK_RUN_REACHED)
        return ends[status];
    // Without a finite step there is no epsilon, and no potential energy to be
    // wrong.
    if (t->epsilon > 0 && off > t->epsilon * t->particles)
        return BRINK_OUTCOME_ENERGY_OFF;
    return t->events < events ? BRINK_OUTCOME_NONE : BRINK_OUTCOME_DONE;
}

void brink_attempt_create(brink_attempt *a, brink_system *start,
                          enum brink_method method, uint64_t events)
{
    brink_trial *t = &a->trial;
    memset(a, 0, sizeof *a);
    a->events = events;
    t->method = method;
    t->particles = start->count;
    t->epsilon = brink_largest_step(start);
    if (create(a, start)) {
        t->outcome = BRINK_OUTCOME_NO_MEMORY;
        brink_system_destroy(start);
        return;
    }
    t->energy_begin = brink_energy_by_position(brink_attempt_run(a));
    t->kept_begin = energy_kept(brink_attempt_run(a));
}

static uint64_t least(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

void brink_attempt_advance(brink_attempt *a, uint64_t events)
{
    brink_trial *t = &a->trial;
    const uint64_t done = brink_tally_events(&brink_attempt_run(a)->tally);
    const uint64_t point = least(brink_trial_next_sample(t->events), a->events);
    const uint64_t target = least(point, done + events);
    const clock_t begin = clock();
    const enum brink_run_status status =
        t->method == BRINK_METHOD_LOGICAL
            ? brink_doubter_advance(&a->doubter, &a->run, target)
            : brink_conventional_advance(&a->conventional, target);
    t->seconds += (double)(clock() - begin) / CLOCKS_PER_SEC;
    if (target < point && status == BRINK_RUN_REACHED)
        return;
    sample(a);
    t->outcome = judge(t, status, a->events);
}
