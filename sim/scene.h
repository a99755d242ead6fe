// SPDX-License-Identifier: MIT
#ifndef BRINK_SCENE_H
#define BRINK_SCENE_H
/**
 * A scene: what is to be simulated, read from YAML, checked, every default filled
 * in.
 *
 *   title: one line of text         default ""; at most BRINK_TITLE_MOST bytes
 *   seed: integer >= 0              default 1; at most BRINK_SEED_MOST
 *   dimensions: 2 | 3               default 3
 *   box:                            exactly one of
 *     number_density: N / V         a cube (square)
 *     packing_fraction: of cores    a cube (square)
 *     size: [Lx, Ly, Lz]            (two numbers in 2-D)
 *     periodic: [true, true, true]  default; there are no walls: false is refused
 *   species:
 *     NAME: {count: n, mass: m, diameter: d}
 *                                   mass default 1; diameter is short for a hard
 *                                   core with its like: steps [[d, .inf]]
 *   start: {lattice: fcc | sc | square | hexagonal} | {random: true} | {file: f}
 *                                   default fcc, in 2-D hexagonal; a file is
 *                                   extended XYZ, relative to the scene's folder
 *   temperature: k_B T > 0          default 1; not with a file with velocities
 *   potentials:
 *     - between: [A, B]
 *       steps: [[distance, energy inside it], ...]
 *                                   outermost first; .inf: a hard core; unlike
 *                                   pairs not given: see brink_scene_mix
 *   run: {events_per_particle: n} | {events: n} | {time: t}
 *                                   default {events_per_particle: 100}
 *   output: {trajectory: dt, checkpoint: seconds}
 *                                   both optional: frames every dt of simulated
 *                                   time; checkpoints every so many seconds (60)
 *   observe:                        default: nothing is measured
 *     every: dt                     simulated time between two samples
 *     from: t                       when the first is taken; default 0
 *     distances: {up_to: r, bins: n}
 *                                   g(r), up to half the box; n: default 100
 *     displacements: {up_to: t}     mean squared, over lags up to t; diffusion
 *     speeds: true                  their distribution
 */
#include "scene_source.h"
#include "system.h"

#define BRINK_TITLE_MOST 200
#define BRINK_SEED_MOST                                                          \
    UINT32_MAX // all that GSL's mt19937 takes; to it, 0 is 4357

enum brink_lattice {
    BRINK_START_FCC,
    BRINK_START_SC,
    BRINK_START_SQUARE,
    BRINK_START_HEXAGONAL,
    BRINK_START_RANDOM,
    BRINK_START_FILE
};

enum brink_target {
    BRINK_TARGET_PER_PARTICLE,
    BRINK_TARGET_EVENTS,
    BRINK_TARGET_TIME
};

/** What is to be measured; nothing of what is 0. */
typedef struct brink_wish {
    double every; // simulated time between two samples
    double from;  // time of the first
    double distance_most;
    int distance_bins;
    int lags; // samples in the longest lag of displacements
    int speeds;
} brink_wish;

typedef struct brink_scene {
    char *title;
    uint64_t seed;
    int dimensions;
    double length[3]; // length[2] = 1 in 2-D
    uint32_t count;   // of particles, all species together
    int species_count;
    brink_species *species;
    brink_potential *potential; // [a * species_count + b], mixed where not given
    enum brink_lattice start;
    char *start_file; // or NULL; already relative to the working folder
    double temperature;
    enum brink_target target;
    double target_value;
    double trajectory_every; // 0: no trajectory
    double checkpoint_every; // seconds on the wall
    brink_wish wish;
    brink_mark start_at; // where a bad start is complained of: `start`, or `box`
    brink_mark temperature_at; // line 0: not given
    char *text;                // the file as read, NUL-terminated
    size_t text_size;
} brink_scene;

/**
 * Reads and checks a scene.  Returns the number of errors, 0 for a good scene;
 * all errors of the file are written to `errors`, each as file:line:column:
 * error: what is wrong the line ^ what to do With errors, *scene is empty.  Never
 * crashes on any bytes; a file over 1 MiB, a directory, an empty file, binary
 * rubbish are errors like any other.
 */
int brink_scene_read(const char *path, brink_scene *scene, FILE *errors);

/** The same from memory; `name` stands for the file in messages and `folder` (""
 * for the working one) is what a start file is relative to. */
int brink_scene_parse(const char *text, size_t size, const char *name,
                      const char *folder, brink_scene *scene, FILE *errors);
void brink_scene_destroy(brink_scene *scene);

/** Total number of events the scene asks for with this target, UINT64_MAX if a
 * time. */
uint64_t brink_scene_events(const brink_scene *scene);
#endif
