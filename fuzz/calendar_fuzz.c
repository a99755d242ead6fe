// SPDX-License-Identifier: MIT
// The calendar against a look through all slots, by an order written down once
// more: time, kind, i, j, slot.
#include "calendar.h"
#include "fuzz.h"
#include <string.h>

enum { SLOTS = 40, STEPS = 300 };

typedef struct book {
    brink_calendar c;
    double year;
    brink_instant now;
    brink_entry entry[SLOTS]; // as they were set
} book;

static void broken(const book *b, const char *law)
{
    FINDING("calendar: %s", law);
    fprintf(stderr,
            "  const uint32_t slots = %u, days = %u;\n"
            "  const double year = %a;\n  const brink_entry entry[] = {\n",
            b->c.slots, b->c.days, b->year);
    for (uint32_t k = 0; k < b->c.slots; k++) {
        const brink_entry *e = &b->entry[k];
        fprintf(stderr, "    {{%lld, %a}, %u, %u, %u, %u, %u},\n",
                (long long)e->when.epoch, e->when.offset, e->i, e->j,
                e->generation, e->kind, e->at_once);
    }
    fprintf(stderr, "  }; // it is day %u of year %lld\n", b->c.today,
            (long long)b->c.epoch);
    finding_end();
}

static int is_before(const brink_entry *a, const brink_entry *b)
{
    if (a->when.epoch != b->when.epoch)
        return a->when.epoch < b->when.epoch;
    if (a->when.offset != b->when.offset)
        return a->when.offset < b->when.offset;
    if (a->kind != b->kind)
        return a->kind < b->kind;
    if (a->i != b->i)
        return a->i < b->i;
    return a->j < b->j;
}

static uint32_t earliest(const book *b)
{
    uint32_t best = b->c.slots;
    for (uint32_t k = 0; k < b->c.slots; k++)
        if (b->entry[k].when.epoch != INT64_MAX &&
            (best == b->c.slots || is_before(&b->entry[k], &b->entry[best])))
            best = k;
    return best;
}

/** At the edge of a day, a rounding from it, or anywhere. */
static double make_offset(stream *s, const book *b)
{
    const int day = stream_int(s, 0, (int)b->c.days);
    const double edge = day * (b->year / b->c.days);
    double offset = edge;
    switch (stream_int(s, 0, 3)) {
    case 0:
        offset = stream_near(s, edge, 2);
        break;
    case 1:
        offset = stream_real(s, 0, b->year);
        break;
    case 2: // soon
        offset = b->now.offset + b->year * 0x1p-10 * stream_int(s, 0, 20);
        break;
    default:
        break;
    }
    return offset >= 0 && offset < b->year ? offset : 0;
}

static void set(book *b, stream *s)
{
    const uint32_t slot = (uint32_t)stream_int(s, 0, (int)b->c.slots - 1);
    brink_entry e = {
        .when = {b->now.epoch, make_offset(s, b)},
        .i = (uint32_t)stream_int(s, 0, 3),
        .j = (uint32_t)stream_int(s, 0, 3),
        .generation = (uint32_t)stream_word(s, 1),
        .kind = (uint16_t)stream_int(s, 0, 2),
        .at_once = (uint16_t)stream_int(s, 0, 1),
    };
    switch (stream_int(s, 0, 7)) {
    case 0:
        e.when.epoch += stream_int(s, 0, 3);
        break;
    case 1:
        e.when.epoch += (int64_t)1 << stream_int(s, 0, 60);
        break;
    case 2: // that of another, to the bit
        e.when = b->entry[stream_int(s, 0, (int)b->c.slots - 1)].when;
        break;
    case 3:
        e.when = BRINK_NEVER;
        break;
    case 4: // of a year gone by
        e.when.epoch -= e.when.epoch > 0;
        break;
    default:
        break;
    }
    // An earlier one than was ever taken is put on top, too, and time is the
    // run's.
    brink_calendar_set(&b->c, slot, &e);
    b->entry[slot] = e;
}

static void take(book *b, stream *s)
{
    const uint32_t right = earliest(b), got = brink_calendar_next(&b->c);
    if (got != right)
        broken(b, "next is what a look through all finds");
    if (got == b->c.slots)
        return;
    const brink_instant when = b->entry[got].when;
    if (brink_instant_compare(when, b->now) > 0)
        b->now = when;
    if (stream_int(s, 0, 3)) {
        b->entry[got] = (brink_entry){.when = BRINK_NEVER};
        brink_calendar_set(&b->c, got, &b->entry[got]);
    }
}

static void look(const book *b)
{
    const char *fault = brink_calendar_is_valid(&b->c);
    if (fault)
        broken(b, fault);
    for (uint32_t k = 0; k < b->c.slots; k++)
        if (memcmp(&b->entry[k], &b->c.entry[k], sizeof *b->entry) != 0)
            broken(b, "a slot holds what it was given");
}

static void order(const book *b, stream *s)
{
    const int last = (int)b->c.slots - 1;
    const brink_entry *x = &b->entry[stream_int(s, 0, last)];
    const brink_entry *y = &b->entry[stream_int(s, 0, last)];
    const int right = is_before(y, x) - is_before(x, y);
    if (brink_entry_compare(x, y) != right)
        broken(b, "the order is by time, kind, i, j");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stream s = stream_of_bytes(data, size);
    book b = {.year = ldexp(1, stream_int(&s, -10, 10))};
    const uint32_t slots = (uint32_t)stream_int(&s, 1, SLOTS);
    const uint32_t days = (uint32_t)stream_int(&s, 1, 100);
    LAW(brink_calendar_create(&b.c, slots, b.year, days) == 0,
        "calendar: memory is out");
    for (uint32_t k = 0; k < slots; k++)
        b.entry[k] = (brink_entry){.when = BRINK_NEVER};
    for (int n = stream_int(&s, 0, STEPS); n > 0; n--) {
        for (int k = stream_int(&s, 0, 3); k > 0; k--)
            set(&b, &s);
        look(&b);
        order(&b, &s);
        take(&b, &s);
    }
    look(&b);
    brink_calendar_destroy(&b.c);
    return 0;
}
