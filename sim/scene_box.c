// SPDX-License-Identifier: MIT
#include "scene_box.h"
#include "scene_species.h"
#include "scene_value.h"
#include <math.h>

// Positions are kept to 2^-64 of the box: up to here that is 2^-40 of the
// shortest distance there is a step at, finer than the contact distance is held
// anyway.
#define BOX_MOST 0x1p24

// Space that equal cores fill at most: fcc (Kepler, Hales), and the hexagonal
// lattice.
#define DENSEST_3D 0.74048048969306104 // pi / (3 sqrt(2))
#define DENSEST_2D 0.90689968211710892 // pi / (2 sqrt(3))

static void read_periodic(brink_source *s, int dimensions, const brink_node *node)
{
    if (!brink_value_list(s, node, "periodic", dimensions,
                          dimensions == 3 ? "[true, true, true]"
                                          : "[true, true]"))
        return;
    for (const brink_node *item = node->first; item; item = item->next)
        brink_value_true(s, item, "periodic",
                         "boxes have no walls yet: leave the key out");
}

static const brink_potential *like(const brink_scene *scene, int a)
{
    return brink_species_like(scene->potential, scene->species_count, a);
}

// Volume that the hard cores of all particles fill.
static double core_volume(const brink_scene *scene)
{
    double sum = 0;
    for (int a = 0; a < scene->species_count; a++)
        sum += scene->species[a].count *
               brink_species_core_volume(like(scene, a), scene->dimensions);
    return sum;
}

// The part of space that the cores can fill at most.  What unequal ones can is
// not known in general, but that it is not all.
static double densest(const brink_scene *scene)
{
    for (int a = 1; a < scene->species_count; a++)
        if (brink_species_core(like(scene, a)) !=
            brink_species_core(like(scene, 0)))
            return 1.0;
    return scene->dimensions == 3 ? DENSEST_3D : DENSEST_2D;
}

// Whether the particles and their potentials fit into the box.
static void check_box(brink_source *s, const brink_scene *scene, brink_mark at)
{
    const int d = scene->dimensions,
              pairs = scene->species_count * scene->species_count;
    double range = 0, shortest = (double)INFINITY, volume = 1;
    double least = (double)INFINITY, most = 0;
    for (int p = 0; p < pairs; p++) {
        const brink_potential *potential = &scene->potential[p];
        range = fmax(range, potential->distance[0]);
        shortest = fmin(shortest, potential->distance[potential->count - 1]);
    }
    for (int a = 0; a < d; a++) {
        least = fmin(least, scene->length[a]);
        most = fmax(most, scene->length[a]);
        volume *= scene->length[a];
    }
    // At just that a pair meets in two images at once: a rounding would choose.
    if (least < 2 * range * BRINK_SLACK)
        brink_complain(
            s, at,
            "the box is %g wide, not more than twice the %g that the potentials "
            "reach\nmake it wider, with more particles or at a lower density",
            least, range);
    if (most > BOX_MOST * shortest)
        brink_complain(
            s, at,
            "the box is %g wide, more than 2^24 times the shortest distance "
            "of a step, %g\nmake it smaller, or the density higher",
            most, shortest);
    const double packing = core_volume(scene) / volume;
    const double most_packing = densest(scene);
    if (packing > most_packing)
        brink_complain(
            s, at,
            "the hard cores fill %g of the box, and not more than %g can be "
            "filled\nmake the box wider, or the particles fewer or smaller",
            packing, most_packing);
}

static int read_size(brink_source *s, brink_scene *scene, const brink_node *node)
{
    int good =
        brink_value_list(s, node, "size", scene->dimensions,
                         scene->dimensions == 3 ? "[Lx, Ly, Lz]" : "[Lx, Ly]");
    if (!good)
        return 0;
    double *length = scene->length;
    for (const brink_node *item = node->first; item; item = item->next)
        good &= brink_value_positive(s, item, "a length of the box", length++);
    return good;
}

void brink_box_read(brink_source *s, brink_scene *scene, const brink_node *node,
                    int have_species)
{
    brink_key keys[] = {{"number_density", 0, 0},
                        {"packing_fraction", 0, 0},
                        {"size", 0, 0},
                        {"periodic", 0, 0}};
    if (!brink_value_map(s, node, "box", BRINK_BOX_EXAMPLE))
        return;
    const int faults = brink_value_keys(s, node, "box", keys, 4);
    if (keys[3].value)
        read_periodic(s, scene->dimensions, keys[3].value);
    const int chosen = faults ? -1 : brink_value_choose(s, node, "box", keys, 3);
    if (chosen < 0)
        return;
    const brink_node *value = keys[chosen].value;
    if (chosen == 2) {
        if (read_size(s, scene, value) && have_species)
            check_box(s, scene, value->at);
        return;
    }
    double fill = 0;
    if (!brink_value_positive(s, value, keys[chosen].name, &fill) ||
        !have_species)
        return;
    const double matter = chosen == 0 ? scene->count : core_volume(scene);
    if (matter == 0) {
        brink_complain(s, value->at,
                       "no species has a hard core to fill space with\n"
                       "give a number_density instead");
        return;
    }
    const double length =
        scene->dimensions == 3 ? cbrt(matter / fill) : sqrt(matter / fill);
    for (int a = 0; a < scene->dimensions; a++)
        scene->length[a] = length;
    check_box(s, scene, value->at);
}
