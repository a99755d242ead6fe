// SPDX-License-Identifier: MIT
// Starts: a scene with its files made into a system, and what is said where not.
#include "outcome.h"
#include "start.h"
#include "start_kinetic.h"
#include "suite.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

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
    return RUN_SUITE("start", 120, where_nothing_more_fits_at_random_it_is_said,
                     cores_that_overlap_on_a_lattice_are_told_with_their_distance,
                     the_box_is_pointed_at_where_the_start_is_not_given,
                     a_seed_is_a_start_and_another_seed_another,
                     a_file_gives_positions_and_velocities_to_the_bit,
                     a_file_of_positions_gets_velocities_at_the_temperature,
                     a_file_that_does_not_go_with_the_scene_is_refused,
                     a_file_out_of_the_plane_is_refused,
                     every_scene_of_the_house_starts);
}
