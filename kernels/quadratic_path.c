// SPDX-License-Identifier: MIT
#include "exact.h"
#include "path.h"
#include "quadratic.h"

#ifdef BRINK_DISPATCH
#define PARAMETERS (double a, double b, double c, double *x0, double *x1)
#define ARGUMENTS  (a, b, c, x0, x1)

BRINK_CHOOSE(int, brink_quadratic_roots, PARAMETERS, ARGUMENTS)
BRINK_CHOOSE(int, brink_quadratic_roots_cr, PARAMETERS, ARGUMENTS)
#endif
