// SPDX-License-Identifier: MIT
#ifndef REFERENCE_H
#define REFERENCE_H
/**
 * The reference simulator: the dynamics written down from its definitions and
 * nothing else.  MPFR numbers of any precision; every pair, in every image,
 * looked at for every event; no cells, no queue, no kernel, not a line shared
 * with the simulator it judges.
 */
#include "system.h"
#include <mpfr.h>

typedef struct reference {
    const brink_system *system; // its tables: box, masses, potentials
    mpfr_t (*x)[3], (*v)[3];    // per particle, at `time`
    int *level;                 // [i * count + j], i < j
    mpfr_t time;
    struct { // the earliest event known
        mpfr_t dt;
        uint32_t i, j; // i < j; i == j: none
        enum brink_direction way;
    } next;
    mpfr_t r[3], image[3], u[3], t, a, b, c, d; // scratch
} reference;

typedef struct reference_event {
    enum brink_event_kind kind;
    uint32_t i, j; // i < j
    double time;   // rounded
} reference_event;

/** Copies what the system holds, without a rounding (so bits >= 128), and takes
 *  levels from position.  The system must outlive it, its particles need not. */
void reference_create(reference *w, const brink_system *system, mpfr_prec_t bits);
void reference_destroy(reference *w);

/** Between events: x += +-size of the box's length and v += +-size v, each
 *  component by a sign of its own. */
void reference_deflect(reference *w, double size, unsigned long signs);

/** Finds and executes the next event; 0 if none came in so many looks ahead, each
 *  over the time in which no pair travels further than a quarter of the box. */
#define REFERENCE_LOOKS 10000
int reference_next(reference *w, reference_event *event);
#endif
