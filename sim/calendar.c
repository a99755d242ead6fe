// SPDX-License-Identifier: MIT
#include "calendar.h"
#include "array.h"
#include <stdlib.h>
#include <string.h>

// A slot's place: NONE, a position in the heap, or IN_LIST + the number of the
// list. Heap positions stay below IN_LIST because slots do.
#define NONE    UINT32_MAX
#define IN_LIST UINT32_C(0x80000000)

int brink_calendar_create(brink_calendar *c, uint32_t slots, double year,
                          uint32_t days)
{
    memset(c, 0, sizeof *c);
    c->slots = slots;
    c->days = 1;
    while (c->days < days && c->days < UINT32_C(1) << 30)
        c->days *= 2;
    c->days_a_time = c->days / year; // powers of two: exact
    c->entry = brink_array_create(slots, sizeof *c->entry);
    c->filed = brink_array_create((size_t)slots + 1, sizeof *c->filed);
    c->heap = brink_array_create(slots, sizeof *c->heap);
    c->first = brink_array_create((size_t)c->days + 1, sizeof *c->first);
    if (!c->entry || !c->filed || !c->heap || !c->first) {
        brink_calendar_destroy(c);
        return -1;
    }
    for (uint32_t slot = 0; slot <= slots; slot++)
        c->filed[slot] = (brink_filed){NONE, slots, slots};
    for (uint32_t day = 0; day <= c->days; day++)
        c->first[day] = slots;
    for (uint32_t slot = 0; slot < slots; slot++)
        c->entry[slot] = (brink_entry){.when = BRINK_NEVER};
    return 0;
}

void brink_calendar_destroy(brink_calendar *c)
{
    free(c->entry);
    free(c->filed);
    free(c->heap);
    free(c->first);
    memset(c, 0, sizeof *c);
}

int brink_entry_compare(const brink_entry *a, const brink_entry *b)
{
    const int time = brink_instant_compare(a->when, b->when);
    if (time)
        return time;
    if (a->kind != b->kind)
        return a->kind < b->kind ? -1 : 1;
    if (a->i != b->i)
        return a->i < b->i ? -1 : 1;
    return (a->j > b->j) - (a->j < b->j);
}

// Both particles of a pair can hold the same event: then the lower slot is
// earlier, so that the order is total and no history of the heap shows in it.
static int earlier(const brink_calendar *c, uint32_t a, uint32_t b)
{
    const int order = brink_entry_compare(&c->entry[a], &c->entry[b]);
    return order ? order < 0 : a < b;
}

static void heap_put(brink_calendar *c, uint32_t position, uint32_t slot)
{
    c->heap[position] = slot;
    c->filed[slot].place = position;
}

// Of the one or two positions below, that of the earlier slot.
static uint32_t first_below(const brink_calendar *c, uint32_t position)
{
    const uint32_t left = 2 * position + 1, right = left + 1;
    return right < c->heap_count && earlier(c, c->heap[right], c->heap[left])
               ? right
               : left;
}

// Moves the hole at `position` to where `slot` belongs, and fills it.
static void heap_settle(brink_calendar *c, uint32_t position, uint32_t slot)
{
    /*@ loop invariant can_settle(c, position, slot);
      @ loop invariant
      @     a_hole_moved{Pre, Here}(c, \at(position, Pre), position, slot);
      @ loop assigns position, c->heap[0 .. \at(c->heap_count, Pre) - 1],
      @     c->filed[0 .. \at(c->slots, Pre) - 1].place;
      @ loop variant position; */
    while (position > 0 && earlier(c, slot, c->heap[(position - 1) / 2])) {
        heap_put(c, position, c->heap[(position - 1) / 2]);
        position = (position - 1) / 2;
    }
    /*@ loop invariant can_settle(c, position, slot);
      @ loop invariant
      @     a_hole_moved{Pre, Here}(c, \at(position, Pre), position, slot) &&
      @     is_after_above(heap_of(c), position, slot);
      @ loop assigns position, c->heap[0 .. \at(c->heap_count, Pre) - 1],
      @     c->filed[0 .. \at(c->slots, Pre) - 1].place;
      @ loop variant c->heap_count - position; */
    while (2 * position + 1 < c->heap_count) {
        const uint32_t child = first_below(c, position);
        if (!earlier(c, c->heap[child], slot))
            break;
        heap_put(c, position, c->heap[child]);
        position = child;
    }
    heap_put(c, position, slot);
}

static void heap_add(brink_calendar *c, uint32_t slot)
{
    heap_settle(c, c->heap_count++, slot);
}

static void list_add(brink_calendar *c, uint32_t list, uint32_t slot)
{
    const uint32_t head = c->first[list];
    c->filed[slot].next = head;
    c->filed[slot].previous = c->slots;
    c->filed[head].previous = slot;
    c->first[list] = slot;
    c->filed[slot].place = IN_LIST + list;
}

// Powers of two: the product is exact, and below `days` because offset < year.
static uint32_t day_of(const brink_calendar *c, double offset)
{
    return (uint32_t)(offset * c->days_a_time);
}

// Files a slot that is nowhere under the time of its entry.
static void file_under(brink_calendar *c, uint32_t slot)
{
    const brink_instant when = c->entry[slot].when;
    if (when.epoch == INT64_MAX)
        return;
    if (when.epoch > c->epoch) {
        list_add(c, c->days, slot);
        return;
    }
    const uint32_t day = day_of(c, when.offset);
    if (when.epoch == c->epoch && day > c->today)
        list_add(c, day, slot);
    else
        heap_add(c, slot);
}

static void list_remove(brink_calendar *c, uint32_t list, uint32_t slot)
{
    const uint32_t before = c->filed[slot].previous, after = c->filed[slot].next;
    if (before == c->slots)
        c->first[list] = after;
    else
        c->filed[before].next = after;
    c->filed[after].previous = before;
}

static void take_out(brink_calendar *c, uint32_t slot)
{
    const uint32_t place = c->filed[slot].place;
    if (place == NONE)
        return;
    if (place < IN_LIST) {
        const uint32_t last = c->heap[--c->heap_count];
        if (last != slot)
            heap_settle(c, place, last);
    } else
        list_remove(c, place - IN_LIST, slot);
    c->filed[slot].place = NONE;
}

void brink_calendar_set(brink_calendar *c, uint32_t slot,
                        const brink_entry *entry)
{
    take_out(c, slot);
    c->entry[slot] = *entry;
    file_under(c, slot);
}

// Empties a list and files each of its slots anew.
static void refile(brink_calendar *c, uint32_t list)
{
    uint32_t slot = c->first[list];
    c->first[list] = c->slots;
    while (slot != c->slots) {
        const uint32_t next = c->filed[slot].next;
        c->filed[slot].place = NONE;
        file_under(c, slot);
        slot = next;
    }
}

// Goes on to the first year that has an event; 0 if there is none.
static int turn_year(brink_calendar *c)
{
    int64_t epoch = INT64_MAX;
    for (uint32_t slot = c->first[c->days]; slot != c->slots;
         slot = c->filed[slot].next)
        if (c->entry[slot].when.epoch < epoch)
            epoch = c->entry[slot].when.epoch;
    if (epoch == INT64_MAX)
        return 0;
    c->epoch = epoch;
    c->today = 0;
    refile(c, c->days);
    return 1;
}

uint32_t brink_calendar_next(brink_calendar *c)
{
    while (c->heap_count == 0) {
        if (c->today + 1 < c->days)
            refile(c, ++c->today);
        else if (!turn_year(c))
            return c->slots;
    }
    return c->heap[0];
}

static const char *heap_is_valid(const brink_calendar *c)
{
    for (uint32_t p = 0; p < c->heap_count; p++) {
        if (c->heap[p] >= c->slots || c->filed[c->heap[p]].place != p)
            return "the heap and the slots disagree about a place";
        if (p > 0 && earlier(c, c->heap[p], c->heap[(p - 1) / 2]))
            return "the heap is out of order";
        const brink_instant when = c->entry[c->heap[p]].when;
        if (when.epoch > c->epoch ||
            (when.epoch == c->epoch && day_of(c, when.offset) > c->today))
            return "a slot of a later day or year is in the heap";
    }
    return NULL;
}

const char *brink_calendar_is_valid(const brink_calendar *c)
{
    uint32_t filed = c->heap_count;
    // A list that ran in a circle would come to a slot whose previous is another.
    for (uint32_t list = 0; list <= c->days; list++) {
        uint32_t before = c->slots;
        for (uint32_t s = c->first[list]; s != c->slots;
             before = s, s = c->filed[s].next) {
            if (s >= c->slots || c->filed[s].place != IN_LIST + list ||
                c->filed[s].previous != before)
                return "a list and its slots disagree";
            const brink_instant when = c->entry[s].when;
            if (list == c->days ? when.epoch <= c->epoch
                                : when.epoch != c->epoch || list <= c->today ||
                                      day_of(c, when.offset) != list)
                return "a slot is in the list of another day";
            filed++;
        }
    }
    uint32_t waiting = 0;
    for (uint32_t s = 0; s < c->slots; s++)
        waiting += c->entry[s].when.epoch != INT64_MAX;
    if (waiting != filed)
        return "an event is filed nowhere, or nowhere's is filed";
    return heap_is_valid(c);
}
