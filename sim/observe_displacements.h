// SPDX-License-Identifier: MIT
#ifndef BRINK_OBSERVE_DISPLACEMENTS_H
#define BRINK_OBSERVE_DISPLACEMENTS_H
/**
 * How far particles get: the mean squared displacement and the diffusion
 * coefficient, of every species.
 *
 * A window is as long as the longest lag; where one ends the next begins.  In
 * each the displacements from its beginning are followed from sample to sample,
 * and D is the slope of the mean squared displacement over its second half, over
 * 2 d: right if in half a window a particle forgets how it was moving.
 *
 * From one sample to the next a particle is taken to have gone to the nearest
 * image of where it is, which is right if it went less than half the box along
 * every axis.  This is watched: `farthest` is the farthest that was seen, in
 * lengths of the box, and above BRINK_DISPLACEMENTS_TRUSTED nothing is answered.
 * Steps are spread smoothly, so some that are mistaken, from 1/2 on, do not come
 * without many between 1/4 and 3/4, all of which are seen to be over 1/4.
 */
#include "observe_series.h"
#include "system.h"

#define BRINK_DISPLACEMENTS_TRUSTED 0.25

typedef struct brink_displacements {
    uint32_t particles;
    int species, lags;
    double span;     // simulated time of the longest lag
    uint64_t looks;  // samples taken; the first of a window is the last's last
    double farthest; // in one axis' lengths of the box
    double *at;      // [3 i + axis] coordinates at the last sample
    double *gone;    // the same: displacement in this window so far
    double *half;    // per species: of this window, at half of it
    brink_series *square;    // [species * lags + lag - 1]
    brink_series *diffusion; // [species]
} brink_displacements;

/** lags >= 2.  0, -1 no memory. */
int brink_displacements_create(brink_displacements *d, const brink_system *system,
                               int lags, double every);
void brink_displacements_destroy(brink_displacements *d);

/** One sample, from the coordinates [3 i + axis] of all particles. */
void brink_displacements_sample(brink_displacements *d,
                                const brink_system *system, const double *x);
void brink_displacements_code(brink_codec *c, brink_displacements *d);

static inline int brink_displacements_trusted(const brink_displacements *d)
{
    return d->farthest <= BRINK_DISPLACEMENTS_TRUSTED;
}
#endif
