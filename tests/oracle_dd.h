// SPDX-License-Identifier: MIT
#ifndef TESTS_ORACLE_DD_H
#define TESTS_ORACLE_DD_H
/** What double-double is measured with. */
#include "oracle.h"
#include "random.h"
#include <brink/exact.h>

static inline void oracle_set_dd(mpfr_t z, dd x)
{
    mpfr_set_d(z, x.hi, ORACLE_N);
    mpfr_add_d(z, z, x.lo, ORACLE_N);
}

/** |got - exact| / |exact|, 0 for 0 / 0. */
static inline double oracle_dd_error(dd got, const mpfr_t exact)
{
    mpfr_t z, ratio;
    mpfr_init2(z, ORACLE_BITS);
    mpfr_init2(ratio, 64); // away from 0, so no less than it is
    oracle_set_dd(z, got);
    mpfr_sub(z, z, exact, ORACLE_N);
    mpfr_set_zero(ratio, 1);
    if (!mpfr_zero_p(z))
        mpfr_div(ratio, z, exact, MPFR_RNDA);
    const double error = fabs(mpfr_get_d(ratio, MPFR_RNDA));
    mpfr_clears(z, ratio, (mpfr_ptr)0);
    return error;
}

/** A double-double of magnitude near 1; one in four with its low part at the
 *  limit. */
static inline dd oracle_any_dd(stream *s)
{
    double hi = stream_scaled(s, -3, 3);
    double half_ulp = ldexp(0x1p-53, ilogb(hi));
    int edge = stream_int(s, 0, 3) == 0;
    return fast_two_sum(hi, edge ? stream_sign(s) * nextafter(half_ulp, 0)
                                 : half_ulp * stream_real(s, -1, 1));
}
#endif
