// SPDX-License-Identifier: MIT
#ifndef BRINK_WALL_H
#define BRINK_WALL_H
/** The clock on the wall, for those above a run who ask how long it takes. */

/** Seconds from some moment on; it never runs back. */
double brink_wall_clock(void);
#endif
