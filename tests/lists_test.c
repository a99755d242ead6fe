// SPDX-License-Identifier: MIT
#include "lists.h"
#include "suite.h"
#include <gsl/gsl_rng.h>
#include <stdio.h>
#include <string.h>

enum { LISTS = 20, MOST = 70 };

// What the lists should be.
typedef struct model {
    uint64_t item[LISTS][MOST];
    uint32_t count[LISTS], room[LISTS];
} model;

// An eighth more than so many, and what is left of malloc's last piece: it gives
// out 8, 24, 40, ... bytes.
static uint32_t room_for(uint32_t count)
{
    uint32_t bytes = 8;
    while (bytes < (count + count / 8) * sizeof(uint64_t))
        bytes += 16;
    return bytes / (uint32_t)sizeof(uint64_t);
}

static void make_room(brink_lists *l, model *m, uint32_t i, uint32_t j)
{
    ck_assert_int_eq(brink_lists_make_room(l, i, j), 0);
    for (uint32_t k = i, both = 0; both < 2; k = j, both++)
        if (m->count[k] == m->room[k])
            m->room[k] = room_for(m->count[k] + 1);
}

static void add(brink_lists *l, model *m, uint32_t i, uint64_t item)
{
    memcpy(brink_lists_add(l, i), &item, sizeof item);
    m->item[i][m->count[i]++] = item;
}

// What is less than half full gives back what it can spare, what is empty all.
static void drop(brink_lists *l, model *m, uint32_t i, uint32_t k)
{
    brink_lists_remove(l, i, k);
    m->item[i][k] = m->item[i][--m->count[i]];
    if (m->count[i] == 0)
        m->room[i] = 0;
    else if (m->count[i] < m->room[i] / 2)
        m->room[i] = room_for(m->count[i]);
}

static void same(const brink_lists *l, const model *m)
{
    uint32_t used = 0;
    for (uint32_t i = 0; i < LISTS; i++) {
        ck_assert_uint_eq(l->list[i].count, m->count[i]);
        used += m->count[i];
        for (uint32_t k = 0; k < m->count[i]; k++)
            ck_assert_uint_eq(((uint64_t *)brink_lists_items(l, i))[k],
                              m->item[i][k]);
        ck_assert_uint_eq(l->list[i].room, m->room[i]);
    }
    ck_assert_uint_eq(l->used, used);
}

START_TEST(lists_grow_and_shrink_as_their_model_does)
{
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    static model m;
    brink_lists l;
    printf("seed 1\n");
    gsl_rng_set(rng, 1);
    ck_assert_int_eq(brink_lists_create(&l, LISTS, sizeof(uint64_t)), 0);
    for (uint64_t n = 0; n < suite_share(200000); n++) {
        // Mostly longer until they are all but full, then mostly shorter until
        // most are empty, and so on: 0.6 * 2000 / LISTS = 60 items up or down.
        const int longer = gsl_rng_uniform(rng) < (n / 2000 % 2 ? 0.8 : 0.2);
        const uint32_t i = (uint32_t)gsl_rng_uniform_int(rng, LISTS);
        if (longer ? m.count[i] == MOST : m.count[i] == 0)
            continue;
        if (longer) {
            make_room(&l, &m, i, (i + 1) % LISTS);
            add(&l, &m, i, n);
        } else {
            drop(&l, &m, i, (uint32_t)gsl_rng_uniform_int(rng, m.count[i]));
        }
        if (n % 50 == 0)
            same(&l, &m);
    }
    brink_lists_destroy(&l);
    gsl_rng_free(rng);
}
END_TEST

START_TEST(an_empty_list_has_no_memory)
{
    brink_lists l;
    ck_assert_int_eq(brink_lists_create(&l, 2, sizeof(uint64_t)), 0);
    ck_assert_ptr_null(brink_lists_items(&l, 0));
    ck_assert_int_eq(brink_lists_make_room(&l, 0, 1), 0);
    memset(brink_lists_add(&l, 0), 0, sizeof(uint64_t));
    ck_assert_ptr_nonnull(brink_lists_items(&l, 0));
    brink_lists_remove(&l, 0, 0);
    ck_assert_ptr_null(brink_lists_items(&l, 0));
    brink_lists_destroy(&l);
}
END_TEST

int main(void)
{
    return RUN_SUITE("lists", 60, lists_grow_and_shrink_as_their_model_does,
                     an_empty_list_has_no_memory);
}
