// SPDX-License-Identifier: MIT
#include "made.h"
#include "start.h"
#include <stdlib.h>
#include <string.h>

void made_system(brink_system *system, const char *text, uint64_t seed)
{
    brink_scene scene;
    if (brink_scene_parse(text, strlen(text), "scene", "", &scene, stderr))
        exit(EXIT_FAILURE);
    scene.seed = seed;
    if (brink_start_make(&scene, "scene", system, stderr))
        exit(EXIT_FAILURE);
    brink_scene_destroy(&scene);
}

void made_run(brink_run *run, const char *text, uint64_t seed)
{
    brink_system system;
    made_system(&system, text, seed);
    if (brink_run_create(run, &system, BRINK_TIER_PLAIN))
        exit(EXIT_FAILURE);
}

uint64_t made_share(uint64_t n)
{
    const char *share = getenv("BRINK_TEST_SHARE");
    const uint64_t part = share ? (uint64_t)((double)n * atof(share)) : n;
    return part > 0 ? part : 1;
}
