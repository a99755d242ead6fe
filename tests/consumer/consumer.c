// SPDX-License-Identifier: MIT
/* Calls into the library and says what it found. */
#include <brink/event_time.h>
#include <brink/quadratic.h>
#include <stdio.h>

int main(void)
{
    const double r[3] = {3, 0, 0}, v[3] = {-1, 0, 0};
    double x0, x1;
    const double t = brink_intersection_time(r, v, 1);
    const int roots = brink_quadratic_roots(1, -3, 2, &x0, &x1);
    printf("they meet at %g; %d roots, %g and %g\n", t, roots, x0, x1);
    return t == 2 && roots == 2 && x0 == 1 && x1 == 2 ? 0 : 1;
}
