// SPDX-License-Identifier: MIT
/*
 * Sessions that end badly, all the way from the scene to the exit code: a run
 * whose clock stands still, results that cannot be written; and one that looks as
 * if it would end badly and does not.
 */
#include "checkpoint.h"
#include "sessions.h"
#include "suite.h"

static const char *folder;
static char path[100], dir[100];

static void prepare(const char *scene)
{
    folder = new_quick_folder();
    write_file(folder, "scene.yaml", scene);
    snprintf(path, sizeof path, "%s/scene.yaml", folder);
    snprintf(dir, sizeof dir, "%s/dir", folder);
}

/** The exit code of a session: `scene_path` run into `out`, or `out` resumed. */
static int session(const char *scene_path, const char *out, double max_wall)
{
    const pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0)
        play(folder, scene_path, out, max_wall);
    return exit_of(child);
}

static void expect_in(const char *where, const char *name, const char *words)
{
    char *text = whole_file(where, name);
    ck_assert_msg(strstr(text, words), "'%s' is not in %s: %s", words, name,
                  text);
    free(text);
}

// --- A clock that stands still -------------------------------------------------

/* Four spheres in a row that is as long as the box: each touches two others, for
 * ever, and has no room.  What one hands on goes round, at one instant: in a ring
 * there is no order of velocities in which nobody runs into the next. */
static const char ring[] = "box: {size: [4, 8, 8]}\n"
                           "species: {A: {count: 4, diameter: 1}}\n"
                           "start: {file: ring.xyz}\n"
                           "run: {time: 10}\n";

static const char ring_places[] = "4\n"
                                  "Lattice=\"4 0 0 0 8 0 0 0 8\" pbc=\"T T T\" "
                                  "Properties=species:S:1:pos:R:3:velo:R:3\n"
                                  "A 0 4 4  1 0 0\n"
                                  "A 1 4 4  0.5 0 0\n"
                                  "A 2 4 4  -1 0 0\n"
                                  "A 3 4 4  -0.5 0 0\n";

static void expect_stuck(void)
{
    expect_in(folder, "said",
              "the run cannot go on: events go on but the clock "
              "does not; after ");
    expect_in(folder, "said", " at time 0\nlast event: core of particles ");
    // The pair's separation and velocity, in hex: a diameter along x.
    char *said = whole_file(folder, "said");
    const char *r = strstr(said, "r = {"), *v = strstr(said, "v = {");
    double x[6];
    ck_assert_msg(
        r && v && sscanf(r, "r = {%la, %la, %la}", &x[0], &x[1], &x[2]) == 3 &&
            sscanf(v, "v = {%la, %la, %la}", &x[3], &x[4], &x[5]) == 3 &&
            strstr(r, "0x") && strstr(v, "0x"),
        "said: %s", said);
    ck_assert_msg(fabs(x[0]) == 1 && x[1] == 0 && x[2] == 0 && x[0] * x[3] > 0,
                  "said: %s", said);
    free(said);
    expect_in(dir, "summary.json", "\"stopped\": \"stuck\"");
}

START_TEST(a_run_whose_clock_stands_still_ends_with_3_and_names_the_pair)
{
    prepare(ring);
    write_file(folder, "ring.xyz", ring_places);
    ck_assert_int_eq(session(path, dir, (double)INFINITY), BRINK_EXIT_WRONG);
    expect_stuck();
    // What it was doing can be looked into: the checkpoints are there, and lead
    // to the same place.
    ck_assert_int_eq(brink_checkpoint_count(dir), 2);
    ck_assert_int_eq(session(NULL, dir, (double)INFINITY), BRINK_EXIT_WRONG);
    expect_stuck();
}
END_TEST

// --- Results that cannot be written --------------------------------------------

static const char gas[] = "seed: 21\n"
                          "box: {packing_fraction: 0.2}\n"
                          "species: {A: {count: 108, diameter: 1}}\n"
                          "run: {events: 3000}\n";

/* /dev/full takes nothing, as a full disk does, where NAME.part should be: so it
 * is for that one result, and everything else is written. */
static void cannot_write(const char *name)
{
    char part[120], whole[120], complaint[200];
    prepare(gas);
    snprintf(whole, sizeof whole, "%s/whole", folder);
    ck_assert_int_eq(session(path, whole, (double)INFINITY), BRINK_EXIT_DONE);
    ck_assert_int_eq(session(path, dir, 1e-9), BRINK_EXIT_STOPPED);
    char *older = whole_file(dir, name);
    snprintf(part, sizeof part, "%s/%s.part", dir, name);
    ck_assert_int_eq(symlink("/dev/full", part), 0);

    ck_assert_int_eq(session(NULL, dir, (double)INFINITY), BRINK_EXIT_USAGE);
    snprintf(complaint, sizeof complaint,
             "/%s: it cannot be written: No space left on device\n"
             "  make room there, then `brink resume ",
             name);
    expect_in(folder, "said", complaint);
    char *now = whole_file(dir, name);
    ck_assert_str_eq(now, older);
    ck_assert_int_ne(access(part, F_OK), 0); // nothing half-written lies about
    free(now);
    free(older);

    // The run itself is over and done with; its results are to be had.
    ck_assert_int_eq(session(NULL, dir, (double)INFINITY), BRINK_EXIT_DONE);
    char *one = whole_file(whole, name), *other = whole_file(dir, name);
    if (strcmp(name, "summary.json") == 0) {
        make_timeless(one);
        make_timeless(other);
    }
    ck_assert_str_eq(one, other);
    free(one);
    free(other);
}

START_TEST(a_summary_that_cannot_be_written_is_said_and_the_older_one_kept)
{
    cannot_write("summary.json");
}
END_TEST

START_TEST(final_places_that_cannot_be_written_are_said_and_the_older_ones_kept)
{
    cannot_write("final.xyz");
}
END_TEST

// --- The rim -------------------------------------------------------------------

// Captured, an ulp from the rim of a well of 2, and on their way along it.
static const char rim[] = "box: {size: [64, 64, 64]}\n"
                          "species: {A: {count: 2}}\n"
                          "start: {file: rim.xyz}\n"
                          "potentials:\n"
                          "  - {between: [A, A], steps: [[2, -1], [1, .inf]]}\n"
                          "run: {events: 20000}\n";

static const char rim_places[] = "2\n"
                                 "Lattice=\"64 0 0 0 64 0 0 0 64\" pbc=\"T T T\" "
                                 "Properties=species:S:1:pos:R:3:velo:R:3\n"
                                 "A 1.9999999999999998 32 32  0 0.25 0\n"
                                 "A 0 32 32  0 -0.25 0\n";

START_TEST(a_pair_that_slides_along_a_rim_gets_on_and_is_counted)
{
    prepare(rim);
    write_file(folder, "rim.xyz", rim_places);
    ck_assert_int_eq(session(path, dir, (double)INFINITY), BRINK_EXIT_DONE);
    char *summary = whole_file(dir, "summary.json");
    const char *turned = strstr(summary, "\"rim\": "),
               *at_once = strstr(summary, "\"zero_time\": "),
               *time = strstr(summary, "\"time\": ");
    ck_assert_ptr_nonnull(strstr(summary, "\"bounce\": 20000,"));
    ck_assert_ptr_nonnull(strstr(summary, "\"refused\": 0}"));
    ck_assert_msg(turned && atoi(turned + strlen("\"rim\": ")) > 0 && at_once &&
                      atoi(at_once + strlen("\"zero_time\": ")) <= 1 && time &&
                      atof(time + strlen("\"time\": ")) > 0,
                  "%s", summary);
    free(summary);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "session, wrong", 300,
        a_run_whose_clock_stands_still_ends_with_3_and_names_the_pair,
        a_summary_that_cannot_be_written_is_said_and_the_older_one_kept,
        final_places_that_cannot_be_written_are_said_and_the_older_ones_kept,
        a_pair_that_slides_along_a_rim_gets_on_and_is_counted);
}
