// SPDX-License-Identifier: MIT
#include "conventional_method.h"
#include <brink/event_time.h>
#include <brink/overlap.h>
#include <math.h>

// With three cells on an axis particles can drift past half the box from one
// another.
void brink_separation_now(const brink_run *run, uint32_t i, uint32_t j,
                          double r[3])
{
    const brink_system *s = &run->system;
    brink_system_separation(s, i, j, run->now.offset, r);
    for (int a = 0; a < 3; a++)
        r[a] -= s->length[a] * rint(r[a] / s->length[a]);
}

double brink_largest_step(const brink_system *s)
{
    double largest = 0;
    for (int p = 0; p < s->species_count * s->species_count; p++)
        for (int k = 0; k < s->potential[p].count; k++)
            if (!isinf(s->potential[p].energy[k]))
                largest = fmax(largest, fabs(s->potential[p].energy[k]));
    return largest > 0 ? largest : (double)INFINITY;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

int brink_level_by_position(const brink_potential *p, const double r[3])
{
    if (dot(r, r) >
        2 * p->distance[0] * p->distance[0]) // no rounding is as large
        return 0;
    const int seen = brink_step_level_at(p, r),
              most = brink_potential_levels(p) - 1;
    return seen < most ? seen : most;
}

// a t^2 + 2 b t + c is r.r - sigma^2 after the time t.
typedef struct quadratic {
    double a, b, c, arg;
} quadratic;

static quadratic quadratic_of(const double r[3], const double v[3], double sigma)
{
    const double a = dot(v, v), b = dot(r, v), c = dot(r, r) - sigma * sigma;
    return (quadratic){a, b, c, b * b - a * c};
}

double brink_intersection_time_as_printed(const double r[3], const double v[3],
                                          double sigma)
{
    const quadratic q = quadratic_of(r, v, sigma);
    if (q.b >= 0 || q.arg <= 0)
        return (double)INFINITY;
    return fmax(0, q.c / (sqrt(q.arg) - q.b));
}

// The later root, in the one form or the other.
static double disjoint_time(const quadratic *q, int by_quotient)
{
    if (q->a == 0)
        return (double)INFINITY;
    if (q->arg <= 0)
        return fmax(0, -q->b / q->a);
    return fmax(0, by_quotient ? -q->c / (sqrt(q->arg) + q->b)
                               : (sqrt(q->arg) - q->b) / q->a);
}

double brink_disjoint_time_put_right(const double r[3], const double v[3],
                                     double sigma)
{
    const quadratic q = quadratic_of(r, v, sigma);
    return disjoint_time(&q, q.b > 0);
}

double brink_disjoint_time_as_printed(const double r[3], const double v[3],
                                      double sigma)
{
    const quadratic q = quadratic_of(r, v, sigma);
    return disjoint_time(&q, !(q.b > 0));
}

static int level_of_state(const brink_run *house, uint32_t i, uint32_t j,
                          const double r[3])
{
    (void)r;
    return brink_states_level(&house->states, i, j);
}

static int level_of_position(const brink_run *house, uint32_t i, uint32_t j,
                             const double r[3])
{
    return brink_level_by_position(brink_system_potential(&house->system, i, j),
                                   r);
}

static int inside_by_state(const brink_run *house, const brink_meeting *m)
{
    return brink_states_level(&house->states, m->i, m->j) > m->step;
}

static int inside_by_position(const brink_run *house, const brink_meeting *m)
{
    (void)house;
    return brink_level_by_position(m->potential, m->r) > m->step;
}

static int inside_as_seen(const brink_run *house, const brink_meeting *m)
{
    (void)house;
    return m->seen_inside;
}

static int inside_by_motion(const brink_run *house, const brink_meeting *m)
{
    (void)house;
    return brink_ball_overlap_rate_sign(m->r, m->v) > 0;
}

// The disjoint time of all but the last is the kernel's, right to its last bits,
// as is every intersection time: what goes wrong in those is the state's doing.
static const brink_rule rules[BRINK_METHODS] = {
    [BRINK_METHOD_LOGICAL] = {.name = "logical states",
                              .idea = "The state of a pair is kept as "
                                      "information of its own and changed by "
                                      "executed events alone.",
                              .level = level_of_state,
                              .disjoint_time = brink_disjoint_time,
                              .is_inside = inside_by_state},
    [BRINK_METHOD_POSITION] =
        {.name = "state from position",
         .idea = "The basic algorithm: whenever an event is looked for or "
                 "executed, the "
                 "distance of the pair says which side of a step it is on.",
         .level = level_of_position,
         .disjoint_time = brink_disjoint_time,
         .is_inside = inside_by_position},
    [BRINK_METHOD_STORED] =
        {.name = "stored separation",
         .idea =
             "Alder and Wainwright's: the distance when the event was looked for "
             "decides, and is remembered until the event is executed.",
         .level = level_of_position,
         .disjoint_time = brink_disjoint_time,
         .is_inside = inside_as_seen},
    [BRINK_METHOD_NUDGED_TIME] =
        {.name = "nudged time",
         .idea = "As before, and a transfer is executed a little late and a "
                 "reflection a "
                 "little early, so that the pair is clearly on its new side.",
         .level = level_of_position,
         .disjoint_time = brink_disjoint_time,
         .time_nudge = BRINK_TIME_NUDGE,
         .is_inside = inside_as_seen},
    [BRINK_METHOD_NUDGED_PLACE] =
        {.name = "nudged position",
         .idea =
             "The side a pair comes from is told by its motion, and after the "
             "event "
             "both particles are moved a little, to the side they are to be on.",
         .level = level_of_position,
         .disjoint_time = brink_disjoint_time,
         .is_inside = inside_by_motion,
         .place_nudge = BRINK_PLACE_NUDGE},
    [BRINK_METHOD_PRINTED] =
        {.name = "algorithm 2 as printed",
         .idea =
             "Logical states, but the time at which a captured pair gets to the "
             "rim "
             "is computed as the paper prints it, its two branches exchanged.",
         .level = level_of_state,
         .disjoint_time = brink_disjoint_time_as_printed,
         .is_inside = inside_by_state},
};

const brink_rule *brink_method_rule(enum brink_method method)
{
    return &rules[method];
}
