// SPDX-License-Identifier: MIT
#include "explain_replay.h"
#include "checkpoint.h"
#include "run_batch.h"
#include "scene.h"
#include "start.h"
#include <inttypes.h>
#include <math.h>
#include <string.h>

// --- Beginnings ----------------------------------------------------------------

static int start(brink_replay *replay, const brink_scene *scene, const char *name,
                 enum brink_tier tier)
{
    brink_system system;
    if (brink_start_make(scene, name, &system, stderr))
        return -1;
    if (brink_run_create(&replay->run, &system, tier) == 0)
        return 0;
    brink_system_destroy(&system);
    fprintf(stderr, "%s: memory is out\n", name);
    return -1;
}

int brink_replay_of_scene(brink_replay *replay, const char *name, int has_seed,
                          uint64_t seed, enum brink_tier tier)
{
    brink_scene scene;
    memset(replay, 0, sizeof *replay);
    if (brink_scene_read(name, &scene, stderr))
        return -1;
    if (has_seed)
        scene.seed = seed;
    replay->seed = scene.seed;
    replay->events = brink_scene_events(&scene);
    replay->until =
        scene.target == BRINK_TARGET_TIME ? scene.target_value : (double)INFINITY;
    const int status = start(replay, &scene, name, tier);
    brink_scene_destroy(&scene);
    return status;
}

// A run that has gone further than it is to be looked at, from its beginning.
static int begin_again(brink_replay *replay, const brink_plan *plan,
                       const char *name)
{
    brink_scene scene;
    const enum brink_tier tier = replay->run.tier;
    brink_run_destroy(&replay->run);
    if (brink_scene_parse(plan->scene, plan->scene_size, name, "", &scene,
                          stderr))
        return -1;
    scene.seed = plan->seed;
    const int status = start(replay, &scene, name, tier);
    brink_scene_destroy(&scene);
    return status;
}

int brink_replay_of_folder(brink_replay *replay, const char *dir, uint64_t event)
{
    brink_plan plan;
    memset(replay, 0, sizeof *replay);
    const int earlier =
        brink_checkpoint_before(dir, event, &replay->run, &plan, replay->from,
                                sizeof replay->from, stderr) == 0;
    if (!earlier &&
        brink_checkpoint_resume(dir, &replay->run, &plan, replay->from,
                                sizeof replay->from, stderr))
        return -1;
    int status = 0;
    replay->seed = plan.seed;
    replay->events = plan.events;
    replay->until = plan.until;
    if (!earlier) {
        status = begin_again(replay, &plan, replay->from);
        replay->from[0] = '\0';
    }
    brink_plan_destroy(&plan);
    return status;
}

// --- On the way ----------------------------------------------------------------

static brink_instant end_of(const brink_replay *replay)
{
    return brink_instant_at(replay->run.system.year, replay->until);
}

// The two of an event are moved to where they meet, as executing it will do.
static void bring_together(brink_run *run, const brink_entry *entry)
{
    if (entry->when.epoch > run->system.epoch)
        brink_system_turn(&run->system, entry->when.epoch);
    brink_system_advance(&run->system, entry->i, entry->when.offset);
    brink_system_advance(&run->system, entry->j, entry->when.offset);
}

// Goes through stale predictions and crossings, to the next event or the end.
static uint32_t next_event(brink_replay *replay, enum brink_run_status *status)
{
    brink_run *run = &replay->run;
    const uint32_t nobody = run->calendar.slots;
    const uint64_t last = run->tally.cell + BRINK_PATIENCE;
    *status = BRINK_RUN_REACHED;
    while (*status == BRINK_RUN_REACHED) {
        const uint32_t slot = brink_calendar_next(&run->calendar);
        if (slot != nobody &&
            brink_instant_compare(run->calendar.entry[slot].when,
                                  end_of(replay)) > 0)
            return nobody;
        if (slot != nobody && brink_run_is_event(run, slot))
            return slot;
        *status = run->tally.cell > last ? BRINK_RUN_QUIET : brink_run_step(run);
    }
    return nobody;
}

static void complain_of_end(const brink_replay *replay, const char *name,
                            uint64_t event, enum brink_run_status status)
{
    const uint64_t events = brink_tally_events(&replay->run.tally);
    char why[2000] = "its target is reached";
    if (status == BRINK_RUN_AT_REST)
        snprintf(why, sizeof why, "nothing moves: there is no further event");
    else if (status == BRINK_RUN_QUIET)
        snprintf(why, sizeof why, "nobody has met anybody for long");
    else if (status != BRINK_RUN_REACHED)
        brink_run_diagnosis(&replay->run, status, why, sizeof why);
    fprintf(stderr,
            "%s: event %" PRIu64
            " is beyond the end of the run, which has %" PRIu64 " events: %s\n",
            name, event, events, why);
}

uint32_t brink_replay_approach(brink_replay *replay, const char *name,
                               uint64_t event)
{
    brink_run *run = &replay->run;
    enum brink_run_status status = BRINK_RUN_REACHED;
    uint32_t slot = run->calendar.slots;
    if (event > replay->events) {
        fprintf(stderr,
                "%s: event %" PRIu64
                " is beyond the end of the run, whose target "
                "is %" PRIu64 " events\n",
                name, event, replay->events);
        return slot;
    }
    status = brink_run_advance(run, event - 1, end_of(replay));
    if (status == BRINK_RUN_REACHED &&
        brink_tally_events(&run->tally) + 1 == event)
        slot = next_event(replay, &status);
    if (slot == run->calendar.slots)
        complain_of_end(replay, name, event, status);
    else
        bring_together(run, &run->calendar.entry[slot]);
    return slot;
}

// --- Who asked for it ----------------------------------------------------------

static double ask(const brink_run *run, const brink_entry *entry,
                  const double r[3], const double v[3], double step)
{
    const struct brink_batch_tier *tier = &brink_batch_tiers[run->tier];
    double t;
    (entry->kind == BRINK_ENTRY_INWARD ? tier->intersection : tier->disjoint)(
        1, &r[0], &r[1], &r[2], &v[0], &v[1], &v[2], &step, &t);
    return t;
}

// In which of its images the other one was found: that which answers with the
// event's instant.
static void find_image(const brink_run *run, const brink_entry *entry,
                       double step, brink_asked *asked)
{
    const brink_system *s = &run->system;
    double near[3];
    for (int a = 0; a < 3; a++)
        near[a] =
            asked->r[a] - (run->cells.images[a] > 1
                               ? s->length[a] * rint(asked->r[a] / s->length[a])
                               : 0);
    for (int m = 0; m < run->images && !asked->is_met; m++) {
        for (int a = 0; a < 3; a++)
            asked->r[a] = near[a] + run->image[m][a];
        asked->answer = ask(run, entry, asked->r, asked->v, step);
        asked->is_met =
            brink_instant_compare(
                brink_instant_after(s->year, asked->when, asked->answer),
                entry->when) == 0;
    }
}

// A prediction of what is in the slot, made just now.
static void look_at(const brink_run *run, uint32_t slot, brink_asked *asked)
{
    const brink_entry *entry = &run->calendar.entry[slot];
    const brink_system *s = &run->system;
    *asked = (brink_asked){.known = entry->kind != BRINK_ENTRY_CELL};
    if (!asked->known)
        return;
    asked->events = brink_tally_events(&run->tally);
    asked->when = run->now;
    asked->by = slot;
    asked->of = slot == entry->i ? entry->j : entry->i;
    asked->level = brink_states_level(&run->states, asked->by, asked->of);
    brink_system_separation(s, asked->by, asked->of, run->now.offset, asked->r);
    for (int a = 0; a < 3; a++)
        asked->v[a] = s->particle[asked->by].v[a] - s->particle[asked->of].v[a];
    const int step =
        entry->kind == BRINK_ENTRY_INWARD ? asked->level : asked->level - 1;
    find_image(run, entry,
               brink_system_potential(s, asked->by, asked->of)->distance[step],
               asked);
}

void brink_replay_watch(brink_replay *replay, uint32_t slot, uint64_t event,
                        brink_asked *asked)
{
    brink_run *run = &replay->run;
    *asked = (brink_asked){0};
    if (!replay->from[0])
        look_at(run, slot, asked);
    for (;;) {
        const uint32_t next = brink_calendar_next(&run->calendar);
        const brink_entry entry = run->calendar.entry[next];
        const int is_event = brink_run_is_event(run, next);
        if (is_event && brink_tally_events(&run->tally) + 1 == event) {
            bring_together(run, &entry);
            return;
        }
        brink_run_step(run);
        if (next == slot || (is_event && (entry.i == slot || entry.j == slot)))
            look_at(run, slot, asked);
    }
}
