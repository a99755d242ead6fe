// SPDX-License-Identifier: MIT
// Lists against arrays: additions two by two, as pairs make them, and removals.
#include "fuzz.h"
#include "lists.h"
#include <string.h>

enum { LISTS = 4, MOST = 300, LARGEST = 16, STEPS = 200 };

typedef struct plain {
    uint32_t count;
    unsigned char item[MOST][LARGEST];
} plain;

static void compare(const brink_lists *l, const plain *model)
{
    uint64_t used = 0;
    for (uint32_t i = 0; i < LISTS; i++) {
        const plain *m = &model[i];
        const unsigned char *items = brink_lists_items(l, i);
        used += m->count;
        LAW(l->list[i].count == m->count, "lists: list %u has %u items, not %u",
            i, l->list[i].count, m->count);
        LAW((items == NULL) == (m->count == 0),
            "lists: an empty list has no memory, and no other");
        // One that becomes shorter is cut to an eighth more than it needs, and to
        // pieces of 16 bytes, when it fills less than half.
        LAW(l->list[i].room / 2 <= m->count + 24 / l->size,
            "lists: room for %u items, where there are %u", l->list[i].room,
            m->count);
        for (uint32_t k = 0; items && k < m->count; k++)
            LAW(memcmp(items + (size_t)k * l->size, m->item[k], l->size) == 0,
                "lists: item %u of list %u is another", k, i);
    }
    LAW(l->used == used, "lists: %llu items are said to be in all, not %llu",
        (unsigned long long)l->used, (unsigned long long)used);
}

static void add(brink_lists *l, plain *m, uint32_t i, stream *s)
{
    unsigned char *item = m[i].item[m[i].count++];
    for (uint32_t b = 0; b < l->size; b++)
        item[b] = (unsigned char)stream_word(s, 1);
    memcpy(brink_lists_add(l, i), item, l->size);
}

/** The last one takes its place. */
static void take_out(brink_lists *l, plain *m, uint32_t i, uint32_t k)
{
    brink_lists_remove(l, i, k);
    memmove(m[i].item[k], m[i].item[--m[i].count], LARGEST);
}

/** Several to the two ends of a pair, or several out of one. */
static void step(brink_lists *l, plain *m, stream *s)
{
    const uint32_t i = (uint32_t)stream_int(s, 0, LISTS - 1);
    const uint32_t j = (i + 1 + (uint32_t)stream_int(s, 0, LISTS - 2)) % LISTS;
    const int out = stream_int(s, 0, 1);
    for (int n = stream_int(s, 1, 20); n > 0; n--)
        if (out && m[i].count > 0) {
            take_out(l, m, i, (uint32_t)stream_int(s, 0, (int)m[i].count - 1));
        } else if (!out && m[i].count < MOST && m[j].count < MOST) {
            LAW(brink_lists_make_room(l, i, j) == 0, "lists: memory is out");
            add(l, m, i, s);
            add(l, m, j, s);
        }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static plain model[LISTS];
    stream s = stream_of_bytes(data, size);
    brink_lists l;
    memset(model, 0, sizeof model);
    const size_t bytes = 4 * (size_t)stream_int(&s, 1, LARGEST / 4);
    LAW(brink_lists_create(&l, LISTS, bytes) == 0, "lists: memory is out");
    for (int n = stream_int(&s, 1, STEPS); n > 0; n--) {
        step(&l, model, &s);
        compare(&l, model);
    }
    brink_lists_destroy(&l);
    return 0;
}
