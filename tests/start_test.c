// SPDX-License-Identifier: MIT
// Starts: where particles are put, how fast they are, and what cannot be.
#include "kinetic.h"
#include "species.h"
#include "start.h"
#include "suite.h"
#include "trajectory.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// What came of a start.
typedef struct outcome {
    int status;
    brink_scene scene;
    brink_system system;
    char *said;
} outcome;

static outcome start(const char *text)
{
    outcome o = {0};
    size_t length = 0;
    ck_assert_int_eq(
        brink_scene_parse(text, strlen(text), "t.yaml", "", &o.scene, stderr), 0);
    FILE *errors = open_memstream(&o.said, &length);
    o.status = brink_start_make(&o.scene, "t.yaml", &o.system, errors);
    fclose(errors);
    return o;
}

static outcome good_start(const char *text)
{
    outcome o = start(text);
    ck_assert_msg(o.status == 0, "%s\n%s", text, o.said);
    const char *fault = brink_system_is_valid(&o.system);
    ck_assert_msg(fault == NULL, "%s\n%s", text, fault);
    return o;
}

static void assert_refused(const char *text, const char *place, const char *words)
{
    outcome o = start(text);
    ck_assert_int_eq(o.status, -1);
    ck_assert_ptr_null(o.system.particle);
    ck_assert_msg(strncmp(o.said, place, strlen(place)) == 0, "not at %s:\n%s",
                  place, o.said);
    ck_assert_msg(strstr(o.said, words) != NULL, "no '%s' in\n%s", words, o.said);
    brink_scene_destroy(&o.scene);
    free(o.said);
}

static void forget(outcome *o)
{
    brink_scene_destroy(&o->scene);
    brink_system_destroy(&o->system);
    free(o->said);
}

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
    // 4 * 5 * 5 * 4 = 400 sites; in their order, 330 would leave the top layer
    // empty.
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

START_TEST(where_nothing_more_fits_at_random_it_is_said)
{
    assert_refused(
        "box: {packing_fraction: 0.45}\n"
        "species: {A: {count: 200, diameter: 1}}\nstart: {random: true}\n",
        "t.yaml:3:1: error: no more particles find room at random where 0.3",
        "start from a lattice");
}
END_TEST

START_TEST(cores_that_overlap_on_a_lattice_are_told_with_their_distance)
{
    // sc at packing 0.6: (pi/6 / 0.6)^(1/3) = 0.955 apart.
    assert_refused(
        "box: {packing_fraction: 0.6}\n"
        "species: {A: {count: 1000, diameter: 1}}\nstart: {lattice: sc}\n",
        "t.yaml:3:1: error: particles 0 (A) and 1 (A) start 0.955",
        "make the box wider");
}
END_TEST

START_TEST(the_box_is_pointed_at_where_the_start_is_not_given)
{
    assert_refused("species: {A: {count: 500, diameter: 1},\n"
                   "  B: {count: 5, diameter: 2}}\n"
                   "box: {packing_fraction: 0.6}\n",
                   "t.yaml:3:1: error: particles", "hard cores reach 1.5");
}
END_TEST

START_TEST(the_temperature_is_the_one_asked_for)
{
    static const int counts[] = {1, 2, 3, 10, 1000};
    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++)
        for (int seed = 0; seed < 40; seed++) {
            char text[256];
            snprintf(text, sizeof text,
                     "seed: %d\ndimensions: %d\nbox: {number_density: 0.01}\n"
                     "species: {A: {count: %d, mass: 0.7, diameter: 0.1}}\n"
                     "temperature: 1.%d\n",
                     seed, 2 + seed % 2, counts[k], seed);
            outcome o = good_start(text);
            const double t = brink_system_temperature(&o.system);
            ck_assert_msg(fabs(t - o.scene.temperature) <=
                              BRINK_KINETIC_ERROR * o.scene.temperature,
                          "%a, not %a, in\n%s", t, o.scene.temperature, text);
            forget(&o);
        }
}
END_TEST

START_TEST(the_centre_of_mass_is_at_rest)
{
    outcome o = good_start("box: {number_density: 0.1}\nspecies: \n"
                           "  A: {count: 700, diameter: 1, mass: 1}\n"
                           "  B: {count: 300, diameter: 1, mass: 9}\n");
    double p[3], sum = 0;
    brink_system_momentum(&o.system, p);
    for (uint32_t i = 0; i < 1000; i++)
        for (int a = 0; a < 3; a++)
            sum += (i < 700 ? 1 : 9) * fabs(o.system.particle[i].v[a]);
    // What is subtracted is rounded, the difference is rounded, the product is
    // rounded: 3 roundings of 2^-53 |m v| for each particle at the most.
    for (int a = 0; a < 3; a++)
        ck_assert_msg(fabs(p[a]) <= 3 * 0x1p-53 * sum, "%a", p[a]);
    forget(&o);
}
END_TEST

START_TEST(velocities_are_those_of_maxwell_and_boltzmann_in_every_species)
{
    outcome o =
        good_start("box: {number_density: 0.1}\ntemperature: 2.5\nspecies:\n"
                   "  A: {count: 20000, diameter: 1, mass: 1}\n"
                   "  B: {count: 20000, diameter: 1, mass: 16}\n");
    for (int a = 0; a < 2; a++) {
        const int n = 60000;
        double second = 0, fourth = 0;
        for (int k = 0; k < n; k++) {
            const double v = o.system.particle[20000 * a + k / 3].v[k % 3];
            const double u2 = o.scene.species[a].mass / 2.5 * v * v;
            second += u2 / n;
            fourth += u2 * u2 / n;
        }
        // Moments of the normal distribution, 1 and 3, within 5 deviations: those
        // of u^2 and u^4 are sqrt(3 - 1) and sqrt(105 - 9).
        ck_assert_msg(fabs(second - 1) < 5 * sqrt(2.0 / n), "%a", second);
        ck_assert_msg(fabs(fourth - 3) < 5 * sqrt(96.0 / n), "%a", fourth);
    }
    forget(&o);
}
END_TEST

START_TEST(a_seed_is_a_start_and_another_seed_another)
{
#define SEEDED(n)                                                                \
    "seed: " n "\nbox: {number_density: 0.1}\nstart: {random: true}\n"           \
    "species: {A: {count: 50, diameter: 1}}\n"
    outcome one = good_start(SEEDED("7")), same = good_start(SEEDED("7")),
            other = good_start(SEEDED("8"));
    const size_t bytes = 50 * sizeof *one.system.particle;
    ck_assert_int_eq(memcmp(one.system.particle, same.system.particle, bytes), 0);
    for (int i = 0; i < 50; i++) {
        ck_assert(one.system.particle[i].x[0] != other.system.particle[i].x[0]);
        ck_assert(one.system.particle[i].v[0] != other.system.particle[i].v[0]);
    }
    forget(&one);
    forget(&same);
    forget(&other);
}
END_TEST

START_TEST(the_year_is_a_power_of_two_near_the_time_to_an_event)
{
    // The mean speed is sqrt(8 / pi) = 1.596.  Dilute square wells: a meeting in
    // 1 / (sqrt(2) 1e-3 pi 9 1.596) = 15.7, a flight of 10 in 6.27; nearest 2^3.
    outcome o =
        good_start("box: {number_density: 1.0e-3}\n"
                   "species: {A: {count: 1372}}\npotentials:\n"
                   "  - {between: [A, A], steps: [[3, -1], [1, .inf]]}\n");
    ck_assert(o.system.year == 8.0);
    forget(&o);
    // Denser ones of reach 1.5: 1 / (sqrt(2) 0.5 pi 2.25 1.596) = 0.125 against
    // 0.789.
    o = good_start(
        "box: {number_density: 0.5}\nspecies: {A: {count: 500}}\npotentials:\n"
        "  - {between: [A, A], steps: [[1.5, -1], [1, .inf]]}\n");
    ck_assert(o.system.year == 0.125);
    forget(&o);
    // Discs: sqrt(pi / 2) = 1.253; 1 / (sqrt(2) 0.35 2 1.253) = 0.806 against
    // 1.35.
    o = good_start("dimensions: 2\nbox: {number_density: 0.35}\n"
                   "species: {A: {count: 500, diameter: 1}}\n");
    ck_assert(o.system.year == 1.0);
    // At rest there is nothing to wait for.
    for (uint32_t i = 0; i < 500; i++)
        memset(o.system.particle[i].v, 0, sizeof o.system.particle[i].v);
    ck_assert(brink_kinetic_year(&o.system) == 1.0);
    forget(&o);
}
END_TEST

// A start file in the working folder, gone again with the test that made it.
static const char *write_file(const char *text)
{
    static char path[] = "start_test_XXXXXX";
    strcpy(path, "start_test_XXXXXX");
    const int fd = mkstemp(path);
    ck_assert_int_ge(fd, 0);
    ck_assert_int_eq(write(fd, text, strlen(text)), (ssize_t)strlen(text));
    close(fd);
    return path;
}

static void scene_of_file(char *text, size_t size, const char *path,
                          const char *more)
{
    snprintf(
        text, size,
        "box: {size: [10, 12, 14]}\nstart: {file: %s}\n"
        "species: {A: {count: 2, diameter: 1}, B: {count: 1, diameter: 1}}\n%s",
        path, more);
}

#define LATTICE "Lattice=\"10 0 0 0 12 0 0 0 14\" "
#define MOVING  "Properties=species:S:1:pos:R:3:velo:R:3\n"

START_TEST(a_file_gives_positions_and_velocities_to_the_bit)
{
    char text[512];
    const char *path =
        write_file("3\n" LATTICE MOVING "B 1.1 2.2 3.3 0.1 0.2 0.3\n"
                   "A 4.4 -3 6.6 0.4 -0.5 0.6\nA 7.7 8.8 9.9 1 2 3\n");
    scene_of_file(text, sizeof text, path, "");
    outcome o = good_start(text);
    const brink_particle *p = o.system.particle;
    ck_assert_uint_eq(p[2].species, 1);
    ck_assert(p[2].x[0] == brink_system_fraction(&o.system, 0, 1.1));
    ck_assert(p[0].x[1] == brink_system_fraction(&o.system, 1, 9)); // -3, wrapped
    ck_assert(p[1].x[2] == brink_system_fraction(&o.system, 2, 9.9));
    ck_assert(p[2].v[0] == 0.1 && p[2].v[1] == 0.2 && p[2].v[2] == 0.3);
    ck_assert(p[0].v[1] == -0.5 && p[1].v[2] == 3.0); // not scaled, nor stopped
    forget(&o);
    unlink(path);
}
END_TEST

START_TEST(a_file_of_positions_gets_velocities_at_the_temperature)
{
    char text[512];
    const char *path = write_file("3\n" LATTICE "\nA 1 2 3\nB 4 5 6\nA 7 8 9\n");
    scene_of_file(text, sizeof text, path, "temperature: 3\n");
    outcome o = good_start(text);
    ck_assert(fabs(brink_system_temperature(&o.system) - 3) <=
              3 * BRINK_KINETIC_ERROR);
    forget(&o);
    unlink(path);
}
END_TEST

static void assert_file_refused(const char *file, const char *more,
                                const char *place, const char *words)
{
    char text[512], where[128];
    const char *path = write_file(file);
    scene_of_file(text, sizeof text, path, more);
    snprintf(where, sizeof where, "%s", *place == ':' ? path : place);
    assert_refused(text, where, words);
    unlink(path);
}

START_TEST(a_file_that_does_not_go_with_the_scene_is_refused)
{
#define AT "t.yaml:2:1: error: "
    assert_file_refused("3\n" LATTICE MOVING "A 1 2 3 0 0 0\nA 4 5 6 0 0 0\n"
                        "B 7 8 9 0 0 0\n",
                        "temperature: 1\n", "t.yaml:4:1: error: ",
                        "has velocities, and a temperature is given too");
    assert_file_refused("1\n" LATTICE "\nA 1 2 3\n", "", AT, "has 1 particles");
    assert_file_refused("3\n" LATTICE "\nA 1 2 3\nA 4 5 6\nA 7 8 9\n", "", AT,
                        "one more of its species");
    assert_file_refused("3\n" LATTICE "\nA 1 2 3\nA 4 5 6\nC 7 8 9\n", "", AT,
                        "of a species that the scene has not");
    assert_file_refused(
        "3\nLattice=\"10 0 0 0 12 0 0 0 14.1\"\nA 1 2 3\nA 4 5 6\n"
        "B 7 8 9\n",
        "", AT, "along z, and the scene 14");
    assert_file_refused("3\n" LATTICE "\nA 1 2 3\nA 4 5 6\nB 1.5 2 3.5\n", "", AT,
                        "start 0.707106781 apart, and their hard cores reach 1");
    assert_file_refused("3\n" LATTICE MOVING "A 1 2 3 0 0 0\nA 4 5 6 0 1e61 0\n"
                        "B 7 8 9 0 0 0\n",
                        "", AT, "a number beyond 1e60");
    assert_file_refused("3\n" LATTICE "\nA 1 2 3\nA 4 5 nan\nB 7 8 9\n", "", ":",
                        ":4: error: a position is not three finite numbers");
    assert_file_refused("", "", AT, "has no frame in it");
    assert_refused("box: {size: [10, 12, 14]}\nstart: {file: no_such.xyz}\n"
                   "species: {A: {count: 2, diameter: 1}}\n",
                   AT "no_such.xyz cannot be read: No such file",
                   "the scene's folder");
}
END_TEST

START_TEST(a_file_out_of_the_plane_is_refused)
{
    char text[512];
    const char *path = write_file("1\n" LATTICE MOVING "A 1 2 0 1 1 1\n");
    snprintf(text, sizeof text,
             "dimensions: 2\nstart: {file: %s}\nbox: {size: [10, 12]}\n"
             "species: {A: {count: 1, diameter: 1}}\n",
             path);
    assert_refused(text, "t.yaml:2:1: error: particle 0 of ",
                   "in the plane, or leaves it");
    unlink(path);
}
END_TEST

START_TEST(every_scene_of_the_house_starts)
{
    static const char *const files[] = {
        "square-well.yaml", "square-shoulder.yaml", "hard-spheres.yaml",
        "three-steps.yaml", "mixture.yaml",         "discs.yaml",
        "discs-well.yaml",  "cuboid.yaml"};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        char path[512];
        brink_scene scene;
        brink_system system;
        snprintf(path, sizeof path, "%s/%s", SCENES, files[k]);
        ck_assert_int_eq(brink_scene_read(path, &scene, stderr), 0);
        ck_assert_int_eq(brink_start_make(&scene, path, &system, stderr), 0);
        ck_assert_ptr_null(brink_system_is_valid(&system));
        brink_system_destroy(&system);
        brink_scene_destroy(&scene);
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "start", 120, the_fcc_lattice_fills_a_cube_evenly,
        every_lattice_has_room_for_every_number,
        vacant_sites_are_spread_over_the_box,
        species_are_numbered_in_turn_and_shuffled_over_the_sites,
        random_insertion_leaves_no_core_in_another,
        random_insertion_reaches_every_part_of_the_box,
        where_nothing_more_fits_at_random_it_is_said,
        cores_that_overlap_on_a_lattice_are_told_with_their_distance,
        the_box_is_pointed_at_where_the_start_is_not_given,
        the_temperature_is_the_one_asked_for, the_centre_of_mass_is_at_rest,
        velocities_are_those_of_maxwell_and_boltzmann_in_every_species,
        a_seed_is_a_start_and_another_seed_another,
        the_year_is_a_power_of_two_near_the_time_to_an_event,
        a_file_gives_positions_and_velocities_to_the_bit,
        a_file_of_positions_gets_velocities_at_the_temperature,
        a_file_that_does_not_go_with_the_scene_is_refused,
        a_file_out_of_the_plane_is_refused, every_scene_of_the_house_starts);
}
