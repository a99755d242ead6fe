// SPDX-License-Identifier: MIT
#include "adverse.h"
#include "fuzz.h"
#include "start_kinetic.h"
#include <brink/overlap.h>
#include <string.h>

// Cores may be in each other by what rounding does: 4 ulp of the distance.
#define IN_EACH_OTHER (1 - 4 * 0x1p-52)

// A shell is far thicker than what rounding does to a contact, which is some 64
// 2^-53 of the box: so that a level and one more can be told apart.
#define SHELL (1 + 0x1p-16)

typedef struct maker {
    stream *s;
    brink_system *system;
    uint32_t placed;
    int family;
} maker;

// --- Potentials and boxes ------------------------------------------------------

static double pick(stream *s, int count, const double *from)
{
    return from[stream_int(s, 0, count - 1)];
}
#define PICK(s, ...)                                                             \
    pick(s, (int)(sizeof((double[]){__VA_ARGS__}) / sizeof(double)),             \
         (const double[]){__VA_ARGS__})

static double make_energy(stream *s)
{
    const double e = PICK(s, 1, 1, 0.5, 2, 1e-3, 1e-9, 0x1p-40, 1e3, 0.3);
    return stream_sign(s) * e;
}

/** From the innermost step outward, most of them a core in a step or two. */
static int make_potential(stream *s, double *distance, double *energy)
{
    const int count = stream_int(s, 1, ADVERSE_STEPS);
    double d = PICK(s, 1, 1, 1, 0.5, 0.75, 1.5, 1.1);
    for (int k = count - 1; k >= 0; k--) {
        distance[k] = d;
        energy[k] = make_energy(s);
        d *= PICK(s, 1.5, 2, 1.25, 1.1, SHELL, 3);
    }
    if (stream_int(s, 0, 3))
        energy[count - 1] = (double)INFINITY;
    return count;
}

/** At least twice the range, which is as narrow as a box may be; three cells a
 * side and images, or five and more. */
static double make_length(stream *s, double range)
{
    const double least = 2 * range * BRINK_SLACK;
    switch (stream_int(s, 0, 5)) {
    case 0:
        return stream_near(s, least * (1 + 0x1p-50), 2);
    case 1: // where doubles are all a coordinate needs
        return exp2(ceil(log2(least)) + stream_int(s, 0, 4));
    case 2:
        return least * PICK(s, 1.25, 1.5, 2, 2.49, 2.5, 2.51, 2.6, 3);
    case 3:
        return least * stream_real(s, 1, 4);
    case 4:
        return least * PICK(s, 10, 50);
    default:
        return least * 4;
    }
}

static void make_empty(maker *m, uint32_t count, int kinds, int dimensions,
                       double spacing)
{
    static const char *const names[] = {"A", "B", "C"};
    double distance[ADVERSE_KINDS * ADVERSE_KINDS][ADVERSE_STEPS],
        energy[ADVERSE_KINDS * ADVERSE_KINDS][ADVERSE_STEPS], range = 0,
                                                              box[3] = {1, 1, 1};
    brink_potential potential[ADVERSE_KINDS * ADVERSE_KINDS];
    brink_species species[ADVERSE_KINDS];
    for (int a = 0; a < kinds; a++) {
        memset(&species[a], 0, sizeof species[a]);
        strcpy(species[a].name, names[a]);
        species[a].mass = PICK(m->s, 1, 1, 1, 2, 0.75, 30, 0x1p-7, 0x1p6);
        for (int b = a; b < kinds; b++) {
            const int k = a * kinds + b;
            const int steps = make_potential(m->s, distance[k], energy[k]);
            potential[k] = (brink_potential){steps, distance[k], energy[k]};
            potential[b * kinds + a] = potential[k];
            range = fmax(range, distance[k][0]);
        }
    }
    for (int a = 0; a < dimensions; a++)
        box[a] = spacing > 0 ? spacing * range : make_length(m->s, range);
    LAW(brink_system_create(m->system, dimensions, box, 1, count, kinds, species,
                            potential) == 0,
        "memory is out");
}

// --- Places --------------------------------------------------------------------

/** A direction: along an axis, a diagonal, or any; of length 1. */
static void make_direction(stream *s, int dimensions, double u[3])
{
    const int axis = stream_int(s, 0, dimensions - 1);
    const int other = (axis + 1) % dimensions, how = stream_int(s, 0, 3);
    double length = 0;
    for (int a = 0; a < 3; a++)
        u[a] = how == 3 && a < dimensions ? stream_normal(s) : 0;
    if (how < 3) {
        u[axis] = stream_sign(s) * (how == 2 ? 0.6 : 1);
        u[other] = how == 0 ? 0 : how == 1 ? 1 : 0.8;
    }
    for (int a = 0; a < 3; a++)
        length += u[a] * u[a];
    for (int a = 0; a < 3; a++)
        u[a] /= sqrt(length);
}

/** At a step of the potential with j, or a few ulp from it: along u from it. */
static void place_at_step(maker *m, uint32_t i, uint32_t j, const double u[3])
{
    const brink_system *s = m->system;
    const brink_potential *p = brink_system_potential(s, i, j);
    const double r =
        stream_near(m->s, p->distance[stream_int(m->s, 0, p->count - 1)], 8);
    for (int a = 0; a < s->dimensions; a++)
        s->particle[i].x[a] =
            s->particle[j].x[a] + brink_system_fraction(s, a, r * u[a]);
}

/** On walls of 3 to 9 cells, or a few units from them. */
static void place_at_walls(maker *m, uint32_t i)
{
    for (int a = 0; a < m->system->dimensions; a++) {
        const uint64_t n = (uint64_t)stream_int(m->s, 3, 9);
        const uint64_t k = (uint64_t)stream_int(m->s, 0, 9) % n;
        const uint64_t wall = UINT64_MAX / n * k;
        m->system->particle[i].x[a] =
            wall + (uint64_t)(int64_t)stream_int(m->s, -3, 3 + (int)n);
    }
}

static void place_anywhere(maker *m, uint32_t i)
{
    for (int a = 0; a < m->system->dimensions; a++)
        m->system->particle[i].x[a] = stream_bits(m->s);
}

/** In a row along x, some distance from the one before, in the middle. */
static void place_in_row(maker *m, uint32_t i)
{
    const brink_system *s = m->system;
    const double gap = PICK(m->s, 1, 1, 1 + 0x1p-52, 1 + 0x1p-30, 1.25, 2);
    for (int a = 0; a < s->dimensions; a++)
        s->particle[i].x[a] = a == 0 ? 0 : UINT64_C(1) << 63;
    if (i == 0)
        return;
    const brink_potential *p = brink_system_potential(s, i, i - 1);
    s->particle[i].x[0] =
        s->particle[i - 1].x[0] +
        brink_system_fraction(s, 0, p->distance[p->count - 1] * gap);
}

/** On a grid, `side` along each axis. */
static void place_on_grid(brink_system *s, uint32_t i, uint32_t side)
{
    uint32_t left = i;
    for (int a = 0; a < s->dimensions; a++, left /= side)
        s->particle[i].x[a] =
            UINT64_MAX / side * (left % side) + (UINT64_C(1) << 40);
}

/** Cores in each other, of one and those placed before, in whatever image. */
static int is_inside(const maker *m, uint32_t i)
{
    const brink_system *s = m->system;
    for (uint32_t j = 0; j < m->placed; j++) {
        const brink_potential *p = brink_system_potential(s, i, j);
        const double core = p->distance[p->count - 1] * IN_EACH_OTHER;
        double r[3];
        brink_system_separation(s, i, j, 0, r);
        if (j != i && isinf(p->energy[p->count - 1]) &&
            brink_ball_overlap_sign(r, core) < 0)
            return 1;
    }
    return 0;
}

// --- Velocities ----------------------------------------------------------------

/** By the pair with j: along u, across, both, or next to nothing of either. */
static void move_by_pair(maker *m, uint32_t i, uint32_t j, const double u[3])
{
    const brink_system *s = m->system;
    const double along = stream_sign(m->s) * PICK(m->s, 0, 0, 1, 1, 1e-300, 1e-20,
                                                  1e-12, 1e-9, 0x1p-24, 1e3);
    const double across = PICK(m->s, 0, 1, 1, 0.5, 1e-6, 1e3);
    double w[3] = {-u[1], u[0], 0};
    if (s->dimensions == 3 && u[0] == 0 && u[1] == 0)
        w[0] = 1;
    for (int a = 0; a < s->dimensions; a++)
        // NOLINTNEXTLINE(clang-analyzer-core.*): at most three dimensions
        s->particle[i].v[a] = s->particle[j].v[a] + along * u[a] + across * w[a];
}

/** So that many meet at once: to the middle, by unit speeds, at rest. */
static void move_plainly(maker *m, uint32_t i)
{
    const brink_system *s = m->system;
    double *v = s->particle[i].v;
    const int how = stream_int(m->s, 0, 3);
    const int axis = stream_int(m->s, 0, s->dimensions - 1);
    for (int a = 0; a < s->dimensions; a++) {
        const int64_t from = (int64_t)(s->particle[i].x[a] - (UINT64_C(1) << 63));
        v[a] = how == 0 ? (from > 0 ? -1 : 1) : 0;
    }
    if (how == 1)
        v[axis] = stream_sign(m->s) * PICK(m->s, 1, 2, 0.5, 1e-9);
    if (how == 2 && i > 0)
        memcpy(v, s->particle[i - 1].v, sizeof s->particle->v);
}

static void move_thermally(maker *m, uint32_t i, double speed)
{
    for (int a = 0; a < m->system->dimensions; a++)
        m->system->particle[i].v[a] = speed * stream_normal(m->s);
}

static void move_anyhow(maker *m, uint32_t i)
{
    move_thermally(m, i, PICK(m->s, 1, 1, 1, 1, 0x1p-20, 0x1p10, 1e-9));
}

// --- The whole -----------------------------------------------------------------

enum family { PAIRS, WALLS, ROW, GRID, ANYWHERE, MIXED, CROWD, FAMILIES, FEW };

static void place(maker *m, uint32_t i)
{
    const int how =
        m->family == MIXED ? stream_int(m->s, 0, ANYWHERE) : m->family;
    const uint32_t j = i == 0 ? 0 : (uint32_t)stream_int(m->s, 0, (int)i - 1);
    double u[3];
    make_direction(m->s, m->system->dimensions, u);
    switch (how) {
    case PAIRS:
        if (i % 2 == 0) {
            place_anywhere(m, i);
            move_anyhow(m, i);
        } else {
            place_at_step(m, i, j, u);
            move_by_pair(m, i, j, u);
        }
        break;
    case WALLS:
        place_at_walls(m, i);
        move_plainly(m, i);
        break;
    case ROW:
        place_in_row(m, i);
        m->system->particle[i].v[0] =
            i == 0 || stream_int(m->s, 0, 3) == 0 ? PICK(m->s, 1, -1, 0.5, 3) : 0;
        break;
    case GRID:
        place_on_grid(m->system, i, 3);
        move_plainly(m, i);
        break;
    case CROWD:
        place_on_grid(m->system, i, 8);
        if (stream_int(m->s, 0, 1))
            move_anyhow(m, i);
        else
            move_plainly(m, i);
        break;
    case FEW:
        place_anywhere(m, i);
        move_thermally(m, i, 1);
        break;
    default:
        place_anywhere(m, i);
        move_anyhow(m, i);
        break;
    }
}

/** What a file can say: a coordinate is a double. */
static void round_places(brink_system *s)
{
    for (uint32_t i = 0; i < s->count; i++)
        for (int a = 0; a < s->dimensions; a++) {
            uint64_t *x = &s->particle[i].x[a], before;
            int tries = 4; // a coordinate of a coordinate is itself, soon
            do {
                before = *x;
                *x = brink_system_fraction(s, a,
                                           brink_system_coordinate(s, a, before));
            } while (*x != before && --tries > 0);
        }
}

/** As many as found room; the species counted again. */
static void keep_placed(brink_system *s, uint32_t count)
{
    s->count = count;
    for (int a = 0; a < s->species_count; a++)
        s->species[a].count = 0;
    for (uint32_t i = 0; i < count; i++)
        s->species[s->particle[i].species].count++;
}

/** Every one that finds room within a few tries; species by species. */
static void place_all(maker *m, uint32_t count)
{
    brink_system *s = m->system;
    const uint32_t kinds = (uint32_t)s->species_count;
    for (uint32_t n = 0; n < count; n++) {
        const uint32_t i = m->placed;
        int tries = 8;
        memset(&s->particle[i], 0, sizeof s->particle[i]);
        s->particle[i].species = n * kinds / count;
        place(m, i);
        while (is_inside(m, i) && --tries > 0)
            place_anywhere(m, i);
        m->placed += tries > 0;
    }
}

static void make(stream *s, brink_system *system, int family, uint32_t most)
{
    const int dimensions = stream_int(s, 2, 3);
    maker m = {s, system, 0, family};
    uint32_t count = 64;
    if (family == CROWD) {
        // Lists are kept of three others in range and more (sim/neighbours.c):
        // 8 along the side of a box of 8 ranges have pi, if it were all core.
        make_empty(&m, count, 1, 2, PICK(s, 8, 8 + 0x1p-40, 8.1, 8.15));
    } else {
        const int kinds = stream_int(s, 1, ADVERSE_KINDS);
        count = (uint32_t)stream_int(s, 2, (int)most);
        make_empty(&m, count, kinds, dimensions, 0);
    }
    place_all(&m, count);
    keep_placed(system, m.placed);
    if (stream_int(s, 0, 1))
        round_places(system);
    system->year = brink_kinetic_year(system);
}

void adverse_make(stream *s, brink_system *system)
{
    make(s, system, stream_int(s, 0, FAMILIES - 1), 16);
}

void adverse_make_few(stream *s, brink_system *system)
{
    make(s, system, FEW, 5);
}

void adverse_copy(brink_system *to, const brink_system *from)
{
    LAW(brink_system_create(to, from->dimensions, from->length, from->year,
                            from->count, from->species_count, from->species,
                            from->potential) == 0,
        "memory is out");
    memcpy(to->particle, from->particle, from->count * sizeof *to->particle);
    to->epoch = from->epoch;
}
