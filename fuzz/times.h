// SPDX-License-Identifier: MIT
#ifndef FUZZ_TIMES_H
#define FUZZ_TIMES_H
/** What every tier of the event times is put to. */
#include "laws.h"
#include <brink/event_time.h>

typedef double time_kernel(const double r[3], const double v[3], double sigma);

/** A tier: its two kernels, each on every path by its name: see tests/paths.h. */
typedef struct time_tier {
    enum rank rank;
    time_kernel *intersection, *disjoint;
    time_kernel *intersection_on[3], *disjoint_on[3];
} time_tier;

/** A pair of the families, moved a little: the contract of both kernels, the
 *  laws, and the same bits on every path. */
void times_check(const time_tier *tier, stream *s);

/**
 * A pair of whole numbers: event or none, now or later, as whole numbers have it;
 * seen a while later, every event is that while nearer; and gone back from
 * there, where it parted it meets.  To `ulp` of either time.
 */
void times_check_whole(const time_tier *tier, double ulp, stream *s);
#endif
