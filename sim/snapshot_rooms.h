// SPDX-License-Identifier: MIT
#ifndef BRINK_SNAPSHOT_ROOMS_H
#define BRINK_SNAPSHOT_ROOMS_H
/**
 * What a run's rooms hold, as bytes: the cell that each particle is in, its home
 * where there are lists, the level of each pair that has one, each particle's
 * pending event.  They are looked up when written and placed when read.
 */
#include "codec.h"
#include "run.h"

void brink_code_instant(brink_codec *c, brink_instant *t);

void brink_rooms_write(brink_codec *c, const brink_run *run);

/** Into a run that has its system, its clock and empty rooms.  Where the codec
 * has a fault afterwards, the run is fit to be destroyed. */
void brink_rooms_read(brink_codec *c, brink_run *run);
#endif
