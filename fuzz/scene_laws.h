// SPDX-License-Identifier: MIT
#ifndef FUZZ_SCENE_LAWS_H
#define FUZZ_SCENE_LAWS_H
/**
 * What holds of any bytes that are given as a scene: they are refused with
 * complaints that an editor can follow, or within every bound that is stated;
 * what is accepted means the same with other ends of lines, and a small one can
 * be started.
 */
#include "scene.h"
#include <stddef.h>

enum { SCENE_TEXT_LONGEST = 8192 };

typedef struct scene_text {
    size_t size;
    char byte[SCENE_TEXT_LONGEST];
} scene_text;

/** Says which law was broken, by which text. */
_Noreturn void scene_broken(const scene_text *t, const char *law);

/** 0 a good scene; or how many complaints, one of them, unless that is 0, in line
 *  `wanted`. */
int scene_parse(const scene_text *t, brink_scene *scene, long wanted);

/** All laws; whether it is a scene. */
int scene_take(const scene_text *t, long wanted);
#endif
