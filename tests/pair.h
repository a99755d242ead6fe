// SPDX-License-Identifier: MIT
#ifndef TESTS_PAIR_H
#define TESTS_PAIR_H
/** A pair, and what families of pairs are made with. */
#include "random.h"
#include <string.h>

typedef struct pair_case {
    double r[3], v[3], sigma;
} pair_case;

static inline void fill_normal(stream *s, double x[3], double scale)
{
    for (int i = 0; i < 3; i++)
        x[i] = scale * stream_normal(s);
}

static inline double length_of(const double x[3])
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

static inline void resize(double x[3], double length)
{
    double factor = length / length_of(x);
    for (int i = 0; i < 3; i++)
        x[i] *= factor;
}
#endif
