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
  @ ensures entries: same_entries{Pre, Post}(c, -1);
  @ ensures size: same_size{Pre, Post}(c);
  @ ensures day: same_day{Pre, Post}(c);
  @ ensures firsts: same_firsts{Pre, Post}(c, -1);
  @ ensures nexts: same_nexts{Pre, Post}(c, -1);
  @ ensures previous: same_previous{Pre, Post}(c, -1, -1);
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
  @ ensures entries: same_entries{Pre, Post}(c, -1);
  @ ensures size: same_size{Pre, Post}(c);
  @ ensures day: same_day{Pre, Post}(c);
  @ ensures firsts: same_firsts{Pre, Post}(c, -1);
  @ ensures nexts: same_nexts{Pre, Post}(c, -1);
  @ ensures previous: same_previous{Pre, Post}(c, -1, -1);
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
  @ ensures size: same_size{Pre, Post}(c);
  @ ensures day: same_day{Pre, Post}(c);
  @ ensures entries: same_entries{Pre, Post}(c, -1);
  @ ensures heap: same_heap{Pre, Post}(c);
  @ ensures place: c->filed[slot].place == 0x80000000 + day;
  @ ensures first: c->first[day] == slot;
  @ ensures before: c->filed[slot].previous == c->slots;
  @ ensures after: c->filed[slot].next == \old(c->first[day]);
  @ ensures and_back: c->filed[\old(c->first[day])].previous == slot;
  @ ensures firsts: same_firsts{Pre, Post}(c, day);
  @ ensures places: same_places{Pre, Post}(c, slot);
  @ ensures nexts: same_nexts{Pre, Post}(c, slot);
  @ ensures previous: same_previous{Pre, Post}(c, slot, \old(c->first[day]));
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
  @ ensures size: same_size{Pre, Post}(c);
  @ ensures day: same_day{Pre, Post}(c);
  @ ensures entries: same_entries{Pre, Post}(c, -1);
  @ ensures heap: same_heap{Pre, Post}(c);
  @ ensures out: c->filed[slot].place == 0xFFFFFFFF;
  @ ensures back: c->filed[\old(c->filed[slot].next)].previous ==
  @     \old(c->filed[slot].previous);
  @ behavior first:
  @     assumes c->filed[slot].previous == c->slots;
  @     ensures on: c->first[\old(c->filed[slot].place) - 0x80000000] ==
  @         \old(c->filed[slot].next);
  @     ensures firsts: same_firsts{Pre, Post}(c,
  @         \old(c->filed[slot].place) - 0x80000000);
  @     ensures nexts: same_nexts{Pre, Post}(c, -1);
  @     ensures places: same_places{Pre, Post}(c, slot);
  @     ensures previous: same_previous{Pre, Post}(c,
  @         \old(c->filed[slot].next), -1);
  @ behavior later:
  @     assumes c->filed[slot].previous < c->slots;
  @     ensures on: c->filed[\old(c->filed[slot].previous)].next ==
  @         \old(c->filed[slot].next);
  @     ensures firsts: same_firsts{Pre, Post}(c, -1);
  @     ensures nexts: same_nexts{Pre, Post}(c, \old(c->filed[slot].previous));
  @     ensures places: same_places{Pre, Post}(c, slot);
  @     ensures previous: same_previous{Pre, Post}(c,
  @         \old(c->filed[slot].next), -1);
  @ complete behaviors;
  @ disjoint behaviors;
  @*/
static void list_remove(brink_calendar *c, uint32_t slot);

/*@ requires is_calendar(c) && slot < c->slots && \valid_read(entry);
  @ terminates \true;
  @ exits \false;
  @ assigns c->entry[slot];
  @ ensures whole: is_calendar(c);
  @ ensures size: same_size{Pre, Post}(c);
  @ ensures day: same_day{Pre, Post}(c);
  @ ensures entries: same_entries{Pre, Post}(c, slot);
  @ ensures heap: same_heap{Pre, Post}(c);
  @ ensures firsts: same_firsts{Pre, Post}(c, -1);
  @ ensures nexts: same_nexts{Pre, Post}(c, -1);
  @ ensures previous: same_previous{Pre, Post}(c, -1, -1);
  @ ensures places: same_places{Pre, Post}(c, -1);
  @ ensures time: is_a_time{Pre}(c, \old(entry->when)) ==>
  @     is_a_time(c, c->entry[slot].when);
  @*/
static void entry_put(brink_calendar *c, uint32_t slot, const brink_entry *entry);

/*@ requires is_calendar(c);
  @ terminates \true;
  @ exits \false;
  @ assigns c->epoch, c->today;
  @ ensures whole: is_calendar(c);
  @ ensures c->epoch == epoch && c->today == today;
  @ ensures size: same_size{Pre, Post}(c);
  @ ensures entries: same_entries{Pre, Post}(c, -1);
  @ ensures heap: same_heap{Pre, Post}(c);
  @ ensures firsts: same_firsts{Pre, Post}(c, -1);
  @ ensures nexts: same_nexts{Pre, Post}(c, -1);
  @ ensures previous: same_previous{Pre, Post}(c, -1, -1);
  @ ensures places: same_places{Pre, Post}(c, -1);
  @*/
static void turn_to(brink_calendar *c, int64_t epoch, uint32_t today);
