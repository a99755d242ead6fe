// SPDX-License-Identifier: MIT
#define NAME(f) rival_##f##_mpfr
#include "rivals_mpfr.h"
