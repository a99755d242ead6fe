// SPDX-License-Identifier: MIT
#include "study_trial.h"
#include "conventional.h"
#include <inttypes.h>
#include <math.h>
#include <string.h>
#include <time.h>

uint64_t brink_trial_next_sample(uint64_t events)
{
    const double ratio = pow(10, 1.0 / 20);
    const uint64_t next = (uint64_t)((double)events * ratio);
    return next > events ? next : events + 1;
}

// What is advanced and looked at: one of the two.
typedef struct subject {
    brink_run run;
    brink_conventional conventional;
    brink_doubts doubts;
    const brink_run *seen;
} subject;

static int create(subject *s, brink_system *start, enum brink_method method)
{
    memset(s, 0, sizeof *s);
    if (method != BRINK_METHOD_LOGICAL) {
        s->seen = &s->conventional.house;
        return brink_conventional_create(&s->conventional, start,
                                         brink_method_rule(method));
    }
    s->seen = &s->run;
    if (brink_doubts_create(&s->doubts, start->count))
        return -1;
    return brink_run_create(&s->run, start, BRINK_TIER_PLAIN);
}

static void destroy(subject *s)
{
    brink_run_destroy(&s->run);
    brink_conventional_destroy(&s->conventional);
    brink_doubts_destroy(&s->doubts);
}

static enum brink_run_status advance(subject *s, uint64_t events)
{
    if (s->seen != &s->run)
        return brink_conventional_advance(&s->conventional, events);
    enum brink_run_status status = BRINK_RUN_REACHED;
    uint64_t done = brink_tally_events(&s->run.tally);
    while (status == BRINK_RUN_REACHED && done < events) {
        status = brink_run_advance(&s->run, ++done, BRINK_NEVER);
        if (status == BRINK_RUN_REACHED)
            brink_doubts_look(&s->doubts, &s->run);
    }
    return status;
}

static void sample(const brink_run *run, FILE *samples, brink_trial *t)
{
    const double energy = brink_energy_by_position(run);
    t->energy_end = energy;
    const double size = fabs(t->energy_begin);
    t->energy_error = fabs(energy - t->energy_begin) / (size > 0 ? size : 1);
    t->energy_worst = fmax(t->energy_worst, t->energy_error);
    t->events = brink_tally_events(&run->tally);
    t->time = brink_run_time(run);
    t->tally = run->tally;
    t->last = run->last;
    fprintf(samples, "%" PRIu64 "\t%.10g\t%.6g\t%.17g\n", t->events, t->time,
            t->energy_error, energy);
    fflush(samples); // a crash leaves what there was
}

static enum brink_outcome judge(const brink_trial *t,
                                enum brink_run_status status, uint64_t events)
{
    static const enum brink_outcome ends[] = {
        [BRINK_RUN_AT_REST] = BRINK_OUTCOME_AT_REST,
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

void brink_trial_run(brink_system *start, enum brink_method method,
                     uint64_t events, FILE *samples, brink_trial *t)
{
    subject s;
    memset(t, 0, sizeof *t);
    t->method = method;
    t->particles = start->count;
    t->epsilon = brink_largest_step(start);
    if (create(&s, start, method)) {
        t->outcome = BRINK_OUTCOME_NO_MEMORY;
        brink_system_destroy(start);
        destroy(&s);
        return;
    }
    t->energy_begin = brink_energy_by_position(s.seen);
    while (t->outcome == BRINK_OUTCOME_NONE) {
        const uint64_t next = brink_trial_next_sample(t->events);
        const clock_t begin = clock();
        const enum brink_run_status status =
            advance(&s, next < events ? next : events);
        t->seconds += (double)(clock() - begin) / CLOCKS_PER_SEC;
        sample(s.seen, samples, t);
        t->outcome = judge(t, status, events);
    }
    t->doubts = s.doubts;
    t->doubts.partner = NULL;
    destroy(&s);
}
