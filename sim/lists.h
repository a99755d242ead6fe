// SPDX-License-Identifier: MIT
#ifndef BRINK_LISTS_H
#define BRINK_LISTS_H
/**
 * Lists, one a particle, each in one piece of memory of its own.  An empty list
 * has none, so memory goes with the number of items.
 */
#include <stddef.h>
#include <stdint.h>

typedef struct brink_list {
    void *item;
    uint32_t count, room; // items there are, and there is memory for
} brink_list;

typedef struct brink_lists {
    uint32_t lists;
    uint32_t size;    // bytes an item
    uint64_t used;    // items in all lists
    brink_list *list; // per particle
} brink_lists;

/** `lists` empty ones of items of `size` bytes.  0, -1 no memory. */
int brink_lists_create(brink_lists *l, uint32_t lists, size_t size);
void brink_lists_destroy(brink_lists *l);

/** The items of list i, until it becomes longer or shorter; NULL if there are
 * none. */
static inline void *brink_lists_items(const brink_lists *l, uint32_t i)
{
    return l->list[i].item;
}

/** Makes sure that lists i and j can each be made one longer.  0, -1 no memory.
 */
int brink_lists_make_room(brink_lists *l, uint32_t i, uint32_t j);

/** Adds an item at the end of list i, for which room was made, and says where. */
void *brink_lists_add(brink_lists *l, uint32_t i);

/** Takes item k out of list i; the last one takes its place. */
void brink_lists_remove(brink_lists *l, uint32_t i, uint32_t k);
#endif
