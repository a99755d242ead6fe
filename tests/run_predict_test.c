// SPDX-License-Identifier: MIT
#include "run_predict.h"
#include "suite.h"
#include "systems.h"
#include <brink/event_time.h>
#include <math.h>

// Earliest time from now at which i and j can meet, over all images within one
// box.
static double meeting(const brink_run *run, uint32_t i, uint32_t j)
{
    const brink_system *s = &run->system;
    const brink_potential *p = brink_system_potential(s, i, j);
    const int level = brink_states_level(&run->states, i, j);
    double r[3], v[3], soonest = (double)INFINITY;
    brink_system_separation(s, i, j, run->now.offset, r);
    for (int a = 0; a < 3; a++)
        v[a] = s->particle[i].v[a] - s->particle[j].v[a];
    if (level > 0) {
        soonest = brink_disjoint_time(r, v, p->distance[level - 1]);
        if (level < p->count)
            soonest =
                fmin(soonest, brink_intersection_time(r, v, p->distance[level]));
        return soonest;
    }
    for (int m = 0; m < 27; m++) {
        const int shift[3] = {m % 3 - 1, m / 3 % 3 - 1, m / 9 - 1};
        double image[3];
        for (int a = 0; a < 3; a++)
            image[a] = r[a] + shift[a] * s->length[a] * (a < s->dimensions);
        soonest =
            fmin(soonest, brink_intersection_time(image, v, p->distance[0]));
    }
    return soonest;
}

// The next event of the calendar, a pair's or a crossing, is not after any
// pair's: looked for among all pairs, without cells, from where everybody is now.
START_TEST(no_pair_meets_before_the_calendar_says)
{
    const char *const scenes[] = {hard_spheres,    square_well,    three_steps,
                                  mixture,         discs_well,     small_box,
                                  crowded_spheres, crowded_mixture};
    for (size_t k = 0; k < sizeof scenes / sizeof *scenes; k++) {
        brink_run run;
        make_run(&run, scenes[k]);
        // So many that about a million pairs are looked at.
        const uint64_t pairs = (uint64_t)run.system.count * run.system.count / 2;
        for (uint64_t events = 1; events < 1000000 / pairs; events++) {
            advance(&run, events);
            const double next = brink_instant_since(
                run.system.year,
                run.calendar.entry[brink_calendar_next(&run.calendar)].when,
                run.now);
            for (uint32_t i = 0; i < run.system.count; i++)
                for (uint32_t j = i + 1; j < run.system.count; j++) {
                    const double dt = meeting(&run, i, j);
                    // Both sides come from r and v with different roundings,
                    // relative to the flight since the prediction: less than a
                    // year.
                    const double slack = 0x1p-40 * run.system.year;
                    ck_assert_msg(
                        !(dt < next - slack),
                        "scene %zu, event %lu: %u and %u meet %a before", k,
                        (unsigned long)events, i, j, next - dt);
                }
        }
        brink_run_destroy(&run);
    }
}
END_TEST

START_TEST(a_pair_s_event_is_kept_by_one_of_the_two_with_the_other_s_generation)
{
    brink_run run;
    make_run(&run, square_well);
    advance(&run, 5000);
    for (uint32_t i = 0; i < run.system.count; i++) {
        brink_predict(&run, i, run.system.particle[i].since);
        const brink_entry *e = &run.calendar.entry[i];
        if (e->kind == BRINK_ENTRY_CELL)
            continue;
        ck_assert(e->i == i || e->j == i);
        const uint32_t partner = e->i == i ? e->j : e->i;
        ck_assert_uint_eq(e->generation, run.system.particle[partner].generation);
        // A pair that is inside nothing can only go in.
        if (brink_states_level(&run.states, e->i, e->j) == 0)
            ck_assert_int_eq(e->kind, BRINK_ENTRY_INWARD);
    }
    brink_run_destroy(&run);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "predict", 300, no_pair_meets_before_the_calendar_says,
        a_pair_s_event_is_kept_by_one_of_the_two_with_the_other_s_generation);
}
