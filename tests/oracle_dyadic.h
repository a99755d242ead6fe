// SPDX-License-Identifier: MIT
#ifndef TESTS_ORACLE_DYADIC_H
#define TESTS_ORACLE_DYADIC_H
/** Dyadic numbers as MPFR has them: without a rounding. */
#include "random.h"
#include <brink/dyadic.h>
#include <mpfr.h>

// A product of six doubles lies between 2^-6444 and 2^6144.
enum { ORACLE_DYADIC_BITS = 13000 };

/** z = a; whether a is as dyadic.h says that every dyadic is. */
static inline int oracle_set_dyadic(mpfr_t z, const brink_dyadic *a)
{
    mpfr_t limb;
    mpfr_init2(limb, 64);
    mpfr_set_zero(z, 1);
    for (int i = 0; i < a->count; i++) {
        mpfr_set_ui_2exp(limb, a->limb[i], 32 * (a->low + i), MPFR_RNDN);
        mpfr_add(z, z, limb, MPFR_RNDN);
    }
    if (a->sign < 0)
        mpfr_neg(z, z, MPFR_RNDN);
    mpfr_clear(limb);
    if (a->count == 0)
        return a->sign == 0;
    return a->count <= BRINK_DYADIC_LIMBS && a->limb[a->count - 1] != 0 &&
           a->sign * a->sign == 1;
}

/** Any finite double, the edges of the range often among them. */
static inline double oracle_any_double(stream *s)
{
    switch (stream_int(s, 0, 7)) {
    case 0:
        return 0;
    case 1:
        return stream_sign(s) * DBL_MAX;
    case 2:
        return stream_sign(s) * 0x1p-1074;
    case 3:
        return stream_int(s, -9, 9);
    default:
        return stream_scaled(s, -1080, 1023);
    }
}
#endif
