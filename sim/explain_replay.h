// SPDX-License-Identifier: MIT
#ifndef BRINK_EXPLAIN_REPLAY_H
#define BRINK_EXPLAIN_REPLAY_H
/**
 * A run replayed to just before one of its events, and the prediction that the
 * event came from.
 *
 * It is replayed twice: once to see whose event it is, once to see who asked for
 * it, and when.  Levels, velocities and roundings are the run's own, to the bit.
 */
#include "run.h"

typedef struct brink_replay {
    brink_run run;
    uint64_t events; // where it ends: its target,
    double until;    // by either
    uint64_t seed;
    char from[4200]; // the checkpoint's path; empty: from its beginning
} brink_replay;

/** The prediction that an entry comes from. */
typedef struct brink_asked {
    int known;       // 0: it was made before the replay began
    uint64_t events; // executed by then
    brink_instant when;
    uint32_t by, of;   // the particle that was looking, and the one it found
    int level;         // of the pair then
    double r[3], v[3]; // x[by] - x[of], in the image that it found
    double answer;     // the kernel's time
    int is_met;        // 1: `answer` later is just when the event is, bit for bit
} brink_asked;

/** Before the first event of a scene's run ... */
int brink_replay_of_scene(brink_replay *replay, const char *name, int has_seed,
                          uint64_t seed, enum brink_tier tier);
/** ... or at the newest checkpoint of a folder's run from before `event`; at its
 * beginning where there is none.  Both: 0; -1 after a complaint, *replay
 * empty. */
int brink_replay_of_folder(brink_replay *replay, const char *dir, uint64_t event);

/** Goes on to just before `event`, the two that have it moved to where they meet.
 * Its slot in the calendar; calendar.slots after a complaint that begins with
 * `name`, where the run ends earlier. */
uint32_t brink_replay_approach(brink_replay *replay, const char *name,
                               uint64_t event);

/** The same, along which the prediction of the event in `slot` is looked out
 * for. */
void brink_replay_watch(brink_replay *replay, uint32_t slot, uint64_t event,
                        brink_asked *asked);
#endif
