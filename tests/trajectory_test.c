// SPDX-License-Identifier: MIT
// Extended XYZ: written, read again, and refused where it is broken.
#include "start.h"
#include "suite.h"
#include "trajectory.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static brink_system make(const char *text)
{
    brink_scene scene;
    brink_system system;
    ck_assert_int_eq(
        brink_scene_parse(text, strlen(text), "t.yaml", "", &scene, stderr), 0);
    ck_assert_int_eq(brink_start_make(&scene, "t.yaml", &system, stderr), 0);
    brink_scene_destroy(&scene);
    return system;
}

#define MIXTURE                                                                  \
    "box: {size: [10, 12.3, 14]}\nstart: {random: true}\n"                       \
    "species:\n  Ar: {count: 5, diameter: 1, mass: 40}\n"                        \
    "  small: {count: 3, diameter: 0.3, mass: 0.1}\n"

static const char *line_of(const char *text, int number)
{
    for (; number > 1; number--)
        text = strchr(text, '\n') + 1;
    return text;
}

START_TEST(a_frame_is_written_as_every_reader_wants_it)
{
    brink_system s = make(MIXTURE);
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    ck_assert_int_eq(brink_trajectory_write(out, &s, 0.0, 0.1), 0);
    fclose(out);
    const char *comment =
        "8\nLattice=\"10 0 0 0 12.300000000000001 0 0 0 14\" "
        "Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:id:I:1 "
        "pbc=\"T T T\" Time=0.10000000000000001 names=\"Ar:5 small:3\"\n";
    ck_assert_msg(strncmp(text, comment, strlen(comment)) == 0, "%s", text);
    ck_assert(strncmp(line_of(text, 3), "Ar ", 3) == 0); // an element
    ck_assert(strncmp(line_of(text, 8), "X ", 2) == 0);  // none
    ck_assert_ptr_nonnull(strstr(line_of(text, 3), " 0.5 40 0\n"));
    ck_assert_ptr_nonnull(strstr(line_of(text, 10), " 0.14999999999999999 0.1"));
    ck_assert_ptr_null(strchr(text, '\r'));
    ck_assert_int_eq(text[size - 1], '\n');
    free(text);
    brink_system_destroy(&s);
}
END_TEST

START_TEST(a_plane_is_written_as_one)
{
    brink_system s = make("dimensions: 2\nbox: {size: [10, 12]}\n"
                          "species: {A: {count: 3, diameter: 1}}\n");
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    ck_assert_int_eq(brink_trajectory_write(out, &s, 0.0, 0.0), 0);
    fclose(out);
    ck_assert_ptr_nonnull(strstr(text, "Lattice=\"10 0 0 0 12 0 0 0 1\""));
    ck_assert_ptr_nonnull(strstr(text, "pbc=\"T T F\""));
    free(text);
    brink_system_destroy(&s);
}
END_TEST

// Also leaves the file for trajectory_check.py.
START_TEST(what_is_written_is_read_again_to_the_bit)
{
    brink_system s = make(MIXTURE);
    brink_frame frame;
    s.particle[4].v[1] = -0x1.23456789abcdep-1040; // a subnormal is a number
    s.particle[5].v[2] = -0.0;
    FILE *file = fopen("trajectory_test.xyz", "w+");
    const double offsets[] = {0.0, 0.1 * s.year, 0.9 * s.year};
    for (int k = 0; k < 3; k++)
        ck_assert_int_eq(brink_trajectory_write(file, &s, offsets[k], offsets[k]),
                         0);
    rewind(file);
    for (int k = 0; k < 3; k++) {
        ck_assert_int_eq(brink_trajectory_read(file, "t.xyz", &frame, stderr), 1);
        ck_assert_uint_eq(frame.count, 8);
        for (uint32_t i = 0; i < 8; i++) {
            brink_system_advance(&s, i,
                                 0.0); // nobody has moved: it was written so
            brink_particle there = s.particle[i];
            brink_system alone = s;
            alone.particle = &there;
            brink_system_advance(&alone, 0, offsets[k]);
            ck_assert_str_eq(frame.species[i], i < 5 ? "Ar" : "small");
            for (int a = 0; a < 3; a++) {
                const double x = brink_system_coordinate(&s, a, there.x[a]);
                ck_assert_msg(frame.x[i][a] == x, "%a, not %a", frame.x[i][a], x);
                ck_assert_int_eq(
                    memcmp(&frame.v[i][a], &there.v[a], sizeof(double)), 0);
            }
        }
        for (int a = 0; a < 3; a++)
            ck_assert(frame.length[a] == s.length[a]);
        brink_frame_destroy(&frame);
    }
    ck_assert_int_eq(brink_trajectory_read(file, "t.xyz", &frame, stderr), 0);
    fclose(file);
    brink_system_destroy(&s);
}
END_TEST

START_TEST(a_full_disk_is_an_error)
{
    brink_system s = make(MIXTURE);
    FILE *full = fopen("/dev/full", "w");
    if (full) {
        setvbuf(full, NULL, _IONBF, 0);
        ck_assert_int_eq(brink_trajectory_write(full, &s, 0.0, 0.0), -1);
        fclose(full);
    }
    brink_system_destroy(&s);
}
END_TEST

typedef struct outcome {
    int status;
    brink_frame frame;
    char *said;
} outcome;

// The `frames`th frame of a text.
static outcome read_text(const char *text, size_t length, int frames)
{
    outcome o = {0};
    size_t size = 0;
    FILE *in = tmpfile(), *errors = open_memstream(&o.said, &size);
    ck_assert_uint_eq(fwrite(text, 1, length, in), length);
    rewind(in);
    for (int k = 0; k < frames; k++) {
        brink_frame_destroy(&o.frame);
        o.status = brink_trajectory_read(in, "t.xyz", &o.frame, errors);
    }
    fclose(in);
    fclose(errors);
    return o;
}

static void forget(outcome *o)
{
    brink_frame_destroy(&o->frame);
    free(o->said);
}

#define BOX "Lattice=\"9 0 0 0 8 0 0 0 7\" "

START_TEST(files_from_elsewhere_are_read)
{
    const char *text =
        "\n  1 \r\n"
        "title=\"Lattice= and names=\" pbc=\"T T T\" stress=3 "
        "Lattice=\"9.0 0.0 0.0 0.0 8.0 0.0 0.0 0.0 7.0\" "
        "Properties=id:I:1:velo:R:3:forces:R:3:pos:R:3:frozen:L:1:species:S:1\r\n"
        "  7\t.1 -2e-3 +3  9 9 9  1.5 2.5 3.5 T Kr \r\n\n";
    outcome o = read_text(text, strlen(text), 1);
    ck_assert_msg(o.status == 1, "%s", o.said);
    ck_assert_str_eq(o.frame.species[0], "Kr");
    ck_assert(o.frame.length[0] == 9 && o.frame.length[1] == 8 &&
              o.frame.length[2] == 7);
    ck_assert(o.frame.x[0][0] == 1.5 && o.frame.x[0][1] == 2.5 &&
              o.frame.x[0][2] == 3.5);
    ck_assert(o.frame.v[0][0] == 0.1 && o.frame.v[0][1] == -2e-3 &&
              o.frame.v[0][2] == 3);
    forget(&o);
    o = read_text(text, strlen(text), 2); // blank lines are the end
    ck_assert_int_eq(o.status, 0);
    forget(&o);
    text = "1\n" BOX "\nA 1 2 3\n"; // a plain XYZ, but for the box
    o = read_text(text, strlen(text), 1);
    ck_assert_msg(o.status == 1, "%s", o.said);
    ck_assert_str_eq(o.frame.species[0], "A");
    ck_assert_ptr_null(o.frame.v);
    forget(&o);
}
END_TEST

START_TEST(names_follow_the_ids_where_another_program_has_sorted_the_lines)
{
    const char *text = "3\n" BOX "Properties=species:S:1:pos:R:3:id:I:1 "
                       "names=\"one:1 two:2\"\n"
                       "X 1 1 1 2\nX 2 2 2 0\nX 3 3 3 1\n";
    outcome o = read_text(text, strlen(text), 1);
    ck_assert_msg(o.status == 1, "%s", o.said);
    ck_assert_str_eq(o.frame.species[0], "two");
    ck_assert_str_eq(o.frame.species[1], "one");
    ck_assert_str_eq(o.frame.species[2], "two");
    forget(&o);
}
END_TEST

START_TEST(a_broken_file_is_refused_with_its_line)
{
    static const struct {
        const char *text;
        int frames, line;
        const char *words;
    } faults[] = {
        {"three\n", 1, 1, "begins with the number"},
        {"-3\n", 1, 1, "begins with the number"},
        {"0\n\n", 1, 1, "begins with the number"},
        {"3 4\n", 1, 1, "begins with the number"},
        {"99999999999\n" BOX "\n", 1, 1, "begins with the number"},
        {"3\n", 1, 1, "ends within a frame"},
        {"1\n\nA 1 2 3\n", 1, 2, "no box"},
        {"1\nLattice=\"9 0 0 0 8 0 0 0\"\nA 1 2 3\n", 1, 2, "no box"},
        {"1\nLattice=\"9 0 0 0 8 0 0 0 0\"\nA 1 2 3\n", 1, 2, "no box"},
        {"1\nLattice=\"9 1 0 0 8 0 0 0 7\"\nA 1 2 3\n", 1, 2, "no box"},
        {"1\nLattice=\"9 0 0 0 inf 0 0 0 7\"\nA 1 2 3\n", 1, 2, "no box"},
        {"1\n" BOX "Properties=species:S:1\nA\n", 1, 2, "Properties needs"},
        {"1\n" BOX "Properties=species:S:1:pos:R\nA\n", 1, 2, "Properties needs"},
        {"1\n" BOX "Properties=species:S:1:pos:R:2\nA 1 2\n", 1, 2,
         "Properties needs"},
        {"1\n" BOX "Properties=species:S:1:pos:R:3:pos:R:3\n", 1, 2,
         "Properties needs"},
        {"1\n" BOX "Properties=species:S:1:pos:R:3:x:R:99\n", 1, 2,
         "Properties needs"},
        {"2\n" BOX "\nA 1 2 3\n", 1, 3, "ends before its last particle"},
        {"1\n" BOX "\nA 1 2\n", 1, 3, "not as many columns"},
        {"1\n" BOX "\nA 1 2 3 4\n", 1, 3, "not as many columns"},
        {"1\n" BOX "\nA 1 2 0x3\n", 1, 3, "a position is not"},
        {"1\n" BOX "\nA 1 2 nan\n", 1, 3, "a position is not"},
        {"1\n" BOX "\nA 1 2 1e999\n", 1, 3, "a position is not"},
        {"1\n" BOX "Properties=species:S:1:pos:R:3:velo:R:3\nA 1 2 3 1 2 inf\n",
         1, 3, "a velocity is not"},
        {"1\n" BOX "\nabcdefghijklmnop 1 2 3\n", 1, 3, "longer than 15 letters"},
        {"1\n" BOX "names=\"A:1\"\nX 1 2 3\n", 1, 3, "does not go with names"},
        {"1\n" BOX
         "Properties=species:S:1:pos:R:3:id:I:1 names=\"A:1\"\nX 1 2 3 1\n",
         1, 3, "does not go with names"},
        {"1\n" BOX "\nA 1 2 3\n2\n" BOX "\nA 1 2 3\nA 1 2 x\n", 2, 7,
         "a position is not"},
    };
    for (size_t k = 0; k < sizeof faults / sizeof *faults; k++) {
        char place[64];
        outcome o =
            read_text(faults[k].text, strlen(faults[k].text), faults[k].frames);
        snprintf(place, sizeof place, "t.xyz:%d: error: ", faults[k].line);
        ck_assert_msg(o.status == -1, "read:\n%s", faults[k].text);
        ck_assert_msg(strncmp(o.said, place, strlen(place)) == 0 &&
                          strstr(o.said, faults[k].words),
                      "no '%s%s' of\n%s\n%s", place, faults[k].words,
                      faults[k].text, o.said);
        ck_assert_ptr_null(o.frame.x); // what is refused is empty
        forget(&o);
    }
}
END_TEST

START_TEST(no_beginning_of_a_file_does_harm)
{
    brink_system s = make(MIXTURE);
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    ck_assert_int_eq(brink_trajectory_write(out, &s, 0.0, 0.1), 0);
    fclose(out);
    for (size_t length = 0; length < size; length++) {
        outcome o = read_text(text, length, 1);
        // It may be whole but for its last digits or line end; else it is
        // refused.
        ck_assert_msg(o.status == (length == 0         ? 0
                                   : length < size - 1 ? -1
                                                       : 1),
                      "%zu of %zu bytes: %d, %s", length, size, o.status, o.said);
        forget(&o);
    }
    free(text);
    brink_system_destroy(&s);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "trajectory", 60, a_frame_is_written_as_every_reader_wants_it,
        a_plane_is_written_as_one, what_is_written_is_read_again_to_the_bit,
        a_full_disk_is_an_error, files_from_elsewhere_are_read,
        names_follow_the_ids_where_another_program_has_sorted_the_lines,
        a_broken_file_is_refused_with_its_line, no_beginning_of_a_file_does_harm);
}
