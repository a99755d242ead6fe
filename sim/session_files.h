// SPDX-License-Identifier: MIT
#ifndef BRINK_SESSION_FILES_H
#define BRINK_SESSION_FILES_H
/**
 * The files of a run's folder, and what is said of one that cannot be written:
 * which, why, and what to do.
 *
 * Results are written beside their place, and renamed into it when they are
 * whole: whatever happens, what bears a result's name is one.
 */
#include <stdio.h>

/** Names the folder of a new run, `out` or else the scene's name without its
 * ending, and makes it.  0; -1 after a complaint: no such folder can be made, or
 * it holds a run. */
int brink_files_choose(char *dir, size_t size, const char *scene,
                       const char *out);

/** Tells of DIR/NAME with the reason in errno.  -1. */
int brink_files_complain(const char *dir, const char *name);

/** DIR/NAME, or NULL after a complaint. */
FILE *brink_files_open(const char *dir, const char *name, const char *mode);

/** Begins DIR/NAME.part; NULL after a complaint. */
FILE *brink_files_begin(const char *dir, const char *name);

/** Ends it and puts it in place as DIR/NAME; `failed`: an earlier write to it
 * did, with its reason in errno.  0; -1 after a complaint, an older DIR/NAME left
 * as it was. */
int brink_files_end(FILE *file, const char *dir, const char *name, int failed);
#endif
