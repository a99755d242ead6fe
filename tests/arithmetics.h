// SPDX-License-Identifier: MIT
#ifndef TESTS_ARITHMETICS_H
#define TESTS_ARITHMETICS_H
/** formulas.h in double, long double and, where there is one, __float128: the
 * functions double_NAME, long_NAME and quad_NAME. */
#include <brink/impulse.h>
#include <math.h>

#define REAL    double
#define SQRT    sqrt
#define NAME(f) double_##f
#include "formulas.h"
#undef REAL
#undef SQRT
#undef NAME

#define REAL    long double
#define SQRT    sqrtl
#define NAME(f) long_##f
#include "formulas.h"
#undef REAL
#undef SQRT
#undef NAME

#ifdef TESTS_FLOAT128
__float128 sqrtq(__float128); // of libquadmath, whose header only gcc finds
#define REAL    __float128
#define SQRT    sqrtq
#define NAME(f) quad_##f
#include "formulas.h"
#undef REAL
#undef SQRT
#undef NAME
#endif
#endif
