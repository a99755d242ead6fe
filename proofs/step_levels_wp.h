// SPDX-License-Identifier: MIT
/** Levels and what is legal at them: proved by step_wp.c, used by states_wp.c. */
#include "../kernels/step.h"
#include <limits.h>

/*@ // Memory behind a potential, and fewer steps than an int can count levels of.
  @ predicate is_potential(brink_potential *p) =
  @     \valid_read(p) && 1 <= p->count < INT_MAX &&
  @     \valid_read(p->distance + (0 .. p->count - 1)) &&
  @     \valid_read(p->energy + (0 .. p->count - 1));
  @
  @ predicate is_core(brink_potential *p, integer level) =
  @     level == p->count - 1 && \is_infinite(p->energy[level]);
  @ predicate has_inner(brink_potential *p, integer level) =
  @     level < p->count && !is_core(p, level);
  @ // No pair is inside of a core.
  @ predicate is_level(brink_potential *p, integer level) =
  @     0 <= level <= p->count && !(level > 0 && is_core(p, level - 1));
  @
  @ // [S16 fig. 1]
  @ predicate legal(brink_potential *p, integer level, integer event) =
  @     is_level(p, level) &&
  @     ((event == BRINK_CORE && is_core(p, level)) ||
  @      (event == BRINK_CAPTURE && has_inner(p, level)) ||
  @      (event == BRINK_RELEASE && level > 0) ||
  @      (event == BRINK_BOUNCE && (level > 0 || has_inner(p, level))));
  @ logic integer change(integer event) =
  @     event == BRINK_CAPTURE ? 1 : event == BRINK_RELEASE ? -1 : 0;
  @*/

/*@ requires is_potential(p);
  @ requires \valid(next);
  @ requires \separated(next, p);
  @ requires \separated(next, p->energy + (0 .. p->count - 1));
  @ terminates \true;
  @ exits \false;
  @ assigns *next;
  @ ensures total: \result == 0 || \result == 1;
  @ ensures legal_alone: \result == 1 <==> legal(p, level, event);
  @ ensures accepted: \result == 1 ==> *next == level + change(event);
  @ ensures refused: \result == 0 ==> *next == level;
  @ ensures stays_a_level: is_level(p, level) ==> is_level(p, *next);
  @ ensures by_one: -1 <= *next - level <= 1;
  @ ensures transfer_alone: *next != level ==>
  @     event == BRINK_CAPTURE || event == BRINK_RELEASE;
  @*/
int brink_step_next(const brink_potential *p, int level,
                    enum brink_event_kind event, int *next);
