// SPDX-License-Identifier: MIT
// Scenes: what good ones say, and that nothing crashes on bad ones.
#include "outcome.h"
#include "scene.h"
#include "suite.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// The least that a scene needs; texts are put together of these and more.
#define BOX     "box: {number_density: 0.1}\n"
#define SPECIES "species: {A: {count: 100, diameter: 1}}\n"

static brink_scene read_scene(const char *file)
{
    char path[512];
    brink_scene scene;
    snprintf(path, sizeof path, "%s/%s", SCENES, file);
    ck_assert_int_eq(brink_scene_read(path, &scene, stderr), 0);
    return scene;
}

START_TEST(the_papers_scene_reads_as_it_is_written)
{
    brink_scene s = read_scene("square-well.yaml");
    ck_assert_str_eq(s.title, "square well, sigma_2 = 3 sigma_1");
    ck_assert_uint_eq(s.seed, 1);
    ck_assert_int_eq(s.dimensions, 3);
    ck_assert_uint_eq(s.count, 1372);
    ck_assert_int_eq(s.species_count, 1);
    ck_assert_str_eq(s.species[0].name, "A");
    ck_assert(s.species[0].mass == 1.0 && s.species[0].diameter == 1.0);
    ck_assert_int_eq(s.potential[0].count, 2);
    ck_assert(s.potential[0].distance[0] == 3.0 &&
              s.potential[0].energy[0] == -1.0);
    ck_assert(s.potential[0].distance[1] == 1.0 &&
              isinf(s.potential[0].energy[1]));
    // V = N / 1e-3, so L is the cube root of 1372000: the nearest double to it or
    // the next, as the C library may round.
    ck_assert(fabs(s.length[0] - 0x1.bc78e84bb3092p+6) <= 0x1p-46);
    ck_assert(s.length[0] == s.length[1] && s.length[0] == s.length[2]);
    ck_assert_int_eq(s.start, BRINK_START_FCC);
    ck_assert(s.temperature == 1.0);
    ck_assert_int_eq(s.target, BRINK_TARGET_PER_PARTICLE);
    ck_assert(s.target_value == 500.0);
    ck_assert_uint_eq(brink_scene_events(&s), 686000);
    ck_assert_ptr_nonnull(strstr(s.text, "title: square well"));
    ck_assert_uint_eq(s.text_size, strlen(s.text));
    brink_scene_destroy(&s);
}
END_TEST

START_TEST(what_is_left_out_gets_its_default)
{
    outcome o = parse(BOX SPECIES);
    const brink_scene *s = &o.scene;
    ck_assert_msg(o.complaints == 0, "%s", o.said);
    ck_assert_str_eq(s->title, "");
    ck_assert_uint_eq(s->seed, 1);
    ck_assert_int_eq(s->dimensions, 3);
    ck_assert(s->species[0].mass == 1.0);
    ck_assert_int_eq(s->start, BRINK_START_FCC);
    ck_assert_int_eq(s->start_at.line, 1);
    ck_assert_int_eq(s->temperature_at.line, 0);
    ck_assert(s->temperature == 1.0 && s->target_value == 100.0);
    ck_assert(s->trajectory_every == 0.0 && s->checkpoint_every == 60.0);
    forget(&o);
}
END_TEST

START_TEST(every_key_arrives_where_it_belongs)
{
    outcome o =
        parse("title: 'all of it'\nseed: 4294967295\ndimensions: 2\n"
              "box: {size: [10, 20.5], periodic: [true, true]}\n"
              "species: {A+: {count: 3, mass: 2, diameter: 0.5}}\n"
              "start: {file: a/b.xyz}\ntemperature: 2.5e-1\n"
              "run: {time: 12}\noutput: {trajectory: 0.5, checkpoint: 10}\n");
    const brink_scene *s = &o.scene;
    ck_assert_msg(o.complaints == 0, "%s", o.said);
    ck_assert_str_eq(s->title, "all of it");
    ck_assert_uint_eq(s->seed, UINT32_MAX);
    ck_assert_int_eq(s->dimensions, 2);
    ck_assert(s->length[0] == 10.0 && s->length[1] == 20.5 &&
              s->length[2] == 1.0);
    ck_assert_str_eq(s->species[0].name, "A+");
    ck_assert(s->species[0].mass == 2.0 && s->species[0].diameter == 0.5);
    ck_assert_int_eq(s->start, BRINK_START_FILE);
    ck_assert_str_eq(s->start_file, "here/a/b.xyz");
    ck_assert(s->temperature == 0.25 && s->temperature_at.line == 7);
    ck_assert_int_eq(s->target, BRINK_TARGET_TIME);
    ck_assert(s->target_value == 12.0 && brink_scene_events(s) == UINT64_MAX);
    ck_assert(s->trajectory_every == 0.5 && s->checkpoint_every == 10.0);
    forget(&o);
}
END_TEST

START_TEST(a_packing_fraction_is_that_of_the_cores)
{
    brink_scene s = read_scene("discs.yaml");
    const double packing =
        400 * atan(1.0) / (s.length[0] * s.length[1]); // pi/4 d^2
    ck_assert(fabs(packing - 0.5) <=
              4 * 0x1p-53); // a root, a product, a quotient
    brink_scene_destroy(&s);
}
END_TEST

START_TEST(unequal_cores_may_fill_more_than_equal_ones)
{
    outcome o =
        parse("box: {packing_fraction: 0.76}\nspecies: {A: {count: 64, diameter: "
              "1}, B: {count: 640, diameter: 0.1}}\n");
    ck_assert_msg(o.complaints == 0, "%s", o.said);
    forget(&o);
}
END_TEST

START_TEST(unlike_pairs_are_mixed_unless_they_are_given)
{
    brink_scene s = read_scene("mixture.yaml");
    const brink_potential *ab = &s.potential[1], *ba = &s.potential[2];
    ck_assert_int_eq(ab->count, 2);
    ck_assert(ab->distance == ba->distance && ab->energy == ba->energy);
    ck_assert(ab->distance[0] == (1.5 + 2.4) / 2 &&
              ab->distance[1] == (1 + 1.6) / 2);
    ck_assert(ab->energy[0] == -sqrt(2.0) && isinf(ab->energy[1]));
    brink_scene_destroy(&s);

    outcome o =
        parse(BOX "species: {A: {count: 9, diameter: 1},"
                  " B: {count: 99, diameter: 2}}\n"
                  "potentials: [{between: [B, A], steps: [[1.25, .inf]]}]\n");
    ck_assert_msg(o.complaints == 0, "%s", o.said);
    ck_assert(o.scene.potential[1].distance[0] == 1.25);
    ck_assert(o.scene.potential[2].distance[0] == 1.25);
    forget(&o);
}
END_TEST

START_TEST(every_scene_of_the_house_is_good)
{
    static const char *const files[] = {
        "square-well.yaml", "square-shoulder.yaml", "hard-spheres.yaml",
        "three-steps.yaml", "mixture.yaml",         "discs.yaml",
        "discs-well.yaml",  "cuboid.yaml"};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        brink_scene s = read_scene(files[k]);
        ck_assert_uint_gt(s.count, 0);
        brink_scene_destroy(&s);
    }
}
END_TEST

START_TEST(windows_line_ends_and_a_byte_order_mark_are_text)
{
    outcome o = parse("\xef\xbb\xbf"
                      "title: \xc3\xa4\r\nseed: 7\r\n" BOX SPECIES);
    ck_assert_msg(o.complaints == 0, "%s", o.said);
    ck_assert_str_eq(o.scene.title, "\xc3\xa4");
    ck_assert_uint_eq(o.scene.seed, 7);
    forget(&o);
}
END_TEST

static void assert_unreadable(const char *path, const char *words)
{
    char *said = NULL;
    size_t length = 0;
    brink_scene scene;
    FILE *errors = open_memstream(&said, &length);
    const int complaints = brink_scene_read(path, &scene, errors);
    fclose(errors);
    ck_assert_int_eq(complaints, 1);
    ck_assert_msg(strncmp(said, path, strlen(path)) == 0 &&
                      strncmp(said + strlen(path), ":1:1: error: ", 13) == 0,
                  "%s", said);
    ck_assert_msg(strstr(said, words) != NULL, "no '%s' in\n%s", words, said);
    ck_assert_ptr_null(scene.species);
    free(said);
}

START_TEST(what_is_no_file_is_said_to_be_none)
{
    assert_unreadable(SCENES, "Is a directory");
    assert_unreadable(SCENES "/no such scene.yaml", "No such file");
    assert_unreadable("/dev/null", "nothing in this file");
}
END_TEST

START_TEST(a_file_beyond_a_mebibyte_is_refused_unread)
{
    const size_t size = ((size_t)1 << 20) + 1;
    char *text = malloc(size);
    memset(text, '#', size);
    outcome o = parse_bytes(text, size);
    ck_assert_int_eq(o.complaints, 1);
    ck_assert_ptr_nonnull(strstr(o.said, "larger than 1 MiB"));
    forget(&o);
    free(text);
}
END_TEST

START_TEST(a_nul_byte_is_no_text)
{
    static const char text[] = "title: a\0b\n" BOX SPECIES;
    outcome o = parse_bytes(text, sizeof text - 1);
    ck_assert_int_eq(o.complaints, 1);
    ck_assert_ptr_nonnull(strstr(o.said, "t.yaml:1:9: error: byte 8, 0x00"));
    forget(&o);
}
END_TEST

// Complaints are as many as are counted, and each has its three lines.
static void assert_consistent(const outcome *o, const char *about, size_t size)
{
    int lines = 0, heads = 0;
    for (const char *p = o->said; *p; p = strchr(p, '\n') + 1, lines++)
        heads += strncmp(p, "t.yaml:", 7) == 0;
    ck_assert_msg(heads == o->complaints && lines == 3 * o->complaints,
                  "%d counted, %d told in %d lines, about\n%.*s\n%s",
                  o->complaints, heads, lines, (int)size, about, o->said);
    ck_assert((o->complaints == 0) == (o->scene.species != NULL));
}

START_TEST(no_beginning_of_a_scene_does_harm)
{
    brink_scene s = read_scene("mixture.yaml");
    for (size_t size = 0; size <= s.text_size; size++) {
        char *text =
            malloc(size + 1); // of just this size, for the address sanitizer
        memcpy(text, s.text, size);
        outcome o = parse_bytes(text, size);
        assert_consistent(&o, text, size);
        forget(&o);
        free(text);
    }
    brink_scene_destroy(&s);
}
END_TEST

static uint64_t next_random(uint64_t *state) // splitmix64
{
    uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

// Puts a few bytes, or a few characters that mean something to YAML, anywhere.
static void mutate(char *text, size_t size, uint64_t *state)
{
    static const char signs[] = "{}[]:,-?&*!|>'\"%@`#\n\t 0123456789.einf~<";
    const uint64_t changes = 1 + next_random(state) % 4;
    for (uint64_t k = 0; k < changes; k++) {
        const uint64_t r = next_random(state);
        const size_t at = (size_t)(next_random(state) % size);
        text[at] = r & 7 ? signs[(r >> 3) % (sizeof signs - 1)] : (char)(r >> 8);
    }
}

START_TEST(no_mutation_of_a_scene_does_harm)
{
    static const char *const files[] = {"square-well.yaml", "mixture.yaml",
                                        "three-steps.yaml", "cuboid.yaml"};
    for (uint64_t seed = 1; seed <= 8000; seed++) {
        uint64_t state = seed;
        brink_scene s = read_scene(files[seed % 4]);
        char *text = malloc(s.text_size);
        memcpy(text, s.text, s.text_size);
        mutate(text, s.text_size, &state);
        outcome o = parse_bytes(text, s.text_size);
        ck_assert_msg(o.complaints >= 0, "seed %" PRIu64, seed);
        assert_consistent(&o, text, s.text_size);
        forget(&o);
        free(text);
        brink_scene_destroy(&s);
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "scene", 300, the_papers_scene_reads_as_it_is_written,
        what_is_left_out_gets_its_default, every_key_arrives_where_it_belongs,
        a_packing_fraction_is_that_of_the_cores,
        unequal_cores_may_fill_more_than_equal_ones,
        unlike_pairs_are_mixed_unless_they_are_given,
        every_scene_of_the_house_is_good,
        windows_line_ends_and_a_byte_order_mark_are_text,
        what_is_no_file_is_said_to_be_none,
        a_file_beyond_a_mebibyte_is_refused_unread, a_nul_byte_is_no_text,
        no_beginning_of_a_scene_does_harm, no_mutation_of_a_scene_does_harm);
}
