// SPDX-License-Identifier: MIT
#include "overlap.h"
#include "dyadic.h"

double brink_ball_overlap(const double r[3], double sigma)
{
    const double x[4] = {r[0], r[1], r[2], sigma},
                 y[4] = {r[0], r[1], r[2], -sigma};
    brink_dyadic f;
    brink_dyadic_dot(&f, 4, x, y);
    return brink_dyadic_round(&f);
}

double brink_ball_overlap_rate(const double r[3], const double v[3])
{
    brink_dyadic f;
    brink_dyadic_dot(&f, 3, r, v);
    return brink_dyadic_round(&f);
}

int brink_ball_overlap_sign(const double r[3], double sigma)
{
    const double x[4] = {r[0], r[1], r[2], sigma},
                 y[4] = {r[0], r[1], r[2], -sigma};
    brink_dyadic f;
    brink_dyadic_dot(&f, 4, x, y);
    return f.sign;
}

int brink_ball_overlap_rate_sign(const double r[3], const double v[3])
{
    brink_dyadic f;
    brink_dyadic_dot(&f, 3, r, v);
    return f.sign;
}
