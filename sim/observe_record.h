// SPDX-License-Identifier: MIT
#ifndef BRINK_OBSERVE_RECORD_H
#define BRINK_OBSERVE_RECORD_H
/**
 * What a scene asks to be measured of a run, sampled at instants a fixed
 * simulated time apart: `from`, from + every, from + 2 every ...  Nothing is done
 * on the way of an event, and a run is the same whether it is observed or not.
 *
 * Averages with their errors: see observe_series.h.  Pressure is
 * N k_B T / V + virial / (d V t), with the virial of the time since the last
 * sample; the rate is that of events of one particle, the inverse of the mean
 * free time.  Speeds are in units of sqrt(k_B T / m), at the temperature the run
 * began with: so all species have one distribution, Maxwell's.
 */
#include "observe_displacements.h"
#include "observe_distances.h"
#include "run.h"
#include "scene.h"

#define BRINK_RECORD_SPEEDS     60  // bins
#define BRINK_RECORD_SPEED_STEP 0.1 // their width; one in 10^7 is beyond the last

typedef struct brink_record {
    brink_wish wish;
    uint64_t samples;
    double thermal;  // k_B T that speeds are measured by
    uint64_t events; // at the last sample
    brink_sum virial;
    double *x; // [3 i + axis] coordinates, scratch
    brink_series pressure, temperature, energy, rate;
    brink_distances distances;
    brink_displacements displacements;
    brink_series *speed; // density, of BRINK_RECORD_SPEEDS bins
} brink_record;

/** Before its first sample.  wish.every > 0.  0, -1 no memory. */
int brink_record_create(brink_record *record, const brink_wish *wish,
                        const brink_run *run);
void brink_record_destroy(brink_record *record);

/** When the next sample is due: BRINK_NEVER where nothing is asked for. */
brink_instant brink_record_due(const brink_record *record, const brink_run *run);

/** Takes the sample that is due, all events up to and at its instant executed. */
void brink_record_sample(brink_record *record, const brink_run *run);

/** Every bit of it as bytes, for a checkpoint: to be freed.  0, -1 no memory. */
int brink_record_pack(const brink_record *record, char **bytes, uint64_t *size);
/** From them into a record just created.  NULL, or what is wrong. */
const char *brink_record_unpack(brink_record *record, char *bytes, uint64_t size);
#endif
