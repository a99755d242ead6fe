// SPDX-License-Identifier: MIT
#ifndef PLAIN_SIMULATOR_H
#define PLAIN_SIMULATOR_H
/**
 * The yardstick: an event-driven simulator as one writes it in an afternoon after
 * the lecture [A04] and the article [C16].  One binary heap of all collisions
 * ahead; what has become stale, told by counts of collisions, is dropped when it
 * comes up.  One list of cells.  Pairs are predicted one by one, by [S16]'s
 * algorithms 1 and 2 as they stand in print, but for the branches of the second,
 * which go where they belong.  Positions and times are doubles.
 *
 * It is fair to it: each particle has a time of its own [C16], a crossing looks
 * at the nine new cells only, memory is asked for seldom, nothing is slow on
 * purpose.  It shares no line with the simulator it stands beside, but reads the
 * same start.
 *
 * One species, a hard core, at most one step around it, three dimensions, a box
 * of at least PLAIN_CELLS ranges a side.  A pair's level is logical [S16]: it is
 * captured if each stands in the other's list of partners.  It is right for runs
 * of some millions of events; it has no answer to what the rounding may do in
 * longer ones.
 */
#include "system.h"

/** Fewest cells on a side.  With four, those in adjacent cells are each other's
 * nearest images. */
#define PLAIN_CELLS 4

typedef struct plain_particle {
    double x[3], v[3];
    double since;   // when x held
    uint32_t count; // of changes of v: what was predicted from fewer is stale
    uint32_t next;  // in its cell
    int cell[3];
} plain_particle;

typedef struct plain_circle { // a particle's partners: captured with it
    uint32_t *who, count, room;
} plain_circle;

enum plain_kind { PLAIN_CROSSING, PLAIN_INWARD, PLAIN_OUTWARD };

typedef struct plain_event {
    double time;
    uint32_t i, j; // of a crossing, j is the axis
    uint32_t count_i, count_j;
    enum plain_kind kind;
} plain_event;

typedef struct plain_simulator {
    uint32_t count;
    plain_particle *particle;
    plain_circle *circle; // per particle
    double mass, length[3];
    double core, range,
        energy; // range is core's where there is no step around it
    int cells[3];
    double side[3];  // of a cell
    uint32_t *first; // per cell: who begins its list
    plain_event *heap;
    size_t waiting, room; // in the heap
    double now;
    uint64_t events, crossings, predictions; // so far
    struct {
        enum brink_event_kind kind;
        uint32_t i, j; // i < j
    } last;            // event
} plain_simulator;

/** Everything predicted from a start at time 0.  Here and later the program ends
 * where memory is out. */
void plain_create(plain_simulator *s, const brink_system *start);
void plain_destroy(plain_simulator *s);

/** Goes on until `events` events in all have been executed, or none is left. */
void plain_advance(plain_simulator *s, uint64_t events);

int plain_is_captured(const plain_simulator *s, uint32_t i, uint32_t j);

/** Nearest-image separation x_i - x_j, and velocity, now. */
void plain_relative(const plain_simulator *s, uint32_t i, uint32_t j, double r[3],
                    double u[3]);
double plain_energy(const plain_simulator *s); // kinetic and potential
#endif
