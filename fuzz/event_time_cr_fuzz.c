// SPDX-License-Identifier: MIT
#include "../tests/paths.h"
#include "times.h"

PATHS_OF(time_kernel, brink_intersection_time_cr)
PATHS_OF(time_kernel, brink_disjoint_time_cr)

static const time_tier tier = {
    RANK_CR,
    brink_intersection_time_cr,
    brink_disjoint_time_cr,
    PATHS(brink_intersection_time_cr),
    PATHS(brink_disjoint_time_cr),
};

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stream s = stream_of_bytes(data, size);
    if (stream_int(&s, 0, 3) == 0)
        times_check_whole(&tier, 0.5, &s);
    else
        times_check(&tier, &s);
    return 0;
}
