// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_PROGRESS_H
#define BRINK_STUDY_PROGRESS_H
/**
 * How far a method has got with a scene, on disk: while its trial is under way a
 * checkpoint of the run, with the trial's figures in it; after that the figures
 * alone.
 *
 * Figures are stored as they lie in memory: only the program that wrote them
 * reads them, see brink_progress_key.
 */
#include "scene.h"
#include "study_nudges.h"
#include "study_trial.h"

typedef struct brink_progress {
    uint64_t key; // of the scene, the start, the method and the program
    brink_attempt attempt;
    int nudges; // other nudges that have been tried
    double nudge_off[BRINK_NUDGES];
} brink_progress;

/** What two pieces of one study have in common: a checksum over the scene's text,
 * its start, the method and the very file of this program. */
uint64_t brink_progress_key(const brink_scene *scene, const brink_system *start,
                            enum brink_method method);

/** Writes a checkpoint into a folder, which is made where it is missing.  0; -1
 * with a message to `errors`. */
int brink_progress_save(const brink_progress *p, const char *folder,
                        FILE *errors);

/** Reads the newest that is whole into *p, whose key, method and number of events
 * are given.  0; -1 with a message to `errors`, its attempt left as it was. */
int brink_progress_resume(brink_progress *p, const char *folder, FILE *errors);

/** Writes the figures alone to a file, which is replaced at once.  0, -1. */
int brink_progress_store(const brink_progress *p, const char *file, FILE *errors);

/** Reads them.  NULL, or what is wrong with them: *p is left as it was then. */
const char *brink_progress_load(brink_progress *p, const char *file);
#endif
