// SPDX-License-Identifier: MIT
#include "lists.h"
#include "array.h"
#include <stdlib.h>
#include <string.h>

int brink_lists_create(brink_lists *l, uint32_t lists, size_t size)
{
    *l = (brink_lists){.lists = lists, .size = (uint32_t)size};
    l->list = brink_array_create(lists, sizeof *l->list);
    return l->list ? 0 : -1;
}

void brink_lists_destroy(brink_lists *l)
{
    for (uint32_t i = 0; i < l->lists && l->list; i++)
        free(l->list[i].item);
    free(l->list);
    memset(l, 0, sizeof *l);
}

// Gives a list memory for so many items, not fewer than it has.  0; -1 no memory,
// and it keeps what it had.
static int resize(const brink_lists *l, brink_list *list, uint32_t room)
{
    void *moved = realloc(list->item, (size_t)room * l->size);
    if (!moved)
        return -1;
    list->item = moved;
    list->room = room;
    return 0;
}

// An eighth more than is needed, as lists become longer and shorter all the
// time, and as many as fill what malloc gives out: pieces of 16 bytes, of which 8
// are its own.
static uint32_t room_for(const brink_lists *l, uint32_t count)
{
    const uint64_t bytes = (count + (uint64_t)count / 8) * l->size;
    const uint64_t pieces = (bytes + 8 + 15) / 16;
    const uint64_t room = (pieces * 16 - 8) / l->size;
    return room < UINT32_MAX ? (uint32_t)room : UINT32_MAX;
}

static int make_room(const brink_lists *l, uint32_t i)
{
    brink_list *list = &l->list[i];
    return list->count < list->room
               ? 0
               : resize(l, list, room_for(l, list->count + 1));
}

int brink_lists_make_room(brink_lists *l, uint32_t i, uint32_t j)
{
    return make_room(l, i) || make_room(l, j) ? -1 : 0;
}

static void *item(const brink_lists *l, uint32_t i, uint32_t k)
{
    return (char *)l->list[i].item + (size_t)k * l->size;
}

void *brink_lists_add(brink_lists *l, uint32_t i)
{
    l->used++;
    return item(l, i, l->list[i].count++);
}

void brink_lists_remove(brink_lists *l, uint32_t i, uint32_t k)
{
    brink_list *list = &l->list[i];
    list->count--;
    l->used--;
    memmove(item(l, i, k), item(l, i, list->count), l->size);
    if (list->count == 0) {
        free(list->item);
        *list = (brink_list){0};
    } else if (list->count < list->room / 2) {
        resize(l, list, room_for(l, list->count)); // else it keeps what it has
    }
}
