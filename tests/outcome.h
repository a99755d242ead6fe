// SPDX-License-Identifier: MIT
#ifndef OUTCOME_H
#define OUTCOME_H
/** What came of a scene's text, and what was said of it. */
#include "scene.h"

typedef struct outcome {
    int complaints; // of reading it
    int status;     // of starting it
    brink_scene scene;
    brink_system system;
    char *said;
} outcome;

/** Reads a text, called t.yaml and in the folder `here`. */
outcome parse_bytes(const char *text, size_t size);
outcome parse(const char *text);

/** Reads a text that is good, in the working folder, and starts it. */
outcome start(const char *text);

/** The same, and the test fails unless the system is made and valid. */
outcome good_start(const char *text);

void forget(outcome *o);
#endif
