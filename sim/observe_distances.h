// SPDX-License-Identifier: MIT
#ifndef BRINK_OBSERVE_DISTANCES_H
#define BRINK_OBSERVE_DISTANCES_H
/**
 * The radial distribution g(r): how many pairs there are at a distance, to how
 * many there would be without interaction, exactly 1 for an ideal gas of N
 * particles (that is, N - 1 others are counted, not N).  One function for every
 * pair of species.
 */
#include "observe_series.h"
#include "system.h"

typedef struct brink_distances {
    double most; // <= half the box: beyond, not all of a shell is in it
    int bins;    // of equal width from 0 to there
    int species;
    brink_series *g; // [kind * bins + bin], see brink_distances_kind
    double *ideal;   // the same: pairs without interaction
    double *pairs;   // the same: scratch
    int cells[3];    // not narrower than `most`, where there are more than two
    uint32_t *first, *next; // lists of who is in them
} brink_distances;

/** 0, -1 no memory. */
int brink_distances_create(brink_distances *d, const brink_system *system,
                           double most, int bins);
void brink_distances_destroy(brink_distances *d);

/** Of species a <= b: 0, 1, ... */
static inline int brink_distances_kind(int a, int b)
{
    return b * (b + 1) / 2 + a;
}

/** One sample, from the coordinates [3 i + axis] of all particles. */
void brink_distances_sample(brink_distances *d, const brink_system *system,
                            const double *x);
void brink_distances_code(brink_codec *c, brink_distances *d);
#endif
