// SPDX-License-Identifier: MIT
// with: -wp-fct brink_instant_compare,brink_entry_compare,earlier -wp-timeout 20
/**
 * Entries are compared, as compiled, by the one order of calendar_order_wp.h, if
 * their offsets are numbers: which of two slots is earlier is the order of the
 * calendar's heap.
 */
#include "calendar_wp.h"

#include "calendar_order_wp.h"

/*@ requires \is_finite(a.offset) && \is_finite(b.offset);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result < 0 <==> instant_before(a, b);
  @ ensures \result > 0 <==> instant_before(b, a);
  @*/
static inline int brink_instant_compare(brink_instant a, brink_instant b);

/*@ requires \valid_read(a) && \valid_read(b);
  @ requires \is_finite(a->when.offset) && \is_finite(b->when.offset);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result < 0 <==> entry_before(a, b);
  @ ensures \result > 0 <==> entry_before(b, a);
  @*/
int brink_entry_compare(const brink_entry *a, const brink_entry *b);

#include "../sim/calendar.c"
