// SPDX-License-Identifier: MIT
#include <brink/step.h>

#include "../tests/oracle_overlap.h"
#include "fuzz.h"
#include <limits.h>
#include <string.h>

enum { MOST_STEPS = 6, MOST_EVENTS = 64 };

typedef struct well {
    double distance[MOST_STEPS], energy[MOST_STEPS];
    brink_potential p;
} well;

static _Noreturn void broken(const well *w, const char *what, int level,
                             int event, int got)
{
    FINDING("step: %s; level %d, event %d: %d", what, level, event, got);
    finding_numbers("distance", w->p.count, w->distance);
    finding_numbers("energy", w->p.count, w->energy);
    finding_end();
}

// --- What is right: written down from step.h, on its own -----------------------

/** Finite distances above 0, each less than the one before; finite energies, and
 *  the last may be +inf. */
static int is_valid(const well *w)
{
    int right = 1;
    double least = (double)INFINITY;
    for (int k = 0; k < w->p.count; k++) {
        const double d = w->distance[k], e = w->energy[k];
        right = right && d > 0 && d < least && isfinite(d) && !isnan(e) &&
                e != -(double)INFINITY;
        right = right && (e != (double)INFINITY || k == w->p.count - 1);
        least = d;
    }
    return right && w->p.count >= 1;
}

/** How many steps a pair can be inside of. */
static int deepest(const well *w)
{
    const int last = w->p.count - 1;
    return w->energy[last] == (double)INFINITY ? last : last + 1;
}

/** Where an event leads to; -1: it is refused. */
static int next_of(const well *w, int level, int event)
{
    const int inner = level < w->p.count, soft = level < deepest(w);
    if (level < 0 || level > deepest(w))
        return -1;
    if (event == BRINK_CAPTURE)
        return soft ? level + 1 : -1;
    if (event == BRINK_RELEASE)
        return level - 1;
    if (event == BRINK_BOUNCE)
        return soft || level > 0 ? level : -1;
    return event == BRINK_CORE && inner && !soft ? level : -1;
}

static double energy_of(const well *w, int level)
{
    if (level < 0 || level > w->p.count)
        return (double)NAN;
    return level > 0 ? w->energy[level - 1] : 0;
}

// --- Against the kernel --------------------------------------------------------

static int equal(double x, double y)
{
    return x == y || (isnan(x) && isnan(y));
}

static void check_energies(const well *w, int level)
{
    if (!equal(brink_potential_energy(&w->p, level), energy_of(w, level)))
        broken(w, "energy", level, 0, 0);
    const int is_level = level >= 0 && level <= deepest(w);
    for (int way = -1; way <= 1; way += 2) {
        const double rise = is_level
                                ? energy_of(w, level - way) - energy_of(w, level)
                                : (double)NAN;
        if (!equal(brink_step_rise(&w->p, level, (enum brink_direction)way),
                   rise))
            broken(w, "rise", level, way, 0);
    }
}

/** Any level, or one that a pair can be in, or is next to. */
static int some_level(stream *s, const well *w)
{
    static const int strange[] = {INT_MIN, INT_MAX, -1000, 1000};
    if (stream_int(s, 0, 15) == 0)
        return strange[stream_int(s, 0, 3)];
    return stream_int(s, -1, w->p.count + 1);
}

static int step_to(const well *w, int level, int event)
{
    int next = INT_MIN;
    const int legal =
        brink_step_next(&w->p, level, (enum brink_event_kind)event, &next);
    const int right = next_of(w, level, event);
    if (legal != (right >= 0))
        broken(w, "legal", level, event, legal);
    if (next != (right >= 0 ? right : level))
        broken(w, "next", level, event, next);
    return next;
}

/** A log of events on a level: it is what it was at first, and as many more as
 *  captures that were legal, and less than releases. */
static void check_log(const well *w, stream *s)
{
    const int start = stream_int(s, 0, deepest(w));
    int state = start, counted = start;
    for (int n = stream_int(s, 0, MOST_EVENTS); n > 0; n--) {
        const int event = stream_int(s, -1, 4), from = state;
        const int legal = next_of(w, state, event) >= 0;
        state = step_to(w, state, event);
        counted +=
            legal ? (event == BRINK_CAPTURE) - (event == BRINK_RELEASE) : 0;
        if (state != counted || state < 0 || state > deepest(w))
            broken(w, "the log", from, event, state);
    }
}

/** A separation on a step's surface, to some ulp; or whole, and exactly on it. */
static void some_place(stream *s, const well *w, double r[3])
{
    static const double triples[3][3] = {{3, 4, 0}, {2, 3, 6}, {-8, 4, 1}};
    const double d = w->distance[stream_int(s, 0, w->p.count - 1)];
    const int which = stream_int(s, 0, 3);
    double unit[3] = {1, 0, 0}, length = 1;
    if (which < 3) {
        memcpy(unit, triples[which], sizeof unit);
        length = which == 0 ? 5 : which == 1 ? 7 : 9;
    }
    for (int i = 0; i < 3; i++)
        r[i] = unit[i] / length * d;
    r[stream_int(s, 0, 2)] += stream_int(s, 0, 3) ? 0 : d * stream_real(s, -1, 1);
    for (int i = 0; i < 3; i++)
        r[i] = stream_near(s, r[i], 1);
}

static void check_place(const well *w, stream *s)
{
    static const double zero[3] = {0, 0, 0};
    double r[3];
    mpfr_t f;
    int level = 0;
    some_place(s, w, r);
    mpfr_init2(f, ORACLE_BITS);
    for (int k = 0; k < w->p.count; k++) { // distances decrease
        oracle_ball(f, r, zero, w->distance[k], 0);
        level += mpfr_sgn(f) < 0;
    }
    mpfr_clear(f);
    const int got = brink_step_level_at(&w->p, r);
    if (got == level)
        return;
    finding_numbers("r", 3, r);
    broken(w, "the level that a place shows", level, 0, got);
}

// --- Sides and cells -----------------------------------------------------------

static void check_virtual_states(const well *w, stream *s)
{
    static const int extremes[] = {INT_MIN, INT_MAX, INT_MAX - 1, -1};
    int next = INT_MIN, side = stream_int(s, -2, 3);
    int legal = brink_side_next(side, &next);
    if (legal != (side == 0 || side == 1) || next != (legal ? !side : side))
        broken(w, "side", side, 0, next);

    const int cells = stream_int(s, 0, 7) ? stream_int(s, -1, 5)
                                          : extremes[stream_int(s, 0, 3)];
    const int cell = stream_int(s, 0, 7) ? stream_int(s, -1, 6)
                                         : extremes[stream_int(s, 0, 3)];
    const int way = stream_int(s, -2, 2), periodic = stream_int(s, 0, 1);
    const long long to = (long long)cell + way;
    const int inside = to >= 0 && to < cells;
    const int right = cell >= 0 && cell < cells && (way == 1 || way == -1) &&
                      (inside || periodic);
    legal = brink_cell_next(cell, cells, way, periodic, &next);
    const long long wrapped = right ? (to + cells) % cells : cell;
    if (legal != right || next != wrapped)
        broken(w, "cell", cell, way, next);
}

// --- The case ------------------------------------------------------------------

/** Decreasing distances and finite energies, as a rule; then perhaps one of them
 *  is changed. */
static void make_well(well *w, stream *s)
{
    static const double odd[] = {(double)INFINITY, -(double)INFINITY, (double)NAN,
                                 0, -1};
    double d = stream_scaled(s, 0, 4);
    w->p =
        (brink_potential){stream_int(s, 1, MOST_STEPS), w->distance, w->energy};
    d = stream_int(s, 0, 3) ? fabs(d) : stream_int(s, 1, 1000);
    for (int k = 0; k < w->p.count; k++) {
        w->distance[k] = d;
        w->energy[k] = stream_int(s, -3, 3);
        d = stream_int(s, 0, 2) ? nextafter(d, 0) : d * stream_real(s, 0.5, 1);
    }
    if (stream_int(s, 0, 1))
        w->energy[w->p.count - 1] = (double)INFINITY;
    if (stream_int(s, 0, 7) == 0) {
        double *of = stream_int(s, 0, 1) ? w->distance : w->energy;
        of[stream_int(s, 0, w->p.count - 1)] = odd[stream_int(s, 0, 4)];
    }
    if (stream_int(s, 0, 15) == 0) // two steps at one distance
        w->distance[w->p.count - 1] = w->distance[w->p.count / 2];
    if (stream_int(s, 0, 15) == 0)
        w->p.count = -stream_int(s, 0, 1);
}

static void check_nothing(const well *w)
{
    const brink_potential no_distance = {1, NULL, w->energy};
    const brink_potential no_energy = {1, w->distance, NULL};
    if (brink_potential_is_valid(NULL) || brink_potential_is_valid(&no_energy) ||
        brink_potential_is_valid(&no_distance))
        broken(w, "nothing is no potential", 0, 0, 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stream s = stream_of_bytes(data, size);
    well w = {0};
    make_well(&w, &s);
    const int valid = brink_potential_is_valid(&w.p);
    if (valid != is_valid(&w))
        broken(&w, "valid", 0, 0, valid);
    check_virtual_states(&w, &s);
    check_nothing(&w);
    if (!valid)
        return 0;
    if (brink_potential_levels(&w.p) != deepest(&w) + 1)
        broken(&w, "levels", 0, 0, brink_potential_levels(&w.p));
    for (int n = 0; n < 4; n++) {
        const int level = some_level(&s, &w);
        check_energies(&w, level);
        step_to(&w, level, stream_int(&s, -1, 5));
    }
    check_log(&w, &s);
    check_place(&w, &s);
    return 0;
}
