// SPDX-License-Identifier: MIT
#ifndef BRINK_LISTS_H
#define BRINK_LISTS_H
/**
 * Lists, one a particle, each in one piece: in a block of a pool that all of them
 * share, with room for 4 items, or 8, or 16, as few as will do.  An empty list
 * has none, so memory goes with the number of items.
 */
#include <stddef.h>
#include <stdint.h>

typedef struct brink_list { // items first .. first + count - 1 of the pool
    uint32_t first, count;
} brink_list;

#define BRINK_BLOCK_SIZES 30 // 4 to 2^31

typedef struct brink_lists {
    uint32_t lists;
    uint32_t size;     // bytes an item
    brink_list *list;  // per particle
    char *pool;        // items
    uint32_t capacity; // of the pool
    uint32_t touched;  // what lies below has been in a block at some time
    uint32_t used;     // items in lists
    // by size: the first free block, chained by its first four bytes
    uint32_t free[BRINK_BLOCK_SIZES];
} brink_lists;

/** `lists` empty ones of items of `size` >= 4 bytes.  0, -1 no memory. */
int brink_lists_create(brink_lists *l, uint32_t lists, size_t size);
void brink_lists_destroy(brink_lists *l);

/** Item k of list i, until a list is made longer. */
static inline void *brink_lists_item(const brink_lists *l, uint32_t i, uint32_t k)
{
    return l->pool + (size_t)(l->list[i].first + k) * l->size;
}

/** Makes sure that lists i and j can each be made one longer or shorter, for
 * which they may have to move.  0, -1 no memory. */
int brink_lists_make_room(brink_lists *l, uint32_t i, uint32_t j);

/** Adds an item at the end of list i, for which room was made, and says where. */
void *brink_lists_add(brink_lists *l, uint32_t i);

/** Takes item k out of list i, for which room was made; the last one takes its
 * place. */
void brink_lists_remove(brink_lists *l, uint32_t i, uint32_t k);
#endif
