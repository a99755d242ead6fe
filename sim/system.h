// SPDX-License-Identifier: MIT
#ifndef BRINK_SYSTEM_H
#define BRINK_SYSTEM_H
/**
 * Particles, their species and potentials, and the box they are in.
 *
 * A position is a 64-bit fraction of the box: the resolution, length / 2^64, is
 * the same everywhere in it, periodic wrapping is the wrap-around of unsigned
 * integers, and the difference of two positions as a signed integer is the
 * nearest image.  Against doubles counted from an origin that is exact
 * translation invariance, and 2048 times the resolution at the far side of the
 * box.
 *
 * Each particle has a time of its own, when its position was last written down;
 * it moves in a straight line from there.  That time is an offset into the
 * current year; when the year turns, every particle is brought to its first
 * instant.
 */
#include "clock.h"
#include <brink/step.h>
#include <stddef.h>

/** So many that two slots for each in a calendar have numbers of 31 bits. */
#define BRINK_PARTICLES_MOST (UINT32_C(1) << 30)

/** What is told from rounded positions is told with this much to spare, so that a
 * pair in range is found wherever rounding has put it: 2^-20 against errors of
 * some 2^-50. */
#define BRINK_SLACK (1.0 + 0x1p-20)

typedef struct brink_particle {
    uint64_t x[3]; // position: fraction of the box's length, in units of 2^-64
    double v[3];   // velocity
    double since;  // offset in the current year at which x holds
    uint32_t generation; // changes of v: what was predicted from fewer is stale
    uint32_t species;
} brink_particle; // 64 bytes, a cache line

typedef struct brink_species {
    char name[16];
    double mass; // > 0
    // distance of the innermost step with its like: what is drawn
    double diameter;
    uint32_t count; // particles of it: they are numbered species by species
} brink_species;

typedef struct brink_system {
    int dimensions;   // 2 or 3; in two, x[2] and v[2] are 0 and length[2] is 1
    double length[3]; // of the box, periodic in all directions
    double unit[3];   // length / 2^64, exact
    double year;      // of the clock
    int64_t epoch;    // the current year: every `since` counts in it
    uint32_t count;
    brink_particle *particle; // count
    int species_count;
    brink_species *species;     // species_count
    brink_potential *potential; // [a * species_count + b], symmetric
    double range;               // the largest distance of any step; every side
                                // is longer than twice that by BRINK_SLACK
} brink_system;

/** Makes a system of `count` particles at rest at the origin, all of species 0,
 * with deep copies of the tables.  Returns 0, or -1 if memory is out (nothing is
 * kept). */
int brink_system_create(brink_system *s, int dimensions, const double length[3],
                        double year, uint32_t count, int species_count,
                        const brink_species *species,
                        const brink_potential *potential);
void brink_system_destroy(brink_system *s);

/** Bits that are not what they should be, as one sentence, or NULL if all is
 * well. */
const char *brink_system_is_valid(const brink_system *s);

static inline const brink_potential *
brink_system_potential(const brink_system *s, uint32_t i, uint32_t j)
{
    return &s->potential[s->particle[i].species * (uint32_t)s->species_count +
                         s->particle[j].species];
}

/** Position as a coordinate in [0, length) and back; any finite coordinate is
 * wrapped. */
double brink_system_coordinate(const brink_system *s, int axis, uint64_t x);
uint64_t brink_system_fraction(const brink_system *s, int axis,
                               double coordinate);

/** Moves particle i along its line to `offset` in the current year. */
void brink_system_advance(brink_system *s, uint32_t i, double offset);

/** Coordinates of particle i at `offset`, which may lie beyond the year's end;
 * the system is left as it is. */
void brink_system_position(const brink_system *s, uint32_t i, double offset,
                           double x[3]);

/** Turns to year `epoch` >= the current one: every particle is moved to its
 * beginning. */
void brink_system_turn(brink_system *s, int64_t epoch);

/** Nearest-image separation r = x_i - x_j at `offset` in the current year. */
static inline void brink_system_separation(const brink_system *s, uint32_t i,
                                           uint32_t j, double offset, double r[3])
{
    const brink_particle *p = &s->particle[i], *q = &s->particle[j];
    const double dp = offset - p->since, dq = offset - q->since;
    for (int a = 0; a < 3; a++)
        r[a] = (double)(int64_t)(p->x[a] - q->x[a]) * s->unit[a] +
               (p->v[a] * dp - q->v[a] * dq);
}

/** Sums over all particles, compensated. */
double brink_system_kinetic_energy(const brink_system *s);
void brink_system_momentum(const brink_system *s, double p[3]);

/** k_B T = 2 K / (d (N - 1)): momentum is conserved, so d degrees of freedom are
 * not thermal (for N = 1: 2 K / d). */
double brink_system_temperature(const brink_system *s);
double brink_system_volume(const brink_system *s);
#endif
