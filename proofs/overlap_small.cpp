// with: kernels/overlap.c kernels/overlap_value.c kernels/dyadic.c
// SPDX-License-Identifier: MIT
// overlap.c in few bits, every input: the sign that a filter answers is the sign.  What it leaves
// to exact numbers is counted.
//
// Every input but for powers of two: all lengths times 2^k, or x_i 2^k and y_i 2^-k, change no
// digit.  Of the sphere the signs of r do not count, and x and y can be exchanged.  Exponents are
// within 8 of one another, or a number is 0.
#include "small_format.h"

extern "C" int brink_ball_overlap_sign(const double[3], double);
extern "C" int brink_ball_overlap_rate_sign(const double[3], const double[3]);

#define double Small
#define brink_ball_overlap_sign           small_sign
#define brink_ball_overlap_rate_sign      small_rate_sign
#define brink_ball_overlap_sign_at        small_sign_at
#define brink_ball_overlap_rate_sign_at   small_rate_sign_at
#define brink_halfspace_overlap_sign      small_plane_sign
#define brink_halfspace_overlap_rate_sign small_plane_rate_sign
#define brink_halfspace_overlap_sign_at   small_plane_sign_at
extern "C" {
#include "overlap.c"
}
#undef double
#undef brink_ball_overlap_sign
#undef brink_ball_overlap_rate_sign

// The exact signs: none is given here.
static const int no_sign = 7;
extern "C" int small_sign_at(const Small *, const Small *, Small, Small)
{
    return no_sign;
}
extern "C" int small_rate_sign_at(const Small *, const Small *, Small)
{
    return no_sign;
}
extern "C" int small_plane_sign_at(const Small *, const Small *, const Small *,
                                   const Small *, Small)
{
    return no_sign;
}

/** The filters' 4 u and 8 u. */
static double constant(double c)
{
    if (c == 0x1p-51 || c == 0x1p-50)
        return std::ldexp(c, 53 - places);
    static const double plain[] = {0, 0x1p-1000};
    for (double known : plain)
        if (c == known)
            return c;
    std::printf("what is %a in few places?\n", c);
    std::exit(2);
}

static int sign_of_double(double x)
{
    return (x > 0) - (x < 0);
}

static bool is_the_library()
{
    places = 53;
    for (int i = 0; i < 1000000; i++) {
        int exponents = i % 2 == 0 ? 3 : 80;
        double r[3], v[3], sigma = random_double(exponents);
        Small sr[3], sv[3];
        for (int k = 0; k < 3; k++) {
            sr[k] = Small::of(r[k] = random_double(exponents));
            sv[k] = Small::of(v[k] = random_double(exponents));
        }
        if (i % 3 == 0)
            sigma = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
        int sign = small_sign(sr, Small::of(sigma)),
            rate = small_rate_sign(sr, sv);
        if ((sign != no_sign && sign != brink_ball_overlap_sign(r, sigma)) ||
            (rate != no_sign && rate != brink_ball_overlap_rate_sign(r, v))) {
            std::printf(
                "not what the library has: r %a %a %a v %a %a %a sigma %a\n",
                r[0], r[1], r[2], v[0], v[1], v[2], sigma);
            return false;
        }
    }
    return true;
}

static long inputs, left;

static bool is_right(int answer, double exact)
{
    inputs++;
    left += answer == no_sign;
    return answer == no_sign || answer == sign_of_double(exact);
}

/** Number n of those from 2^lowest on; 0 is the first. */
static double number(int n, int lowest)
{
    int ones = 1 << (places - 1);
    return n == 0 ? 0
                  : std::ldexp((double)(ones + (n - 1) % ones),
                               (n - 1) / ones + lowest);
}

static bool sphere_holds(int p, int lengths)
{
    places = p;
    inputs = left = 0;
    int ones = 1 << (p - 1), all = 1 + 6 * ones, last = lengths == 3 ? all : 1;
    for (int s = 1; s <= ones; s++)
        for (int i = 0; i < all; i++)
            for (int j = 0; j <= i; j++)
                for (int k = 0; k < last; k++) {
                    double x = number(i, -3), y = number(j, -3),
                           z = number(k, -3);
                    double sigma = number(s, 0);
                    Small r[3] = {Small::of(x), Small::of(y), Small::of(z)};
                    if (!is_right(small_sign(r, Small::of(sigma)),
                                  x * x + y * y + z * z - sigma * sigma)) {
                        std::printf("wrong sign in %d bits: %a %a %a, %a\n", p, x,
                                    y, z, sigma);
                        return false;
                    }
                }
    std::printf("sphere, %d lengths of %d bits: %ld inputs, left %.3f\n", lengths,
                p, inputs, (double)left / (double)inputs);
    return true;
}

/** Of n products, the first v in [1, 2). */
static bool rate_holds(int p, int n)
{
    places = p;
    inputs = left = 0;
    int ones = 1 << (p - 1), all = 1 + 5 * ones, thirds = n == 3 ? all : 1;
    for (int a = 1; a <= ones; a++)
        for (int b = 1; b <= ones; b++)
            for (int c = 1; c <= ones; c++)
                for (int d = -all + 1; d < all; d++)
                    for (int e = 1; e <= (n == 3 ? ones : 1); e++)
                        for (int f = -thirds + 1; f < thirds; f++) {
                            double r[3] = {number(a, 0), number(b, 0),
                                           number(e, 0)};
                            double v[3] = {number(c, 0), number(std::abs(d), -2),
                                           number(std::abs(f), -2)};
                            v[1] = d < 0 ? -v[1] : v[1];
                            v[2] = f < 0 ? -v[2] : v[2];
                            Small x[3], y[3];
                            double exact = 0;
                            for (int k = 0; k < 3; k++) {
                                x[k] = Small::of(r[k]);
                                y[k] = Small::of(v[k]);
                                exact += r[k] * v[k];
                            }
                            if (!is_right(small_rate_sign(x, y), exact)) {
                                std::printf(
                                    "wrong rate in %d bits: %a %a %a, %a %a %a\n",
                                    p, r[0], r[1], r[2], v[0], v[1], v[2]);
                                return false;
                            }
                        }
    std::printf("rate, %d products of %d bits: %ld inputs, left %.3f\n", n, p,
                inputs, (double)left / (double)inputs);
    return true;
}

int main()
{
    return !(is_the_library() && sphere_holds(4, 3) && sphere_holds(5, 3) &&
             sphere_holds(6, 2) && rate_holds(3, 3) && rate_holds(4, 3) &&
             rate_holds(5, 2) && rate_holds(6, 2));
}
