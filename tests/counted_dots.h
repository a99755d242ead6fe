// SPDX-License-Identifier: MIT
#ifndef TESTS_COUNTED_DOTS_H
#define TESTS_COUNTED_DOTS_H
/** Whether a time comes to exact numbers: the linker leads the calls of
 * brink_dyadic_dot, their first, through here (tests/CMakeLists.txt). */
#include <brink/dyadic.h>

static int dots;

typedef void dot(brink_dyadic *z, int n, const double *x, const double *y);
dot real_dot __asm__("__real_brink_dyadic_dot");
dot counted_dot __asm__("__wrap_brink_dyadic_dot");

void counted_dot(brink_dyadic *z, int n, const double *x, const double *y)
{
    dots++;
    real_dot(z, n, x, y);
}
#endif
