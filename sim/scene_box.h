// SPDX-License-Identifier: MIT
#ifndef BRINK_SCENE_BOX_H
#define BRINK_SCENE_BOX_H
/**
 * The key `box` of a scene: how long its sides are, and whether the particles fit
 * in.
 */
#include "scene.h"
#include "scene_tree.h"

#define BRINK_BOX_EXAMPLE "box: {number_density: 0.1}"

/** Fills length from the node.  Where the species are sound they have been read
 * before; otherwise what depends on them is not looked at. */
void brink_box_read(brink_source *s, brink_scene *scene, const brink_node *node,
                    int have_species);
#endif
