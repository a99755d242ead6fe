// SPDX-License-Identifier: MIT
#ifndef BRINK_CALENDAR_H
#define BRINK_CALENDAR_H
/**
 * The event queue: a fixed number of slots, each with one event or none, and the
 * earliest of them in O(1) (Paul 2007: J. Comput. Phys. 221, 615).  The year of
 * the clock is divided into days; today's events are in a small heap, those of
 * later days of this year in a list a day, those of later years in one list that
 * is gone through when the year turns.
 *
 * One order: (time, kind, i, j), then slot.  What comes out does not depend on
 * when or in which order things were put in.
 */
#include "clock.h"
#include <stddef.h>

enum brink_entry_kind { // what a slot waits for; the order of simultaneous events
    BRINK_ENTRY_INWARD = 0,
    BRINK_ENTRY_OUTWARD = 1,
    BRINK_ENTRY_CELL = 2 // a crossing, or a departure from home
};

typedef struct brink_entry {
    brink_instant when; // BRINK_NEVER: none
    // pair: i < j; cell: the particle, and of a crossing its number
    uint32_t i, j;
    uint32_t generation; // pair: the partner's, as the prediction knew it
    uint16_t kind;       // enum brink_entry_kind
    uint16_t at_once;    // 1: was due when it was predicted; no part of the order
} brink_entry;

typedef struct brink_filed { // where a slot is
    uint32_t place;          // its heap position, or in which list
    uint32_t next, previous; // in that list; `slots`: nobody
} brink_filed;

typedef struct brink_calendar {
    uint32_t slots;
    uint32_t days;      // a power of two
    double days_a_time; // days / year
    int64_t epoch;      // the current year
    uint32_t today;
    brink_entry *entry; // per slot
    brink_filed *filed; // per slot; and one for nobody, where anything is written
    uint32_t *first;    // per day, and one more: later years
    uint32_t *heap;     // slots, earliest first
    uint32_t heap_count;
} brink_calendar;

/** `days` is rounded up to a power of two, at most 2^30.  0, -1 no memory. */
int brink_calendar_create(brink_calendar *c, uint32_t slots, double year,
                          uint32_t days);
void brink_calendar_destroy(brink_calendar *c);
const char *brink_calendar_is_valid(const brink_calendar *c);

/** -1, 0, 1 in the one order of events. */
int brink_entry_compare(const brink_entry *a, const brink_entry *b);

/** Replaces what the slot holds.  The event must not lie before the last one
 * taken by brink_calendar_next (an earlier one is put at once on top: time never
 * runs back). */
void brink_calendar_set(brink_calendar *c, uint32_t slot,
                        const brink_entry *entry);

/** The slot with the earliest event, which stays in it until it is set anew;
 * slots where there is none.  Goes on to the day and year of that event. */
uint32_t brink_calendar_next(brink_calendar *c);
#endif
