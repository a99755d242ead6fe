// SPDX-License-Identifier: MIT
// Scenes with faults: where each is, what is said of it, and how it looks.
#include "outcome.h"
#include "scene.h"
#include "suite.h"
#include <stdlib.h>
#include <string.h>

// The least that a scene needs: texts below are made of these and one fault.
#define BOX     "box: {number_density: 0.1}\n"
#define SPECIES "species: {A: {count: 100, diameter: 1}}\n"
#define TWO     "species:\n  A: {count: 50, mass: 1}\n  B: {count: 50, mass: 2}\n"

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
     "at most 1073741824"},
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
    {BOX "species: {A: {count: 1073741824, diameter: 1}, B: {count: 1, diameter: "
         "1}}\n",
     2, 10, "there are 1073741825 particles"},
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
    {ONE("[[6, -1], [1, .inf]]"), 1, 23, "not more than twice the 6"},
    // Found by fuzz/run_fuzz.c: at just twice, a pair meets in two images at
    // once, and the impulse could be for the other one.
    {"box: {size: [4, 8, 8]}\nspecies: {A: {count: 9}}\npotentials:\n  - "
     "between: [A, A]\n"
     "    steps: [[2, -1], [1, .inf]]\n",
     1, 13, "not more than twice the 2"},
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
    {BOX "species: {A: {count: 1, diameter: 1}}\nrun: {events: 5}\n", 3, 15,
     "one particle meets nobody"},
    {BOX SPECIES "run: {events: 1, time: 1}\n", 3, 18,
     "both 'events' and 'time'"},
    {BOX SPECIES "output: {trajectory: 0}\n", 3, 22, "must be more than 0"},
    {BOX SPECIES "output: {checkpoint: [1]}\n", 3, 22, "a list where a number"},
    // observe; the box is 10 long
    {BOX SPECIES "observe: 0.1\n", 3, 10, "observe: {every: 0.1}"},
    {BOX SPECIES "observe: {speeds: true}\n", 3, 10, "has no 'every'"},
    {BOX SPECIES "observe: {every: -1}\n", 3, 18, "must be more than 0"},
    {BOX SPECIES "observe: {ever: 1, every: 1}\n", 3, 11,
     "did you mean 'every'?"},
    {BOX SPECIES "observe: {every: 1, from: -2}\n", 3, 27, "begins at time 0"},
    {BOX SPECIES "observe: {every: 1, speeds: false}\n", 3, 29,
     "leave the key out"},
    {BOX SPECIES "observe: {every: 1, distances: {bins: 9}}\n", 3, 32,
     "distances has no 'up_to'"},
    {BOX SPECIES "observe: {every: 1, distances: {up_to: 5.1}}\n", 3, 40,
     "at most 5"},
    {BOX SPECIES "observe: {every: 1, distances: {up_to: 3, bins: 0}}\n", 3, 49,
     "at least 1"},
    {BOX SPECIES "observe: {every: 1, displacements: 5}\n", 3, 36,
     "displacements: {up_to: 5}"},
    {BOX SPECIES "observe: {every: 1, displacements: {}}\n", 3, 36,
     "displacements has no 'up_to'"},
    {BOX SPECIES "observe: {every: 0.1, displacements: {up_to: 0.1}}\n", 3, 46,
     "from 0.2 to 100"},
    {BOX SPECIES "observe: {every: 0.1, displacements: {up_to: 101}}\n", 3, 46,
     "from 0.2 to 100"},
    {BOX SPECIES "observe: {every: 0.63, displacements: {up_to: 9}}\n", 3, 47,
     "make 'every' at most 0.625"},
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
    // 2^30 particles of 256 bytes are 2^38; machines with as much are let off.
    outcome o = parse(BOX "species: {A: {count: 1073741824, diameter: 1}}\n");
    if (o.complaints)
        ck_assert_ptr_nonnull(strstr(o.said, "need 274877906944 bytes"));
    forget(&o);
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

int main(void)
{
    Suite *suite = suite_create("scene faults");
    TCase *tcase = tcase_create("faults");
    tcase_add_loop_test(tcase, one_fault_is_one_complaint_in_its_place, 0,
                        (int)(sizeof faults / sizeof *faults));
    tcase_add_test(tcase, all_faults_of_a_file_are_told_together);
    tcase_add_test(tcase, the_caret_stands_under_the_fault);
    tcase_add_test(tcase, a_tab_before_the_fault_keeps_the_caret_in_its_place);
    tcase_add_test(tcase, a_long_line_is_cut_around_the_caret);
    tcase_add_test(tcase, a_title_too_long_is_refused);
    tcase_add_test(tcase, more_particles_than_memory_are_refused_with_the_bytes);
    tcase_add_test(tcase, a_mebibyte_of_faults_is_listed_in_part);
    tcase_set_timeout(tcase, 120);
    suite_add_tcase(suite, tcase);
    return run_whole_suite(suite);
}
