// SPDX-License-Identifier: MIT
#include "../tests/paths.h"
#include "times.h"

PATHS_OF(time_kernel, brink_intersection_time_fast)
PATHS_OF(time_kernel, brink_disjoint_time_fast)

static const time_tier tier = {
    RANK_FAST,
    brink_intersection_time_fast,
    brink_disjoint_time_fast,
    PATHS(brink_intersection_time_fast),
    PATHS(brink_disjoint_time_fast),
};

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stream s = stream_of_bytes(data, size);
    times_check(&tier, &s);
    return 0;
}
