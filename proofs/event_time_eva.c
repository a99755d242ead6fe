// SPDX-License-Identifier: MIT
#include "../kernels/event_time_fast.c"
#include <__fc_builtin.h>
#define B 0x1p100
static double any(void) { return Frama_C_double_interval(-B, B); }
void main(void)
{
    const double r[3] = {any(), any(), any()}, v[3] = {any(), any(), any()};
    double sigma = Frama_C_double_interval(0, B);
    double t = brink_intersection_time_fast(r, v, sigma);
    //@ assert !\is_NaN(t);
    //@ assert t >= 0;
    double u = brink_disjoint_time_fast(r, v, sigma);
    //@ assert !\is_NaN(u);
    //@ assert u >= 0;
}
