// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_H
#define BRINK_STUDY_H
/**
 * The long-run stability study of [S16] section 5: scenes run with logical states
 * and with each of the conventional methods beside them, from the same start, and
 * a page that shows what became of their energy.
 *
 * A trial runs in a process of its own, as many at a time as the machine has
 * cores, and leaves its samples and figures in OUT; a trial that crashes is
 * reported as such.  A study that was stopped or killed goes on where it was when
 * it is run again; what was done is not done again, unless the scene or the
 * program has changed.
 */

/**
 * Runs the study into the folder `out`, which is made where it is missing.  A
 * scene is the path of a file, or one word: a scene that comes with the program.
 * count 0: square-well and square-shoulder.
 *
 * Returns   the exit code: 0 done, the page's path on standard output; 2 a scene
 * is not good or the page cannot be written; 3 a trial crashed, or the logical
 * states did not come to their end (the page says how); 75 stopped by SIGTERM or
 * SIGINT: run again, the study goes on.
 */
int brink_study(const char *out, int count, const char *const scenes[]);
#endif
