// SPDX-License-Identifier: MIT
#include "start_kinetic.h"
#include <gsl/gsl_randist.h>
#include <math.h>

#define PI    3.14159265358979324
#define SQRT2 1.41421356237309505

static void stop_the_centre_of_mass(brink_system *s)
{
    double mass = 0, p[3];
    for (int a = 0; a < s->species_count; a++)
        mass += s->species[a].mass * s->species[a].count;
    brink_system_momentum(s, p);
    for (uint32_t i = 0; i < s->count; i++)
        for (int a = 0; a < s->dimensions; a++)
            s->particle[i].v[a] -= p[a] / mass;
}

static void scale(brink_system *s, double factor)
{
    for (uint32_t i = 0; i < s->count; i++)
        for (int a = 0; a < s->dimensions; a++)
            s->particle[i].v[a] *= factor;
}

void brink_kinetic_heat(brink_system *s, double temperature, gsl_rng *random)
{
    for (uint32_t i = 0; i < s->count; i++) {
        const double m = s->species[s->particle[i].species].mass;
        for (int a = 0; a < s->dimensions; a++)
            s->particle[i].v[a] =
                gsl_ran_gaussian_ziggurat(random, sqrt(temperature / m));
    }
    if (s->count > 1)
        stop_the_centre_of_mass(s);
    // In units of 2^-53 this is off by 1 for the factor's quotient, halved by the
    // root, and 1 for the root, which count twice: 3; by 1 for each velocity,
    // twice: 2; and by 1 a term, 1 in all and 1 for the quotient in measuring,
    // before and after: 6.
    scale(s, sqrt(temperature / brink_system_temperature(s)));
}

double brink_kinetic_year(const brink_system *s)
{
    const double temperature = brink_system_temperature(s);
    const double density = s->count / brink_system_volume(s);
    const int is_plane = s->dimensions == 2;
    double speed = 0; // mean of |v| over all particles
    for (int a = 0; a < s->species_count; a++) {
        const double u = temperature / s->species[a].mass;
        speed += sqrt(is_plane ? PI / 2 * u : 8 / PI * u) * s->species[a].count /
                 s->count;
    }
    if (!(speed > 0))
        return 1.0;
    // 1 / (sqrt(2) n A v), A the cross section of a pair's outermost step.
    const double section = is_plane ? 2 * s->range : PI * s->range * s->range;
    const double meet = 1 / (SQRT2 * density * section * speed);
    const double fly = 1 / ((is_plane ? sqrt(density) : cbrt(density)) * speed);
    return exp2(rint(log2(fmin(meet, fly))));
}
