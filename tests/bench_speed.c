// SPDX-License-Identifier: MIT
#include "bench_speed.h"
#include "cost.h"
#include <brink/event_time.h>
#include <stddef.h>

// --- Batches -------------------------------------------------------------------

typedef void batch(size_t n, const double *rx, const double *ry, const double *rz,
                   const double *vx, const double *vy, const double *vz,
                   const double *sigma, double *t);

/** A batch on each path; weak, as a build may have but one, under no name. */
#define BATCH(name)                                                              \
    batch name##_any __attribute__((weak)), name##_fma __attribute__((weak)),    \
        name##_avx512 __attribute__((weak));                                     \
    BATCH_LOOP(name##_any)                                                       \
    BATCH_LOOP(name##_fma)                                                       \
    BATCH_LOOP(name##_avx512)

#define BATCH_LOOP(name)                                                         \
    static void name##_loop(const inputs *in, answers *out)                      \
    {                                                                            \
        double *const *c = in->columns;                                          \
        name((size_t)in->n, c[0], c[1], c[2], c[3], c[4], c[5], c[6],            \
             out->x[0]);                                                         \
    }

BATCH(brink_intersection_times)
BATCH(brink_intersection_times_fast)
BATCH(brink_disjoint_times)
BATCH(brink_disjoint_times_fast)

enum path { HERE, ANY, FMA, AVX512 };

static int machine_has(enum path path)
{
#if defined __x86_64__ && defined __GNUC__
    const int fma =
        __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    return path < FMA || (path == FMA && fma) ||
           (path == AVX512 && fma && __builtin_cpu_supports("avx512f") &&
            __builtin_cpu_supports("avx512dq") &&
            __builtin_cpu_supports("avx512vl"));
#else
    return path == HERE;
#endif
}

// --- The table -----------------------------------------------------------------

typedef struct line {
    const char *kernel, *family, *baseline; // methods by name
    double at_most;
    loop *batch;  // in place of a method of that name
    batch *there; // not NULL where the build has it
    enum path path;
} line;

#define CALL(kernel, family, baseline, at_most)                                  \
    {                                                                            \
        kernel, family, baseline, at_most, NULL, NULL, HERE                      \
    }
#define CALLS(name, label, family, baseline, at_most, path)                      \
    {                                                                            \
        label, family, baseline, at_most, brink_##name##_loop, brink_##name,     \
            path                                                                 \
    }

#define IN  "intersection/printed"
#define OUT "disjoint/stable"

/** As a family: a line for each there is. */
#define EVERY NULL

#define BATCHES(name, family, baseline, at_most)                                 \
    CALLS(name##_any, #name ", SSE2", family, baseline, 0, ANY),                 \
        CALLS(name##_fma, #name ", AVX2", family, baseline, at_most, FMA),       \
        CALLS(name##_avx512, #name ", AVX-512", family, baseline, at_most,       \
              AVX512)

static const line lines[] = {
    CALL("quadratic_roots", "benign", "quadratic/textbook", 1.1),
    CALL("quadratic_roots_cr", "benign", "quadratic/textbook", 2.5),
    CALL("quadratic_roots", "scaled", "quadratic/goualard", 1),
    CALL("quadratic_roots", "wild", "quadratic/goualard", 1),
    CALL("quadratic_roots", "subnormal", "quadratic/goualard", 1),
    CALL("quadratic_roots", "huge", "quadratic/goualard", 1),
    CALL("ball_overlap_sign", "dilute", "ball/sign", 1.3),
    CALL("ball_overlap_rate_sign", "dilute", "rate/sign", 1.1),
    CALL("intersection_time_fast", EVERY, IN, 1.25),
    CALL("intersection_time", "dilute", IN, 1.5),
    CALL("intersection_time", "neighbours", IN, 1.8),
    CALL("intersection_time", "contact", IN, 2.7),
    CALL("intersection_time", "hits", IN, 0),
    CALL("intersection_time", "grazing", IN, 0),
    CALL("intersection_time_cr", "dilute", IN, 6),
    CALL("intersection_time_cr", "hits", IN, 10),
    CALL("intersection_time_cr", "neighbours", IN, 10),
    CALL("intersection_time_cr", "contact", IN, 10),
    BATCHES(intersection_times, "dilute", IN, 0.7),
    BATCHES(intersection_times, "neighbours", IN, 0),
    BATCHES(intersection_times_fast, "dilute", IN, 0.7),
    CALL("disjoint_time_fast", EVERY, OUT, 1.25),
    CALL("disjoint_time", "dilute", OUT, 1.5),
    CALL("disjoint_time", "captured", OUT, 1.8),
    CALL("disjoint_time", "neighbours", OUT, 1.8),
    CALL("disjoint_time", "contact", OUT, 2.7),
    CALL("disjoint_time_cr", "dilute", OUT, 6),
    CALL("disjoint_time_cr", "captured", OUT, 10),
    CALL("disjoint_time_cr", "neighbours", OUT, 10),
    CALL("disjoint_time_cr", "contact", OUT, 10),
    BATCHES(disjoint_times, "dilute", OUT, 0.7),
    BATCHES(disjoint_times, "captured", OUT, 0),
    BATCHES(disjoint_times, "neighbours", OUT, 0),
    BATCHES(disjoint_times_fast, "dilute", OUT, 0.7),
    BATCHES(disjoint_times_fast, "captured", OUT, 0),
    BATCHES(disjoint_times_fast, "neighbours", OUT, 0),
};

enum { LINES = sizeof lines / sizeof *lines };

static const method *method_named(const char *name, const problem **p)
{
    int k;
    *p = problem_of(name, &k);
    return &(*p)->method[k];
}

/** How many lines of what is written this one makes. */
static int lines_of(const line *l)
{
    const problem *p;
    method_named(l->baseline, &p);
    return l->family == EVERY ? p->families : 1;
}

int bench_speed_lines(void)
{
    int count = 0;
    for (int k = 0; k < LINES; k++)
        count += lines_of(&lines[k]);
    return count;
}

/** A line of what is written: the table's that makes it; its family. */
static const line *line_at(int which, int *family)
{
    const line *l = lines;
    for (; which >= lines_of(l); l++)
        which -= lines_of(l);
    const problem *p;
    method_named(l->baseline, &p);
    *family = l->family == EVERY ? which : problem_family(p, l->family);
    return l;
}

const char *bench_speed_kernel(int which)
{
    int family;
    return line_at(which, &family)->kernel;
}

const char *const speed_words[] = {[SPEED_NOT_HERE] = "not here",
                                   [SPEED_NOT_ASKED] = " ",
                                   [SPEED_KEPT] = "kept",
                                   [SPEED_OVER] = "over"};

static enum speed_verdict verdict_of(const speed *s)
{
    if (s->at_most == 0)
        return SPEED_NOT_ASKED;
    return s->ratio > s->at_most ? SPEED_OVER : SPEED_KEPT;
}

int bench_speed_measure(int which, uint64_t seed, double seconds, speed *s)
{
    int family;
    const line *l = line_at(which, &family);
    const problem *p;
    const method *baseline = method_named(l->baseline, &p);
    *s = (speed){l->kernel, p->family(family), baseline->label, 0,
                 0,         l->at_most,        SPEED_NOT_HERE};
    if (l->batch != NULL && (l->there == NULL || !machine_has(l->path)))
        return 0;
    loop *const subject =
        l->batch != NULL ? l->batch : method_named(l->kernel, &p)->loop;
    loop *const loops[] = {baseline->loop, subject};
    inputs *in = inputs_make(p, family, COST_INPUTS, seed);
    answers *out = answers_make(COST_INPUTS);
    double ns[2];
    const int failed = in == NULL || out == NULL ||
                       cost_compare(2, loops, in, out, seconds, ns) != 0;
    if (!failed) {
        s->ns = ns[1];
        s->ratio = ns[1] / ns[0];
        s->verdict = verdict_of(s);
    }
    answers_free(out);
    inputs_free(in);
    return failed ? -1 : 0;
}
