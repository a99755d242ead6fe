// SPDX-License-Identifier: MIT
#include "observe_distances.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NOBODY UINT32_MAX
#define PI     3.14159265358979323846

static int kinds(const brink_distances *d)
{
    return brink_distances_kind(0, d->species);
}

// Volume within r; in the plane, area.
static double ball(int dimensions, double r)
{
    return dimensions == 3 ? 4 * PI / 3 * r * r * r : PI * r * r;
}

static void fill_ideal(brink_distances *d, const brink_system *s)
{
    const double volume = brink_system_volume(s), width = d->most / d->bins;
    for (int b = 0; b < d->species; b++)
        for (int a = 0; a <= b; a++) {
            const double na = s->species[a].count, nb = s->species[b].count;
            const double pairs = a == b ? na * (na - 1) / 2 : na * nb;
            double *ideal = &d->ideal[brink_distances_kind(a, b) * d->bins];
            for (int k = 0; k < d->bins; k++)
                ideal[k] = pairs / volume *
                           (ball(s->dimensions, width * (k + 1)) -
                            ball(s->dimensions, width * k));
        }
}

// Cells along an axis: at least `most` wide, and no more than there are particles
// for.
static int cells_along(const brink_system *s, int axis, double most)
{
    const double fit = floor(s->length[axis] / most);
    const double enough = ceil(cbrt((double)s->count));
    return axis >= s->dimensions ? 1 : (int)fmax(1, fmin(fit, enough));
}

int brink_distances_create(brink_distances *d, const brink_system *system,
                           double most, int bins)
{
    *d = (brink_distances){
        .most = most, .bins = bins, .species = system->species_count};
    const size_t all = (size_t)kinds(d) * (size_t)bins;
    size_t cells = 1;
    for (int a = 0; a < 3; a++) {
        d->cells[a] = cells_along(system, a, most);
        cells *= (size_t)d->cells[a];
    }
    d->g = calloc(all, sizeof *d->g);
    d->ideal = calloc(all, sizeof *d->ideal);
    d->pairs = calloc(all, sizeof *d->pairs);
    d->first = calloc(cells, sizeof *d->first);
    d->next = calloc(system->count, sizeof *d->next);
    if (!d->g || !d->ideal || !d->pairs || !d->first || !d->next) {
        brink_distances_destroy(d);
        return -1;
    }
    fill_ideal(d, system);
    return 0;
}

void brink_distances_destroy(brink_distances *d)
{
    free(d->g);
    free(d->ideal);
    free(d->pairs);
    free(d->first);
    free(d->next);
    memset(d, 0, sizeof *d);
}

// The cell of a coordinate in [0, length].
static int cell_of(const brink_distances *d, const brink_system *s, int axis,
                   double x)
{
    const int cell = (int)(x / s->length[axis] * d->cells[axis]);
    return cell < d->cells[axis] ? cell : d->cells[axis] - 1;
}

static void file_particles(brink_distances *d, const brink_system *s,
                           const double *x)
{
    const size_t cells =
        (size_t)d->cells[0] * (size_t)d->cells[1] * (size_t)d->cells[2];
    memset(d->first, 0xff, cells * sizeof *d->first); // NOBODY
    for (uint32_t i = 0; i < s->count; i++) {
        const double *p = &x[(size_t)i * 3];
        const int cell =
            (cell_of(d, s, 2, p[2]) * d->cells[1] + cell_of(d, s, 1, p[1])) *
                d->cells[0] +
            cell_of(d, s, 0, p[0]);
        d->next[i] = d->first[cell];
        d->first[cell] = i;
    }
}

static void count_pair(brink_distances *d, const brink_system *s, const double *x,
                       uint32_t i, uint32_t j)
{
    double square = 0;
    for (int a = 0; a < s->dimensions; a++) {
        const double apart =
            x[(size_t)i * 3 + (size_t)a] - x[(size_t)j * 3 + (size_t)a];
        const double nearest = apart - s->length[a] * rint(apart / s->length[a]);
        square += nearest * nearest;
    }
    const double at = sqrt(square) / d->most * d->bins;
    if (!(at < d->bins))
        return;
    const int p = (int)s->particle[i].species, q = (int)s->particle[j].species;
    const int kind =
        p < q ? brink_distances_kind(p, q) : brink_distances_kind(q, p);
    d->pairs[kind * d->bins + (int)at]++;
}

// The cells next to a cell along an axis, itself among them, none twice.
static int cells_beside(int cells, int cell, int beside[3])
{
    const int count = cells < 3 ? cells : 3;
    for (int k = 0; k < count; k++)
        beside[k] = (cell + k + cells - 1) % cells;
    return count;
}

static void count_around(brink_distances *d, const brink_system *s,
                         const double *x, uint32_t i)
{
    int beside[3][3], count[3];
    for (int a = 0; a < 3; a++)
        count[a] = cells_beside(d->cells[a],
                                cell_of(d, s, a, x[(size_t)i * 3 + (size_t)a]),
                                beside[a]);
    for (int w = 0; w < count[2]; w++)
        for (int v = 0; v < count[1]; v++)
            for (int u = 0; u < count[0]; u++) {
                const int cell =
                    (beside[2][w] * d->cells[1] + beside[1][v]) * d->cells[0] +
                    beside[0][u];
                for (uint32_t j = d->first[cell]; j != NOBODY; j = d->next[j])
                    if (j > i)
                        count_pair(d, s, x, i, j);
            }
}

void brink_distances_sample(brink_distances *d, const brink_system *system,
                            const double *x)
{
    const int all = kinds(d) * d->bins;
    memset(d->pairs, 0, (size_t)all * sizeof *d->pairs);
    file_particles(d, system, x);
    for (uint32_t i = 0; i < system->count; i++)
        count_around(d, system, x, i);
    for (int k = 0; k < all; k++)
        brink_series_add(&d->g[k],
                         d->ideal[k] > 0 ? d->pairs[k] / d->ideal[k] : 0);
}

void brink_distances_code(brink_codec *c, brink_distances *d)
{
    for (int k = 0; k < kinds(d) * d->bins; k++)
        brink_series_code(c, &d->g[k]);
}
