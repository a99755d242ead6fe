// SPDX-License-Identifier: MIT
#include "times.h"

TIMES_TARGET(RANK_FAST, brink_intersection_time_fast, brink_disjoint_time_fast)
