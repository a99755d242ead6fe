// SPDX-License-Identifier: MIT
// The signs that are asked for at every turn, by a filter that needs no fma();
// what it does not decide goes the way of the signs at a later time, at t = 0.
#include "overlap.h"
#include "exact.h"

static const double zero[3] = {0, 0, 0};

int brink_ball_overlap_sign(const double r[3], double sigma)
{
    // r.r is off by 3u of itself, sigma^2 by 1u, each product by 2^-1075 at the
    // least; the difference has the sign that they have.
    double rr = r[0] * r[0] + r[1] * r[1] + r[2] * r[2], ss = sigma * sigma;
    double f = rr - ss, error = 0x1p-51 * (rr + ss) + 0x1p-1000;
    if (fabs(f) > error)
        return sign_of(f);
    return brink_ball_overlap_sign_at(r, zero, sigma, 0);
}

int brink_ball_overlap_rate_sign(const double r[3], const double v[3])
{
    double x = r[0] * v[0], y = r[1] * v[1], z = r[2] * v[2];
    double f = x + y + z, size = fabs(x) + fabs(y) + fabs(z); // 3u of the size
    if (fabs(f) > 0x1p-51 * size + 0x1p-1000)
        return sign_of(f);
    return brink_ball_overlap_rate_sign_at(r, v, 0);
}

int brink_halfspace_overlap_sign(const double r[3], const double n[3],
                                 const double c[3])
{
    double x = n[0] * (r[0] - c[0]), y = n[1] * (r[1] - c[1]);
    double z = n[2] * (r[2] - c[2]);
    double f = x + y + z, size = fabs(x) + fabs(y) + fabs(z); // 4u of the size
    if (fabs(f) > 0x1p-50 * size + 0x1p-1000)
        return sign_of(f);
    return brink_halfspace_overlap_sign_at(r, zero, n, c, 0);
}

int brink_halfspace_overlap_rate_sign(const double v[3], const double n[3])
{
    return brink_ball_overlap_rate_sign(n, v);
}
