// SPDX-License-Identifier: MIT
#include "times.h"

TIMES_TARGET(RANK_PLAIN, brink_intersection_time, brink_disjoint_time)
