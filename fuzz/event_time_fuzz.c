// SPDX-License-Identifier: MIT
#include "../tests/paths.h"
#include "times.h"

PATHS_OF(time_kernel, brink_intersection_time)
PATHS_OF(time_kernel, brink_disjoint_time)

static const time_tier tier = {
    RANK_PLAIN,
    brink_intersection_time,
    brink_disjoint_time,
    PATHS(brink_intersection_time),
    PATHS(brink_disjoint_time),
};

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stream s = stream_of_bytes(data, size);
    if (stream_int(&s, 0, 3) == 0)
        times_check_whole(&tier, BRINK_EVENT_TIME_ULP, &s);
    else
        times_check(&tier, &s);
    return 0;
}
