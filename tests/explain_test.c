// SPDX-License-Identifier: MIT
// What `brink explain` says is what the run does: of every event in a row, of
// runs of every make, from a scene and from a folder.
#include "checkpoint.h"
#include "explain.h"
#include "explained.h"
#include "folder.h"
#include "session.h"
#include "suite.h"
#include "systems.h"
#include <fcntl.h>
#include <inttypes.h>
#include <math.h>
#include <unistd.h>

static const char *folder;
static char scene[100];

static void write_scene(const char *text, const char *run)
{
    char whole[2000];
    folder = new_quick_folder();
    snprintf(whole, sizeof whole, "%srun: {%s}\n", text, run);
    write_file(folder, "scene.yaml", whole);
    snprintf(scene, sizeof scene, "%s/scene.yaml", folder);
}

/** What is said of it, to be freed; the exit code is looked at. */
static char *explained(const char *of, const brink_explain_orders *orders,
                       int code)
{
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    ck_assert_int_eq(brink_explain(out, of, orders), code);
    fclose(out);
    return text;
}

static char *explained_event(uint64_t event)
{
    const brink_explain_orders orders = {.event = event,
                                         .tier = BRINK_TIER_PLAIN};
    return explained(scene, &orders, BRINK_EXIT_DONE);
}

// --- Events --------------------------------------------------------------------

/* Event by event, the run beside it: who, when, what; that the kernel's answer is
 * the event's instant to the bit and that the run does what the page says. */
static void follow(const char *text, uint64_t from, uint64_t count)
{
    static const char *const kinds[] = {"core", "capture", "release", "bounce"};
    brink_run run;
    char who[2][60];
    write_scene(text, "events_per_particle: 100");
    make_run(&run, text);
    for (uint64_t n = from; n < from + count; n++) {
        brink_run_advance(&run, n, BRINK_NEVER);
        const brink_happening *e = &run.last;
        char *page = explained_event(n);
        snprintf(who[0], sizeof who[0], "1: %" PRIu32 ", of", e->i);
        snprintf(who[1], sizeof who[1], "2: %" PRIu32 ", of", e->j);
        expect_words(page, "the event", "kind", kinds[e->kind]);
        expect_words(page, "the event", "particles", who[0]);
        expect_words(page, "the event", "particles", "species");
        ck_assert_ptr_nonnull(strstr(page, who[1]));
        ck_assert_double_eq(number_of(page, "the event", "  time"),
                            brink_run_time(&run));
        expect_words(page, "how it was predicted", "so much later", "yes");
        expect_words(page, "the decision", "kind", kinds[e->kind]);
        expect_words(page, "afterwards", "the run did the same", "yes");
        ck_assert_double_eq(number_of(page, "owed before", "     after"),
                            run.owed);
        free(page);
    }
    brink_run_destroy(&run);
}

START_TEST(every_event_of_a_well_is_what_the_run_did)
{
    follow(square_well, 1, 20);
    follow(square_well, 3000, 10);
}
END_TEST

START_TEST(a_shoulder_is_explained)
{
    follow(square_shoulder, 500, 10);
}
END_TEST

START_TEST(three_steps_are_explained)
{
    follow(three_steps, 700, 20);
}
END_TEST

START_TEST(images_in_a_small_box_are_found)
{
    follow(small_box, 1, 40);
}
END_TEST

START_TEST(a_crowd_with_lists_is_explained)
{
    follow(crowded_mixture, 2000, 10);
}
END_TEST

START_TEST(every_tier_is_asked_for_its_own_times)
{
    static const char *const names[] = {"tier fast", "tier plain", "tier cr"};
    write_scene(square_well, "events: 1000");
    for (int k = 0; k < 3; k++) {
        const brink_explain_orders orders = {
            .event = 300, .has_tier = 1, .tier = (enum brink_tier)k};
        char *page = explained(scene, &orders, BRINK_EXIT_DONE);
        expect_words(page, "how it was predicted", "kernel asked", names[k]);
        expect_words(page, "how it was predicted", "so much later", "yes");
        free(page);
    }
}
END_TEST

START_TEST(a_seed_makes_it_another_run)
{
    write_scene(square_well, "events: 1000");
    const brink_explain_orders other = {
        .event = 9, .has_seed = 1, .seed = 77, .tier = BRINK_TIER_PLAIN};
    char *page = explained_event(9);
    char *another = explained(scene, &other, BRINK_EXIT_DONE);
    expect_words(another, "event 9", "seed", "77");
    ck_assert_double_ne(number_of(page, "the event", "  time"),
                        number_of(another, "the event", "  time"));
    free(page);
    free(another);
}
END_TEST

START_TEST(any_pair_can_be_looked_at_at_that_moment)
{
    const brink_explain_orders orders = {
        .event = 50, .has_pair = 1, .pair = {3, 14}, .tier = BRINK_TIER_PLAIN};
    brink_run run;
    double r[3];
    write_scene(square_well, "events: 1000");
    make_run(&run, square_well);
    brink_run_advance(&run, 50, BRINK_NEVER);
    char *page = explained(scene, &orders, BRINK_EXIT_DONE);
    expect_words(page, "the pair", "particles", "1: 3, of species A");
    ck_assert_double_eq(number_of(page, "the pair", "  time"),
                        brink_run_time(&run));
    // Neither is in event 50: they are where they are behind it, too.
    ck_assert(run.last.i != 3 && run.last.i != 14 && run.last.j != 3 &&
              run.last.j != 14);
    brink_system_separation(&run.system, 3, 14, run.now.offset, r);
    ck_assert_double_eq(number_of(page, "the pair", "r = r1 - r2"), r[0]);
    ck_assert_ptr_null(strstr(page, "the decision"));
    brink_run_destroy(&run);
    free(page);
}
END_TEST

// --- Folders -------------------------------------------------------------------

/** A folder with checkpoints at these numbers of events. */
static const char *run_with_checkpoints(const uint64_t *events, int count)
{
    static char dir[100];
    brink_run run;
    char *text = whole_file(folder, "scene.yaml");
    brink_plan plan = {.events = 1000,
                       .until = (double)INFINITY,
                       .seed = 12,
                       .scene = text,
                       .scene_size = strlen(text)};
    snprintf(dir, sizeof dir, "%s/dir", folder);
    ck_assert_int_eq(mkdir(dir, 0777), 0);
    make_run(&run, square_well);
    for (int k = 0; k < count; k++) {
        brink_run_advance(&run, events[k], BRINK_NEVER);
        ck_assert_int_eq(brink_checkpoint_save(dir, &run, &plan, stderr), 0);
    }
    brink_run_destroy(&run);
    free(text);
    return dir;
}

START_TEST(a_folder_is_replayed_from_its_newest_checkpoint_before_it)
{
    static const char from_400[] = "checkpoint-00000000000000000400.brink";
    static const char from_300[] = "checkpoint-00000000000000000300.brink";
    const struct {
        uint64_t event;
        const char *from;
    } cases[] = {{301, from_300}, {400, from_300},        {401, from_400},
                 {600, from_400}, {300, "its beginning"}, {7, "its beginning"}};
    write_scene(square_well, "events: 1000");
    const char *dir = run_with_checkpoints((const uint64_t[]){300, 400}, 2);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        const brink_explain_orders orders = {.event = cases[k].event};
        char *page = explained_event(cases[k].event);
        char *same = explained(dir, &orders, BRINK_EXIT_DONE);
        expect_words(same, "event", "replayed from", cases[k].from);
        ck_assert_str_eq(strstr(same, "the pair,"), strstr(page, "the pair,"));
        free(page);
        free(same);
    }
}
END_TEST

START_TEST(a_prediction_from_before_the_checkpoint_is_said_to_be)
{
    const brink_explain_orders orders = {.event = 401};
    write_scene(square_well, "events: 1000");
    char *page = explained(run_with_checkpoints((const uint64_t[]){400}, 1),
                           &orders, BRINK_EXIT_DONE);
    expect_words(page, "how it was predicted", "when", "before this checkpoint");
    expect_words(page, "afterwards", "the run did the same", "yes");
    free(page);
}
END_TEST

// --- What cannot be ------------------------------------------------------------

static void expect_complaint(const char *of, const brink_explain_orders *orders,
                             const char *words)
{
    const char *said = in_folder(folder, "said");
    fflush(stderr);
    const int before = dup(STDERR_FILENO),
              to = open(said, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    dup2(to, STDERR_FILENO);
    char *page = explained(of, orders, BRINK_EXIT_USAGE);
    dup2(before, STDERR_FILENO);
    close(to);
    char *text = whole_file(folder, "said");
    ck_assert_msg(strstr(text, words), "'%s' is not in: %s", words, text);
    ck_assert_str_eq(page, "");
    free(text);
    free(page);
}

START_TEST(an_event_beyond_the_end_is_refused)
{
    write_scene(square_well, "events: 1000");
    expect_complaint(scene, &(brink_explain_orders){.event = 1001, .tier = 1},
                     "whose target is 1000 events");
    write_scene(square_well, "time: 0.25");
    expect_complaint(scene, &(brink_explain_orders){.event = 100000, .tier = 1},
                     "its target is reached");
    write_scene("box: {size: [16, 16, 16]}\n"
                "species: {A: {count: 2, diameter: 1}}\n"
                "start: {file: rest.xyz}\n",
                "events: 3");
    write_file(folder, "rest.xyz",
               "2\n"
               "Lattice=\"16 0 0 0 16 0 0 0 16\" pbc=\"T T T\" "
               "Properties=species:S:1:pos:R:3:velo:R:3\n"
               "A 1 4 4  0 0 0\nA 8 4 4  0 0 0\n");
    expect_complaint(scene, &(brink_explain_orders){.event = 1, .tier = 1},
                     "nothing moves");
}
END_TEST

START_TEST(particles_that_there_are_not_are_refused)
{
    write_scene(square_well, "events: 1000");
    expect_complaint(
        scene,
        &(brink_explain_orders){.event = 1, .has_pair = 1, .pair = {3, 256}},
        "there is no particle 256: they are 0 to 255");
}
END_TEST

START_TEST(a_folder_has_its_own_seed_and_tier)
{
    write_scene(square_well, "events: 1000");
    const char *dir = run_with_checkpoints((const uint64_t[]){10}, 1);
    expect_complaint(dir, &(brink_explain_orders){.event = 20, .has_seed = 1},
                     "this run has its seed and its tier");
    expect_complaint(dir, &(brink_explain_orders){.event = 20, .has_tier = 1},
                     "this run has its seed and its tier");
    expect_complaint(folder, &(brink_explain_orders){.event = 20},
                     "it holds no checkpoint");
}
END_TEST

/* Four in a row that is as long as the box: see tests/session_wrong_test.c. */
START_TEST(a_run_that_stands_still_ends_with_a_diagnosis)
{
    write_scene("box: {size: [4, 8, 8]}\n"
                "species: {A: {count: 4, diameter: 1}}\n"
                "start: {file: ring.xyz}\n",
                "events: 100000");
    write_file(folder, "ring.xyz",
               "4\n"
               "Lattice=\"4 0 0 0 8 0 0 0 8\" pbc=\"T T T\" "
               "Properties=species:S:1:pos:R:3:velo:R:3\n"
               "A 0 4 4  1 0 0\nA 1 4 4  0.5 0 0\n"
               "A 2 4 4  -1 0 0\nA 3 4 4  -0.5 0 0\n");
    expect_complaint(scene, &(brink_explain_orders){.event = 100000, .tier = 1},
                     "events go on but the clock does not");
    char *said = whole_file(folder, "said");
    uint64_t last;
    ck_assert_int_eq(
        sscanf(strstr(said, "which has"), "which has %" SCNu64, &last), 1);
    char *page = explained_event(last);
    ck_assert_ptr_nonnull(strstr(page, "The run cannot go on: events go on"));
    expect_words(page, "afterwards", "the run did the same", "yes");
    free(page);
    free(said);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "explain", 300, every_event_of_a_well_is_what_the_run_did,
        a_shoulder_is_explained, three_steps_are_explained,
        images_in_a_small_box_are_found, a_crowd_with_lists_is_explained,
        every_tier_is_asked_for_its_own_times, a_seed_makes_it_another_run,
        any_pair_can_be_looked_at_at_that_moment,
        a_folder_is_replayed_from_its_newest_checkpoint_before_it,
        a_prediction_from_before_the_checkpoint_is_said_to_be,
        an_event_beyond_the_end_is_refused,
        particles_that_there_are_not_are_refused,
        a_folder_has_its_own_seed_and_tier,
        a_run_that_stands_still_ends_with_a_diagnosis);
}
