// with: kernels/quadratic.c kernels/root.c kernels/dyadic.c
// SPDX-License-Identifier: MIT
// quadratic.c in 4, 5 and 6 bits, every input: the number of roots exact, roots within
// BRINK_QUADRATIC_ULP, and of the _cr tier every root that it is certain of correctly rounded.
//
// Every input but for powers of two: x 2^k, and all coefficients times one number of sign and
// power of two, change no digit.  So a is in [1, 2), |c| in [1, 4) or 0, and |b| from where b^2
// is nothing beside a c to where a c is nothing beside b^2, or 0.
#include "small_format.h"

extern "C" int brink_quadratic_roots(double, double, double, double *, double *);
extern "C" int brink_quadratic_roots_cr(double, double, double, double *,
                                        double *);

#define double Small
#define brink_quadratic_roots    small_roots
#define brink_quadratic_roots_cr small_roots_cr
#define BRINK_LANES_H
#include "exact.h"
BRINK_INLINE two_lanes lanes_fma(two_lanes x, two_lanes y, two_lanes z)
{
    return {fma(x[0], y[0], z[0]), fma(x[1], y[1], z[1])};
}
BRINK_INLINE int lanes_are_told(two_lanes x, two_lanes y, two_lanes *nearest)
{
    const two_lanes margin = {1 + 0x1p-20, 1 + 0x1p-20};
    two_lanes hi = x + y, again = lanes_fma(y - (hi - x), margin, hi);
    *nearest = hi;
    return (again[0] == hi[0]) & (again[1] == hi[1]);
}
extern "C" {
#include "quadratic.c"
}
#undef double
#undef brink_quadratic_roots
#undef brink_quadratic_roots_cr

/** lanes_are_told's 2^-20, 53 - 20 = 33 bits behind the last place, in p bits: a
 *  margin of 1/2 tells what is less than u / 4 of x, and with 6 bits s is not off by
 *  more.  (With fewer, what is to first order in u is not small, and it is not looked at.) */
static double constant(double c)
{
    if (c == 1 + 0x1p-20)
        return 1.5;
    static const double plain[] = {0, 0.5, -0.5, 1, 2, -1};
    for (double known : plain)
        if (c == known)
            return c;
    std::printf("what is %a in few places?\n", c);
    std::exit(2);
}

typedef int roots_of_small(Small, Small, Small, Small *, Small *);
typedef int roots_of_library(double, double, double, double *, double *);

/** The one count, and the same bits. */
static bool agree(roots_of_small *small, roots_of_library *library, double a,
                  double b, double c)
{
    Small s[2] = {7, 7};
    double d[2] = {7, 7};
    int n = small(Small::of(a), Small::of(b), Small::of(c), &s[0], &s[1]);
    if (n == library(a, b, c, &d[0], &d[1]) && std::memcmp(s, d, sizeof d) == 0)
        return true;
    std::printf("not what the library has: %a %a %a\n", a, b, c);
    return false;
}

static bool is_the_library()
{
    places = 53;
    for (int i = 0; i < 1000000; i++) {
        int exponents = i % 3 == 0 ? 2000 : i % 3 == 1 ? 4 : 60;
        double a = random_double(exponents), b = random_double(exponents);
        double c = i % 5 == 0 ? std::nextafter(b * b / (4 * a), 0)
                              : random_double(exponents);
        if (!agree(small_roots, brink_quadratic_roots, a, b, c) ||
            !agree(small_roots_cr, brink_quadratic_roots_cr, a, b, c))
            return false;
    }
    return true;
}

/** x in so few places; what is within 2^-40 of a midpoint is one, as a root that is none is
 *  farther from it: its polynomial has few bits. */
static double nearest(long double x)
{
    if (x == 0)
        return 0;
    int e;
    std::frexp(x, &e);
    long double unit = std::ldexp(1.0L, e - places - 1),
                twice = std::nearbyint(x / unit);
    if (std::fabs(x / unit - twice) > 0x1p-40L)
        return to_places(
            (double)(unit * (twice + (x / unit > twice ? 0.25L : -0.25L))));
    return to_places((double)(unit * twice));
}

static double ulps(long double exact, double x)
{
    int e;
    std::frexp(exact, &e);
    return exact == 0
               ? (x == 0 ? 0 : 1e9)
               : (double)(std::fabs(x - exact) / std::ldexp(1.0L, e - places));
}

static long inputs, told;
static double worst;

/** The roots in order, of an exact discriminant that is not negative. */
static void true_roots(double a, double b, double c, long double d,
                       long double root[2])
{
    long double s = -(b + std::copysign(std::sqrt(d), (long double)b)) / 2;
    long double x = s / a, y = s == 0 ? 0 : c / s;
    root[0] = std::fmin(x, y);
    root[1] = std::fmax(x, y);
}

static bool is_right(double a, double b, double c)
{
    // Exact in 64 bits: 6 places + 14 hold the bits of both.
    long double d = (long double)b * b - 4.0L * a * c, root[2];
    Small x[2] = {0, 0}, y[2] = {0, 0};
    int count =
        small_roots(Small::of(a), Small::of(b), Small::of(c), &x[0], &x[1]);
    int count_cr =
        small_roots_cr(Small::of(a), Small::of(b), Small::of(c), &y[0], &y[1]);
    inputs++;
    if (count != count_cr || count != (d < 0 ? 0 : 2))
        return false;
    if (count == 0)
        return true;
    true_roots(a, b, c, d, root);
    worst =
        std::fmax(worst, std::fmax(ulps(root[0], x[0].x), ulps(root[1], x[1].x)));
    // Exact numbers round to 53 bits, here as there: what has more than `places` came from them.
    bool is_told = to_places(y[0].x) == y[0].x && to_places(y[1].x) == y[1].x;
    told += is_told;
    return worst <= BRINK_QUADRATIC_ULP &&
           (places < 6 || !is_told ||
            (y[0].x == nearest(root[0]) && y[1].x == nearest(root[1])));
}

static bool holds_of_every_input(int p)
{
    places = p;
    inputs = told = 0;
    worst = 0;
    int ones = 1 << (p - 1), far = p + 3;
    for (int i = ones; i < 2 * ones; i++)
        for (int k = -4 * ones; k <= 4 * ones; k++) {
            if (std::abs(k) >= 2 * ones ? k % 2 != 0
                                        : std::abs(k) < ones && k != 0)
                continue;
            for (int j = -1; j < (far + p + 5) * ones; j++) {
                double a = (double)i / ones, c = (double)k / ones;
                double b = j < 0 ? 0
                                 : std::ldexp((double)(ones + j % ones) / ones,
                                              j / ones - far);
                if (!is_right(a, b, c) || !is_right(a, -b, c)) {
                    std::printf("wrong in %d bits: %a %a %a\n", p, a, b, c);
                    return false;
                }
            }
        }
    std::printf("%d bits: %ld inputs, worst root %.3f ulp, told %.3f of them\n",
                p, inputs, worst, (double)told / (double)inputs);
    return true;
}

int main()
{
    if (!is_the_library())
        return 1;
    for (int p = 4; p <= 6; p++)
        if (!holds_of_every_input(p))
            return 1;
    return 0;
}
