// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_TIERS_H
#define BRINK_STUDY_TIERS_H
/**
 * What the tiers of event times cost and buy for a whole run: a scene run in each
 * of them from the same start, side by side.
 */
#include "report.h"
#include "run.h"
#include "scene.h"

#define BRINK_TIERS 3 // enum brink_tier

typedef struct brink_tier_trial {
    enum brink_run_status status;
    double seconds; // of the processor, for the events alone
    // sqrt of the mean of (|r| / distance - 1)^2 over every hundredth event
    double contact_rms;
    double energy_error; // at the end, relative to that at the start
    brink_tally tally;
} brink_tier_trial;

/** Runs a scene, which was read from `path`, for so many events in each tier, in
 *  a process of its own.  The tiers take turns, so that what disturbs one of them
 *  disturbs all.  0, -1 where this could not be done. */
int brink_tiers_try(const brink_scene *scene, const char *path, uint64_t events,
                    brink_tier_trial trial[BRINK_TIERS]);

/** A heading, a paragraph and a table of them. */
void brink_tiers_tell(brink_report *r, const brink_tier_trial trial[BRINK_TIERS]);
#endif
