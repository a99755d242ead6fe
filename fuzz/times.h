// SPDX-License-Identifier: MIT
#ifndef FUZZ_TIMES_H
#define FUZZ_TIMES_H
/** What every tier of the event times is put to. */
#include "../tests/paths.h"
#include "laws.h"
#include <brink/event_time.h>

typedef double time_kernel(const double r[3], const double v[3], double sigma);

/** A tier: its two kernels, each on every path by its name: see tests/paths.h. */
typedef struct time_tier {
    enum rank rank;
    time_kernel *intersection, *disjoint;
    time_kernel *intersection_on[3], *disjoint_on[3];
} time_tier;

/**
 * One case of a tier.  Three in four are a pair of the families, moved a little:
 * the contract of both kernels, the laws, and the same bits on every path.
 *
 * The fourth is a pair of whole numbers: event or none, now or later, as whole
 * numbers have it; seen a while later, every event is that while nearer; and gone
 * back from there, where it parted it meets.  To the tier's bound of either time;
 * _fast has none, and may see whole numbers on the surface on either side of it:
 * it is put to the families alone.
 */
void times_check(const time_tier *tier, stream *s);

/** The target of a tier, by its kernels' names. */
#define TIMES_TARGET(rank, in, out)                                              \
    PATHS_OF(time_kernel, in)                                                    \
    PATHS_OF(time_kernel, out)                                                   \
    int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)                 \
    {                                                                            \
        static const time_tier tier = {rank, in, out, PATHS(in), PATHS(out)};    \
        stream s = stream_of_bytes(data, size);                                  \
        times_check(&tier, &s);                                                  \
        return 0;                                                                \
    }
#endif
