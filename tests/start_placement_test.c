// SPDX-License-Identifier: MIT
// Where particles are put: on lattices and at random.
#include "outcome.h"
#include "start_placement.h"
#include "suite.h"
#include <math.h>

static double distance(const brink_system *s, uint32_t i, uint32_t j)
{
    double r[3];
    brink_system_separation(s, i, j, 0.0, r);
    return sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
}

static double nearest(const brink_system *s)
{
    double least = (double)INFINITY;
    for (uint32_t i = 0; i < s->count; i++)
        for (uint32_t j = 0; j < i; j++)
            least = fmin(least, distance(s, i, j));
    return least;
}

// Every pair, not only those a grid thinks of.
static void assert_no_core_in_another(const brink_system *s)
{
    for (uint32_t i = 0; i < s->count; i++)
        for (uint32_t j = 0; j < i; j++) {
            const brink_potential *p = brink_system_potential(s, i, j);
            double r[3];
            brink_system_separation(s, i, j, 0.0, r);
            ck_assert_msg(brink_step_level_at(p, r) < brink_potential_levels(p),
                          "%u and %u at %a %a %a", i, j, r[0], r[1], r[2]);
        }
}

START_TEST(the_fcc_lattice_fills_a_cube_evenly)
{
    outcome o = good_start("box: {number_density: 0.5}\n"
                           "species: {A: {count: 1372, diameter: 1}}\n");
    const double proper = o.scene.length[0] / 7 * sqrt(0.5); // 1372 = 4 * 7^3
    // A coordinate is a sum, a quotient, a product, and a fraction and back: 5
    // roundings of less than L 2^-53 each, twice in a difference.
    ck_assert(fabs(nearest(&o.system) - proper) <=
              10 * sqrt(3) * o.scene.length[0] * 0x1p-53);
    forget(&o);
}
END_TEST

START_TEST(every_lattice_has_room_for_every_number)
{
    static const struct {
        const char *box, *lattice;
    } starts[] = {{"box: {number_density: 0.1}", "fcc"},
                  {"box: {number_density: 0.1}", "sc"},
                  {"box: {size: [40, 9, 7]}", "fcc"},
                  {"box: {size: [40, 9, 7]}", "sc"},
                  {"dimensions: 2\nbox: {number_density: 0.2}", "square"},
                  {"dimensions: 2\nbox: {number_density: 0.2}", "hexagonal"},
                  {"dimensions: 2\nbox: {size: [90, 9]}", "square"},
                  {"dimensions: 2\nbox: {size: [9, 90]}", "hexagonal"}};
    for (size_t k = 0; k < sizeof starts / sizeof *starts; k++)
        for (int count = 40; count <= 160; count += 7) {
            char text[256];
            snprintf(text, sizeof text,
                     "%s\nstart: {lattice: %s}\n"
                     "species: {A: {count: %d, diameter: 1}}\n",
                     starts[k].box, starts[k].lattice, count);
            outcome o = good_start(text);
            assert_no_core_in_another(&o.system);
            forget(&o);
        }
}
END_TEST

START_TEST(vacant_sites_are_spread_over_the_box)
{
    // 4 * 5 * 5 * 4 = 400 sites: taken in order, 330 leave the top layer empty.
    outcome o = good_start("box: {number_density: 0.1}\n"
                           "species: {A: {count: 330, diameter: 1}}\n");
    uint32_t layers[4] = {0};
    for (uint32_t i = 0; i < 330; i++)
        layers[o.system.particle[i].x[2] >> 62]++;
    for (int k = 0; k < 4; k++) { // 82.5, rounded at both ends of a layer
        ck_assert_uint_ge(layers[k], 81);
        ck_assert_uint_le(layers[k], 84);
    }
    forget(&o);
}
END_TEST

START_TEST(species_are_numbered_in_turn_and_shuffled_over_the_sites)
{
    outcome o = good_start("box: {number_density: 0.1}\n"
                           "species:\n"
                           "  A: {count: 1000, diameter: 1, mass: 1}\n"
                           "  B: {count: 372, diameter: 1.5, mass: 9}\n");
    uint32_t low = 0;
    for (uint32_t i = 0; i < 1372; i++)
        ck_assert_uint_eq(o.system.particle[i].species, i >= 1000);
    for (uint32_t i = 1000; i < 1372; i++)
        low += o.system.particle[i].x[2] < UINT64_C(1) << 63;
    // Half of 372, give or take 5 deviations of a binomial distribution, of
    // 9.6 each.  Laid in order of the sites, all or none would be low.
    ck_assert_uint_ge(low, 186 - 48);
    ck_assert_uint_le(low, 186 + 48);
    forget(&o);
}
END_TEST

#define RANDOM "start: {random: true}\n"
#define FEW    "species: {A: {count: 100, diameter: 1}}\n"
#define MANY   "species: {A: {count: 300, diameter: 1}}\n"
#define TWO_SIZES                                                                \
    "species: {A: {count: 300, diameter: 1}, B: {count: 30, diameter: 2.5}}\n"

START_TEST(random_insertion_leaves_no_core_in_another)
{
    static const char *const texts[] = {
        RANDOM "box: {packing_fraction: 0.3}\n" MANY,
        RANDOM "dimensions: 2\nbox: {packing_fraction: 0.45}\n" MANY,
        RANDOM "box: {size: [60, 4.1, 2.05]}\n" FEW, // two cells across, and four
        RANDOM "box: {packing_fraction: 0.3}\n" TWO_SIZES};
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++) {
        outcome o = good_start(texts[k]);
        assert_no_core_in_another(&o.system);
        forget(&o);
    }
}
END_TEST

START_TEST(random_insertion_reaches_every_part_of_the_box)
{
    outcome o = good_start("box: {number_density: 0.001}\nstart: {random: true}\n"
                           "species: {A: {count: 8000, diameter: 1}}\n");
    uint32_t octants[8] = {0};
    for (uint32_t i = 0; i < 8000; i++) {
        const uint64_t *x = o.system.particle[i].x;
        octants[x[0] >> 63 | x[1] >> 63 << 1 | x[2] >> 63 << 2]++;
    }
    for (int k = 0; k < 8; k++) { // 1000 +- 5 sqrt(1000 * 7 / 8)
        ck_assert_uint_ge(octants[k], 1000 - 148);
        ck_assert_uint_le(octants[k], 1000 + 148);
    }
    forget(&o);
}
END_TEST

int main(void)
{
    return RUN_SUITE("placement", 120, the_fcc_lattice_fills_a_cube_evenly,
                     every_lattice_has_room_for_every_number,
                     vacant_sites_are_spread_over_the_box,
                     species_are_numbered_in_turn_and_shuffled_over_the_sites,
                     random_insertion_leaves_no_core_in_another,
                     random_insertion_reaches_every_part_of_the_box);
}
