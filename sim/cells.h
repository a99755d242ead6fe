// SPDX-License-Identifier: MIT
#ifndef BRINK_CELLS_H
#define BRINK_CELLS_H
/**
 * Who can meet whom: the box in cells, every particle in a list of one of them.
 * The cell of a particle is a virtual state [S16 section 4]: set from position
 * once, then changed only by an executed crossing of a cell's wall.
 *
 * An axis has at least three cells (one where the system has no such dimension).
 * With five or more, cells are wider than the interaction, and two particles in
 * adjacent cells, at most 2/5 of the box apart, are each other's nearest image.
 * (With four they can be half the box apart, where a rounding would decide which
 * image is nearest.) With three, every cell is adjacent to every other and a
 * particle is looked for in its three nearest images: a particle travels at most
 * a third of the box between two crossings, a pair two thirds, and the fourth
 * image would have to come a whole box nearer to be within the interaction's
 * range, which is less than half the box.
 */
#include "system.h"

#define BRINK_BUCKET 3

/** Whom a cell holds, in no order.  Cells hold one or two as a rule: so three
 * are kept where the cell itself is, and the rest in further buckets.  Side by
 * side, a row of cells is a cache line or two. */
typedef struct brink_bucket {
    uint32_t who[BRINK_BUCKET];
    uint32_t fill; // how many; or, of a full one, the bucket that goes on
} brink_bucket;

typedef struct brink_cells {
    int count[3];  // cells along each axis
    int images[3]; // images to look in: 1 or 3
    // per axis, 0 or 1: are there cells beside a cell, and are they always near
    uint32_t adjacent[3], always[3];
    uint64_t inverse[2]; // ceil(2^64 / count[])
    uint32_t particles;  // number of them
    uint32_t total;      // cells: count[0] * count[1] * count[2]
    uint64_t *wall[3]; // per axis: the lower wall of each cell, and the box's end
    brink_bucket *bucket; // one a cell, then those for the rest
    uint32_t free;        // the first of those unused, chained by `fill`
    uint32_t *cell;       // per particle: the logical state, x fastest
    double reach;         // the interaction's, and a little more
} brink_cells;

/** A crossing: the axis of the wall and the way, -1 or +1. */
typedef struct brink_crossing {
    int axis, way;
} brink_crossing;

/** A crossing as one number, below 2 * dimensions, and back. */
static inline uint32_t brink_crossing_number(brink_crossing c)
{
    return (uint32_t)(2 * c.axis + (c.way > 0));
}

static inline brink_crossing brink_crossing_of(uint32_t number)
{
    return (brink_crossing){(int)(number / 2), number % 2 ? 1 : -1};
}

/** Chooses cells for the system, wider than `reach`, and files every particle by
 * its position.  0, -1 no memory.  Needs reach <= length / 2 on every axis. */
int brink_cells_create(brink_cells *c, const brink_system *system, double reach);
void brink_cells_destroy(brink_cells *c);
const char *brink_cells_is_valid(const brink_cells *c);

/** The cell at a position. */
uint32_t brink_cells_at(const brink_cells *c, const uint64_t x[3]);

/** Sets a particle's cell from a stored state (a checkpoint). */
void brink_cells_place(brink_cells *c, uint32_t i, uint32_t cell);

/** A particle's stay in its cell. */
typedef struct brink_stay {
    double until; // an offset that may lie beyond the year's end; +inf: for good
    brink_crossing crossing; // what ends it
    int cells;         // those in which it could meet somebody in the meantime:
    uint32_t near[27]; // adjacent, and within the interaction's range of its way
} brink_stay;

/** The stay of particle i from `offset` on; it does not end before that.  When it
 * ends depends on the particle's state alone, not on when it is asked for.  Who
 * has crossed looks anew, so nobody who is met while both are in their cells is
 * overlooked; where an axis has three images, all cells are near. */
void brink_cells_stay(const brink_cells *c, const brink_system *system,
                      uint32_t i, double offset, brink_stay *stay);

/** Executes a crossing.  Returns 1, or 0 where the state machine refuses it. */
int brink_cells_cross(brink_cells *c, uint32_t i, brink_crossing crossing);

/** The up to 27 cells adjacent to `cell`, itself included; the number of them. */
int brink_cells_around(const brink_cells *c, uint32_t cell, uint32_t around[27]);

/** Whoever is in some cells, a handful at a time. */
typedef struct brink_tour {
    const uint32_t *cell; // those still to be seen
    int cells;
    uint32_t further; // the bucket to go on with; 0: the next cell's
} brink_tour;

#define BRINK_NOBODY  UINT32_MAX
#define BRINK_HANDFUL 128

static inline brink_tour brink_tour_of(const uint32_t *cell, int cells)
{
    return (brink_tour){cell, cells, 0};
}

/** A tour of the cells around particle i's, whose numbers go to `around`. */
static inline brink_tour brink_tour_around(const brink_cells *c, uint32_t i,
                                           uint32_t around[27])
{
    return brink_tour_of(around, brink_cells_around(c, c->cell[i], around));
}

/** The next of a cell with more of them than its own bucket holds. */
int brink_tour_further(const brink_cells *c, brink_tour *tour,
                       uint32_t who[BRINK_HANDFUL]);

/** The next of them; how many, 0 when all have been seen.  Every bucket is copied
 * whole and counted afterwards: how many it holds is nothing that a processor
 * could foresee, and it need not wait for that to fetch the next. */
static inline int brink_tour_next(const brink_cells *c, brink_tour *tour,
                                  uint32_t who[BRINK_HANDFUL])
{
    if (tour->further)
        return brink_tour_further(c, tour, who);
    const uint32_t *cell = tour->cell, *const end = cell + tour->cells;
    uint32_t n = 0, further = 0;
    while (cell < end && n <= BRINK_HANDFUL - BRINK_BUCKET) {
        const brink_bucket *b = &c->bucket[*cell];
        const uint32_t fill = b->fill;
        for (int k = 0; k < BRINK_BUCKET; k++)
            who[n + (uint32_t)k] = b->who[k];
        if (fill > BRINK_BUCKET) {
            n += BRINK_BUCKET;
            further = fill;
            break;
        }
        n += fill;
        cell++;
    }
    *tour = (brink_tour){cell, (int)(end - cell), further};
    return (int)n;
}
#endif
