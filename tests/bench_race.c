// SPDX-License-Identifier: MIT
#include "bench_race.h"
#include "scene.h"
#include "start.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

enum { PIECES = 5 }; // odd: the median is one of them

uint32_t race_particles(const race_course *c)
{
    return 4 * (uint32_t)(c->edge * c->edge * c->edge);
}

race_course race_within(const race_course *c, uint32_t most)
{
    race_course smaller = *c;
    while (race_particles(&smaller) > most && smaller.edge > 5)
        smaller.edge--;
    return smaller;
}

double race_packing(const race_course *c)
{
    return c->density * acos(-1) / 6; // cores are of diameter 1
}

// --- Both of them --------------------------------------------------------------

/** Bytes given out by malloc and not yet given back. */
static double bytes_held(void)
{
#if defined __GLIBC__ && __GLIBC_PREREQ(2, 33)
    const struct mallinfo2 m = mallinfo2();
    return (double)m.uordblks + (double)m.hblkhd;
#else
    return (double)NAN;
#endif
}

static int make_start(brink_system *start, const race_course *c)
{
    brink_scene scene;
    char steps[100] = "[[1, .inf]]", text[500];
    if (c->range > 0)
        snprintf(steps, sizeof steps, "[[%g, %g], [1, .inf]]", c->range,
                 c->energy);
    snprintf(text, sizeof text,
             "box: {number_density: %.17g}\n"
             "species: {A: {count: %u}}\n"
             "potentials: [{between: [A, A], steps: %s}]\n",
             c->density, race_particles(c), steps);
    if (brink_scene_parse(text, strlen(text), "bench", "", &scene, stderr) != 0)
        return -1;
    const int failed = brink_start_make(&scene, "bench", start, stderr);
    brink_scene_destroy(&scene);
    return failed;
}

int race_begin(race_pair *p, const race_course *c)
{
    brink_system start;
    const double at_first = bytes_held();
    if (make_start(&start, c) != 0)
        return -1;
    const double with_start = bytes_held();
    plain_create(&p->plain, &start);
    const double with_plain = bytes_held();
    if (brink_run_create(&p->brink, &start, BRINK_TIER_PLAIN) != 0) {
        fprintf(stderr, "bench: no memory for %u particles\n", race_particles(c));
        plain_destroy(&p->plain);
        return -1;
    }
    p->bytes[RACE_PLAIN] = with_plain - with_start;
    p->bytes[RACE_BRINK] = bytes_held() - with_plain + with_start - at_first;
    return 0;
}

void race_end(race_pair *p)
{
    brink_run_destroy(&p->brink);
    plain_destroy(&p->plain);
}

static void advance_brink(brink_run *run, uint64_t events)
{
    char why[2000];
    const enum brink_run_status status = brink_run_advance(
        run, brink_tally_events(&run->tally) + events, BRINK_NEVER);
    if (status == BRINK_RUN_REACHED)
        return;
    brink_run_diagnosis(run, status, why, sizeof why);
    fprintf(stderr, "bench: the run stopped: %s\n", why);
    exit(EXIT_FAILURE);
}

static double cpu_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double race_go(race_pair *p, enum racer who, uint64_t events)
{
    const double held = bytes_held(), begin = cpu_seconds();
    if (who == RACE_BRINK)
        advance_brink(&p->brink, events);
    else
        plain_advance(&p->plain, p->plain.events + events);
    const double seconds = cpu_seconds() - begin;
    p->bytes[who] += bytes_held() - held;
    return seconds;
}

// --- The race ------------------------------------------------------------------

static void count_crossings(const race_pair *p, double crossings[RACERS])
{
    crossings[RACE_BRINK] = (double)p->brink.tally.cell;
    crossings[RACE_PLAIN] = (double)p->plain.crossings;
}

/** Partners of a particle, on average. */
static double captured(const plain_simulator *s)
{
    double partners = 0;
    for (uint32_t i = 0; i < s->count; i++)
        partners += s->circle[i].count;
    return partners / s->count;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double x[PIECES])
{
    qsort(x, PIECES, sizeof *x, by_size);
    return x[PIECES / 2];
}

/** So many pieces, one after the other; how fast they were. */
static void take_turns(race_result *result, race_pair *p, uint64_t events)
{
    double rate[RACERS][PIECES], ratio[PIECES];
    for (int k = 0; k < PIECES; k++) {
        for (enum racer who = 0; who < RACERS; who++)
            rate[who][k] = (double)events / race_go(p, who, events);
        ratio[k] = rate[RACE_BRINK][k] / rate[RACE_PLAIN][k];
    }
    for (int who = 0; who < RACERS; who++)
        result->rate[who] = median(rate[who]);
    result->ratio = median(ratio);
    result->least = ratio[0]; // sorted now
    result->most = ratio[PIECES - 1];
}

int race_hold(race_result *result, const race_course *c, double seconds)
{
    race_pair p;
    double settling[RACERS], before[RACERS], after[RACERS];
    if (race_begin(&p, c) != 0)
        return -1;
    const double n = race_particles(c);
    for (enum racer who = 0; who < RACERS; who++)
        settling[who] = race_go(&p, who, RACE_SETTLING * (uint64_t)n);
    const double rate = RACE_SETTLING * n /
                        fmax(settling[RACE_BRINK], 1e-6); // s: the clock's tick
    const uint64_t events = (uint64_t)fmax(n / 2, seconds * rate);
    *result = (race_result){.course = *c};
    count_crossings(&p, before);
    take_turns(result, &p, events);
    count_crossings(&p, after);
    for (int who = 0; who < RACERS; who++) {
        result->crossings[who] =
            (after[who] - before[who]) / (double)(PIECES * events);
        result->bytes[who] = p.bytes[who] / n;
    }
    result->captured = captured(&p.plain);
    race_end(&p);
    return 0;
}
