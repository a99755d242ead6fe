// SPDX-License-Identifier: MIT
/**
 * Lets both simulators go through some thousand events of each system, for
 * simulator_counts.sh to have callgrind count their instructions: each has its
 * costs dumped under "NAME WHO EVENTS".  Predictions of pairs
 * it counts itself, and prints "NAME WHO pairs NUMBER", an event.
 *
 *   simulator_count [PARTICLES]     in systems of no more than so many
 */
#include "bench_courses.h"
#include <brink/event_time.h>
#include <stdlib.h>
#ifdef __has_include
#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#endif
#endif
#ifndef CALLGRIND_START_INSTRUMENTATION // nothing counts without it
#define CALLGRIND_START_INSTRUMENTATION
#define CALLGRIND_STOP_INSTRUMENTATION
#define CALLGRIND_DUMP_STATS_AT(name) (void)(name)
#endif

// The linker leads calls of these kernels here: see CMakeLists.txt.
typedef void batch(size_t n, const double *rx, const double *ry, const double *rz,
                   const double *vx, const double *vy, const double *vz,
                   const double *sigma, double *t);
batch real_in __asm__("__real_brink_intersection_times");
batch real_out __asm__("__real_brink_disjoint_times");
batch counted_in __asm__("__wrap_brink_intersection_times");
batch counted_out __asm__("__wrap_brink_disjoint_times");

static double pairs; // that went through them

void counted_in(size_t n, const double *rx, const double *ry, const double *rz,
                const double *vx, const double *vy, const double *vz,
                const double *sigma, double *t)
{
    pairs += (double)n;
    real_in(n, rx, ry, rz, vx, vy, vz, sigma, t);
}

void counted_out(size_t n, const double *rx, const double *ry, const double *rz,
                 const double *vx, const double *vy, const double *vz,
                 const double *sigma, double *t)
{
    pairs += (double)n;
    real_out(n, rx, ry, rz, vx, vy, vz, sigma, t);
}

static void count(race_pair *p, enum racer who, const char *key)
{
    static const char *const names[RACERS] = {"brink", "plain"};
    char name[100];
    const double pairs_before = pairs,
                 plain_before = (double)p->plain.predictions;
    CALLGRIND_START_INSTRUMENTATION;
    race_go(p, who, RACE_COUNTED);
    CALLGRIND_STOP_INSTRUMENTATION;
    snprintf(name, sizeof name, "%s %s %d", key, names[who], RACE_COUNTED);
    CALLGRIND_DUMP_STATS_AT(name);
    const double seen = who == RACE_BRINK
                            ? pairs - pairs_before
                            : (double)p->plain.predictions - plain_before;
    printf("%s %s pairs %.2f\n", key, names[who], seen / RACE_COUNTED);
}

int main(int argc, char **argv)
{
    const uint32_t most = argc > 1 ? (uint32_t)atoi(argv[1]) : UINT32_MAX;
    for (int k = 0; k < COUNTED; k++) {
        race_course c = race_within(&bench_courses[k].course, most);
        race_pair p;
        if (race_begin(&p, &c) != 0)
            return EXIT_FAILURE;
        for (enum racer who = 0; who < RACERS; who++) {
            race_go(&p, who, RACE_SETTLING * (uint64_t)race_particles(&c));
            count(&p, who, bench_courses[k].key);
        }
        race_end(&p);
    }
    return EXIT_SUCCESS;
}
