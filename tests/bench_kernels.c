// SPDX-License-Identifier: MIT
/**
 * What each kernel costs beside its baseline: bench_kernels [filter].
 *
 * Every line is a family of inputs and a kernel; the kernel and its baseline take
 * turns in the same process over the same inputs, and the ratio of their shortest
 * times is printed.  On a machine shared with others the minima are what is left
 * of the truth.
 */
#include "baselines.h"
#include "pairs.h"
#include "quadratics.h"
#include <brink/event_time.h>
#include <brink/overlap.h>
#include <brink/quadratic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { INPUTS = 8192 };

/** Seconds a line may take: enough for some moments in which nobody else
 *  disturbs. */
static const double PATIENCE = 0.4;

static pair_case pairs[INPUTS];
static quadratic_case quadratics[INPUTS];
static double
    soa[8][INPUTS + 40]; // the pairs again as a structure of arrays, and answers
static volatile double sink; // so that no answer is optimised away

typedef double pair_time(const double r[3], const double v[3], double sigma);
typedef int pair_sign(const double r[3], double sigma);
typedef int rate_sign(const double r[3], const double v[3]);
typedef int roots(double a, double b, double c, double *x0, double *x1);
typedef void times(size_t n, const double *rx, const double *ry, const double *rz,
                   const double *vx, const double *vy, const double *vz,
                   const double *sigma, double *t);

/** One kernel in the shape of one of the types above. */
typedef struct subject {
    pair_time *time;
    pair_sign *sign;
    rate_sign *rate;
    roots *roots;
    times *times;
} subject;

static void go_through(const subject *k)
{
    double sum = 0, x0 = 0, x1 = 0;
    int count = 0; // apart from the sum: a conversion costs more than a sign
    if (k->time)
        for (int i = 0; i < INPUTS; i++)
            sum += k->time(pairs[i].r, pairs[i].v, pairs[i].sigma);
    if (k->sign)
        for (int i = 0; i < INPUTS; i++)
            count += k->sign(pairs[i].r, pairs[i].sigma);
    if (k->rate)
        for (int i = 0; i < INPUTS; i++)
            count += k->rate(pairs[i].r, pairs[i].v);
    if (k->roots)
        for (int i = 0; i < INPUTS; i++) {
            sum += k->roots(quadratics[i].a, quadratics[i].b, quadratics[i].c,
                            &x0, &x1);
            sum += x0 + x1;
        }
    if (k->times)
        k->times(INPUTS, soa[0], soa[1], soa[2], soa[3], soa[4], soa[5], soa[6],
                 soa[7]);
    sink = sum + count;
}

static double seconds(const subject *k)
{
    struct timespec from, to;
    clock_gettime(CLOCK_MONOTONIC, &from);
    go_through(k);
    clock_gettime(CLOCK_MONOTONIC, &to);
    return (double)(to.tv_sec - from.tv_sec) +
           1e-9 * (double)(to.tv_nsec - from.tv_nsec);
}

static void compare(const char *kernel, const char *family, const subject *k,
                    const subject *baseline, double at_most)
{
    double best = (double)INFINITY, base = (double)INFINITY;
    for (double spent = 0; spent < PATIENCE;) {
        double a = seconds(baseline), b = seconds(k);
        base = fmin(base, a);
        best = fmin(best, b);
        spent += a + b;
    }
    double ratio = best / base;
    printf("%-22s %-12s %7.2f ns %7.2f ns %6.2f %6.2f%s\n", kernel, family,
           1e9 * best / INPUTS, 1e9 * base / INPUTS, ratio, at_most,
           ratio > at_most ? "  over" : "");
    fflush(stdout);
}

static void make_pairs(const char *family)
{
    for (int f = 0; f < PAIR_FAMILIES; f++)
        if (strcmp(family, pair_families[f].name) == 0) {
            stream s = {1};
            for (int i = 0; i < INPUTS; i++) {
                pair_families[f].make(&s, &pairs[i]);
                for (int k = 0; k < 3; k++) {
                    soa[k][i] = pairs[i].r[k];
                    soa[3 + k][i] = pairs[i].v[k];
                }
                soa[6][i] = pairs[i].sigma;
            }
        }
}

static void make_quadratics(const char *family)
{
    for (int f = 0; f < QUADRATIC_FAMILIES; f++)
        if (strcmp(family, quadratic_families[f].name) == 0) {
            stream s = {1};
            for (int i = 0; i < INPUTS; i++)
                quadratic_families[f].make(&s, &quadratics[i]);
        }
}

typedef struct line {
    const char *kernel, *family;
    subject subject, baseline;
    double at_most;
} line;

#define TIME(k)                                                                  \
    {                                                                            \
        .time = k                                                                \
    }
#define ROOTS(k)                                                                 \
    {                                                                            \
        .roots = k                                                               \
    }
#define BATCH(k)                                                                 \
    {                                                                            \
        .times = k                                                               \
    }
#define IN  TIME(baseline_intersection)
#define OUT TIME(baseline_disjoint)

static const line lines[] = {
    {"quadratic", "benign", ROOTS(brink_quadratic_roots),
     ROOTS(baseline_quadratic_textbook), 1.1},
    {"quadratic_cr", "benign", ROOTS(brink_quadratic_roots_cr),
     ROOTS(baseline_quadratic_textbook), 2.5},
    {"quadratic", "scaled", ROOTS(brink_quadratic_roots),
     ROOTS(baseline_quadratic_goualard), 1},
    {"quadratic", "wild", ROOTS(brink_quadratic_roots),
     ROOTS(baseline_quadratic_goualard), 1},
    {"overlap_sign",
     "dilute",
     {.sign = brink_ball_overlap_sign},
     {.sign = baseline_overlap_sign},
     1.3},
    {"overlap_rate_sign",
     "dilute",
     {.rate = brink_ball_overlap_rate_sign},
     {.rate = baseline_overlap_rate_sign},
     1.1},
    {"intersection_fast", "dilute", TIME(brink_intersection_time_fast), IN, 1.25},
    {"intersection_fast", "hits", TIME(brink_intersection_time_fast), IN, 1.25},
    {"intersection_fast", "neighbours", TIME(brink_intersection_time_fast), IN,
     1.25},
    {"intersection_fast", "contact", TIME(brink_intersection_time_fast), IN,
     1.25},
    {"intersection_fast", "grazing", TIME(brink_intersection_time_fast), IN,
     1.25},
    {"intersection", "dilute", TIME(brink_intersection_time), IN, 1.5},
    {"intersection", "hits", TIME(brink_intersection_time), IN, 1.8},
    {"intersection", "neighbours", TIME(brink_intersection_time), IN, 1.8},
    {"intersection", "contact", TIME(brink_intersection_time), IN, 2.7},
    {"intersection", "grazing", TIME(brink_intersection_time), IN, 10},
    {"intersection_cr", "dilute", TIME(brink_intersection_time_cr), IN, 6},
    {"intersection_cr", "hits", TIME(brink_intersection_time_cr), IN, 10},
    {"intersection_cr", "neighbours", TIME(brink_intersection_time_cr), IN, 10},
    {"intersection_cr", "contact", TIME(brink_intersection_time_cr), IN, 10},
    {"intersections", "dilute", BATCH(brink_intersection_times), IN, 0.7},
    {"intersections_fast", "dilute", BATCH(brink_intersection_times_fast), IN,
     0.7},
    {"intersections", "neighbours", BATCH(brink_intersection_times), IN, 1.8},
    {"intersections_fast", "neighbours", BATCH(brink_intersection_times_fast), IN,
     1.25},
    {"disjoint_fast", "dilute", TIME(brink_disjoint_time_fast), OUT, 1.25},
    {"disjoint_fast", "captured", TIME(brink_disjoint_time_fast), OUT, 1.25},
    {"disjoint_fast", "contact", TIME(brink_disjoint_time_fast), OUT, 1.25},
    {"disjoint_fast", "rim", TIME(brink_disjoint_time_fast), OUT, 1.25},
    {"disjoint", "dilute", TIME(brink_disjoint_time), OUT, 1.5},
    {"disjoint", "captured", TIME(brink_disjoint_time), OUT, 1.8},
    {"disjoint", "contact", TIME(brink_disjoint_time), OUT, 2.7},
    {"disjoint_cr", "dilute", TIME(brink_disjoint_time_cr), OUT, 6},
    {"disjoint_cr", "captured", TIME(brink_disjoint_time_cr), OUT, 10},
    {"disjoint_cr", "contact", TIME(brink_disjoint_time_cr), OUT, 10},
    {"disjoints", "dilute", BATCH(brink_disjoint_times), OUT, 0.7},
    {"disjoints_fast", "dilute", BATCH(brink_disjoint_times_fast), OUT, 0.7},
    {"disjoints_fast", "captured", BATCH(brink_disjoint_times_fast), OUT, 0.7},
};

int main(int argc, char **argv)
{
    const char *filter = argc > 1 ? argv[1] : "";
    printf("%-22s %-12s %10s %10s %6s %6s\n", "kernel", "family", "a call",
           "baseline", "ratio", "asked");
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        const line *l = &lines[i];
        if (strstr(l->kernel, filter) == NULL)
            continue;
        make_pairs(l->family);
        make_quadratics(l->family);
        compare(l->kernel, l->family, &l->subject, &l->baseline, l->at_most);
    }
    return EXIT_SUCCESS;
}
