// SPDX-License-Identifier: MIT
// with: -wp-fct heap_put -wp-model Typed+real
/**
 * The one way that the calendar's heap is written, as compiled: a slot is put at
 * a position, and knows it; no other changes, nor does the order.
 */
#include "calendar_wp.h"

#include "calendar_kept_wp.h"

#include "../sim/calendar.c"
