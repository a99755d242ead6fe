// SPDX-License-Identifier: MIT
#include "systems.h"
#include "scene.h"
#include "start.h"
#include <check.h>
#include <string.h>

const char hard_spheres[] = "seed: 11\n"
                            "box: {packing_fraction: 0.3}\n"
                            "species: {A: {count: 256, diameter: 1}}\n";

const char square_well[] =
    "seed: 12\n"
    "box: {number_density: 0.3}\n"
    "species: {A: {count: 256}}\n"
    "potentials:\n"
    "  - {between: [A, A], steps: [[1.5, -1], [1, .inf]]}\n";

const char square_shoulder[] =
    "seed: 13\n"
    "box: {number_density: 0.01}\n"
    "species: {A: {count: 256}}\n"
    "potentials:\n"
    "  - {between: [A, A], steps: [[3, 1], [1, .inf]]}\n";

const char three_steps[] = "seed: 14\n"
                           "box: {number_density: 0.2}\n"
                           "species: {A: {count: 256}}\n"
                           "potentials:\n"
                           "  - {between: [A, A], steps: [[1.8, -0.3], [1.5, "
                           "-1], [1.2, 0.5], [1, .inf]]}\n";

const char mixture[] =
    "seed: 15\n"
    "box: {number_density: 0.1}\n"
    "species: {A: {count: 200, mass: 1}, B: {count: 56, mass: 30}}\n"
    "start: {random: true}\n"
    "potentials:\n"
    "  - {between: [A, A], steps: [[1.5, -1], [1, .inf]]}\n"
    "  - {between: [B, B], steps: [[2.4, -0.5], [1.6, .inf]]}\n";

const char discs_well[] =
    "seed: 16\n"
    "dimensions: 2\n"
    "box: {number_density: 0.3}\n"
    "species: {A: {count: 200}}\n"
    "potentials:\n"
    "  - {between: [A, A], steps: [[1.5, -1], [1, .inf]]}\n";

const char small_box[] = "seed: 17\n"
                         "box: {size: [4.5, 5, 16]}\n"
                         "species: {A: {count: 30}}\n"
                         "start: {random: true}\n"
                         "potentials:\n"
                         "  - {between: [A, A], steps: [[2, -1], [1, .inf]]}\n";

const char crowded_spheres[] = "seed: 18\n"
                               "box: {packing_fraction: 0.45}\n"
                               "species: {A: {count: 500, diameter: 1}}\n";

const char crowded_mixture[] =
    "seed: 19\n"
    "box: {size: [12, 11.5, 11.3]}\n"
    "species: {A: {count: 400, mass: 1}, B: {count: 100, mass: 3}}\n"
    "start: {random: true}\n"
    "potentials:\n"
    "  - {between: [A, A], steps: [[1.5, -1], [1, .inf]]}\n"
    "  - {between: [A, B], steps: [[1.1, .inf]]}\n"
    "  - {between: [B, B], steps: [[1.2, .inf]]}\n";

void make_system(brink_system *system, const char *scene)
{
    brink_scene s;
    ck_assert_int_eq(
        brink_scene_parse(scene, strlen(scene), "scene", "", &s, stderr), 0);
    ck_assert_int_eq(brink_start_make(&s, "scene", system, stderr), 0);
    brink_scene_destroy(&s);
}

void make_run(brink_run *run, const char *scene)
{
    brink_system system;
    make_system(&system, scene);
    ck_assert_int_eq(brink_run_create(run, &system, BRINK_TIER_PLAIN), 0);
}

void make_pair(brink_run *run, const brink_potential *potential,
               const double r[3], const double v[3])
{
    const double box[3] = {64, 64, 64};
    const brink_species species = {"A", 1, 1, 2};
    brink_system s;
    ck_assert_int_eq(
        brink_system_create(&s, 3, box, 1.0, 2, 1, &species, potential), 0);
    for (int a = 0; a < 3; a++) {
        s.particle[0].x[a] = brink_system_fraction(&s, a, 32 + r[a]);
        s.particle[1].x[a] = brink_system_fraction(&s, a, 32);
        s.particle[0].v[a] = v[a] / 2;
        s.particle[1].v[a] = -v[a] / 2;
    }
    ck_assert_int_eq(brink_run_create(run, &s, BRINK_TIER_PLAIN), 0);
}

void advance(brink_run *run, uint64_t events)
{
    const enum brink_run_status status =
        brink_run_advance(run, events, BRINK_NEVER);
    char why[2000];
    brink_run_diagnosis(run, status, why, sizeof why);
    ck_assert_msg(status == BRINK_RUN_REACHED, "%s", why);
}

static int same_levels(const brink_run *a, const brink_run *b)
{
    const brink_states *s = &a->states;
    if (s->links.used != b->states.links.used)
        return 0;
    for (uint32_t i = 0; i < s->particles; i++)
        for (uint32_t k = 0; k < brink_states_partners(s, i); k++) {
            const brink_link link = brink_states_links(s, i)[k];
            if (brink_states_level(&b->states, i, link.partner) != link.level)
                return 0;
        }
    return 1;
}

static int same_homes(const brink_run *a, const brink_run *b)
{
    const brink_neighbours *m = &a->neighbours, *n = &b->neighbours;
    return m->radius == n->radius && m->who.used == n->who.used &&
           (!(m->radius > 0) ||
            memcmp(m->home, n->home, a->system.count * sizeof *m->home) == 0);
}

int same_state(const brink_run *a, const brink_run *b)
{
    const size_t n = a->system.count;
    return n == b->system.count && a->system.epoch == b->system.epoch &&
           memcmp(a->system.particle, b->system.particle,
                  n * sizeof *a->system.particle) == 0 &&
           memcmp(a->cells.cell, b->cells.cell, n * sizeof *a->cells.cell) == 0 &&
           same_homes(a, b) &&
           memcmp(a->calendar.entry, b->calendar.entry,
                  n * sizeof *a->calendar.entry) == 0 &&
           memcmp(&a->tally, &b->tally, sizeof a->tally) == 0 &&
           brink_instant_compare(a->now, b->now) == 0 && a->idle == b->idle &&
           a->owed == b->owed && same_levels(a, b);
}
