// SPDX-License-Identifier: MIT
/*
 * Prints a hash of the state of some runs after a while: positions, velocities,
 * levels, clock.  golden.sh builds it by several compilers; they must all print
 * what golden.txt says.
 */
#include "scene.h"
#include "start.h"
#include "systems.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** After 20000 events; this is no Check program, so it looks for itself. */
static void run_scene(brink_run *run, const char *text)
{
    brink_scene scene;
    brink_system system;
    if (brink_scene_parse(text, strlen(text), "scene", "", &scene, stderr) ||
        brink_start_make(&scene, "scene", &system, stderr) ||
        brink_run_create(run, &system, BRINK_TIER_PLAIN) ||
        brink_run_advance(run, 20000, BRINK_NEVER) != BRINK_RUN_REACHED)
        exit(EXIT_FAILURE);
    brink_scene_destroy(&scene);
}

/** FNV-1a, 64 bits. */
static uint64_t hash(uint64_t h, const void *bytes, size_t count)
{
    const unsigned char *p = bytes;
    for (size_t n = 0; n < count; n++)
        h = (h ^ p[n]) * UINT64_C(0x100000001b3);
    return h;
}

static void golden(const char *name, const char *scene)
{
    uint64_t h = UINT64_C(0xcbf29ce484222325);
    brink_run run;
    run_scene(&run, scene);
    const uint32_t n = run.system.count;
    for (uint32_t i = 0; i < n; i++) {
        brink_particle *p = &run.system.particle[i];
        brink_system_advance(&run.system, i, run.now.offset);
        h = hash(h, p->x, sizeof p->x);
        h = hash(h, p->v, sizeof p->v);
        for (uint32_t j = i + 1; j < n; j++) {
            const int level = brink_states_level(&run.states, i, j);
            h = hash(h, &level, sizeof level);
        }
    }
    h = hash(h, &run.now.epoch, sizeof run.now.epoch);
    h = hash(h, &run.now.offset, sizeof run.now.offset);
    printf("%016" PRIx64 "  %s\n", h, name);
    brink_run_destroy(&run);
}

int main(void)
{
    golden("hard spheres", hard_spheres);
    golden("square well", square_well);
    golden("three steps", three_steps);
    golden("mixture", mixture);
    golden("discs in wells", discs_well);
    golden("crowded spheres", crowded_spheres);
    golden("crowded mixture", crowded_mixture);
    return 0;
}
