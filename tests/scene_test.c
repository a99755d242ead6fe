// SPDX-License-Identifier: MIT
// Scenes: what good ones say, and what is said of bad ones.
#include "scene.h"
#include <check.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// A parsed text and all that was said of it.
typedef struct outcome {
    brink_scene scene;
    int complaints;
    char *said;
} outcome;

static outcome parse_bytes(const char *text, size_t size)
{
    outcome o = {0};
    size_t length = 0;
    FILE *errors = open_memstream(&o.said, &length);
    o.complaints =
        brink_scene_parse(text, size, "t.yaml", "here", &o.scene, errors);
    fclose(errors);
    return o;
}

static outcome parse(const char *text)
{
    return parse_bytes(text, strlen(text));
}

static void forget(outcome *o)
{
    brink_scene_destroy(&o->scene);
    free(o->said);
}

static brink_scene read_scene(const char *file)
{
    char path[512];
    brink_scene scene;
    snprintf(path, sizeof path, "%s/%s", SCENES, file);
    ck_assert_int_eq(brink_scene_read(path, &scene, stderr), 0);
    return scene;
}

// The least that a scene needs; texts below are put together of these and one
// fault.
#define BOX     "box: {number_density: 0.1}\n"
#define SPECIES "species: {A: {count: 100, diameter: 1}}\n"
#define TWO     "species:\n  A: {count: 50, mass: 1}\n  B: {count: 50, mass: 2}\n"

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

// A text with one fault: where it is, and words of what is said of it.
static const struct fault {
    const char *text;
    int line, column;
    const char *words;
} faults[] = {
    // keys
    {"titel: x\n" BOX SPECIES, 1, 1, "did you mean 'title'?"},
    {"sed: 1\n" BOX SPECIES, 1, 1, "did you mean 'seed'?"},
    {"gravity: 1\n" BOX SPECIES, 1, 1, "its keys are: title, seed"},
    {"<<: {seed: 1}\n" BOX SPECIES, 1, 1, "has no key '<<'"},
    {BOX SPECIES "seed: 1\nseed: 1\n", 4, 1, "stands in line 3 already"},
    {BOX SPECIES "title:\n", 3, 1, "'title' has no value"},
    {BOX SPECIES "? [a, b]\n: 1\n", 3, 3, "a key is a list"},
    {BOX, 1, 1, "has no species"},
    {SPECIES, 1, 1, "has no box"},
    {"box:\n" SPECIES, 1, 1, "'box' has no value"},
    {"- a\n- b\n", 1, 1, "a scene is a list"},
    {"12\n", 1, 1, "a scene is a bare word"},
    // texts
    {"title: [a]\n" BOX SPECIES, 1, 8, "a list where a line of text is wanted"},
    {"title: \"a\\nb\"\n" BOX SPECIES, 1, 8, "line break or control character"},
    {"title: \"a\\e[31m\"\n" BOX SPECIES, 1, 8,
     "line break or control character"},
    {"title: \"a\\0b\"\n" BOX SPECIES, 1, 8, "NUL"},
    // counts
    {"seed: -1\n" BOX SPECIES, 1, 7, "cannot be negative"},
    {"seed: 1.5\n" BOX SPECIES, 1, 7, "must be a whole number"},
    {"seed: 1e3\n" BOX SPECIES, 1, 7, "write 1000"},
    {"seed: 0x10\n" BOX SPECIES, 1, 7, "without leading zeros"},
    {"seed: 017\n" BOX SPECIES, 1, 7, "without leading zeros"},
    {"seed: 1_000\n" BOX SPECIES, 1, 7, "without underscores"},
    {"seed: 1,5\n" BOX SPECIES, 1, 7, "the decimal sign is a point"},
    {"seed: true\n" BOX SPECIES, 1, 7, "a truth value is not a number"},
    {"seed: '1'\n" BOX SPECIES, 1, 7, "take off the quotes"},
    {"seed: {a: 1}\n" BOX SPECIES, 1, 7, "a map where a whole number"},
    {"seed: 4294967296\n" BOX SPECIES, 1, 7, "at most 4294967295"},
    {"seed: 99999999999999999999\n" BOX SPECIES, 1, 7, "at most 4294967295"},
    {"seed: 1e999\n" BOX SPECIES, 1, 7, "not a whole number"},
    {"dimensions: 4\n" BOX SPECIES, 1, 13, "at most 3"},
    {"dimensions: 1\n" BOX SPECIES, 1, 13, "at least 2"},
    {BOX "species: {A: {count: 0, diameter: 1}}\n", 2, 22, "at least 1"},
    {BOX "species: {A: {count: 1000000000000, diameter: 1}}\n", 2, 22,
     "at most 2147483648"},
    {BOX "species: {A: {count: 1e12, diameter: 1}}\n", 2, 22,
     "write 1000000000000"},
    // numbers
    {BOX SPECIES "temperature: hot\n", 3, 14, "'hot', which is not a number"},
    {BOX SPECIES "temperature: .nan\n", 3, 14, "write a finite number"},
    {BOX SPECIES "temperature: nan\n", 3, 14, "write a finite number"},
    {BOX SPECIES "temperature: -.inf\n", 3, 14, "write a finite number"},
    {BOX SPECIES "temperature: .inf\n", 3, 14, "write a finite number"},
    {BOX SPECIES "temperature: 1e999\n", 3, 14, "beyond the magnitudes"},
    {BOX SPECIES "temperature: 1e-999\n", 3, 14, "beyond the magnitudes"},
    {BOX SPECIES "temperature: 1e61\n", 3, 14, "nearer to 1"},
    {BOX SPECIES "temperature: 0\n", 3, 14, "must be more than 0"},
    {BOX SPECIES "temperature: -1\n", 3, 14, "must be more than 0"},
    {BOX SPECIES "temperature: '1'\n", 3, 14, "take off the quotes"},
    {BOX SPECIES "temperature: 1,5\n", 3, 14, "the decimal sign is a point"},
    {BOX SPECIES "temperature: 1.5 kT\n", 3, 14, "without a unit"},
    {BOX SPECIES "temperature: 0x1p3\n", 3, 14, "in decimal"},
    {BOX SPECIES "temperature: 1e\n", 3, 14, "not a number"},
    {BOX SPECIES "temperature: .\n", 3, 14, "not a number"},
    {BOX SPECIES "temperature: [1]\n", 3, 14, "a list where a number is wanted"},
    // box
    {"box: {}\n" SPECIES, 1, 6, "needs one of"},
    {"box: 10\n" SPECIES, 1, 6, "where keys with values are wanted"},
    {"box: {number_density: 0.1, size: [9, 9, 9]}\n" SPECIES, 1, 28,
     "both 'number_density' and 'size'"},
    {"box: {size: 9}\n" SPECIES, 1, 13, "where a list of 3 is wanted"},
    {"box: {size: [9, 9]}\n" SPECIES, 1, 13, "has 2 items where 3"},
    {"dimensions: 2\nbox: {size: [20, 20, 20]}\n" SPECIES, 2, 13,
     "3 items where 2"},
    {"box: {size: [9, -9, 9]}\n" SPECIES, 1, 17, "must be more than 0"},
    {"box: {size: [90, 1.99, 90]}\n" SPECIES, 1, 13, "the box is 1.99 wide"},
    {"box: {size: [90, 90, 1e9]}\n" SPECIES, 1, 13, "more than 2^24 times"},
    {"box: {packing_fraction: 0.75}\n" SPECIES, 1, 25, "not more than 0.74048"},
    {"dimensions: 2\nbox: {packing_fraction: 0.91}\n" SPECIES, 2, 25,
     "not more than 0.9069"},
    {"box: {number_density: 1.4143}\n" SPECIES, 1, 23, "not more than 0.74048"},
    {"box: {number_density: 0.1, periodic: [true, true, false]}\n" SPECIES, 1, 51,
     "no walls yet"},
    {"box: {number_density: 0.1, periodic: [true, true]}\n" SPECIES, 1, 38,
     "2 items where 3"},
    {"box: {number_density: 0.1, periodic: [true, yes, true]}\n" SPECIES, 1, 45,
     "not a truth value"},
    {"box: {packing_fraction: 0.1}\nspecies: {A: {count: 99}}\npotentials:\n"
     "  - {between: [A, A], steps: [[1, 1]]}\n",
     1, 25, "no species has a hard core"},
    // species
    {BOX "species: []\n", 2, 10, "where keys with values are wanted"},
    {BOX "species: {}\n", 2, 10, "there are 0 species"},
    {BOX "species: {A: 5}\n", 2, 14, "where keys with values are wanted"},
    {BOX "species: {A: {diameter: 1}}\n", 2, 11, "species 'A' has no count"},
    {BOX "species: {A: {count: 100}}\n", 2, 11, "how particles of 'A' meet"},
    {BOX "species: {A: {count: 100, diameter: -1}}\n", 2, 37,
     "must be more than 0"},
    {BOX "species: {A: {count: 100, diameter: 1, mass: 0}}\n", 2, 46,
     "more than 0"},
    {BOX "species: {A: {cuont: 100, count: 100, diameter: 1}}\n", 2, 15,
     "did you mean 'count'?"},
    {BOX "species: {1a: {count: 100, diameter: 1}}\n", 2, 11, "a letter first"},
    {BOX "species: {a b: {count: 100, diameter: 1}}\n", 2, 11,
     "cannot be a species"},
    {BOX "species: {abcdefghijklmnop: {count: 100, diameter: 1}}\n", 2, 11,
     "up to 15 letters"},
    {BOX "species: {A: {count: 50, diameter: 1}, A: {count: 50, diameter: 1}}\n",
     2, 40, "'A' is given again"},
    {BOX "species: {A: {count: 2147483648, diameter: 1}, B: {count: 1, diameter: "
         "1}}\n",
     2, 10, "there are 2147483649 particles"},
    // potentials
    {BOX SPECIES "potentials: {between: [A, A]}\n", 3, 13, "is not a list"},
    {BOX SPECIES "potentials: [1]\n", 3, 14, "where keys with values are wanted"},
    {BOX SPECIES "potentials: [{between: [A, A]}]\n", 3, 14, "has no 'steps'"},
    {BOX SPECIES "potentials: [{steps: [[1, 1]]}]\n", 3, 14, "has no 'between'"},
    {BOX SPECIES "potentials: [{between: [A, A], steps: [[1, .inf]]}]\n", 2, 11,
     "has a diameter and a potential"},
    {BOX TWO "potentials: [{between: [A, A], steps: [[1, .inf]]}]\n", 4, 3,
     "how particles of 'B' meet"},
    {BOX SPECIES "potentials: [{between: [A, C], steps: [[1, .inf]]}]\n", 3, 28,
     "no species 'C'"},
    {BOX "species: {Argon: {count: 99}}\npotentials: [{between: [Argon, Argno], "
         "steps: [[1, .inf]]}]\n",
     3, 32, "did you mean 'Argon'?"},
    {BOX SPECIES "potentials: [{between: [A, [A]], steps: [[1, .inf]]}]\n", 3, 28,
     "a list where a line of text"},
    {BOX SPECIES "potentials: [{between: [A], steps: [[1, .inf]]}]\n", 3, 24,
     "has 1 item where 2"},
    {BOX SPECIES "potentials: [{between: [A, A], steps: []}]\n", 3, 39,
     "1 to 1000"},
    {BOX SPECIES "potentials: [{between: [A, A], steps: 3}]\n", 3, 39,
     "1 to 1000"},
#define ONE(steps)                                                               \
    BOX "species: {A: {count: 99}}\npotentials:\n  - between: [A, A]\n    "      \
        "steps: " steps "\n"
    {ONE("[3]"), 5, 13, "a bare word where a list of 2 is wanted"},
    {ONE("[[3, -1, 2]]"), 5, 13, "3 items where 2"},
    {ONE("[[3, .inf], [1, -1]]"), 5, 17, "a hard core is not the last step"},
    {ONE("[[1, -2], [3, -1]]"), 5, 22, "from the outermost to the innermost"},
    {ONE("[[1, -2], [1, .inf]]"), 5, 22, "from the outermost to the innermost"},
    {ONE("[[1, -.inf]]"), 5, 17, "write a finite number"},
    {ONE("[[1, .nan]]"), 5, 17, "write a finite number"},
    {ONE("[[1, '.inf']]"), 5, 17, "take off the quotes"},
    {ONE("[[.inf, 1]]"), 5, 14, "write a finite number"},
    {ONE("[[0, .inf]]"), 5, 14, "must be more than 0"},
    {ONE("[[6, -1], [1, .inf]]"), 1, 23, "less than twice the 6"},
    {ONE("[[1, .inf]]") "  - {between: [A, A], steps: [[1, .inf]]}\n", 6, 15,
     "is given again"},
#define MIXED(a, b)                                                              \
    BOX TWO "potentials:\n  - {between: [A, A], steps: " a "}\n"                 \
            "  - {between: [B, B], steps: " b "}\n"
    {MIXED("[[1, .inf]]", "[[2, -1], [1, .inf]]"), 3, 3,
     "different numbers of steps"},
    {MIXED("[[1, .inf]]", "[[1, 5]]"), 3, 3, "the other has none"},
    {MIXED("[[2, 1], [1, .inf]]", "[[2, -1], [1, .inf]]"), 3, 3,
     "attracts in one of them"},
    {MIXED("[[2, 1], [1.9999999999999998, .inf]]",
           "[[1.0000000000000002, 1], [1, .inf]]"),
     3, 3, "would be at one distance"},
    // start, run, output
    {BOX SPECIES "start: {}\n", 3, 8, "needs one of"},
    {BOX SPECIES "start: fcc\n", 3, 8, "where keys with values are wanted"},
    {BOX SPECIES "start: {lattice: fc}\n", 3, 18, "write fcc or sc"},
    {BOX SPECIES "start: {lattice: square}\n", 3, 18,
     "no lattice in 3 dimensions"},
    {"dimensions: 2\n" BOX SPECIES "start: {lattice: fcc}\n", 4, 18,
     "write square or hexagonal"},
    {BOX SPECIES "start: {random: false}\n", 3, 17, "give a lattice instead"},
    {BOX SPECIES "start: {random: 1}\n", 3, 17, "not a truth value"},
    {BOX SPECIES "start: {lattice: fcc, random: true}\n", 3, 23,
     "keep one of them"},
    {BOX SPECIES "start: {file: [a]}\n", 3, 15, "a list where a line of text"},
    {BOX SPECIES "run: {}\n", 3, 6, "needs one of"},
    {BOX SPECIES "run: {events: 0}\n", 3, 15, "at least 1"},
    {BOX SPECIES "run: {events: 1e6}\n", 3, 15, "write 1000000"},
    {BOX SPECIES "run: {time: -1}\n", 3, 13, "must be more than 0"},
    {BOX SPECIES "run: {events_per_particle: 1e14}\n", 3, 28, "more than 2^53"},
    {BOX SPECIES "run: {events: 1, time: 1}\n", 3, 18,
     "both 'events' and 'time'"},
    {BOX SPECIES "output: {trajectory: 0}\n", 3, 22, "must be more than 0"},
    {BOX SPECIES "output: {checkpoint: [1]}\n", 3, 22, "a list where a number"},
    // YAML that scenes have no use for, and what is none
    {"title: &a x\n" BOX SPECIES, 1, 8, "no anchors"},
    {"title: *a\n" BOX SPECIES, 1, 8, "no aliases"},
    {"title: !!str x\n" BOX SPECIES, 1, 8, "no tags"},
    {"box: !b {number_density: 0.1}\n" SPECIES, 1, 6, "no tags"},
    {BOX SPECIES "---\n" BOX SPECIES, 3, 1, "a second document"},
    {"title: [[[[[[[[[[[[x]]]]]]]]]]]]\n" BOX SPECIES, 1, 15, "more than 8 deep"},
    {BOX SPECIES "run: {time: 1\n", 4, 1, "look from line 3 on"},
    {BOX "\tspecies: x\n", 2, 1, "never tabs"},
    {"title: 'x\n" BOX SPECIES, 4, 1, "look from line 1 on"},
    {"", 1, 1, "nothing in this file"},
    {"# a comment\n\n", 1, 1, "nothing in this file"},
    {"title: \xff\xfe\n", 1, 8, "byte 7, 0xff, is not text"},
    {"title: \xc0\xaf\n", 1, 8, "is not text"},           // an overlong '/'
    {"title: \xed\xa0\x80\n", 1, 8, "is not text"},       // half a surrogate
    {"title: \xf4\x90\x80\x80\n", 1, 8, "is not text"},   // beyond U+10FFFF
    {"seed: 1\n# \xe2\x80\xa8 x\n", 2, 3, "is not text"}, // U+2028, a line break
    {"seed: 1\rseed: 2\n", 1, 8, "byte 7, 0x0d"},
    {"\x7f"
     "ELF\x02\x01\x01",
     1, 1, "is this the right file?"},
};

START_TEST(one_fault_is_one_complaint_in_its_place)
{
    const struct fault *f = &faults[_i];
    char place[64];
    outcome o = parse(f->text);
    snprintf(place, sizeof place, "t.yaml:%d:%d: error: ", f->line, f->column);
    ck_assert_msg(o.complaints == 1, "%d complaints about\n%s\n%s", o.complaints,
                  f->text, o.said);
    ck_assert_msg(strncmp(o.said, place, strlen(place)) == 0,
                  "not at %d:%d in\n%s\n%s", f->line, f->column, f->text, o.said);
    ck_assert_msg(strstr(o.said, f->words) != NULL, "no '%s' about\n%s\n%s",
                  f->words, f->text, o.said);
    ck_assert_ptr_null(o.scene.species); // a bad scene is empty
    forget(&o);
}
END_TEST

START_TEST(all_faults_of_a_file_are_told_together)
{
    outcome o = parse("titel: x\n"
                      "seed: 1.5\n"
                      "box: {number_density: -1}\n"
                      "species: {A: {count: two, mass: .nan}}\n"
                      "start: {lattice: bcc}\n"
                      "temperature: cold\n"
                      "potentials: [{between: [A, B], steps: [[1, -.inf]]}]\n"
                      "run: {evnts: 3}\n");
    static const char *const places[] = {"1:1",  "2:7",  "3:23", "4:22", "4:33",
                                         "5:18", "6:14", "7:28", "8:7"};
    for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
        char place[32];
        snprintf(place, sizeof place, "t.yaml:%s: error: ", places[k]);
        ck_assert_msg(strstr(o.said, place) != NULL, "none at %s:\n%s", places[k],
                      o.said);
    }
    ck_assert_int_eq(o.complaints, 9);
    forget(&o);
}
END_TEST

START_TEST(the_caret_stands_under_the_fault)
{
    outcome o = parse("seed: x\n" BOX SPECIES);
    ck_assert_str_eq(
        o.said, "t.yaml:1:7: error: seed is 'x', which is not a whole number\n"
                "  seed: x\n"
                "        ^ write a number, such as 12, 1.5 or 1.0e-3, without a "
                "unit\n");
    forget(&o);
}
END_TEST

START_TEST(a_tab_before_the_fault_keeps_the_caret_in_its_place)
{
    outcome o = parse("box: {\t\"\xc3\xa4\": 0.1}\n" SPECIES);
    ck_assert_msg(
        strstr(o.said, "\n  box: {\t\"\xc3\xa4\": 0.1}\n        \t^ ") != NULL,
        "%s", o.said);
    forget(&o);
}
END_TEST

START_TEST(a_long_line_is_cut_around_the_caret)
{
    char text[1024] = "{title: '";
    memset(text + strlen(text), 'x', 190);
    strcat(text, "', seed: bad, box: {number_density: 0.1}, ");
    strcat(text, SPECIES);
    strcat(text, "}");
    outcome o = parse(text);
    ck_assert_int_eq(o.complaints, 1);
    const char *echo = strchr(o.said, '\n') + 1, *caret = strchr(echo, '\n') + 1;
    ck_assert_int_lt(caret - echo,
                     86); // two of margin, 76, and dots at both ends
    ck_assert_msg(strncmp(echo + strcspn(caret, "^"), "bad", 3) == 0, "%s",
                  o.said);
    forget(&o);
}
END_TEST

START_TEST(a_title_too_long_is_refused)
{
    char text[512] = "title: ";
    memset(text + 7, 'x', BRINK_TITLE_MOST + 1);
    strcat(text, "\n" BOX SPECIES);
    outcome o = parse(text);
    ck_assert_int_eq(o.complaints, 1);
    ck_assert_ptr_nonnull(strstr(o.said, "201 bytes long"));
    forget(&o);
}
END_TEST

START_TEST(more_particles_than_memory_are_refused_with_the_bytes)
{
    // 2^31 particles of 256 bytes are 2^39; machines with as much are let off.
    outcome o = parse(BOX "species: {A: {count: 2147483648, diameter: 1}}\n");
    if (o.complaints)
        ck_assert_ptr_nonnull(strstr(o.said, "need 549755813888 bytes"));
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

// 150 000 faults in one line: nothing in reading them takes time by the square.
START_TEST(a_mebibyte_of_faults_is_listed_in_part)
{
    const int pieces = 150000;
    char *text = malloc((size_t)pieces * 6 + 3);
    char *end = text + sprintf(text, "{");
    for (int k = 0; k < pieces; k++)
        end += sprintf(end, "a: b, ");
    strcpy(end, "}");
    outcome o = parse(text);
    int lines = 0;
    for (const char *p = o.said; *p; p = strchr(p, '\n') + 1)
        lines++;
    ck_assert_int_ge(o.complaints, pieces);
    ck_assert_int_eq(lines, 3 * BRINK_COMPLAINTS_MOST + 1);
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
    brink_scene s = read_scene(files[_i]);
    char *text = malloc(s.text_size);
    for (uint64_t seed = 1; seed <= 2000; seed++) {
        uint64_t state = seed;
        memcpy(text, s.text, s.text_size);
        mutate(text, s.text_size, &state);
        outcome o = parse_bytes(text, s.text_size);
        ck_assert_msg(o.complaints >= 0, "seed %" PRIu64, seed);
        assert_consistent(&o, text, s.text_size);
        forget(&o);
    }
    free(text);
    brink_scene_destroy(&s);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("scene");
    TCase *good = tcase_create("good"), *bad = tcase_create("bad");
    tcase_add_test(good, the_papers_scene_reads_as_it_is_written);
    tcase_add_test(good, what_is_left_out_gets_its_default);
    tcase_add_test(good, every_key_arrives_where_it_belongs);
    tcase_add_test(good, a_packing_fraction_is_that_of_the_cores);
    tcase_add_test(good, unequal_cores_may_fill_more_than_equal_ones);
    tcase_add_test(good, unlike_pairs_are_mixed_unless_they_are_given);
    tcase_add_test(good, every_scene_of_the_house_is_good);
    tcase_add_test(good, windows_line_ends_and_a_byte_order_mark_are_text);
    tcase_add_loop_test(bad, one_fault_is_one_complaint_in_its_place, 0,
                        (int)(sizeof faults / sizeof *faults));
    tcase_add_test(bad, all_faults_of_a_file_are_told_together);
    tcase_add_test(bad, the_caret_stands_under_the_fault);
    tcase_add_test(bad, a_tab_before_the_fault_keeps_the_caret_in_its_place);
    tcase_add_test(bad, a_long_line_is_cut_around_the_caret);
    tcase_add_test(bad, a_title_too_long_is_refused);
    tcase_add_test(bad, more_particles_than_memory_are_refused_with_the_bytes);
    tcase_add_test(bad, what_is_no_file_is_said_to_be_none);
    tcase_add_test(bad, a_file_beyond_a_mebibyte_is_refused_unread);
    tcase_add_test(bad, a_mebibyte_of_faults_is_listed_in_part);
    tcase_add_test(bad, a_nul_byte_is_no_text);
    tcase_add_test(bad, no_beginning_of_a_scene_does_harm);
    tcase_add_loop_test(bad, no_mutation_of_a_scene_does_harm, 0, 4);
    tcase_set_timeout(bad, 300);
    suite_add_tcase(suite, good);
    suite_add_tcase(suite, bad);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    const int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
