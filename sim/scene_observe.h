// SPDX-License-Identifier: MIT
#ifndef BRINK_SCENE_OBSERVE_H
#define BRINK_SCENE_OBSERVE_H
/**
 * A scene's `observe`: what is to be measured, and how often.
 */
#include "scene.h"
#include "scene_tree.h"

/** Reads it into scene->wish; box, species and temperature are read already, and
 * good if nothing was complained of so far. */
void brink_observe_read(brink_source *s, brink_scene *scene,
                        const brink_node *node);
#endif
