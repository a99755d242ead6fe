// SPDX-License-Identifier: MIT
#include "neighbours.h"
#include "array.h"
#include <brink/event_time.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// A quarter of the distance between particles, and lists where three of them and
// more are in a sphere of the interaction's range.  Smaller balls are left too
// often, larger ones list too many, but a fifth is nearly as good; where it is
// less crowded, particles fly so far that they leave any ball too often.  Seen
// with hard spheres, packing 0.15 to 0.5, and square wells of 1.5, density 0.2 to
// 0.7.
#define RADIUS 0.25
#define CROWD  3.0

double brink_neighbours_radius(const brink_system *system)
{
    const double pi = acos(-1.0), range = system->range;
    const int is_plane = system->dimensions == 2;
    const double volume = brink_system_volume(system) / system->count;
    const double apart = is_plane ? sqrt(volume) : cbrt(volume);
    const double sphere =
        is_plane ? pi * range * range : 4 * pi / 3 * range * range * range;
    // In 64ths of the range, so that nothing hangs on a rounding of cbrt.
    const double radius = rint(RADIUS * apart / range * 64) / 64 * range;
    const double near = (range + 2 * radius) * BRINK_SLACK;
    for (int a = 0; a < system->dimensions; a++)
        if (system->length[a] < 5 * near)
            return 0;
    return sphere < CROWD * volume ? 0 : radius;
}

static void centre(const brink_home *home, uint64_t x[3])
{
    for (int a = 0; a < 3; a++)
        x[a] = (uint64_t)home->x[a] << 32;
}

void brink_neighbours_place(brink_neighbours *n, brink_cells *cells, uint32_t i,
                            const brink_home *home)
{
    uint64_t x[3];
    n->home[i] = *home;
    centre(home, x);
    brink_cells_place(cells, i, brink_cells_at(cells, x));
}

// The home of particle i is where it is, as near as may be.
static void settle(brink_neighbours *n, brink_cells *cells,
                   const brink_system *system, uint32_t i)
{
    const brink_particle *p = &system->particle[i];
    brink_home home = {.species = p->species};
    for (int a = 0; a < 3; a++)
        home.x[a] = (uint32_t)((p->x[a] + UINT64_C(0x80000000)) >> 32);
    brink_neighbours_place(n, cells, i, &home);
}

int brink_neighbours_create(brink_neighbours *n, brink_cells *cells,
                            const brink_system *system, double radius)
{
    memset(n, 0, sizeof *n);
    n->radius = radius;
    if (!(radius > 0))
        return 0;
    const size_t kinds = (size_t)system->species_count;
    n->home = brink_array_create(system->count, sizeof *n->home);
    n->mark = brink_array_create(system->count, 1);
    n->near = malloc(kinds * kinds * sizeof *n->near);
    if (!n->home || !n->mark || !n->near ||
        brink_lists_create(&n->who, system->count, sizeof(uint32_t))) {
        brink_neighbours_destroy(n);
        return -1;
    }
    for (int a = 0; a < 3; a++)
        n->unit[a] = system->length[a] * 0x1p-32;
    for (size_t k = 0; k < kinds * kinds; k++) {
        const double near =
            (system->potential[k].distance[0] + 2 * radius) * BRINK_SLACK;
        n->near[k] = near * near;
    }
    for (uint32_t i = 0; i < system->count; i++)
        settle(n, cells, system, i);
    return 0;
}

void brink_neighbours_destroy(brink_neighbours *n)
{
    free(n->home);
    free(n->mark);
    free(n->near);
    brink_lists_destroy(&n->who);
    memset(n, 0, sizeof *n);
}

// All axes at once, in three lanes of four.
typedef uint32_t units __attribute__((vector_size(16))); // they wrap around
typedef int32_t way_round __attribute__((vector_size(16)));
typedef double lanes __attribute__((vector_size(32)));

// Leaves of `who` those whose homes are near i's, itself included, and says how
// many: counted rather than branched to, as no processor could foresee who is.
static int keep_near(const brink_neighbours *n, const brink_system *system,
                     uint32_t i, uint32_t *who, int count)
{
    const brink_home *home = n->home;
    const double *near =
        &n->near[home[i].species * (uint32_t)system->species_count];
    const lanes unit = {n->unit[0], n->unit[1], n->unit[2], 0.0};
    units p, q;
    memcpy(&p, &home[i], sizeof p);
    int kept = 0;
    for (int m = 0; m < count; m++) {
        const uint32_t k = who[m];
        memcpy(&q, &home[k], sizeof q);
        lanes d = __builtin_convertvector((way_round)(p - q), lanes) * unit;
        d *= d;
        who[kept] = k;
        kept += d[0] + d[1] + d[2] < near[home[k].species];
    }
    return kept;
}

// The next of a tour whose homes are near i's; how many, 0 when all were seen.
static int next_near(const brink_neighbours *n, const brink_cells *cells,
                     const brink_system *system, uint32_t i, brink_tour *tour,
                     uint32_t who[BRINK_HANDFUL])
{
    int near = 0;
    for (int count;
         near == 0 && (count = brink_tour_next(cells, tour, who)) > 0;) {
        for (int m = 0; m < count; m++)
            __builtin_prefetch(&n->home[who[m]]);
        near = keep_near(n, system, i, who, count);
    }
    return near;
}

static int make_neighbours(brink_neighbours *n, uint32_t i, uint32_t k)
{
    if (brink_lists_make_room(&n->who, i, k))
        return -1;
    *(uint32_t *)brink_lists_add(&n->who, i) = k;
    *(uint32_t *)brink_lists_add(&n->who, k) = i;
    return 0;
}

// The one at place m of i's list is its neighbour no more.
static void part_from(brink_neighbours *n, uint32_t i, uint32_t m)
{
    const uint32_t k = brink_neighbours_of(n, i)[m];
    const uint32_t *who = brink_neighbours_of(n, k);
    uint32_t place = 0;
    while (who[place] != i)
        place++;
    brink_lists_remove(&n->who, i, m);
    brink_lists_remove(&n->who, k, place);
}

int brink_neighbours_fill(brink_neighbours *n, const brink_cells *cells,
                          const brink_system *system)
{
    if (!(n->radius > 0))
        return 0;
    for (uint32_t i = 0; i < system->count; i++) {
        uint32_t around[27], who[BRINK_HANDFUL];
        brink_tour tour = brink_tour_around(cells, i, around);
        for (int near; (near = next_near(n, cells, system, i, &tour, who)) > 0;)
            for (int m = 0; m < near; m++)
                if (who[m] > i && make_neighbours(n, i, who[m]))
                    return -1;
    }
    return 0;
}

// Where particle i was, as seen from its home, at its own time.
static void from_home(const brink_neighbours *n, const brink_system *system,
                      uint32_t i, double r[3])
{
    const brink_particle *p = &system->particle[i];
    uint64_t home[3];
    centre(&n->home[i], home);
    for (int a = 0; a < 3; a++)
        r[a] = (double)(int64_t)(p->x[a] - home[a]) * system->unit[a];
}

double brink_neighbours_until(const brink_neighbours *n,
                              const brink_system *system, uint32_t i,
                              double offset)
{
    const brink_particle *p = &system->particle[i];
    double r[3];
    from_home(n, system, i, r);
    const double until = p->since + brink_disjoint_time_fast(r, p->v, n->radius);
    return until > offset ? until : offset;
}

enum { NO_NEIGHBOUR, BEFORE, BEFORE_AND_NOW };

// Adds those around to i's list who are near now and were not before.
static int add_new(brink_neighbours *n, const brink_cells *cells,
                   const brink_system *system, uint32_t i)
{
    uint32_t around[27], who[BRINK_HANDFUL];
    brink_tour tour = brink_tour_around(cells, i, around);
    for (int near; (near = next_near(n, cells, system, i, &tour, who)) > 0;)
        for (int m = 0; m < near; m++) {
            const uint32_t k = who[m];
            if (n->mark[k] == BEFORE)
                n->mark[k] = BEFORE_AND_NOW;
            else if (k != i && make_neighbours(n, i, k))
                return -1;
        }
    return 0;
}

int brink_neighbours_depart(brink_neighbours *n, brink_cells *cells,
                            const brink_system *system, uint32_t i)
{
    const uint32_t before = brink_neighbours_count(n, i);
    for (uint32_t m = 0; m < before; m++)
        n->mark[brink_neighbours_of(n, i)[m]] = BEFORE;
    settle(n, cells, system, i);
    if (add_new(n, cells, system, i))
        return -1;
    // Backwards, so that whoever takes the place of one that goes has been seen.
    for (uint32_t m = before; m-- > 0;) {
        const uint32_t k = brink_neighbours_of(n, i)[m];
        if (n->mark[k] == BEFORE)
            part_from(n, i, m);
        n->mark[k] = NO_NEIGHBOUR;
    }
    return 0;
}

static int is_in_ball(const brink_neighbours *n, const brink_system *system,
                      uint32_t i)
{
    double r[3];
    from_home(n, system, i, r);
    return r[0] * r[0] + r[1] * r[1] + r[2] * r[2] <
           n->radius * n->radius * BRINK_SLACK;
}

// As many as are near, and every one of them.
static int has_its_neighbours(const brink_neighbours *n, const brink_cells *cells,
                              const brink_system *system, uint32_t i)
{
    uint32_t around[27], who[BRINK_HANDFUL], near = 0, listed = 0;
    const uint32_t *list = brink_neighbours_of(n, i);
    brink_tour tour = brink_tour_around(cells, i, around);
    for (int some; (some = next_near(n, cells, system, i, &tour, who)) > 0;) {
        near += (uint32_t)some;
        for (int m = 0; m < some; m++)
            for (uint32_t k = 0; k < brink_neighbours_count(n, i); k++)
                listed += list[k] == who[m];
    }
    return near == listed + 1 && listed == brink_neighbours_count(n, i);
}

const char *brink_neighbours_is_valid(const brink_neighbours *n,
                                      const brink_cells *cells,
                                      const brink_system *system)
{
    if (!(n->radius > 0))
        return NULL;
    for (uint32_t i = 0; i < system->count; i++) {
        if (!is_in_ball(n, system, i))
            return "a particle is not in its ball";
        if (!has_its_neighbours(n, cells, system, i))
            return "a particle's list is not of those near its home";
    }
    return NULL;
}
