// SPDX-License-Identifier: MIT
// transcribed: event_time_meeting.g
// transcribed: event_time_sums.v
// with: -wp-fct time_of_meeting,dot_rounded,is_far
// with: -wp-no-parasite -wp-no-filter
/**
 * event_time_*.h, as compiled, is what event_time_meeting.g and
 * event_time_sums.v are about, operation by operation; the script's d is |d|.
 */
#include "link_wp.h"

#include "event_time_meeting_g.h"
#include "event_time_sums_v.h"

/*@ requires \valid_read(x + (0 .. 2)) && \valid_read(y + (0 .. 2));
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures link: bits(\result) == bits(
  @     event_time_sums_v_dot_rounded(x[0], y[0], x[1], y[1], x[2], y[2]));
  @*/
static double dot_rounded(const double x[3], const double y[3]);

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures link: \result == 1 <==> event_time_sums_v_is_far(rr, ss);
  @*/
static int is_far(double rr, double ss);

#include "../kernels/event_time_meeting.h"

/*@ requires \valid_read(m);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures link: bits(\result) ==
  @     bits(event_time_meeting_g_t(m->c, m->b, size_of(m->d).x));
  @*/
static double time_of_meeting(const meeting *m);
