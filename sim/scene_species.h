// SPDX-License-Identifier: MIT
#ifndef BRINK_SCENE_SPECIES_H
#define BRINK_SCENE_SPECIES_H
/**
 * The species of a scene and the potentials between them: the keys `species` and
 * `potentials`, completed by hard cores from diameters and by mixing
 * (scene_mix.h).
 */
#include "scene.h"
#include "scene_tree.h"
#include <math.h>

// More than anybody has, and few enough for tables of all pairs of species and
// levels.
#define BRINK_SPECIES_MOST 64
#define BRINK_STEPS_MOST   1000

#define BRINK_SPECIES_EXAMPLE "species: {A: {count: 1000, mass: 1, diameter: 1}}"

/** Fills species, species_count, count and potential of an empty scene from the
 * two nodes; potentials may be NULL.  1 if all of them are sound, 0 after
 * complaints. */
int brink_species_read(brink_source *s, brink_scene *scene,
                       const brink_node *species, const brink_node *potentials);
void brink_species_destroy(brink_scene *scene);

/** The potential of species a with its like, in a table of `count` species. */
static inline const brink_potential *
brink_species_like(const brink_potential *table, int count, int a)
{
    return &table[(size_t)a * ((size_t)count + 1)];
}

/** Distance of a potential's hard core, 0 where it has none. */
static inline double brink_species_core(const brink_potential *p)
{
    return isinf(p->energy[p->count - 1]) ? p->distance[p->count - 1] : 0.0;
}

/** Volume of the core, area on a plane. */
static inline double brink_species_core_volume(const brink_potential *p,
                                               int dimensions)
{
    const double pi = 3.14159265358979324, d = brink_species_core(p);
    return dimensions == 3 ? pi / 6 * d * d * d : pi / 4 * d * d;
}
#endif
