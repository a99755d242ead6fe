// SPDX-License-Identifier: MIT
#include "explain.h"
#include "explain_pair.h"
#include "explain_put.h"
#include "explain_replay.h"
#include "session.h"
#include <brink/event_time.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>
#include <sys/stat.h>

static const char *const tiers[] = {"fast", "plain", "cr"};

static int is_folder(const char *path)
{
    struct stat about;
    return stat(path, &about) == 0 && S_ISDIR(about.st_mode);
}

static int begin(brink_replay *replay, const char *of,
                 const brink_explain_orders *o)
{
    if (!is_folder(of))
        return brink_replay_of_scene(replay, of, o->has_seed, o->seed, o->tier);
    if (!o->has_seed && !o->has_tier)
        return brink_replay_of_folder(replay, of, o->event);
    fprintf(stderr, "%s: this run has its seed and its tier\n", of);
    return -1;
}

// --- The pair at hand ----------------------------------------------------------

static brink_explained pair_of(const brink_run *run, uint32_t i, uint32_t j,
                               double offset)
{
    const brink_system *s = &run->system;
    const brink_particle *a = &s->particle[i], *b = &s->particle[j];
    brink_explained pair = {
        .m1 = s->species[a->species].mass,
        .m2 = s->species[b->species].mass,
        .potential = brink_system_potential(s, i, j),
        .level = brink_states_level(&run->states, i, j),
    };
    memcpy(pair.v1, a->v, sizeof pair.v1);
    memcpy(pair.v2, b->v, sizeof pair.v2);
    brink_system_separation(s, i, j, offset, pair.r);
    return pair;
}

static void put_particles(FILE *out, const brink_system *s, uint32_t i,
                          uint32_t j)
{
    char words[100];
    snprintf(words, sizeof words, "1: %" PRIu32 ", of species %s", i,
             s->species[s->particle[i].species].name);
    put_words(out, "particles", words);
    snprintf(words, sizeof words, "2: %" PRIu32 ", of species %s", j,
             s->species[s->particle[j].species].name);
    put_words(out, "", words);
}

static void put_instant(FILE *out, const char *name, double year, brink_instant t)
{
    char words[40];
    put_number(out, name, brink_instant_time(year, t));
    snprintf(words, sizeof words, "%" PRId64, t.epoch);
    put_words(out, "    is years gone by", words);
    put_number(out, "    of", year);
    put_number(out, "    and", t.offset);
}

// --- What came before ----------------------------------------------------------

static void put_replay(FILE *out, const brink_replay *replay, const char *of,
                       uint64_t event)
{
    fprintf(out, "event %" PRIu64 " of %s\n", event, of);
    put_words(out, "replayed from",
              replay->from[0] ? replay->from : "its beginning");
    fprintf(out, "  %-30s  %" PRIu64 "\n", "seed", replay->seed);
    put_words(out, "tier", tiers[replay->run.tier]);
}

static void put_asked(FILE *out, const brink_run *run, const brink_asked *asked,
                      const brink_entry *entry)
{
    char words[120];
    put_head(out, "how it was predicted");
    if (!asked->known) {
        put_words(out, "when", "before this checkpoint was written");
        return;
    }
    snprintf(words, sizeof words,
             "after event %" PRIu64 ", for particle %" PRIu32
             ", which found %" PRIu32,
             asked->events, asked->by, asked->of);
    put_words(out, "when", words);
    put_instant(out, "time", run->system.year, asked->when);
    put_vector(out, "r", asked->r);
    put_vector(out, "v", asked->v);
    snprintf(words, sizeof words, "%s time, tier %s, step %d",
             entry->kind == BRINK_ENTRY_INWARD ? "intersection" : "disjoint",
             tiers[run->tier],
             entry->kind == BRINK_ENTRY_INWARD ? asked->level + 1 : asked->level);
    put_words(out, "kernel asked", words);
    put_number(out, "its answer", asked->answer);
    put_words(out, "so much later is the event",
              asked->is_met ? "yes, to the bit" : "NO");
}

static void put_event(FILE *out, const brink_run *run, const brink_entry *entry,
                      enum brink_run_status status)
{
    static const char *const kinds[] = {"core", "capture", "release", "bounce"};
    const brink_happening *e = &run->last;
    char words[40];
    put_head(out, "the event");
    put_words(out, "kind",
              status == BRINK_RUN_REFUSED ? "refused" : kinds[e->kind]);
    put_particles(out, &run->system, entry->i, entry->j);
    if (status != BRINK_RUN_REFUSED) {
        snprintf(words, sizeof words, "%d -> %d", e->level_before,
                 e->level_after);
        put_words(out, "level", words);
    }
    put_instant(out, "time", run->system.year, entry->when);
    put_words(out, "due when predicted", entry->at_once ? "yes: clamped" : "no");
}

// --- The event -----------------------------------------------------------------

// Whether the run, the event executed, has what was made of it here.
static int is_run_the_same(const brink_run *run, const brink_entry *entry,
                           const brink_explained *pair, double owed)
{
    const brink_particle *p = run->system.particle;
    return memcmp(p[entry->i].v, pair->v1, sizeof pair->v1) == 0 &&
           memcmp(p[entry->j].v, pair->v2, sizeof pair->v2) == 0 &&
           brink_states_level(&run->states, entry->i, entry->j) == pair->level &&
           run->owed == owed;
}

// The run is just before the event, and will be just behind it.
static void explain_event(FILE *out, brink_run *run, const brink_entry *entry,
                          const brink_asked *asked)
{
    brink_explained pair = pair_of(run, entry->i, entry->j, entry->when.offset);
    double owed = run->owed;
    const enum brink_run_status status = brink_run_step(run);
    put_event(out, run, entry, status);
    put_asked(out, run, asked, entry);
    put_head(out, "the pair, just before it");
    brink_explain_pair(out, &pair);
    brink_explain_surfaces(out, &pair);
    brink_explain_meeting(
        out, &pair,
        entry->kind == BRINK_ENTRY_INWARD ? BRINK_INWARD : BRINK_OUTWARD, &owed);
    put_words(out, "the run did the same",
              is_run_the_same(run, entry, &pair, owed) ? "yes, to the bit"
                                                       : "NO");
    if (status != BRINK_RUN_REACHED) {
        char why[2000];
        brink_run_diagnosis(run, status, why, sizeof why);
        fprintf(out, "\nThe run cannot go on: %s", why);
    }
}

static void explain_pair(FILE *out, const brink_run *run,
                         const brink_entry *entry, const uint32_t who[2])
{
    const brink_explained pair = pair_of(run, who[0], who[1], entry->when.offset);
    put_head(out, "the pair, just before the event");
    put_particles(out, &run->system, who[0], who[1]);
    put_instant(out, "time", run->system.year, entry->when);
    brink_explain_pair(out, &pair);
    brink_explain_surfaces(out, &pair);
}

static int knows_pair(const brink_run *run, const char *of,
                      const brink_explain_orders *o)
{
    for (int k = 0; o->has_pair && k < 2; k++)
        if (o->pair[k] >= run->system.count) {
            fprintf(stderr,
                    "%s: there is no particle %" PRIu32 ": they are 0 to %" PRIu32
                    "\n",
                    of, o->pair[k], run->system.count - 1);
            return 0;
        }
    return 1;
}

static int explain(FILE *out, brink_replay *replay, const char *of,
                   const brink_explain_orders *o)
{
    brink_run *run = &replay->run;
    brink_asked asked;
    if (!knows_pair(run, of, o))
        return BRINK_EXIT_USAGE;
    const uint32_t slot = brink_replay_approach(replay, of, o->event);
    if (slot == run->calendar.slots)
        return BRINK_EXIT_USAGE;
    if (!o->has_pair) {
        brink_run_destroy(run);
        if (begin(replay, of, o))
            return BRINK_EXIT_USAGE;
        brink_replay_watch(replay, slot, o->event, &asked);
    }
    const brink_entry entry = run->calendar.entry[slot];
    put_replay(out, replay, of, o->event);
    if (o->has_pair)
        explain_pair(out, run, &entry, o->pair);
    else
        explain_event(out, run, &entry, &asked);
    return BRINK_EXIT_DONE;
}

int brink_explain(FILE *out, const char *of, const brink_explain_orders *orders)
{
    brink_replay replay;
    int code = BRINK_EXIT_USAGE;
    if (begin(&replay, of, orders) == 0) {
        code = explain(out, &replay, of, orders);
        brink_run_destroy(&replay.run);
    }
    return code;
}
