// SPDX-License-Identifier: MIT
#define ORACLE_BITS 256
#define NAME(f)     rival_##f##_mpfr256
#include "rivals_mpfr.h"
