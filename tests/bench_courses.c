// SPDX-License-Identifier: MIT
#include "bench_courses.h"

/** Number density of spheres of diameter 1 at a packing fraction: 6 / pi */
#define PACKED(fraction) ((fraction)*1.909859317102744)

const bench_course bench_courses[COURSES] = {
    {"well-3",
     "square well, λ = 3, density 0.001",
     {20, 1e-3, 3, -1},
     650000,
     33800,
     0,
     1},
    {"shoulder-3",
     "square shoulder, λ = 3, density 0.001",
     {20, 1e-3, 3, 1},
     650000,
     24000,
     0,
     0},
    {"spheres-0.25",
     "hard spheres, packing 0.25",
     {20, PACKED(0.25), 0, 0},
     760000,
     77000,
     508000,
     0},
    {"spheres-0.45",
     "hard spheres, packing 0.45",
     {20, PACKED(0.45), 0, 0},
     1070000,
     71000,
     710000,
     1},
    {"well-1.5",
     "square well, λ = 1.5, density 0.5",
     {10, 0.5, 1.5, -1},
     400000,
     0,
     0,
     0},
    {"million",
     "hard spheres, packing 0.45",
     {63, PACKED(0.45), 0, 0},
     450000,
     0,
     301000,
     0},
};

race_course bench_size(int k)
{
    static const int edge[SIZES] = {6, 9, 14, 20, 30, 44, 63};
    return (race_course){edge[k], PACKED(0.45), 0, 0};
}

race_course bench_density(int k)
{
    static const double packing[DENSITIES] = {0.0005, 0.002, 0.01, 0.05, 0.15,
                                              0.25,   0.35,  0.45, 0.5};
    return (race_course){20, PACKED(packing[k]), 0, 0};
}

const race_course bench_well_12 = {20, 0.5, 1.75, -1};
