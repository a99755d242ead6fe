// SPDX-License-Identifier: MIT
#ifndef FUZZ_SCENE_KNOWN_H
#define FUZZ_SCENE_KNOWN_H
/** Scenes that are written from known values: these are read, and of one fault
 *  that is put in there is a complaint in its line. */
#include "../tests/random.h"
#include "scene_laws.h"

/** Writes one into *t, sound or with a fault, and sees what is read of it. */
void scene_known_check(stream *s, scene_text *t);
#endif
