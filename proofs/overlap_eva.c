// SPDX-License-Identifier: MIT
// with: -warn-special-float non-finite
/**
 * The estimates of an overlap, its rate and its sign later: no invalid operation
 * and no overflow on the way, for any components that are at most 2^200 and times
 * that are at most 2^200.  Larger ones are what the kernels ask is_precise and
 * is_certain for, and then they count in dyadics.
 */
#include "libm_eva.h"

#include "../kernels/overlap_value.c"

static double any(void)
{
    return Frama_C_double_interval(-0x1p200, 0x1p200);
}

static void make(double x[3])
{
    for (int i = 0; i < 3; i++)
        x[i] = any();
}

int main(void)
{
    double r[3], v[3], n[3], c[3], sigma = any(), t = any();
    make(r);
    make(v);
    make(n);
    make(c);
    estimate all[5] = {ball_now(r, sigma), dot(r, v), plane_now(n, r, c),
                       ball(r, v, sigma, t), plane(n, r, v, c, t)};
    for (int i = 0; i < 5; i++) {
        //@ assert value: \is_finite(all[i].value);
        //@ assert size: \is_finite(all[i].size);
        is_precise(all[i]);
        is_certain(all[i]);
    }
    return 0;
}
