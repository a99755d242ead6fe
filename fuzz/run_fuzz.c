// SPDX-License-Identifier: MIT
/*
 * The whole simulator, on systems near discontinuities on purpose: a witness
 * looks at every event, and what is saved half-way goes on to the same bits.
 */
#include "../tests/systems.h"
#include "adverse.h"
#include "fuzz.h"
#include "snapshot.h"
#include "witness.h"
#include <string.h>

enum {
    EVENTS = 200,
    CROWD_EVENTS = 40,
    LOOKS =
        60 // for events, each over as long as the fastest takes to cross the box
};

static void expect_going(const witness *w, enum brink_run_status status)
{
    char why[2000];
    if (status == BRINK_RUN_REACHED || status == BRINK_RUN_AT_REST ||
        status == BRINK_RUN_QUIET)
        return;
    const brink_happening *last = &w->run->last;
    if (status == BRINK_RUN_STUCK && witness_is_hidden(w, last->i, last->j))
        return;
    brink_run_diagnosis(w->run, status, why, sizeof why);
    witness_break(w, "%s", why);
}

/** The time in which the fastest flies as far as the box is long. */
static double look_of(const brink_system *s)
{
    double speed = 0;
    for (uint32_t i = 0; i < s->count; i++)
        for (int a = 0; a < 3; a++)
            speed = fmax(speed, fabs(s->particle[i].v[a]));
    return fmax(s->length[0], fmax(s->length[1], s->length[2])) / speed;
}

/** To the next event, or for a look; 0 where nothing will ever happen. */
static int go_on(brink_run *run, witness *w)
{
    const uint64_t events = brink_tally_events(&run->tally);
    const double look = look_of(&run->system);
    const brink_instant until =
        brink_instant_after(run->system.year, run->now, look);
    const enum brink_run_status status =
        brink_run_advance(run, events + 1, until);
    expect_going(w, status);
    const uint64_t more = brink_tally_events(&run->tally) - events;
    if (more > 1)
        witness_break(w, "one event was asked for, and there were more");
    witness_look(w, more == 1);
    return status != BRINK_RUN_AT_REST && status != BRINK_RUN_STUCK;
}

// --- Saved and loaded ----------------------------------------------------------

static char scene[] = "none";

static const brink_plan plan = {.events = 7,
                                .until = 0.5,
                                .seed = 3,
                                .frames = 2,
                                .frame_end = 1,
                                .wall_seconds = 0.25,
                                .scene = scene,
                                .scene_size = sizeof scene - 1};

static void save_and_load(const witness *w, brink_run *loaded)
{
    char *bytes = NULL;
    size_t size = 0;
    brink_plan read;
    FILE *file = open_memstream(&bytes, &size);
    const char *fault = brink_snapshot_write(file, w->run, &plan);
    fclose(file);
    if (fault)
        witness_break(w, "saved: %s", fault);
    file = fmemopen(bytes, size, "r");
    fault = brink_snapshot_read(file, loaded, &read);
    fclose(file);
    free(bytes);
    if (fault)
        witness_break(w, "loaded: %s", fault);
    if (!same_state(w->run, loaded))
        witness_break(w, "what is loaded is not what was saved");
    if (read.events != plan.events || read.until != plan.until ||
        read.seed != plan.seed || read.frames != plan.frames ||
        read.frame_end != plan.frame_end ||
        read.wall_seconds != plan.wall_seconds || strcmp(read.scene, scene) != 0)
        witness_break(w, "another plan is loaded than was saved");
    brink_plan_destroy(&read);
}

/** In one piece, where the other was looked at event by event: to its last event,
 *  or to the instant that it has come to since. */
static void go_the_same_way(const witness *w, brink_run *loaded)
{
    const brink_run *run = w->run;
    const int after = brink_instant_compare(run->now, run->last.when) > 0;
    const enum brink_run_status status =
        after ? brink_run_advance(loaded, UINT64_MAX, run->now)
              : brink_run_advance(loaded, brink_tally_events(&run->tally),
                                  BRINK_NEVER);
    expect_going(w, status);
    if (!same_state(run, loaded))
        witness_break(w, "what was loaded goes another way");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stream s = stream_of_bytes(data, size);
    brink_system system;
    brink_run run, loaded;
    witness w;
    const enum brink_tier tier =
        (enum brink_tier)stream_int(&s, 0, BRINK_TIER_CR);
    const int most = stream_int(&s, 1, EVENTS), save = stream_int(&s, 0, most);
    int has_loaded = 0, looks = LOOKS;
    adverse_make(&s, &system);
    const int events =
        system.count > 16 && most > CROWD_EVENTS ? CROWD_EVENTS : most;
    LAW(brink_run_create(&run, &system, tier) == 0, "run: memory is out");
    witness_begin(&w, &run);
    for (int n = 0; n < events && looks > 0; n++) {
        if (n == save) {
            save_and_load(&w, &loaded);
            has_loaded = 1;
        }
        const uint64_t before = brink_tally_events(&run.tally);
        if (!go_on(&run, &w))
            break;
        looks -= brink_tally_events(&run.tally) == before;
    }
    if (has_loaded) {
        go_the_same_way(&w, &loaded);
        brink_run_destroy(&loaded);
    }
    witness_end(&w);
    brink_run_destroy(&run);
    return 0;
}
