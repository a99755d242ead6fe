// SPDX-License-Identifier: MIT
#ifndef BRINK_TRAJECTORY_H
#define BRINK_TRAJECTORY_H
/**
 * Extended XYZ, as OVITO, ASE and MDAnalysis all read it: quoted nine-number
 * Lattice, quoted pbc, numbers as %.17g, LF, never nan or inf, and
 *     Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:id:I:1
 *
 * ASE knows no species but elements: the column has the species' name where that
 * is an element's symbol, X otherwise.  The names themselves stand in the comment
 * line, with how many there are of each in the order of id: names="A:400 B:100".
 */
#include "system.h"
#include <stdio.h>

/** Writes one frame: the system as it is at `offset` in the current year; `time`
 * goes into the comment line.  0, -1 with errno set. */
int brink_trajectory_write(FILE *out, const brink_system *system, double offset,
                           double time);

typedef struct brink_frame { // what a frame says, in the file's order of
                             // particles
    uint32_t count;
    double length[3];
    char (*species)[16];
    double (*x)[3];
    double (*v)[3]; // NULL if the file has none
} brink_frame;

/** Reads the next frame.  1 a frame; 0 end of file; -1 an error, told to `errors`
 * with file:line.  Memory is the frame's: brink_frame_destroy. */
int brink_trajectory_read(FILE *in, const char *name, brink_frame *frame,
                          FILE *errors);
void brink_frame_destroy(brink_frame *frame);
#endif
