// SPDX-License-Identifier: MIT
// What Coq is told the filters of overlap.c do is what they do.  The linker puts
// what is below in the place of the signs at a later time, which a filter asks
// where it is not certain: see CMakeLists.txt.
#include "transcribed/overlap_v.h"
#include "transcribed/underflow_v.h"
#include <brink/overlap.h>

enum { ASKED = 2 }; // no sign
#define VECTOR(x) (x)[0], (x)[1], (x)[2]

typedef int sign_later(const double r[3], const double v[3], double sigma,
                       double t);
typedef int rate_sign_later(const double r[3], const double v[3], double t);
typedef int plane_sign_later(const double r[3], const double v[3],
                             const double n[3], const double c[3], double t);
sign_later asked_sign __asm__("__wrap_brink_ball_overlap_sign_at");
rate_sign_later asked_rate __asm__("__wrap_brink_ball_overlap_rate_sign_at");
plane_sign_later asked_plane __asm__("__wrap_brink_halfspace_overlap_sign_at");

int asked_sign(const double r[3], const double v[3], double sigma, double t)
{
    (void)r, (void)v, (void)sigma, (void)t;
    return ASKED;
}

int asked_rate(const double r[3], const double v[3], double t)
{
    (void)r, (void)v, (void)t;
    return ASKED;
}

int asked_plane(const double r[3], const double v[3], const double n[3],
                const double c[3], double t)
{
    (void)r, (void)v, (void)n, (void)c, (void)t;
    return ASKED;
}

static int answered(double f, double error)
{
    return fabs(f) > error ? (f > 0) - (f < 0) : ASKED;
}

/** Often so small that the absolute part of the filters decides, or products
 *  underflow. */
static void any_vector(stream *s, double x[3])
{
    const int tiny[] = {0, 0, -490, -520};
    const int e = tiny[stream_int(s, 0, 3)];
    for (int k = 0; k < 3; k++)
        x[k] = stream_scaled(s, e - 10, e + 10);
}

/** Most of them so near the surface that the filter may be certain or not. */
START_TEST(the_filter_of_a_sphere_is_that_of_the_proof)
{
    EACH_INPUT(s)
    {
        double r[3];
        any_vector(&s, r);
        const double length = sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
        const double sigma = stream_near(&s, length, stream_int(&s, 0, 100));
        const product x = {r[0], r[0]}, y = {r[1], r[1]}, z = {r[2], r[2]};
        const product ss = {sigma, sigma};
        SAME(answered(overlap_v_ball_difference(x, y, z, ss),
                      overlap_v_ball_error(x, y, z, ss)),
             brink_ball_overlap_sign(r, sigma), r[0], r[1], r[2], sigma);
    }
}
END_TEST

START_TEST(the_filter_of_its_rate_is_that_of_the_proof)
{
    EACH_INPUT(s)
    {
        double r[3], v[3];
        any_vector(&s, r);
        any_vector(&s, v);
        v[2] = stream_near(&s, -(r[0] * v[0] + r[1] * v[1]) / r[2], 8);
        const product x = {r[0], v[0]}, y = {r[1], v[1]}, z = {r[2], v[2]};
        SAME(answered(underflow_v_dot_plain(x, y, z),
                      overlap_v_rate_error(x, y, z)),
             brink_ball_overlap_rate_sign(r, v), r[0], r[1], r[2], v[0], v[1],
             v[2]);
    }
}
END_TEST

START_TEST(the_filter_of_a_plane_is_that_of_the_proof)
{
    EACH_INPUT(s)
    {
        double n[3], r[3], c[3];
        any_vector(&s, n);
        any_vector(&s, r);
        any_vector(&s, c);
        const double to_it = n[0] * (r[0] - c[0]) + n[1] * (r[1] - c[1]);
        c[2] = stream_near(&s, r[2] + to_it / n[2], 8);
        SAME(answered(overlap_v_plane_sum(VECTOR(n), VECTOR(r), VECTOR(c)),
                      overlap_v_plane_error(VECTOR(n), VECTOR(r), VECTOR(c))),
             brink_halfspace_overlap_sign(r, n, c), VECTOR(n), VECTOR(r),
             VECTOR(c));
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE("overlap, transcribed", 120,
                     the_filter_of_a_sphere_is_that_of_the_proof,
                     the_filter_of_its_rate_is_that_of_the_proof,
                     the_filter_of_a_plane_is_that_of_the_proof);
}
