// SPDX-License-Identifier: MIT
#include "times.h"

TIMES_TARGET(RANK_CR, brink_intersection_time_cr, brink_disjoint_time_cr)
