// SPDX-License-Identifier: MIT
#include "observe_displacements.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

int brink_displacements_create(brink_displacements *d, const brink_system *system,
                               int lags, double every)
{
    *d = (brink_displacements){.particles = system->count,
                               .species = system->species_count,
                               .lags = lags,
                               .span = lags * every};
    const size_t kinds = (size_t)d->species, axes = 3 * (size_t)d->particles;
    d->at = calloc(axes, sizeof *d->at);
    d->gone = calloc(axes, sizeof *d->gone);
    d->half = calloc(kinds, sizeof *d->half);
    d->square = calloc(kinds * (size_t)lags, sizeof *d->square);
    d->diffusion = calloc(kinds, sizeof *d->diffusion);
    if (d->at && d->gone && d->half && d->square && d->diffusion)
        return 0;
    brink_displacements_destroy(d);
    return -1;
}

void brink_displacements_destroy(brink_displacements *d)
{
    free(d->at);
    free(d->gone);
    free(d->half);
    free(d->square);
    free(d->diffusion);
    memset(d, 0, sizeof *d);
}

static void follow(brink_displacements *d, const brink_system *s, const double *x)
{
    for (uint32_t i = 0; i < d->particles; i++)
        for (int a = 0; a < s->dimensions; a++) {
            const size_t k = (size_t)i * 3 + (size_t)a;
            const double turns = (x[k] - d->at[k]) / s->length[a];
            const double step = turns - rint(turns);
            d->farthest = fmax(d->farthest, fabs(step));
            d->gone[k] += step * s->length[a];
        }
}

// The mean squared displacement of a species so far in this window.
static double mean_square(const brink_displacements *d, const brink_system *s,
                          int species)
{
    double sum = 0;
    for (uint32_t i = 0; i < d->particles; i++)
        if (s->particle[i].species == (uint32_t)species) {
            const double *g = &d->gone[(size_t)i * 3];
            sum += g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
        }
    return sum / s->species[species].count;
}

static void take_down(brink_displacements *d, const brink_system *s, int lag)
{
    const int half = d->lags / 2;
    for (int k = 0; k < d->species; k++) {
        const double square = mean_square(d, s, k);
        brink_series_add(&d->square[k * d->lags + lag - 1], square);
        if (lag == half)
            d->half[k] = square;
        if (lag == d->lags) {
            const double time = d->span * (d->lags - half) / d->lags;
            brink_series_add(&d->diffusion[k],
                             (square - d->half[k]) / (2 * s->dimensions * time));
        }
    }
    if (lag == d->lags)
        memset(d->gone, 0, 3 * (size_t)d->particles * sizeof *d->gone);
}

void brink_displacements_sample(brink_displacements *d,
                                const brink_system *system, const double *x)
{
    if (d->looks > 0) {
        follow(d, system, x);
        take_down(d, system, (int)((d->looks - 1) % (uint64_t)d->lags) + 1);
    }
    memcpy(d->at, x, 3 * (size_t)d->particles * sizeof *d->at);
    d->looks++;
}

void brink_displacements_code(brink_codec *c, brink_displacements *d)
{
    brink_code_u64(c, &d->looks);
    brink_code_double(c, &d->farthest);
    for (size_t k = 0; k < 3 * (size_t)d->particles && !c->fault; k++) {
        brink_code_double(c, &d->at[k]);
        brink_code_double(c, &d->gone[k]);
    }
    for (int k = 0; k < d->species; k++) {
        brink_code_double(c, &d->half[k]);
        brink_series_code(c, &d->diffusion[k]);
    }
    for (int k = 0; k < d->species * d->lags; k++)
        brink_series_code(c, &d->square[k]);
}
