// SPDX-License-Identifier: MIT
#ifndef BRINK_OBSERVE_H
#define BRINK_OBSERVE_H
/**
 * What a run has to say for itself: the summary, and the line of progress.  Looks
 * at a run between pieces and changes nothing.
 */
#include "observe_record.h"
#include "snapshot.h"
#include <stdio.h>

/**
 * Writes summary.json: particles, events, events_by_kind{core, capture, release,
 * bounce, wall, cell}, time, wall_seconds, events_per_second, energy_initial,
 * energy_final, energy_drift_relative (to the initial kinetic energy, which
 * unlike the total is never near 0), momentum_drift (largest component of the
 * change, to the sum of |p|), temperature, potential_energy_per_particle,
 * pressure, compressibility_factor, mean_free_time, contact_error_max (relative
 * to the step's distance), anomalies{clamped, zero_time, repeated, rim, refused};
 * besides title, version, seed, tier, stopped (why) and the neighbourhood: cells
 * or lists of neighbours, how many cells, and neighbours_per_particle of lists.
 * A figure that does not exist yet (pressure at time 0) is null.  Where the scene
 * asks for observations (`record` is not NULL), also observed: see
 * brink_figures_json.  0, -1 if the file could not be written.
 */
int brink_observe_summary(FILE *out, const brink_run *run, const brink_plan *plan,
                          const char *title, const char *stopped,
                          const brink_record *record);

/** Part of the target that is done, 0 to 1. */
double brink_observe_done(const brink_run *run, const brink_plan *plan);

/** One line: events, part done, rate, time left, energy drift. */
void brink_observe_progress(char *line, size_t size, const brink_run *run,
                            const brink_plan *plan, double rate);
#endif
