// SPDX-License-Identifier: MIT
/**
 * The functions that change the calendar, each by a step of calendar_steps_wp.h;
 * proved in calendar_lists_wp.c.
 */

/*@ requires is_calendar(c) && slot < c->slots;
  @ requires is_indexed(c, -1) && c->filed[slot].place >= 0x80000000;
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap_count, c->heap[0 .. c->slots - 1];
  @ assigns c->filed[0 .. c->slots - 1].place;
  @ ensures whole: is_calendar(c);
  @ ensures times: same_times(view_of{Pre}(c), view_of{Post}(c), -1);
  @ ensures numbers: same_numbers{Pre, Post}(c);
  @ ensures firsts: same_firsts{Pre, Post}(c);
  @ ensures nexts: same_nexts{Pre, Post}(c);
  @ ensures previous: same_previous{Pre, Post}(c);
  @ ensures count: c->heap_count == \old(c->heap_count) + 1;
  @ ensures index: is_indexed(c, -1);
  @ ensures put: in_heap(c, -1, slot);
  @ ensures none_lost: none_lost{Pre, Post}(c, -1, -1, slot);
  @*/
static void heap_add(brink_calendar *c, uint32_t slot);

/*@ requires is_calendar(c) && slot < c->slots;
  @ requires is_indexed(c, -1) && in_heap(c, -1, slot);
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap_count, c->heap[0 .. c->slots - 1];
  @ assigns c->filed[0 .. c->slots - 1].place;
  @ ensures whole: is_calendar(c);
  @ ensures times: same_times(view_of{Pre}(c), view_of{Post}(c), -1);
  @ ensures numbers: same_numbers{Pre, Post}(c);
  @ ensures firsts: same_firsts{Pre, Post}(c);
  @ ensures nexts: same_nexts{Pre, Post}(c);
  @ ensures previous: same_previous{Pre, Post}(c);
  @ ensures count: c->heap_count == \old(c->heap_count) - 1;
  @ ensures index: is_indexed(c, -1);
  @ ensures out: c->filed[slot].place == 0xFFFFFFFF;
  @ ensures none_lost: none_lost{Pre, Post}(c, -1, -1, slot);
  @*/
static void heap_remove(brink_calendar *c, uint32_t slot);

/*@ requires is_calendar(c) && day < c->days && slot < c->slots;
  @ requires first(view_of(c), day) <= c->slots && first(view_of(c), day) != slot;
  @ terminates \true;
  @ exits \false;
  @ assigns c->first[0 .. c->days - 1], c->filed[0 .. c->slots];
  @ ensures whole: is_calendar(c);
  @ ensures size: same_size(view_of{Pre}(c), view_of{Post}(c));
  @ ensures day: same_day(view_of{Pre}(c), view_of{Post}(c));
  @ ensures times: same_times(view_of{Pre}(c), view_of{Post}(c), -1);
  @ ensures heap: same_heap(view_of{Pre}(c), view_of{Post}(c));
  @ ensures place: c->filed[slot].place == 0x80000000 + day;
  @ ensures first: c->first[day] == slot;
  @ ensures before: c->filed[slot].previous == c->slots;
  @ ensures after: c->filed[slot].next == \old(c->first[day]);
  @ ensures and_back: c->filed[\old(c->first[day])].previous == slot;
  @ ensures firsts: same_firsts(view_of{Pre}(c), view_of{Post}(c), day);
  @ ensures places: same_places(view_of{Pre}(c), view_of{Post}(c), slot);
  @ ensures nexts: same_nexts(view_of{Pre}(c), view_of{Post}(c), slot);
  @ ensures previous: same_previous(view_of{Pre}(c), view_of{Post}(c), slot,
  @     \old(c->first[day]));
  @*/
static void list_add(brink_calendar *c, uint32_t day, uint32_t slot);

/*@ requires is_calendar(c) && slot < c->slots;
  @ requires 0 <= filed_at(view_of(c), slot) < c->days;
  @ requires previous(view_of(c), slot) <= c->slots;
  @ requires next(view_of(c), slot) <= c->slots;
  @ terminates \true;
  @ exits \false;
  @ assigns c->first[0 .. c->days - 1], c->filed[0 .. c->slots];
  @ ensures whole: is_calendar(c);
  @ ensures size: same_size(view_of{Pre}(c), view_of{Post}(c));
  @ ensures day: same_day(view_of{Pre}(c), view_of{Post}(c));
  @ ensures times: same_times(view_of{Pre}(c), view_of{Post}(c), -1);
  @ ensures heap: same_heap(view_of{Pre}(c), view_of{Post}(c));
  @ ensures out: c->filed[slot].place == 0xFFFFFFFF;
  @ ensures back: c->filed[\old(c->filed[slot].next)].previous ==
  @     \old(c->filed[slot].previous);
  @ ensures places: same_places(view_of{Pre}(c), view_of{Post}(c), slot);
  @ ensures previous: same_previous(view_of{Pre}(c), view_of{Post}(c),
  @     \old(c->filed[slot].next), -1);
  @ behavior first:
  @     assumes c->filed[slot].previous == c->slots;
  @     ensures on: c->first[\old(c->filed[slot].place) - 0x80000000] ==
  @         \old(c->filed[slot].next);
  @     ensures firsts: same_firsts(view_of{Pre}(c), view_of{Post}(c),
  @         \old(c->filed[slot].place) - 0x80000000);
  @     ensures nexts: same_nexts(view_of{Pre}(c), view_of{Post}(c), -1);
  @ behavior later:
  @     assumes c->filed[slot].previous < c->slots;
  @     ensures on: c->filed[\old(c->filed[slot].previous)].next ==
  @         \old(c->filed[slot].next);
  @     ensures firsts: same_firsts(view_of{Pre}(c), view_of{Post}(c), -1);
  @     ensures nexts: same_nexts(view_of{Pre}(c), view_of{Post}(c),
  @         \old(c->filed[slot].previous));
  @ complete behaviors;
  @ disjoint behaviors;
  @*/
static void list_remove(brink_calendar *c, uint32_t slot);

/*@ requires is_calendar(c) && slot < c->slots && \valid_read(entry);
  @ requires \separated(entry, c, c->entry + (0 .. c->slots - 1),
  @     c->filed + (0 .. c->slots), c->heap + (0 .. c->slots - 1),
  @     c->first + (0 .. c->days - 1));
  @ terminates \true;
  @ exits \false;
  @ assigns c->entry[slot];
  @ ensures whole: is_calendar(c);
  @ ensures size: same_size(view_of{Pre}(c), view_of{Post}(c));
  @ ensures day: same_day(view_of{Pre}(c), view_of{Post}(c));
  @ ensures times: same_times(view_of{Pre}(c), view_of{Post}(c), slot);
  @ ensures heap: same_heap(view_of{Pre}(c), view_of{Post}(c));
  @ ensures lists: same_lists(view_of{Pre}(c), view_of{Post}(c));
  @ ensures places: same_places(view_of{Pre}(c), view_of{Post}(c), -1);
  @ ensures time: is_a_time{Pre}(c, \old(entry->when)) ==>
  @     has_a_time(view_of(c), slot);
  @*/
static void entry_put(brink_calendar *c, uint32_t slot, const brink_entry *entry);

/*@ requires is_calendar(c);
  @ terminates \true;
  @ exits \false;
  @ assigns c->epoch, c->today;
  @ ensures whole: is_calendar(c);
  @ ensures c->epoch == epoch && c->today == today;
  @ ensures size: same_size(view_of{Pre}(c), view_of{Post}(c));
  @ ensures times: same_times(view_of{Pre}(c), view_of{Post}(c), -1);
  @ ensures heap: same_heap(view_of{Pre}(c), view_of{Post}(c));
  @ ensures lists: same_lists(view_of{Pre}(c), view_of{Post}(c));
  @ ensures places: same_places(view_of{Pre}(c), view_of{Post}(c), -1);
  @*/
static void turn_to(brink_calendar *c, int64_t epoch, uint32_t today);
