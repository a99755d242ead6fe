// SPDX-License-Identifier: MIT
#include "system.h"
#include "array.h"
#include "sum.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

// One block holds both tables of every potential, distances first.
static int copy_potentials(brink_system *s, const brink_potential *from)
{
    const size_t pairs = (size_t)s->species_count * (size_t)s->species_count;
    size_t steps = 0;
    for (size_t p = 0; p < pairs; p++)
        steps += (size_t)from[p].count;
    const size_t size = pairs * sizeof *s->potential + 2 * steps * sizeof(double);
    // NOLINTNEXTLINE(clang-analyzer-optin.portability.*): never without species
    s->potential = malloc(size);
    if (!s->potential)
        return -1;
    double *table = (double *)(void *)(s->potential + pairs);
    for (size_t p = 0; p < pairs; p++) {
        const size_t bytes = (size_t)from[p].count * sizeof(double);
        s->potential[p].count = from[p].count;
        s->potential[p].distance = memcpy(table, from[p].distance, bytes);
        table += from[p].count;
        s->potential[p].energy = memcpy(table, from[p].energy, bytes);
        table += from[p].count;
        s->range = fmax(s->range, from[p].distance[0]);
    }
    return 0;
}

int brink_system_create(brink_system *s, int dimensions, const double length[3],
                        double year, uint32_t count, int species_count,
                        const brink_species *species,
                        const brink_potential *potential)
{
    memset(s, 0, sizeof *s);
    s->dimensions = dimensions;
    s->year = year;
    s->count = count;
    s->species_count = species_count;
    for (int a = 0; a < 3; a++) {
        s->length[a] = length[a];
        s->unit[a] = ldexp(length[a], -64);
    }
    s->particle = brink_array_create(count, sizeof *s->particle);
    s->species = malloc((size_t)species_count * sizeof *species);
    if (!s->particle || !s->species || copy_potentials(s, potential)) {
        brink_system_destroy(s);
        return -1;
    }
    memcpy(s->species, species, (size_t)species_count * sizeof *species);
    return 0;
}

void brink_system_destroy(brink_system *s)
{
    free(s->particle);
    free(s->species);
    free(s->potential);
    memset(s, 0, sizeof *s);
}

const char *brink_system_is_valid(const brink_system *s)
{
    int exponent = 0;
    if (s->dimensions != 2 && s->dimensions != 3)
        return "the number of dimensions is neither 2 nor 3";
    if (!(s->year > 0) || !isfinite(s->year) || frexp(s->year, &exponent) != 0.5)
        return "the year is not a power of two";
    for (int a = 0; a < 3; a++)
        if (!(s->length[a] > 0) || !isfinite(s->length[a]))
            return "a length of the box is not a positive number";
    for (int p = 0; p < s->species_count * s->species_count; p++)
        if (!brink_potential_is_valid(&s->potential[p]))
            return "a potential's steps are not decreasing distances with "
                   "energies";
    for (int a = 0; a < s->dimensions; a++)
        if (s->range * BRINK_SLACK > s->length[a] / 2)
            return "the interaction reaches as far as half the box";
    for (uint32_t i = 0; i < s->count; i++) {
        const brink_particle *p = &s->particle[i];
        if (p->species >= (uint32_t)s->species_count)
            return "a particle's species does not exist";
        if (!isfinite(p->v[0]) || !isfinite(p->v[1]) || !isfinite(p->v[2]))
            return "a velocity is not finite";
        if (!(p->since >= 0) || !(p->since < s->year))
            return "a particle's own time is not within the year";
        if (s->dimensions == 2 && (p->x[2] != 0 || p->v[2] != 0))
            return "a particle of a two-dimensional system leaves the plane";
    }
    return NULL;
}

double brink_system_coordinate(const brink_system *s, int axis, uint64_t x)
{
    const double c = (double)x * s->unit[axis];
    return c < s->length[axis]
               ? c
               : 0.0; // the last 2^10 units round up to the length
}

// A fraction of the box in [-1/2, 1/2] as a signed number of units; 1/2 itself,
// which has no signed number, is the same place as -1/2.
static uint64_t units(double fraction)
{
    return (uint64_t)llrint((fraction < 0.5 ? fraction : -0.5) * 0x1p64);
}

uint64_t brink_system_fraction(const brink_system *s, int axis, double coordinate)
{
    const double f = coordinate / s->length[axis];
    return units(f - rint(f));
}

// How far p gets in dt along an axis, in units, whole turns round the box left
// out.
static uint64_t flight(const brink_system *s, const brink_particle *p, int axis,
                       double dt)
{
    const double f = p->v[axis] * dt / s->length[axis];
    return units(f - rint(f)); // the difference is exact
}

void brink_system_advance(brink_system *s, uint32_t i, double offset)
{
    brink_particle *p = &s->particle[i];
    for (int a = 0; a < s->dimensions; a++)
        p->x[a] += flight(s, p, a, offset - p->since);
    p->since = offset;
}

void brink_system_position(const brink_system *s, uint32_t i, double offset,
                           double x[3])
{
    const brink_particle *p = &s->particle[i];
    for (int a = 0; a < 3; a++)
        x[a] = brink_system_coordinate(
            s, a, p->x[a] + flight(s, p, a, offset - p->since));
}

void brink_system_turn(brink_system *s, int64_t epoch)
{
    const double years = (double)(epoch - s->epoch);
    for (uint32_t i = 0; i < s->count; i++) {
        brink_system_advance(s, i, years * s->year);
        s->particle[i].since = 0.0;
    }
    s->epoch = epoch;
}

double brink_system_kinetic_energy(const brink_system *s)
{
    brink_sum sum = {0};
    for (uint32_t i = 0; i < s->count; i++) {
        const double m = s->species[s->particle[i].species].mass;
        for (int a = 0; a < s->dimensions; a++) {
            const double v = s->particle[i].v[a];
            brink_sum_product(&sum, 0.5 * m * v, v);
        }
    }
    return brink_sum_value(&sum);
}

void brink_system_momentum(const brink_system *s, double p[3])
{
    for (int a = 0; a < 3; a++) {
        brink_sum sum = {0};
        for (uint32_t i = 0; i < s->count; i++)
            brink_sum_product(&sum, s->species[s->particle[i].species].mass,
                              s->particle[i].v[a]);
        p[a] = brink_sum_value(&sum);
    }
}

double brink_system_temperature(const brink_system *s)
{
    const uint32_t bodies = s->count > 1 ? s->count - 1 : 1;
    return 2.0 * brink_system_kinetic_energy(s) /
           (s->dimensions * (double)bodies);
}

double brink_system_volume(const brink_system *s)
{
    return s->length[0] * s->length[1] *
           (s->dimensions == 3 ? s->length[2] : 1.0);
}
