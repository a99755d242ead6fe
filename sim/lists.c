// SPDX-License-Identifier: MIT
#include "lists.h"
#include <stdlib.h>
#include <string.h>

#define NO_BLOCK UINT32_MAX

// The size, as 4 * 2^size, of the block for so many items; -1 for none.
static int size_for(uint32_t count)
{
    int size = -1;
    while (count > 0 && (size < 0 || UINT32_C(4) << size < count))
        size++;
    return size;
}

static char *at(const brink_lists *l, uint32_t item)
{
    return l->pool + (size_t)item * l->size;
}

static uint32_t take_block(brink_lists *l, int size)
{
    uint32_t first = l->free[size];
    if (first != NO_BLOCK) {
        memcpy(&l->free[size], at(l, first), sizeof l->free[size]);
    } else {
        first = l->touched;
        l->touched += UINT32_C(4) << size;
    }
    return first;
}

static void free_block(brink_lists *l, uint32_t first, int size)
{
    memcpy(at(l, first), &l->free[size], sizeof l->free[size]);
    l->free[size] = first;
}

// Makes the pool twice as large, or as large as needed.  0, -1 no memory.
static int grow(brink_lists *l, uint64_t needed)
{
    const uint64_t twice = 2 * (uint64_t)l->capacity;
    uint64_t capacity = twice < NO_BLOCK ? twice : NO_BLOCK - 1;
    capacity = capacity < needed ? needed : capacity;
    if (capacity >= NO_BLOCK)
        return -1;
    char *grown = realloc(l->pool, capacity * l->size);
    if (!grown)
        return -1;
    l->pool = grown;
    l->capacity = (uint32_t)capacity;
    return 0;
}

int brink_lists_create(brink_lists *l, uint32_t lists, size_t size)
{
    memset(l, 0, sizeof *l);
    memset(l->free, 0xff, sizeof l->free);
    l->lists = lists;
    l->size = (uint32_t)size;
    l->list = calloc(lists, sizeof *l->list);
    if (l->list && grow(l, 16) == 0)
        return 0;
    brink_lists_destroy(l);
    return -1;
}

void brink_lists_destroy(brink_lists *l)
{
    free(l->list);
    free(l->pool);
    memset(l, 0, sizeof *l);
}

int brink_lists_make_room(brink_lists *l, uint32_t i, uint32_t j)
{
    const uint32_t ni = l->list[i].count, nj = l->list[j].count;
    const int size = size_for((ni > nj ? ni : nj) + 1);
    const uint64_t needed = l->touched + (UINT64_C(8) << size);
    return needed <= l->capacity ? 0 : grow(l, needed);
}

// Moves a list to a block for so many items, one more or one fewer than it has,
// if its own is full or too large for that.
static void fit(brink_lists *l, uint32_t i, uint32_t count)
{
    brink_list *list = &l->list[i];
    const int from = size_for(list->count), to = size_for(count);
    const uint32_t old = list->first;
    if (from == to)
        return;
    if (to >= 0) {
        list->first = take_block(l, to);
        const uint32_t kept = list->count < count ? list->count : count;
        memcpy(at(l, list->first), at(l, old), (size_t)kept * l->size);
    }
    if (from >= 0)
        free_block(l, old, from);
}

void *brink_lists_add(brink_lists *l, uint32_t i)
{
    fit(l, i, l->list[i].count + 1);
    l->used++;
    return brink_lists_item(l, i, l->list[i].count++);
}

void brink_lists_remove(brink_lists *l, uint32_t i, uint32_t k)
{
    brink_list *list = &l->list[i];
    memmove(brink_lists_item(l, i, k), brink_lists_item(l, i, list->count - 1),
            l->size);
    fit(l, i, list->count - 1);
    list->count--;
    l->used--;
}
