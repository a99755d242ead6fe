// SPDX-License-Identifier: MIT
#ifndef BRINK_OBSERVE_FIGURES_H
#define BRINK_OBSERVE_FIGURES_H
/**
 * What a record comes to: figures with their errors, and curves.
 */
#include "observe_record.h"

typedef struct brink_figure {
    double mean, error; // NaN where there are too few samples
} brink_figure;

brink_figure brink_figures_of(const brink_series *series);
/** Inverse of the mean rate of events. */
brink_figure brink_figures_free_time(const brink_record *record);
/** NaN where displacements are not to be trusted. */
brink_figure brink_figures_diffusion(const brink_record *record, int species);

/**
 * For summary.json "observed": {from, every, samples, pressure, temperature,
 * potential_energy_per_particle, mean_free_time, and where displacements are
 * asked for diffusion: {SPECIES: ...}, farthest_step}, each figure as
 * {"mean": , "error": }, null where there is none yet.
 */
void brink_figures_json(FILE *out, const brink_record *record,
                        const brink_system *system);

/**
 * Tables for plots: `#` and what the columns are, then a row a bin or lag.  Of
 * g(r) the middle of the bin and, for each pair of species, mean and error; of
 * displacements the time and the same for each species; of speeds the middle of
 * the bin, density, error.
 */
void brink_figures_distances(FILE *out, const brink_record *record,
                             const brink_system *system);
void brink_figures_displacements(FILE *out, const brink_record *record,
                                 const brink_system *system);
void brink_figures_speeds(FILE *out, const brink_record *record);

/** Text as the inside of a JSON string. */
void brink_figures_json_text(FILE *out, const char *text);
#endif
