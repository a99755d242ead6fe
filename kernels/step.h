// SPDX-License-Identifier: MIT
#ifndef BRINK_STEP_H
#define BRINK_STEP_H
/**
 * The logical state machine of a stepped potential [S16 sections 2-4].
 *
 * A potential is a list of steps at decreasing distance, each with the energy of
 * a pair inside it.  A pair's *level* is the number of steps it is inside of: 0
 * is uncaptured.  The level is information of its own, set once from positions
 * when a configuration is first made and changed afterwards by executed transfer
 * events alone; no function here that moves a state looks at a position.
 */
#ifdef __cplusplus
extern "C" {
#endif

typedef struct brink_potential {
    int count;              // number of steps, >= 1
    const double *distance; // count values, finite, > 0, strictly decreasing
    const double *energy;   // count values; energy[k] holds inside distance[k].
                            // finite, or +inf in the last one: a hard core
} brink_potential;

/** What happens to a pair at a step [S16 fig. 1].  The numbers are an order:
 * events at one instant are executed in it, and files name them by it. */
enum brink_event_kind {
    BRINK_CORE = 0,    // elastic reflection at an infinite step
    BRINK_CAPTURE = 1, // goes in by one step
    BRINK_RELEASE = 2, // goes out by one step
    BRINK_BOUNCE = 3   // reflected by a finite step, from either side
};

/** Which way a pair meets a step; from which side, its level says. */
enum brink_direction { BRINK_INWARD = -1, BRINK_OUTWARD = 1 };

/** 1 if the potential is as described above, 0 otherwise. */
int brink_potential_is_valid(const brink_potential *p);

/** Energy of a pair at `level`: 0 for level 0, energy[level - 1] within 1..count,
 *  NaN for any other level. */
double brink_potential_energy(const brink_potential *p, int level);

/** Number of levels a pair can be in: count + 1, or count where the innermost
 * step is a hard core, which no pair is ever inside of. */
int brink_potential_levels(const brink_potential *p);

/** Change of potential energy on crossing the next step inward or outward from
 *  `level`; +inf at a hard core; NaN where there is no such step. */
double brink_step_rise(const brink_potential *p, int level,
                       enum brink_direction way);

/** The level that the separation r shows: how many steps have r.r < distance^2,
 * by exact signs.  On a step's surface a pair counts as outside it.  For
 * configurations when first made, and for those who want to see how often
 * position is wrong. */
int brink_step_level_at(const brink_potential *p, const double r[3]);

/**
 * The state machine: one event applied to one level.
 *
 * Returns   1 and the new level in *next where the event is legal:
 *               capture  the next step inward is finite: level + 1
 *               release  the level is above 0: level - 1
 *               bounce   there is a finite step to bounce from: level
 *               core     the next step inward is infinite: level
 *           0 and *next = level for everything else, an illegal level included
 */
int brink_step_next(const brink_potential *p, int level,
                    enum brink_event_kind event, int *next);

/**
 * The virtual states of [S16 section 4], by the same rule: the side of a virtual
 * wall (0 or 1) and the index of a cell along an axis change only by an executed
 * crossing.
 *
 *     brink_side_next    the other side
 *     brink_cell_next    cell + way along an axis of `cells` cells, wrapping
 *                        round where it is periodic
 *
 * Returns   1 and the new one in *next; 0 and *next = the old one where that is
 *           none or has no next
 */
int brink_side_next(int side, int *next);
int brink_cell_next(int cell, int cells, int way, int periodic, int *next);

#ifdef __cplusplus
}
#endif
#endif
