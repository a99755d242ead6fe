// SPDX-License-Identifier: MIT
// with: -wp-fct take_out,file_under,brink_calendar_set,open_today,earliest_epoch
// with: -wp-fct turn_year,brink_calendar_next -wp-split
/**
 * The calendar as a whole, as compiled: whatever is set, and whatever is asked
 * for next, each slot is where the time of its entry says, and what
 * calendar_state_wp.h keeps is kept; every loop ends.
 */
#include "calendar_memory_wp.h"

#include "calendar_seen_wp.h"

#include "calendar_told_wp.h"

// --- Steps, for those who need no more than what follows of them ---------------

/*@ axiomatic Steps {
  @   predicate same_times(view a, view b, integer but);
  @   predicate same_heap(view a, view b);
  @   predicate same_firsts(view a, view b, integer but);
  @   predicate same_places(view a, view b, integer but);
  @   predicate same_nexts(view a, view b, integer but);
  @   predicate same_previous(view a, view b, integer x, integer y);
  @   predicate same_lists(view a, view b);
  @   predicate is_indexed(view v);
  @   predicate in_heap(view v, integer slot);
  @   predicate none_lost(view a, view b, integer but);
  @   predicate is_out(view a, view b, integer slot);
  @   predicate is_in(view a, view b, integer slot);
  @   predicate are_all_filed(view v);
  @ }
  @ axiomatic Places {
  @   predicate is_indexed{L}(brink_calendar *c, integer hole)
  @     reads *c, c->heap[..], c->filed[..];
  @   predicate in_heap{L}(brink_calendar *c, integer hole, integer slot)
  @     reads *c, c->heap[..], c->filed[..];
  @   predicate none_lost{A, B}(brink_calendar *c, integer before, integer hole,
  @                             integer but)
  @     reads \at(*c, A), \at(c->heap[..], A), \at(c->filed[..], A),
  @         \at(*c, B), \at(c->heap[..], B), \at(c->filed[..], B);
  @   predicate same_size{A, B}(brink_calendar *c) reads \at(*c, A), \at(*c, B);
  @   predicate same_day{A, B}(brink_calendar *c) reads \at(*c, A), \at(*c, B);
  @   predicate same_entries{A, B}(brink_calendar *c, integer but)
  @     reads \at(*c, A), \at(c->entry[..], A), \at(*c, B), \at(c->entry[..], B);
  @   predicate same_heap{A, B}(brink_calendar *c)
  @     reads \at(*c, A), \at(c->heap[..], A), \at(*c, B), \at(c->heap[..], B);
  @   predicate same_firsts{A, B}(brink_calendar *c, integer but)
  @     reads \at(*c, A), \at(c->first[..], A), \at(*c, B), \at(c->first[..], B);
  @   predicate same_places{A, B}(brink_calendar *c, integer but)
  @     reads \at(*c, A), \at(c->filed[..], A), \at(*c, B), \at(c->filed[..], B);
  @   predicate same_nexts{A, B}(brink_calendar *c, integer but)
  @     reads \at(*c, A), \at(c->filed[..], A), \at(*c, B), \at(c->filed[..], B);
  @   predicate same_previous{A, B}(brink_calendar *c, integer x, integer y)
  @     reads \at(*c, A), \at(c->filed[..], A), \at(*c, B), \at(c->filed[..], B);
  @ }
  @ predicate a_hole_moved{Old, New}(brink_calendar *c, integer before,
  @                                  integer hole, integer slot) = \true;
  @*/

#include "calendar_steps_wp.h"

#include "calendar_calls_wp.h"

#include "calendar_keeps_wp.h"

#include "calendar_bridge_wp.h"

#include "calendar_ghosts_wp.h"

#include "calendar_unordered_wp.h"

/*@ requires is_calendar(c) && is_sound(view_of(c)) && slot < c->slots;
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap_count, c->heap[0 .. c->slots - 1];
  @ assigns c->first[0 .. c->days - 1], c->filed[0 .. c->slots];
  @ ensures whole: is_calendar(c);
  @ ensures size: c->slots == \old(c->slots) && c->days == \old(c->days);
  @ ensures today: c->today == \old(c->today);
  @ ensures count: \old(filed_at(view_of(c), slot)) >= 0 ==>
  @     c->heap_count == \old(c->heap_count);
  @ ensures out: is_out(view_of{Pre}(c), view_of{Post}(c), slot);
  @ ensures sound: is_out(view_of{Pre}(c), view_of{Post}(c), slot) ==>
  @     is_sound(view_of(c));
  @*/
static void take_out(brink_calendar *c, uint32_t slot);

// Trusted: what the product is, as a whole number.
/*@ requires is_calendar(c);
  @ requires 0 <= offset && in_days(c->days_a_time, offset) < c->days;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result < c->days;
  @ ensures \result == day_at(c->days_a_time, offset);
  @*/
static uint32_t day_of(const brink_calendar *c, double offset);

/*@ requires is_calendar(c) && is_sound(view_of(c)) && is_dated(view_of(c));
  @ requires slot < c->slots && filed_at(view_of(c), slot) == -2;
  @ requires has_a_time(view_of(c), slot);
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap_count, c->heap[0 .. c->slots - 1];
  @ assigns c->first[0 .. c->days - 1], c->filed[0 .. c->slots];
  @ ensures whole: is_calendar(c);
  @ ensures size: c->slots == \old(c->slots) && c->days == \old(c->days);
  @ ensures today: c->today == \old(c->today);
  @ ensures first: first(view_of(c), c->today) == c->first[c->today];
  @ ensures count: \old(filed_for(view_of(c), slot)) == -1 ==>
  @     c->heap_count == \old(c->heap_count) + 1;
  @ ensures in: is_in(view_of{Pre}(c), view_of{Post}(c), slot);
  @ ensures sound: is_in(view_of{Pre}(c), view_of{Post}(c), slot) ==>
  @     is_sound(view_of(c));
  @*/
static void file_under(brink_calendar *c, uint32_t slot);

/*@ requires is_calendar(c) && are_filed(view_of(c), 0, 0);
  @ requires slot < c->slots && \valid_read(entry);
  @ requires \base_addr(entry) != \base_addr(c) &&
  @     \base_addr(entry) != \base_addr(c->entry) &&
  @     \base_addr(entry) != \base_addr(c->filed) &&
  @     \base_addr(entry) != \base_addr(c->heap) &&
  @     \base_addr(entry) != \base_addr(c->first);
  @ requires is_a_time(c, entry->when);
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap_count, c->heap[0 .. c->slots - 1], c->entry[slot];
  @ assigns c->first[0 .. c->days - 1], c->filed[0 .. c->slots];
  @ ensures whole: is_calendar(c);
  @ ensures kept: are_filed(view_of(c), 0, 0);
  @*/
void brink_calendar_set(brink_calendar *c, uint32_t slot,
                        const brink_entry *entry);

/*@ requires is_calendar(c) && are_filed_but_for(view_of(c), c->today);
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap_count, c->heap[0 .. c->slots - 1];
  @ assigns c->first[0 .. c->days - 1], c->filed[0 .. c->slots];
  @ ensures whole: is_calendar(c);
  @ ensures today: c->today == \old(c->today);
  @ ensures size: c->slots == \old(c->slots) && c->days == \old(c->days);
  @ ensures kept: are_filed(view_of(c), 0, 0);
  @*/
static void open_today(brink_calendar *c);

/*@ requires is_calendar(c);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures is_earliest_epoch(view_of(c), \result, c->slots);
  @*/
static int64_t earliest_epoch(const brink_calendar *c);

/*@ requires is_calendar(c) && are_filed(view_of(c), 0, 0);
  @ requires c->heap_count == 0 && c->today == c->days - 1;
  @ terminates \true;
  @ exits \false;
  @ assigns c->epoch, c->today, c->heap_count, c->heap[0 .. c->slots - 1];
  @ assigns c->first[0 .. c->days - 1], c->filed[0 .. c->slots];
  @ ensures whole: is_calendar(c);
  @ ensures size: c->slots == \old(c->slots) && c->days == \old(c->days);
  @ ensures kept: are_filed(view_of(c), 0, 0);
  @ ensures later: \result != 0 ==> c->epoch > \old(c->epoch) && c->today == 0;
  @ ensures none: \result == 0 ==> c->heap_count == 0 &&
  @     \forall integer s; 0 <= s < c->slots ==>
  @         c->entry[s].when.epoch == 0x7FFFFFFFFFFFFFFF;
  @*/
static int turn_year(brink_calendar *c);

/*@ requires is_calendar(c) && are_filed(view_of(c), 0, 0);
  @ terminates \true;
  @ exits \false;
  @ assigns c->epoch, c->today, c->heap_count, c->heap[0 .. c->slots - 1];
  @ assigns c->first[0 .. c->days - 1], c->filed[0 .. c->slots];
  @ ensures whole: is_calendar(c);
  @ ensures size: c->slots == \old(c->slots) && c->days == \old(c->days);
  @ ensures kept: are_filed(view_of(c), 0, 0);
  @ ensures first: c->heap_count > 0 ==>
  @     \result < c->slots && \result == at(view_of(c), 0);
  @ ensures due: c->heap_count > 0 ==>
  @     epoch_of(view_of(c), \result) <= c->epoch < 0x7FFFFFFFFFFFFFFF;
  @ ensures none: c->heap_count == 0 ==> \result == c->slots &&
  @     \forall integer s; 0 <= s < c->slots ==>
  @         c->entry[s].when.epoch == 0x7FFFFFFFFFFFFFFF;
  @*/
uint32_t brink_calendar_next(brink_calendar *c);

#include "../sim/calendar.c"
