// SPDX-License-Identifier: MIT
// with: -wp-fct heap_put,first_below,heap_settle,heap_add,list_add,list_remove
// with: -wp-fct take_out,file_under,there_is_room
/**
 * What the calendar's functions do to its lists, as compiled, slot by slot.  A
 * slot that is put in a list is its first, one that is taken out is left out by
 * the two beside it, and every other link, place and first is what it was; the
 * heap's moves touch no link at all, and of slots that are not in the heap no
 * place.  That this keeps the lists linked is calendar_links_wp.c.  And a slot is
 * filed where the time of its entry says: in the list of its day, in that of the
 * later years, in the heap or nowhere.
 */
#include "calendar_memory_wp.h"

// --- The heap, but for its order, which is calendar_wp.c's ---------------------

/*@ predicate is_indexed(brink_calendar *c, integer hole) =
  @     \forall integer p; 0 <= p < c->heap_count && p != hole ==>
  @         c->heap[p] < c->slots && c->filed[c->heap[p]].place == p;
  @
  @ predicate in_heap(brink_calendar *c, integer hole, integer slot) =
  @     c->filed[slot].place < c->heap_count && c->filed[slot].place != hole &&
  @     c->heap[c->filed[slot].place] == slot;
  @
  @ predicate has_hole(brink_calendar *c, integer hole, integer slot) =
  @     is_calendar(c) && 0 <= hole < c->heap_count && 0 <= slot < c->slots &&
  @     is_indexed(c, hole) && !in_heap(c, hole, slot);
  @
  @ // No slot is lost, none has come, and no other has another place.
  @ predicate none_lost{Old, New}(brink_calendar *c, integer before,
  @                               integer hole, integer but) =
  @     \forall integer s; 0 <= s < \at(c->slots, Old) && s != but ==>
  @         (in_heap{Old}(c, before, s)
  @             ? in_heap{New}(c, hole, s)
  @             : !in_heap{New}(c, hole, s) &&
  @                   \at(c->filed[s].place, New) == \at(c->filed[s].place, Old));
  @
  @ predicate same_size{Old, New}(brink_calendar *c) =
  @     \at(c->slots, New) == \at(c->slots, Old) &&
  @     \at(c->days, New) == \at(c->days, Old) &&
  @     \at(c->heap_count, New) == \at(c->heap_count, Old);
  @
  @ predicate a_hole_moved{Old, New}(brink_calendar *c, integer before,
  @                                  integer hole, integer slot) =
  @     has_hole{New}(c, hole, slot) &&
  @     \at(c->slots, New) == \at(c->slots, Old) &&
  @     \at(c->heap_count, New) == \at(c->heap_count, Old) &&
  @     none_lost{Old, New}(c, before, hole, -1);
  @
  @ // What heap_settle's loops keep of the order: here nothing.
  @ predicate can_settle(brink_calendar *c, integer position, integer slot) =
  @     \true;
  @ logic integer heap_of(brink_calendar *c) = 0;
  @ predicate is_after_above(integer heap, integer position, integer slot) =
  @     \true;
  @*/

/*@ requires is_calendar(c);
  @ requires a < c->slots && b < c->slots;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == 0 || \result == 1;
  @*/
static int earlier(const brink_calendar *c, uint32_t a, uint32_t b);

/*@ requires is_calendar(c);
  @ requires position < c->slots && slot < c->slots;
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap[position], c->filed[slot].place;
  @ ensures here: c->heap[position] == slot && c->filed[slot].place == position;
  @ ensures whole: is_calendar(c) && c->slots == \old(c->slots) &&
  @                c->heap_count == \old(c->heap_count);
  @ ensures heap: \forall integer p; 0 <= p < c->slots && p != position ==>
  @     c->heap[p] == \old(c->heap[p]);
  @ ensures places: \forall integer s; 0 <= s < c->slots && s != slot ==>
  @     c->filed[s].place == \old(c->filed[s].place);
  @ ensures moves_the_hole: \forall integer from, to_come;
  @     \old(has_hole(c, position, to_come)) && 0 <= from < c->heap_count &&
  @     from != position && \old(c->heap[from]) == slot ==>
  @     a_hole_moved{Pre, Post}(c, position, from, to_come);
  @ ensures fills_the_hole: \old(has_hole(c, position, slot)) ==>
  @     is_indexed(c, -1) && in_heap(c, -1, slot) &&
  @     none_lost{Pre, Post}(c, position, -1, slot);
  @*/
static void heap_put(brink_calendar *c, uint32_t position, uint32_t slot);

/*@ requires is_calendar(c) && is_indexed(c, position);
  @ requires 2 * position + 1 < c->heap_count;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == 2 * position + 1 || \result == 2 * position + 2;
  @ ensures \result < c->heap_count;
  @*/
static uint32_t first_below(const brink_calendar *c, uint32_t position);

/*@ requires has_hole(c, position, slot);
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap[0 .. c->heap_count - 1],
  @         c->filed[0 .. c->slots - 1].place;
  @ ensures whole: is_calendar(c) && same_size{Pre, Post}(c);
  @ ensures index: is_indexed(c, -1);
  @ ensures put_in: in_heap(c, -1, slot);
  @ ensures none_lost: none_lost{Pre, Post}(c, \at(position, Pre), -1, slot);
  @*/
static void heap_settle(brink_calendar *c, uint32_t position, uint32_t slot);

/*@ requires is_calendar(c) && is_indexed(c, -1) && slot < c->slots;
  @ requires c->filed[slot].place >= 0x80000000 && c->heap_count < c->slots;
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap_count, c->heap[0 .. c->slots - 1];
  @ assigns c->filed[0 .. c->slots - 1].place;
  @ ensures whole: is_calendar(c) && c->slots == \old(c->slots);
  @ ensures one_more: c->heap_count == \old(c->heap_count) + 1;
  @ ensures index: is_indexed(c, -1);
  @ ensures put_in: in_heap(c, -1, slot);
  @ ensures none_lost: none_lost{Pre, Post}(c, -1, -1, slot);
  @*/
static void heap_add(brink_calendar *c, uint32_t slot);

// --- What stays as it was ------------------------------------------------------

/*@ predicate same_heap{Old, New}(brink_calendar *c) =
  @     \forall integer p; 0 <= p < \at(c->slots, Old) ==>
  @         \at(c->heap[p], New) == \at(c->heap[p], Old);
  @
  @ predicate same_first{Old, New}(brink_calendar *c, integer but) =
  @     \forall integer d; 0 <= d <= \at(c->days, Old) && d != but ==>
  @         \at(c->first[d], New) == \at(c->first[d], Old);
  @
  @ predicate same_place{Old, New}(brink_calendar *c, integer but) =
  @     \forall integer s; 0 <= s < \at(c->slots, Old) && s != but ==>
  @         \at(c->filed[s].place, New) == \at(c->filed[s].place, Old);
  @
  @ predicate same_next{Old, New}(brink_calendar *c, integer but) =
  @     \forall integer s; 0 <= s < \at(c->slots, Old) && s != but ==>
  @         \at(c->filed[s].next, New) == \at(c->filed[s].next, Old);
  @
  @ predicate same_previous{Old, New}(brink_calendar *c, integer x, integer y) =
  @     \forall integer s; 0 <= s < \at(c->slots, Old) && s != x && s != y ==>
  @         \at(c->filed[s].previous, New) == \at(c->filed[s].previous, Old);
  @*/

// --- The lists -----------------------------------------------------------------

/*@ requires is_calendar(c);
  @ requires list <= c->days && slot < c->slots;
  @ requires c->first[list] <= c->slots && c->first[list] != slot;
  @ terminates \true;
  @ exits \false;
  @ assigns c->first[0 .. c->days], c->filed[0 .. c->slots];
  @ ensures whole: is_calendar(c) && same_size{Pre, Post}(c);
  @ ensures place: c->filed[slot].place == 0x80000000 + list;
  @ ensures first: c->first[list] == slot;
  @ ensures before: c->filed[slot].previous == c->slots;
  @ ensures after: c->filed[slot].next == \old(c->first[list]);
  @ ensures and_back: c->filed[\old(c->first[list])].previous == slot;
  @ ensures heap: same_heap{Pre, Post}(c);
  @ ensures lists: same_first{Pre, Post}(c, list);
  @ ensures places: same_place{Pre, Post}(c, slot);
  @ ensures nexts: same_next{Pre, Post}(c, slot);
  @ ensures previous:
  @     same_previous{Pre, Post}(c, slot, \old(c->first[list]));
  @*/
static void list_add(brink_calendar *c, uint32_t list, uint32_t slot);

/*@ requires is_calendar(c);
  @ requires slot < c->slots && list <= c->days;
  @ requires c->filed[slot].previous <= c->slots;
  @ requires c->filed[slot].next <= c->slots;
  @ terminates \true;
  @ exits \false;
  @ assigns c->first[0 .. c->days], c->filed[0 .. c->slots];
  @ ensures whole: is_calendar(c) && same_size{Pre, Post}(c);
  @ ensures back: c->filed[\old(c->filed[slot].next)].previous ==
  @                   \old(c->filed[slot].previous);
  @ ensures heap: same_heap{Pre, Post}(c);
  @ ensures places: same_place{Pre, Post}(c, -1);
  @ ensures previous:
  @     same_previous{Pre, Post}(c, \old(c->filed[slot].next), -1);
  @ behavior first:
  @     assumes c->filed[slot].previous == c->slots;
  @     ensures on: c->first[list] == \old(c->filed[slot].next);
  @     ensures lists: same_first{Pre, Post}(c, list);
  @     ensures nexts: same_next{Pre, Post}(c, -1);
  @ behavior later:
  @     assumes c->filed[slot].previous < c->slots;
  @     ensures on: c->filed[\old(c->filed[slot].previous)].next ==
  @                     \old(c->filed[slot].next);
  @     ensures lists: same_first{Pre, Post}(c, -1);
  @     ensures nexts: same_next{Pre, Post}(c, \old(c->filed[slot].previous));
  @ complete behaviors;
  @ disjoint behaviors;
  @*/
static void list_remove(brink_calendar *c, uint32_t list, uint32_t slot);

// --- What a slot that is taken out leaves --------------------------------------

/*@ requires is_calendar(c) && is_indexed(c, -1) && slot < c->slots;
  @ terminates \true;
  @ exits \false;
  @ behavior nowhere:
  @     assumes c->filed[slot].place == 0xFFFFFFFF;
  @     assigns \nothing;
  @ behavior heap:
  @     assumes c->filed[slot].place < 0x80000000;
  @     requires in_heap(c, -1, slot);
  @     assigns c->heap_count, c->heap[0 .. c->slots - 1];
  @     assigns c->filed[0 .. c->slots - 1].place;
  @     ensures whole: is_calendar(c);
  @     ensures out: c->filed[slot].place == 0xFFFFFFFF;
  @     ensures one_less: c->heap_count == \old(c->heap_count) - 1;
  @     ensures index: is_indexed(c, -1);
  @     ensures none_lost: none_lost{Pre, Post}(c, -1, -1, slot);
  @ behavior list:
  @     assumes 0x80000000 <= c->filed[slot].place < 0xFFFFFFFF;
  @     requires c->filed[slot].place <= 0x80000000 + c->days;
  @     requires c->filed[slot].previous <= c->slots;
  @     requires c->filed[slot].next <= c->slots;
  @     assigns c->first[0 .. c->days], c->filed[0 .. c->slots];
  @     ensures whole: is_calendar(c) && same_size{Pre, Post}(c);
  @     ensures out: c->filed[slot].place == 0xFFFFFFFF;
  @     ensures heap: same_heap{Pre, Post}(c);
  @     ensures places: same_place{Pre, Post}(c, slot);
  @     ensures index: is_indexed(c, -1);
  @     ensures back: c->filed[\old(c->filed[slot].next)].previous ==
  @                       \old(c->filed[slot].previous);
  @     ensures previous:
  @         same_previous{Pre, Post}(c, \old(c->filed[slot].next), -1);
  @ behavior first:
  @     assumes 0x80000000 <= c->filed[slot].place < 0xFFFFFFFF;
  @     assumes c->filed[slot].previous == c->slots;
  @     ensures on: c->first[\old(c->filed[slot].place) - 0x80000000] ==
  @                     \old(c->filed[slot].next);
  @     ensures lists:
  @         same_first{Pre, Post}(c, \old(c->filed[slot].place) - 0x80000000);
  @     ensures nexts: same_next{Pre, Post}(c, -1);
  @ behavior later:
  @     assumes 0x80000000 <= c->filed[slot].place < 0xFFFFFFFF;
  @     assumes c->filed[slot].previous < c->slots;
  @     ensures on: c->filed[\old(c->filed[slot].previous)].next ==
  @                     \old(c->filed[slot].next);
  @     ensures lists: same_first{Pre, Post}(c, -1);
  @     ensures nexts: same_next{Pre, Post}(c, \old(c->filed[slot].previous));
  @ complete behaviors nowhere, heap, list;
  @ disjoint behaviors nowhere, heap, list;
  @*/
static void take_out(brink_calendar *c, uint32_t slot);

// --- Where the time of its entry files a slot ----------------------------------

/*@ axiomatic Day {
  @     logic integer day_at(double days_a_time, double offset);
  @ }
  @
  @ // The list of a slot's day, or of the later years; -1: due today, or before.
  @ logic integer list_for(brink_calendar *c, integer slot) =
  @     c->entry[slot].when.epoch > c->epoch ? c->days
  @     : c->entry[slot].when.epoch == c->epoch &&
  @           day_at(c->days_a_time, c->entry[slot].when.offset) > c->today
  @         ? day_at(c->days_a_time, c->entry[slot].when.offset) : -1;
  @ predicate is_in_year(brink_calendar *c, double offset) =
  @     0 <= offset && offset * c->days_a_time < c->days;
  @ predicate waits(brink_calendar *c, integer slot) =
  @     c->entry[slot].when.epoch != 0x7FFFFFFFFFFFFFFF;
  @*/

// Trusted.
/*@ requires is_calendar(c) && is_in_year(c, offset);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result < c->days;
  @ ensures \result == day_at(c->days_a_time, offset);
  @*/
static uint32_t day_of(const brink_calendar *c, double offset);

/*@ requires is_calendar(c) && is_indexed(c, -1) && slot < c->slots;
  @ requires c->filed[slot].place == 0xFFFFFFFF && c->heap_count < c->slots;
  @ requires waits(c, slot) ==> is_in_year(c, c->entry[slot].when.offset);
  @ requires \forall integer d; 0 <= d <= c->days ==>
  @     c->first[d] <= c->slots && c->first[d] != slot;
  @ terminates \true;
  @ exits \false;
  @ behavior never:
  @     assumes !waits(c, slot);
  @     assigns \nothing;
  @ behavior list:
  @     assumes waits(c, slot) && list_for(c, slot) >= 0;
  @     assigns c->first[0 .. c->days], c->filed[0 .. c->slots];
  @     ensures whole: is_calendar(c) && same_size{Pre, Post}(c);
  @     ensures place: c->filed[slot].place ==
  @                       0x80000000 + \old(list_for(c, slot));
  @     ensures first: c->first[\old(list_for(c, slot))] == slot;
  @     ensures before: c->filed[slot].previous == c->slots;
  @     ensures after:
  @         c->filed[slot].next == \old(c->first[list_for(c, slot)]);
  @     ensures and_back:
  @         c->filed[\old(c->first[list_for(c, slot)])].previous == slot;
  @     ensures heap: same_heap{Pre, Post}(c);
  @     ensures lists: same_first{Pre, Post}(c, \old(list_for(c, slot)));
  @     ensures places: same_place{Pre, Post}(c, slot);
  @     ensures nexts: same_next{Pre, Post}(c, slot);
  @     ensures previous: same_previous{Pre, Post}(
  @         c, slot, \old(c->first[list_for(c, slot)]));
  @ behavior heap:
  @     assumes waits(c, slot) && list_for(c, slot) < 0;
  @     assigns c->heap_count, c->heap[0 .. c->slots - 1];
  @     assigns c->filed[0 .. c->slots - 1].place;
  @     ensures whole: is_calendar(c);
  @     ensures one_more: c->heap_count == \old(c->heap_count) + 1;
  @     ensures index: is_indexed(c, -1);
  @     ensures put_in: in_heap(c, -1, slot);
  @     ensures none_lost: none_lost{Pre, Post}(c, -1, -1, slot);
  @ complete behaviors;
  @ disjoint behaviors;
  @*/
static void file_under(brink_calendar *c, uint32_t slot);

// --- A heap that a slot is not in has room for it ------------------------------

// Counted: as many of all slots are in the heap as it has positions.

/*@ logic integer in_heap_below(brink_calendar *c, integer count, integer n) =
  @     n <= 0 ? 0
  @     : in_heap_below(c, count, n - 1) +
  @           (c->filed[n - 1].place < count &&
  @            c->heap[c->filed[n - 1].place] == n - 1 ? 1 : 0);
  @*/

/*@ ghost
  @ /@ requires is_calendar(c) && is_indexed(c, -1);
  @    requires slot < c->slots && c->filed[slot].place >= c->heap_count;
  @    terminates \true;
  @    exits \false;
  @    assigns \nothing;
  @    ensures c->heap_count < c->slots;
  @ @/
  @ void there_is_room(brink_calendar *c, uint32_t slot)
  @ {
  @     uint32_t n = 0, count = 0;
  @     /@ loop invariant n <= c->slots && in_heap_below(c, 0, n) == 0;
  @        loop assigns n;
  @        loop variant c->slots - n;
  @     @/
  @     while (n < c->slots)
  @         n++;
  @     /@ loop invariant count <= c->heap_count;
  @        loop invariant in_heap_below(c, count, c->slots) == count;
  @        loop assigns n, count;
  @        loop variant c->heap_count - count;
  @     @/
  @     while (count < c->heap_count) {
  @         n = 0;
  @         /@ loop invariant n <= c->slots;
  @            loop invariant in_heap_below(c, count + 1, n) ==
  @                in_heap_below(c, count, n) + (c->heap[count] < n ? 1 : 0);
  @            loop assigns n;
  @            loop variant c->slots - n;
  @         @/
  @         while (n < c->slots)
  @             n++;
  @         count++;
  @     }
  @     n = 0;
  @     /@ loop invariant n <= c->slots;
  @        loop invariant in_heap_below(c, c->heap_count, n) <=
  @            n - (slot < n ? 1 : 0);
  @        loop assigns n;
  @        loop variant c->slots - n;
  @     @/
  @     while (n < c->slots)
  @         n++;
  @ }
  @*/

#include "../sim/calendar.c"
