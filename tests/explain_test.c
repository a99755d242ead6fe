// SPDX-License-Identifier: MIT
// What `brink explain` says is what the run does: of every event in a row, of
// runs of every make, from a scene and from a folder.
#include "checkpoint.h"
#include "explain.h"
#include "explain_pair.h"
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

/** A copy of the line on `name`, behind the one that is `head`. */
static const char *line_of(const char *text, const char *head, const char *name)
{
    static char line[300];
    const char *at = strstr(text, head);
    ck_assert_msg(at != NULL, "there is no '%s' in:\n%s", head, text);
    at = strstr(at, name);
    ck_assert_msg(at != NULL, "there is no '%s' behind '%s' in:\n%s", name, head,
                  text);
    while (at > text && at[-1] != '\n')
        at--;
    snprintf(line, sizeof line, "%.*s", (int)strcspn(at, "\n"), at);
    return line;
}

/** The number in decimal on a line, which is the same in hex. */
static double number_of(const char *text, const char *head, const char *name)
{
    const char *line = line_of(text, head, name);
    double decimal, hex;
    const int columns = 34; // of names
    ck_assert_msg(sscanf(line + columns, "%lf %la", &decimal, &hex) == 2 &&
                      decimal == hex,
                  "%s", line);
    return decimal;
}

static void expect_words(const char *text, const char *head, const char *name,
                         const char *words)
{
    const char *line = line_of(text, head, name);
    ck_assert_msg(strstr(line, words) != NULL, "not '%s': %s", words, line);
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

// --- A pair by itself ----------------------------------------------------------

static const double shoulder_distance[] = {3, 1},
                    shoulder_energy[] = {1, (double)INFINITY};
static const brink_potential shoulder = {2, shoulder_distance, shoulder_energy};

static char *meeting(brink_explained *pair, enum brink_direction way)
{
    char *text;
    size_t size;
    double owed = 0;
    FILE *out = open_memstream(&text, &size);
    brink_explain_pair(out, pair);
    brink_explain_surfaces(out, pair);
    brink_explain_meeting(out, pair, way, &owed);
    fclose(out);
    return text;
}

START_TEST(every_answer_has_its_reason)
{
    const struct {
        double v;
        int level;
        enum brink_direction way;
        const char *answer;
        int after;
    } cases[] = {
        {-3, 0, BRINK_INWARD, "crossed: the former is larger (kind: capture)", 1},
        {-1, 0, BRINK_INWARD, "stays outside (kind: bounce)", 0},
        {1, 1, BRINK_OUTWARD, "crossed: the former is larger (kind: release)", 0},
        {-1, 1, BRINK_INWARD, "a hard core; nothing suffices (kind: core)", 1},
        {1, 0, BRINK_OUTWARD, "refused: from this level there is no such step",
         0},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        brink_explained pair = {.r = {3, 0, 0},
                                .v1 = {cases[k].v, 0, 0},
                                .m1 = 1,
                                .m2 = 1,
                                .potential = &shoulder,
                                .level = cases[k].level};
        char *page = meeting(&pair, cases[k].way);
        expect_words(page, "the decision", "answer", cases[k].answer);
        ck_assert_int_eq(pair.level, cases[k].after);
        free(page);
    }
}
END_TEST

/* On the inside of a well, all but along it: what it takes to be turned
 * inward. */
START_TEST(the_rim_rule_is_named)
{
    static const double energy[] = {-1, (double)INFINITY};
    static const brink_potential well = {2, shoulder_distance, energy};
    brink_explained pair = {.r = {3, 0, 0},
                            .v1 = {1e-12, 1, 0},
                            .m1 = 1,
                            .m2 = 1,
                            .potential = &well,
                            .level = 1};
    char *page = meeting(&pair, BRINK_OUTWARD);
    expect_words(page, "the decision", "answer",
                 "by the rim rule (kind: bounce)");
    free(page);
    pair.v1[0] = 0.5;
    page = meeting(&pair, BRINK_OUTWARD);
    expect_words(page, "the decision", "answer", "stays inside (kind: bounce)");
    free(page);
}
END_TEST

/* r = (5, 0, 0), v = (-1, 0, 0), sigma = 3: f = 16, roots 2 and 8; all exact. */
START_TEST(a_ball_has_its_signs_roots_and_times)
{
    const double r[3] = {5, 0, 0}, v[3] = {-1, 0, 0};
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    brink_explain_ball(out, r, v, 3);
    fclose(out);
    expect_words(text, "f =", "f =", "sign  1: outside");
    expect_words(text, "f =", "rate =", "sign -1: approaching");
    ck_assert_double_eq(number_of(text, "f =", "f ="), 16);
    ck_assert_double_eq(number_of(text, "f =", "b^2 - a c"), 9);
    ck_assert_double_eq(number_of(text, "f =", "roots of"), 2);
    ck_assert_double_eq(number_of(text, "f =", "intersection time"), 2);
    ck_assert_double_eq(number_of(text, "f =", "disjoint time"), 8);
    // 16 / (5 + 3) = 2 from a distance of 3, whose ulp is 2^-51.
    ck_assert_double_eq(number_of(text, "f =", "    in ulp"), 0x1p52);
    free(text);
}
END_TEST

START_TEST(a_plane_has_its_sign_and_time)
{
    const double r[3] = {0, 0, 5}, v[3] = {1, 0, -2}, n[3] = {0, 0, 2},
                 c[3] = {9, 9, 1};
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    brink_explain_halfspace(out, r, v, n, c);
    fclose(out);
    expect_words(text, "f =", "f =", "sign  1: outside");
    expect_words(text, "f =", "rate =", "sign -1: approaching");
    ck_assert_double_eq(number_of(text, "f =", "halfspace time"), 2);
    free(text);
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
        a_run_that_stands_still_ends_with_a_diagnosis,
        every_answer_has_its_reason, the_rim_rule_is_named,
        a_ball_has_its_signs_roots_and_times, a_plane_has_its_sign_and_time);
}
