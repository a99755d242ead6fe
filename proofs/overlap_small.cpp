// with: kernels/overlap.c kernels/overlap_value.c kernels/dyadic.c
// SPDX-License-Identifier: MIT
// overlap.c in few bits, every input: a sign that its filters answer is the sign.  What they
// leave is asked in exact numbers, which is counted.
//
// Every input but for powers of two: a length 2^k changes no digit, nor x_i 2^k and y_i 2^-k in
// a product; of the sphere the signs of r do not count.  Terms that are less than 2^-(p + 3) of
// the largest one are looked at as 0.
#include "small_format.h"

extern "C" int brink_ball_overlap_sign(const double[3], double);
extern "C" int brink_ball_overlap_rate_sign(const double[3], const double[3]);
static long left_to_exact;

#define double                       Small
#define brink_ball_overlap_sign      small_sign
#define brink_ball_overlap_rate_sign small_rate_sign
#define brink_ball_overlap_sign_at   small_sign_at
#define brink_ball_overlap_rate_sign_at small_rate_sign_at
#define brink_halfspace_overlap_sign small_plane_sign
#define brink_halfspace_overlap_rate_sign small_plane_rate_sign
#define brink_halfspace_overlap_sign_at small_plane_sign_at
extern "C" {
#include "overlap.c"
}
