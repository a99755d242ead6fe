// SPDX-License-Identifier: MIT
// with: -wp-fct brink_potential_is_valid,has_core,has_finite_step,is_level
// with: -wp-fct brink_potential_levels,brink_potential_energy,brink_step_rise
// with: -wp-fct brink_step_level_at,brink_step_next,brink_side_next
// with: -wp-fct brink_cell_next,replay,replay_sides,replay_cells
/**
 * The logical state machine, as compiled: every function of kernels/step.c ends,
 * reads and writes nothing it should not, and does what its contract here says.
 *
 * A level changes by one, by a capture or a release alone; what is refused
 * changes nothing.  The functions that replay a log are no part of brink: they
 * say what follows for a log of any length, that
 *
 *     level = start + captures - releases
 *
 * and likewise that a side is the parity of the crossings, and a cell stays one.
 */
#include "step_wp.h"
#include "libm_wp.h"
#include "step_levels_wp.h"

/*@ requires p == \null || \valid_read(p);
  @ requires p != \null && p->count >= 1 && p->distance != \null
  @              && p->energy != \null ==> is_potential(p);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures total: \result == 0 || \result == 1;
  @ ensures is_potential: \result == 1 ==> is_potential(p);
  @ ensures distances: \result == 1 ==>
  @     \forall integer k; 0 <= k < p->count ==>
  @         \is_finite(p->distance[k]) && p->distance[k] > 0;
  @ ensures decreasing: \result == 1 ==> decreases(p->distance, p->count);
  @ ensures energies: \result == 1 ==>
  @     \forall integer k; 0 <= k < p->count ==>
  @         \is_finite(p->energy[k]) ||
  @         (k == p->count - 1 && \is_plus_infinity(p->energy[k]));
  @*/
int brink_potential_is_valid(const brink_potential *p);

/*@ requires is_potential(p);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == 0 || \result == 1;
  @ ensures \result == 1 <==> is_core(p, level);
  @*/
static int has_core(const brink_potential *p, int level);

/*@ requires is_potential(p);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == 0 || \result == 1;
  @ ensures \result == 1 <==> has_inner(p, level);
  @*/
static int has_finite_step(const brink_potential *p, int level);

/*@ requires is_potential(p);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == 0 || \result == 1;
  @ ensures \result == 1 <==> is_level(p, level);
  @*/
static int is_level(const brink_potential *p, int level);

/*@ requires is_potential(p);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures none: level < 0 || level > p->count ==> \is_NaN(\result);
  @ ensures outside: level == 0 ==> \result == 0.0;
  @ ensures inside: 1 <= level <= p->count ==> \result == p->energy[level - 1];
  @*/
double brink_potential_energy(const brink_potential *p, int level);

/*@ requires is_potential(p);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures with_a_core: is_core(p, p->count - 1) ==> \result == p->count;
  @ ensures without: !is_core(p, p->count - 1) ==> \result == p->count + 1;
  @*/
int brink_potential_levels(const brink_potential *p);

/*@ requires is_potential(p);
  @ requires way == BRINK_INWARD || way == BRINK_OUTWARD;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures none: !is_level(p, level) ==> \is_NaN(\result);
  @*/
double brink_step_rise(const brink_potential *p, int level,
                       enum brink_direction way);

/*@ axiomatic Overlap {
  @   logic integer overlap_sign(double *r, double sigma) reads r[0 .. 2];
  @ }
  @*/

/*@ // What kernels/overlap.h promises.
  @ requires \valid_read(r + (0 .. 2));
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == overlap_sign(r, sigma);
  @*/
int brink_ball_overlap_sign(const double r[3], double sigma);

/*@ requires is_potential(p);
  @ requires \valid_read(r + (0 .. 2));
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures in_range: 0 <= \result <= p->count;
  @ ensures inside: \forall integer k; 0 <= k < \result ==>
  @     overlap_sign(r, p->distance[k]) < 0;
  @ ensures and_no_further: \result < p->count ==>
  @     overlap_sign(r, p->distance[\result]) >= 0;
  @*/
int brink_step_level_at(const brink_potential *p, const double r[3]);

/*@ requires \valid(next);
  @ terminates \true;
  @ exits \false;
  @ assigns *next;
  @ ensures total: \result == 0 || \result == 1;
  @ ensures legal_alone: \result == 1 <==> side == 0 || side == 1;
  @ ensures accepted: \result == 1 ==> *next == 1 - side;
  @ ensures refused: \result == 0 ==> *next == side;
  @*/
int brink_side_next(int side, int *next);

/*@ predicate is_cell(integer cell, integer cells) = 0 <= cell < cells;
  @
  @ logic integer round(integer cell, integer cells) =
  @     cell < 0 ? cells - 1 : cell >= cells ? 0 : cell;
  @*/

/*@ requires \valid(next);
  @ terminates \true;
  @ exits \false;
  @ assigns *next;
  @ ensures total: \result == 0 || \result == 1;
  @ ensures legal_alone: \result == 1 <==>
  @     is_cell(cell, cells) && (way == -1 || way == 1) &&
  @     (periodic || is_cell(cell + way, cells));
  @ ensures accepted: \result == 1 ==> *next == round(cell + way, cells);
  @ ensures refused: \result == 0 ==> *next == cell;
  @ ensures stays_a_cell: is_cell(cell, cells) ==> is_cell(*next, cells);
  @*/
int brink_cell_next(int cell, int cells, int way, int periodic, int *next);

#include "../kernels/step.c"

// --- Logs ----------------------------------------------------------------------

/*@ // How many of the first n events are captures, or releases.
  @ logic integer captures(enum brink_event_kind *log, integer n) =
  @     n <= 0 ? 0
  @            : captures(log, n - 1) + (log[n - 1] == BRINK_CAPTURE ? 1 : 0);
  @ logic integer releases(enum brink_event_kind *log, integer n) =
  @     n <= 0 ? 0
  @            : releases(log, n - 1) + (log[n - 1] == BRINK_RELEASE ? 1 : 0);
  @*/

/*@ requires is_potential(p);
  @ requires is_level(p, start);
  @ requires n >= 0 && \valid_read(log + (0 .. n - 1));
  @ requires \valid(end);
  @ requires \separated(end, p, p->energy + (0 .. p->count - 1),
  @                     log + (0 .. n - 1));
  @ terminates \true;
  @ exits \false;
  @ assigns *end;
  @ ensures 0 <= \result <= n;
  @ ensures a_level: is_level(p, *end);
  @ ensures conserved:
  @     *end == start + captures(log, \result) - releases(log, \result);
  @ ensures up_to_what_is_refused:
  @     \result < n ==> !legal(p, *end, log[\result]);
  @*/
int replay(const brink_potential *p, int start, const enum brink_event_kind *log,
           int n, int *end)
{
    *end = start;
    int i = 0, level = start;
    /*@ loop invariant 0 <= i <= n;
      @ loop invariant is_level(p, level);
      @ loop invariant level == start + captures(log, i) - releases(log, i);
      @ loop invariant *end == level;
      @ loop assigns i, level, *end;
      @ loop variant n - i;
      @*/
    while (i < n && brink_step_next(p, level, log[i], end)) {
        level = *end;
        i++;
    }
    return i;
}

/*@ requires side == 0 || side == 1;
  @ requires n >= 0;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures parity: \result == (side + n) % 2;
  @*/
int replay_sides(int side, int n)
{
    /*@ loop invariant 0 <= i <= n;
      @ loop invariant side == (\at(side, Pre) + i) % 2;
      @ loop assigns i, side;
      @ loop variant n - i;
      @*/
    for (int i = 0; i < n; i++) {
        int next;
        brink_side_next(side, &next);
        side = next;
    }
    return side;
}

/*@ requires is_cell(cell, cells);
  @ requires n >= 0 && \valid_read(way + (0 .. n - 1));
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures a_cell: is_cell(\result, cells);
  @*/
int replay_cells(int cell, int cells, const int *way, int n, int periodic)
{
    /*@ loop invariant 0 <= i <= n;
      @ loop invariant is_cell(cell, cells);
      @ loop assigns i, cell;
      @ loop variant n - i;
      @*/
    for (int i = 0; i < n; i++) {
        int next;
        brink_cell_next(cell, cells, way[i], periodic, &next);
        cell = next;
    }
    return cell;
}
