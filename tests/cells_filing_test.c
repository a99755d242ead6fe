// SPDX-License-Identifier: MIT
// Who is in which cell, however many there are, and what the check sees of it.
#include "cells.h"
#include "suite.h"
#include <math.h>

static const brink_potential hard = {1, (const double[]){1},
                                     (const double[]){(double)INFINITY}};

// A system of so many particles, all in one cell.
static void crowd(brink_system *s, brink_cells *c, const double box[3],
                  uint32_t count)
{
    const brink_species species = {"A", 1, 1, count};
    ck_assert_int_eq(
        brink_system_create(s, 3, box, 1.0, count, 1, &species, &hard), 0);
    for (uint32_t i = 0; i < count; i++)
        s->particle[i].x[0] = i;
    ck_assert_int_eq(brink_cells_create(c, s, s->range), 0);
    ck_assert_ptr_null(brink_cells_is_valid(c));
}

static const double cube[3] = {8, 8, 8};

static void destroy(brink_system *s, brink_cells *c)
{
    brink_cells_destroy(c);
    brink_system_destroy(s);
}

// The lower wall is a cell's first position: of five cells, of which 2^64 is no
// multiple, of eight, of which it is, and of three.
START_TEST(walls_are_where_cells_begin)
{
    brink_system s;
    brink_cells c;
    crowd(&s, &c, (const double[]){5.1, 8.1, 4}, 500);
    uint32_t stride = 1;
    for (int a = 0; a < 3; a++) {
        ck_assert_int_eq(c.count[a], a == 0 ? 5 : a == 1 ? 8 : 3);
        for (uint32_t k = 0; k < (uint32_t)c.count[a]; k++) {
            uint64_t x[3] = {0, 0, 0};
            x[a] = c.wall[a][k];
            ck_assert_uint_eq(brink_cells_at(&c, x), stride * k);
            x[a]--;
            const uint32_t below = (k > 0 ? k : (uint32_t)c.count[a]) - 1;
            ck_assert_uint_eq(brink_cells_at(&c, x), stride * below);
        }
        ck_assert_uint_eq(c.wall[a][c.count[a]], 0);
        stride *= (uint32_t)c.count[a];
    }
    destroy(&s, &c);
}
END_TEST

// From one to several handfuls; and they leave it in another order.
START_TEST(a_cell_holds_any_number)
{
    for (uint32_t count = 1; count <= 3 * BRINK_HANDFUL; count++) {
        brink_system s;
        brink_cells c;
        uint32_t cell = 0, all = 0, who[BRINK_HANDFUL];
        uint8_t seen[3 * BRINK_HANDFUL] = {0};
        crowd(&s, &c, cube, count);
        brink_tour tour = brink_tour_of(&cell, 1);
        for (int n; (n = brink_tour_next(&c, &tour, who)) != 0;)
            for (int k = 0; k < n; k++, all++)
                ck_assert_msg(!seen[who[k]]++, "%u twice", who[k]);
        ck_assert_uint_eq(all, count);
        for (uint32_t i = 0; i < count; i++) {
            const uint32_t leaves = (uint32_t)(UINT64_C(1009) * i % count);
            ck_assert_int_eq(
                brink_cells_cross(&c, leaves, (brink_crossing){0, 1}), 1);
        }
        ck_assert_ptr_null(brink_cells_is_valid(&c));
        destroy(&s, &c);
    }
}
END_TEST

// More than a handful in all, none of them in a further bucket.
START_TEST(a_tour_goes_on_where_the_handful_was_full)
{
    brink_system s;
    brink_cells c;
    uint32_t cells[60] = {0}, who[BRINK_HANDFUL], all = 0;
    uint8_t seen[60 * BRINK_BUCKET] = {0};
    crowd(&s, &c, cube, 60 * BRINK_BUCKET);
    for (uint32_t i = 0; i < s.count; i++) {
        brink_cells_place(&c, i, i / BRINK_BUCKET);
        cells[i / BRINK_BUCKET] = i / BRINK_BUCKET;
    }
    brink_tour tour = brink_tour_of(cells, 60);
    for (int n; (n = brink_tour_next(&c, &tour, who)) != 0;) {
        ck_assert_int_le(n, BRINK_HANDFUL);
        for (int k = 0; k < n; k++, all++)
            ck_assert_msg(!seen[who[k]]++, "%u twice", who[k]);
    }
    ck_assert_uint_eq(all, s.count);
    destroy(&s, &c);
}
END_TEST

START_TEST(a_crossing_is_a_number_and_back)
{
    for (uint32_t number = 0; number < 6; number++) {
        const brink_crossing crossing = brink_crossing_of(number);
        ck_assert_int_eq(crossing.axis, (int)number / 2);
        ck_assert_int_eq(crossing.way, number % 2 == 0 ? -1 : 1);
        ck_assert_uint_eq(brink_crossing_number(crossing), number);
    }
}
END_TEST

START_TEST(a_crossing_that_is_none_is_refused)
{
    brink_system s;
    brink_cells c;
    crowd(&s, &c, cube, 10);
    ck_assert_int_eq(brink_cells_cross(&c, 4, (brink_crossing){0, 0}), 0);
    ck_assert_uint_eq(c.cell[4], 0);
    ck_assert_ptr_null(brink_cells_is_valid(&c));
    destroy(&s, &c);
}
END_TEST

// A fault is put in, seen, and taken out again.
static void is_seen(const brink_cells *c, uint32_t *place, uint32_t fault,
                    const char *what)
{
    const uint32_t kept = *place;
    *place = fault;
    ck_assert_pstr_eq(brink_cells_is_valid(c), what);
    *place = kept;
    ck_assert_ptr_null(brink_cells_is_valid(c));
}

START_TEST(the_check_sees_what_is_wrong)
{
    static const char disagree[] = "a cell and its particles disagree";
    brink_system s;
    brink_cells c;
    crowd(&s, &c, cube, 10);
    const uint32_t second = c.bucket[0].fill;
    is_seen(&c, &c.cell[4], 1, disagree);
    is_seen(&c, &c.bucket[0].who[0], 10, disagree);
    is_seen(&c, &c.bucket[0].who[0], 11, disagree);
    is_seen(&c, &c.bucket[0].fill, 3, "a particle is in no cell");
    is_seen(&c, &c.bucket[second].fill, second,
            "more particles are in cells than there are");
    for (uint32_t i = 0; i < s.count; i++)
        brink_cells_place(&c, i, 2);
    is_seen(&c, &c.cell[4], 1, disagree);
    destroy(&s, &c);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "cells: filing", 60, walls_are_where_cells_begin, a_cell_holds_any_number,
        a_tour_goes_on_where_the_handful_was_full,
        a_crossing_is_a_number_and_back, a_crossing_that_is_none_is_refused,
        the_check_sees_what_is_wrong);
}
