// SPDX-License-Identifier: MIT
#include "step.h"
#include "exact.h"
#include "overlap.h"
#include <stddef.h>

int brink_potential_is_valid(const brink_potential *p)
{
    if (p == NULL || p->count < 1 || p->distance == NULL || p->energy == NULL)
        return 0;
    /*@ loop invariant 0 <= k <= p->count;
      @ loop invariant distances: \forall integer i; 0 <= i < k ==>
      @     \is_finite(p->distance[i]) && p->distance[i] > 0;
      @ loop invariant decreasing: decreases(p->distance, k);
      @ loop invariant and_next: 0 < k < p->count && \is_finite(p->distance[k])
      @     ==> p->distance[k] < p->distance[k - 1];
      @ loop invariant energies: \forall integer i; 0 <= i < k ==>
      @     \is_finite(p->energy[i]) ||
      @     (i == p->count - 1 && \is_plus_infinity(p->energy[i]));
      @ loop assigns k;
      @ loop variant p->count - k; */
    for (int k = 0; k < p->count; k++) {
        int last = k == p->count - 1;
        if (!isfinite(p->distance[k]) || p->distance[k] <= 0)
            return 0;
        if (!last && p->distance[k + 1] >= p->distance[k])
            return 0;
        if (!isfinite(p->energy[k]) && !(last && p->energy[k] > 0))
            return 0;
    }
    return 1;
}

/** Whether there is a step inward from `level` and it is, or is not, a hard core.
 */
static int has_core(const brink_potential *p, int level)
{
    return level == p->count - 1 && isinf(p->energy[level]);
}

static int has_finite_step(const brink_potential *p, int level)
{
    return level < p->count && !has_core(p, level);
}

int brink_potential_levels(const brink_potential *p)
{
    return has_core(p, p->count - 1) ? p->count : p->count + 1;
}

static int is_level(const brink_potential *p, int level)
{
    return level >= 0 && level < brink_potential_levels(p);
}

double brink_potential_energy(const brink_potential *p, int level)
{
    if (level < 0 || level > p->count)
        return (double)NAN;
    return level == 0 ? 0 : p->energy[level - 1];
}

double brink_step_rise(const brink_potential *p, int level,
                       enum brink_direction way)
{
    if (!is_level(p, level))
        return (double)NAN;
    int next = way == BRINK_INWARD ? level + 1 : level - 1;
    return brink_potential_energy(p, next) - brink_potential_energy(p, level);
}

int brink_step_level_at(const brink_potential *p, const double r[3])
{
    int level = 0;
    /*@ loop invariant 0 <= level <= p->count;
      @ loop invariant inside: \forall integer k; 0 <= k < level ==>
      @     overlap_sign(r, p->distance[k]) < 0;
      @ loop assigns level;
      @ loop variant p->count - level; */
    while (level < p->count && brink_ball_overlap_sign(r, p->distance[level]) < 0)
        level++;
    return level;
}

int brink_step_next(const brink_potential *p, int level,
                    enum brink_event_kind event, int *next)
{
    *next = level;
    if (!is_level(p, level))
        return 0;
    switch (event) {
    case BRINK_CORE:
        return has_core(p, level);
    case BRINK_CAPTURE:
        if (!has_finite_step(p, level))
            return 0;
        *next = level + 1;
        return 1;
    case BRINK_RELEASE:
        if (level == 0)
            return 0;
        *next = level - 1;
        return 1;
    case BRINK_BOUNCE: // outward every step is finite, or the pair would not be
                       // inside
        return level > 0 || has_finite_step(p, level);
    }
    return 0; // not a kind of event
}

int brink_side_next(int side, int *next)
{
    int legal = side == 0 || side == 1;
    *next = legal ? 1 - side : side;
    return legal;
}

int brink_cell_next(int cell, int cells, int way, int periodic, int *next)
{
    *next = cell;
    if (cell < 0 || cell >= cells || (way != -1 && way != 1))
        return 0;
    int to = cell + way;
    if (to < 0 || to >= cells) {
        if (!periodic)
            return 0;
        to = way < 0 ? cells - 1 : 0;
    }
    *next = to;
    return 1;
}
