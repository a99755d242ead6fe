// SPDX-License-Identifier: MIT
#include "start.h"
#include "scene_species.h"
#include "scene_value.h"
#include "start_kinetic.h"
#include "start_placement.h"
#include "trajectory.h"
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// A box given to six decimals, as most programs print by default, is the same
// box.
#define SAME_LENGTH 1e-6

typedef struct maker {
    const brink_scene *scene;
    brink_system *system;
    gsl_rng *random;
    brink_source source; // complaints point at the scene's text
} maker;

static int complain_of_memory(maker *m)
{
    brink_complain(&m->source, m->scene->start_at,
                   "there is no memory for the particles\nhave fewer of them");
    return -1;
}

static int check_overlap(maker *m)
{
    const brink_system *s = m->system;
    uint32_t i = 0, j = 0;
    double r[3];
    const int status = brink_placement_overlap(s, &i, &j);
    if (status < 0)
        return complain_of_memory(m);
    if (status == 0)
        return 0;
    brink_system_separation(s, i, j, 0.0, r);
    brink_complain(
        &m->source, m->scene->start_at,
        "particles %u (%s) and %u (%s) start %.9g apart, and their hard cores "
        "reach %.9g\nmake the box wider or the density lower, or start from "
        "other positions",
        j, s->species[s->particle[j].species].name, i,
        s->species[s->particle[i].species].name, hypot(hypot(r[0], r[1]), r[2]),
        brink_species_core(brink_system_potential(s, i, j)));
    return -1;
}

static int place_on_lattice(maker *m)
{
    if (brink_placement_lattice(m->system, m->scene->start, m->random))
        return complain_of_memory(m);
    return check_overlap(m);
}

static int place_at_random(maker *m)
{
    double packing = 0;
    const int status = brink_placement_random(m->system, m->random, &packing);
    if (status < 0)
        return complain_of_memory(m);
    if (status > 0)
        brink_complain(
            &m->source, m->scene->start_at,
            "no more particles find room at random where %.3g of the box is "
            "full\n"
            "start from a lattice, or make the box wider or the density lower",
            packing);
    return -status;
}

static int refuse_particle(maker *m, uint32_t k, const char *what,
                           const char *advice)
{
    brink_complain(&m->source, m->scene->start_at, "particle %u of %s %s\n%s", k,
                   m->scene->start_file, what, advice);
    return -1;
}

static int check_vector(maker *m, uint32_t k, const double x[3])
{
    // Beyond the magnitudes that a scene may have, products of a run overflow.
    if (fmax(fmax(fabs(x[0]), fabs(x[1])), fabs(x[2])) > BRINK_VALUE_MOST)
        return refuse_particle(m, k, "has a number beyond 1e60",
                               "choose units in which it is nearer to 1");
    if (m->scene->dimensions == 2 && x[2] != 0)
        return refuse_particle(m, k, "is not in the plane, or leaves it",
                               "in two dimensions every z is 0");
    return 0;
}

static int find_species(const brink_scene *scene, const char *name)
{
    for (int a = 0; a < scene->species_count; a++)
        if (strcmp(scene->species[a].name, name) == 0)
            return a;
    return -1;
}

// A frame's particles in the scene's order: species by species, in each as they
// come.
static int take_particles(maker *m, const brink_frame *frame)
{
    const brink_scene *scene = m->scene;
    uint32_t next[BRINK_SPECIES_MOST] = {0}, end[BRINK_SPECIES_MOST] = {0},
             sum = 0;
    for (int a = 0; a < scene->species_count; a++) {
        next[a] = sum;
        end[a] = sum += scene->species[a].count;
    }
    for (uint32_t k = 0; k < frame->count; k++) {
        static const double at_rest[3] = {0};
        const double *x = frame->x[k], *v = frame->v ? frame->v[k] : at_rest;
        const int a = find_species(scene, frame->species[k]);
        if (a < 0)
            return refuse_particle(m, k, "is of a species that the scene has not",
                                   "make the two agree");
        if (next[a] == end[a])
            return refuse_particle(m, k,
                                   "is one more of its species than in the scene",
                                   "make the two agree");
        if (check_vector(m, k, x) || check_vector(m, k, v))
            return -1;
        brink_particle *p = &m->system->particle[next[a]++];
        for (int d = 0; d < scene->dimensions; d++) {
            p->x[d] = brink_system_fraction(m->system, d, x[d]);
            // NOLINTNEXTLINE(clang-analyzer-core.*): at most three dimensions
            p->v[d] = v[d];
        }
    }
    return 0;
}

static int take_frame(maker *m, const brink_frame *frame)
{
    const brink_scene *scene = m->scene;
    if (frame->count != scene->count) {
        brink_complain(
            &m->source, scene->start_at,
            "%s has %u particles, and the scene %u\nmake the two agree",
            scene->start_file, frame->count, scene->count);
        return -1;
    }
    for (int a = 0; a < scene->dimensions; a++) {
        const double length = scene->length[a];
        if (fabs(frame->length[a] - length) <= SAME_LENGTH * length)
            continue;
        brink_complain(
            &m->source, scene->start_at,
            "%s has a box of length %.17g along %c, and the scene %.17g\n"
            "make the two agree; `size` sets the scene's",
            scene->start_file, frame->length[a], "xyz"[a], length);
        return -1;
    }
    if (frame->v && scene->temperature_at.line) {
        brink_complain(&m->source, scene->temperature_at,
                       "%s has velocities, and a temperature is given too\n"
                       "take out one of them",
                       scene->start_file);
        return -1;
    }
    return take_particles(m, frame) || check_overlap(m) ? -1 : 0;
}

// 1 if the file gives velocities, 0 if positions alone, -1 after a complaint.
static int place_from_file(maker *m)
{
    const char *path = m->scene->start_file;
    brink_frame frame = {0};
    errno = 0;
    FILE *file = fopen(path, "r");
    if (!file) {
        brink_complain(
            &m->source, m->scene->start_at,
            "%s cannot be read: %s\nthe path counts from the scene's folder",
            path, strerror(errno));
        return -1;
    }
    int status = brink_trajectory_read(file, path, &frame, m->source.errors);
    if (status == 0)
        brink_complain(&m->source, m->scene->start_at,
                       "%s has no frame in it\nit must be extended XYZ", path);
    status = status == 1 && take_frame(m, &frame) == 0 ? frame.v != NULL : -1;
    brink_frame_destroy(&frame);
    fclose(file);
    return status;
}

static int place(maker *m)
{
    switch (m->scene->start) {
    case BRINK_START_RANDOM:
        return place_at_random(m);
    case BRINK_START_FILE:
        return place_from_file(m);
    default:
        return place_on_lattice(m);
    }
}

static int make(maker *m)
{
    const brink_scene *scene = m->scene;
    brink_system *s = m->system;
    uint32_t i = 0;
    if (brink_system_create(s, scene->dimensions, scene->length, 1.0,
                            scene->count, scene->species_count, scene->species,
                            scene->potential))
        return complain_of_memory(m);
    for (int a = 0; a < scene->species_count; a++)
        for (uint32_t k = 0; k < scene->species[a].count; k++)
            s->particle[i++].species = (uint32_t)a;
    const int placed = place(m);
    if (placed < 0)
        return -1;
    if (placed == 0)
        brink_kinetic_heat(s, scene->temperature, m->random);
    s->year = brink_kinetic_year(s);
    return 0;
}

int brink_start_make(const brink_scene *scene, const char *name,
                     brink_system *system, FILE *errors)
{
    maker m = {.scene = scene,
               .system = system,
               .random = gsl_rng_alloc(gsl_rng_mt19937),
               .source =
                   brink_source_of(name, scene->text, scene->text_size, errors)};
    gsl_rng_set(m.random, scene->seed);
    const int status = make(&m);
    if (status)
        brink_system_destroy(system);
    gsl_rng_free(m.random);
    return status;
}
