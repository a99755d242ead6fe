// SPDX-License-Identifier: MIT
#ifndef BRINK_LIBM_EVA_H
#define BRINK_LIBM_EVA_H
/**
 * What Eva is told of <math.h> where Frama-C's own says nothing; trusted.  Each
 * is an interval that holds what the function gives, so Eva goes on with more
 * than can be.  Included before the source it is for.
 */
#include "__fc_builtin.h"
#include <float.h>
#include <math.h>

/** x y + z, rounded once: no farther from 0 than |x y| + |z| with room for three
 *  roundings and underflow, and not negative where neither x y nor z is. */
static double fma_within(double x, double y, double z)
{
    double p = x * y, m = (fabs(p) + fabs(z)) * (1 + 0x1p-50) + 0x1p-1070;
    double least = p >= 0 && z >= 0 ? 0 : -m;
    return Frama_C_double_interval(least, m);
}

#define fma(x, y, z) fma_within(x, y, z)

/** Of 0, as there are two, and of NaN: either. */
#undef signbit
#define signbit(x) ((x) < 0 || (!((x) > 0) && Frama_C_interval(0, 1)))

#endif
