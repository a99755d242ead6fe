// SPDX-License-Identifier: MIT
// What Coq is told overlap_value.c does is what it does.
#define BRINK_PATH transcribed // its functions beside the library's
// NOLINTNEXTLINE(bugprone-suspicious-include): for what is static there
#include "../kernels/overlap_value.c"

#include "transcribed/overlap_value_v.h"

/** All that an overlap is made of, often so that it all but cancels. */
typedef struct scene {
    double r[3], v[3], n[3], c[3], sigma, t;
} scene;

static scene any_scene(stream *s)
{
    scene x;
    const int wide = stream_int(s, 0, 1) ? 3 : 40;
    for (int k = 0; k < 3; k++) {
        x.r[k] = stream_scaled(s, -wide, wide);
        x.v[k] = stream_scaled(s, -wide, wide);
        x.n[k] = stream_scaled(s, -wide, wide);
        x.c[k] = x.r[k] * (1 + stream_scaled(s, -52, 0));
    }
    x.t = stream_scaled(s, -wide, wide);
    x.sigma = stream_near(s, sqrt(x.r[0] * x.r[0] + x.r[1] * x.r[1]), 9);
    if (stream_int(s, 0, 1))
        x.v[2] = -(x.r[0] * x.v[0] + x.r[1] * x.v[1]) / x.r[2];
    else
        x.v[0] = -x.r[0] / x.t;
    return x;
}

#define VECTOR(x)  (x)[0], (x)[1], (x)[2]
#define NUMBERS(x) VECTOR((x).r), VECTOR((x).v), VECTOR((x).n), VECTOR((x).c)
#define SAME_ESTIMATE(parts, its_size, source, ...)                              \
    do {                                                                         \
        const estimate ours = (source);                                          \
        SAME(overlap_value_v_value(parts), ours.value, __VA_ARGS__);             \
        SAME(its_size, ours.size, __VA_ARGS__);                                  \
    } while (0)

START_TEST(overlaps_now_are_those_of_the_proof)
{
    EACH_INPUT(s)
    {
        const scene x = any_scene(&s);
        SAME_ESTIMATE(overlap_value_v_ball_now_parts(VECTOR(x.r), x.sigma),
                      overlap_value_v_ball_now_size(VECTOR(x.r), x.sigma),
                      ball_now(x.r, x.sigma), VECTOR(x.r), x.sigma);
        SAME_ESTIMATE(overlap_value_v_dot_parts(VECTOR(x.r), VECTOR(x.v)),
                      overlap_value_v_dot_size(VECTOR(x.r), VECTOR(x.v)),
                      dot(x.r, x.v), VECTOR(x.r), VECTOR(x.v));
        SAME_ESTIMATE(
            overlap_value_v_plane_now_parts(VECTOR(x.n), VECTOR(x.r),
                                            VECTOR(x.c)),
            overlap_value_v_plane_now_size(VECTOR(x.n), VECTOR(x.r), VECTOR(x.c)),
            plane_now(x.n, x.r, x.c), NUMBERS(x));
    }
}
END_TEST

START_TEST(overlaps_later_are_those_of_the_proof)
{
    EACH_INPUT(s)
    {
        const scene x = any_scene(&s);
        SAME_ESTIMATE(
            overlap_value_v_ball_parts(VECTOR(x.r), VECTOR(x.v), x.sigma, x.t),
            overlap_value_v_ball_size(VECTOR(x.r), VECTOR(x.v), x.sigma, x.t,
                                      0x1p-960),
            ball(x.r, x.v, x.sigma, x.t), NUMBERS(x), x.sigma, x.t);
        SAME_ESTIMATE(overlap_value_v_plane_parts(VECTOR(x.n), VECTOR(x.r),
                                                  VECTOR(x.v), VECTOR(x.c), x.t),
                      overlap_value_v_plane_size(VECTOR(x.n), VECTOR(x.r),
                                                 VECTOR(x.v), VECTOR(x.c), x.t,
                                                 0x1p-960),
                      plane(x.n, x.r, x.v, x.c, x.t), NUMBERS(x), x.t);
    }
}
END_TEST

/** Most of them at the margin, where either may be said. */
START_TEST(what_is_let_through_is_what_the_proof_lets_through)
{
    EACH_INPUT(s)
    {
        const double size = fabs(stream_scaled(&s, -650, 400));
        const int precise = stream_int(&s, 0, 1);
        const double margin = precise ? 0x1p-43 : 0x1p-97;
        const estimate e = {stream_near(&s, margin * size + 0x1p-700, 2), size};
        SAME(overlap_value_v_precise_from(size, 0x1p-700) < fabs(e.value),
             is_precise(e), e.value, size);
        SAME(overlap_value_v_certain_from(size, 0x1p-700) < fabs(e.value),
             is_certain(e), e.value, size);
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE("overlap_value, transcribed", 120,
                     overlaps_now_are_those_of_the_proof,
                     overlaps_later_are_those_of_the_proof,
                     what_is_let_through_is_what_the_proof_lets_through);
}
