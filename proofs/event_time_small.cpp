// with: kernels/event_time.c kernels/event_time_slow.c kernels/root.c kernels/dyadic.c
// SPDX-License-Identifier: MIT
// event_time.c in few bits, every input: of what its fast paths answer, whether there is an event
// and whether now is exact, and the time within BRINK_EVENT_TIME_ULP.  What they leave to the exact
// path is counted.
//
// Every input but for powers of two: all lengths times 2^k and all velocities times 2^l change no
// digit, nor does a mirror.  So sigma and v_x are within [1, 2), r_x and r_y not negative.
#include "small_format.h"
#include <vector>

extern "C" double brink_intersection_time(const double[3], const double[3],
                                          double);
extern "C" double brink_disjoint_time(const double[3], const double[3], double);

#define double Small
#define brink_intersection_time      small_intersection
#define brink_intersection_time_cr   small_intersection_cr
#define brink_intersection_time_slow small_intersection_slow
#define brink_disjoint_time          small_disjoint
#define brink_disjoint_time_cr       small_disjoint_cr
#define brink_disjoint_time_slow     small_disjoint_slow
#define BRINK_EVENT_TIME_LANES_H
#include "event_time_sums.h"
BRINK_INLINE sums sums_in_lanes(const double r[3], const double v[3],
                                double sigma)
{
    return sums_of(r, v, sigma);
}
BRINK_INLINE two_dots dots_in_lanes(const double r[3], const double v[3])
{
    return (two_dots){dot_of(r, v), dot_of(r, r)};
}
#include "event_time.c"
#undef double
#undef brink_intersection_time
#undef brink_disjoint_time

// The exact times: none is given here.
static const double no_time = -7;
Small small_intersection_slow(const Small *, const Small *, Small)
{
    return Small::of(no_time);
}
Small small_disjoint_slow(const Small *, const Small *, Small)
{
    return Small::of(no_time);
}

static double u;

static void in_places(int p)
{
    places = p;
    u = std::ldexp(1, -p);
}

/**
 * What the derivations beside the constants give for so large a u.
 *
 * Far is what has rr > 2 ss, as c is off by 8u of itself then: 6u for rr < 2 c, u for ss < c, and
 * u.  A pair passes by where the ratio of a c and b^2 is off by less than 24u: 8u are c's, 3u a's, 3u
 * those of the roundings, 6u sqrt(2) b's, as P^2 <= 2 a c.  Its time is known where 8u^2 P is no more
 * than u of b.  Where d is certain it has to be known to some u: here it is where that is seen.
 */
static inline double constant(double c)
{
    if (c == 1 + 0x1p-10)
        return 2;
    if (c == 4 - 0x1p-36)
        return 4 - 96 * u;
    if (c == 0x1p-100) // 9u^2 of b^2, for b off by 3u P
        return 64 * u * u;
    if (c == 0x1p-200) // 49u^4, for 7u^2 P
        return 4096 * u * u * u * u;
    if (c == 0x1p-90) // 150u^2
        return 256 * u * u;
    if (c == 0x1p-44)
        return 0.125;
    if (c == 0x1p-80)
        return 128 * u * u;
    if (c == 0x1.8p-104)
        return 6 * u * u;
    if (c == 0x1.cp-104)
        return 7 * u * u;
    if (c == 0x1p-150 || c == 0x1p-140) // 200u^3
        return 256 * u * u * u;
    if (c == 0x1.68p51) // 2^53 / 2.85; a little more, to have few bits
        return 0.375 / u;
    if (c == 0x1p55)
        return 4 / u;
    static const double plain[] = {0,  0.5, 0.75,     1,        2,
                                   -2, -1,  0x1p-900, 0x1p-450, 0x1p450};
    for (double known : plain)
        if (c == known)
            return c;
    if (std::isinf(c))
        return c;
    std::printf("what is %a in few places?\n", c);
    std::exit(2);
}

// --- What is right -------------------------------------------------------------

typedef long double
    wide; // of 64 bits: what is made of the numbers below is exact

struct pair_of_balls {
    double r[3], v[3], sigma;
};

/** The times, +inf for none. */
struct times {
    wide meeting, parting;
};

static wide dot(const double x[3], const double y[3])
{
    return (wide)x[0] * y[0] + (wide)x[1] * y[1] + (wide)x[2] * y[2];
}

static times true_times(const pair_of_balls &x)
{
    const wide never = INFINITY;
    wide a = dot(x.v, x.v), b = dot(x.r, x.v);
    wide c = dot(x.r, x.r) - (wide)x.sigma * x.sigma, d = b * b - a * c;
    wide root = std::sqrt(std::fabs(d));
    return {b >= 0   ? never
            : c <= 0 ? 0
            : d <= 0 ? never
                     : c / (root - b),
            b >= 0 && c >= 0 ? 0
            : d <= 0         ? -b / a
            : b > 0          ? -c / (root + b)
                             : (root - b) / a};
}

static double ulps(wide exact, double t)
{
    int e;
    std::frexp(exact, &e);
    return (double)(std::fabs(t - exact) / std::ldexp(1.0L, e - places));
}

/** What became of the inputs of a kernel. */
struct tally {
    const char *name;
    double within;                              // so many ulp
    long inputs, answered, late, late_answered; // late: neither 0 nor +inf
    double worst;
};
static tally meetings = {"meetings", 3.1}, partings = {"partings", 4.2};
static_assert(4.2 <= BRINK_EVENT_TIME_ULP);

static bool is_right(tally &all, wide exact, double t)
{
    bool is_late = exact > 0 && exact < (wide)INFINITY;
    all.inputs++;
    all.late += is_late;
    if (t == no_time)
        return true;
    all.answered++;
    if (!is_late)
        return t == exact;
    all.late_answered++;
    if (!(t > 0 && t < INFINITY))
        return false;
    all.worst = std::fmax(all.worst, ulps(exact, t));
    return all.worst <= all.within;
}

static bool holds(const pair_of_balls &x)
{
    Small r[3], v[3];
    for (int k = 0; k < 3; k++) {
        r[k] = Small::of(x.r[k]);
        v[k] = Small::of(x.v[k]);
    }
    Small sigma = Small::of(x.sigma);
    times exact = true_times(x);
    if (is_right(meetings, exact.meeting, small_intersection(r, v, sigma).x) &&
        is_right(partings, exact.parting, small_disjoint(r, v, sigma).x))
        return true;
    std::printf("wrong in %d bits: r %a %a %a v %a %a %a sigma %a\n", places,
                x.r[0], x.r[1], x.r[2], x.v[0], x.v[1], x.v[2], x.sigma);
    return false;
}

// --- Every input ---------------------------------------------------------------

typedef std::vector<double> numbers;

/** 0 and those in [2^lowest, 2^highest). */
static numbers from_0(int lowest, int highest)
{
    numbers all = {0};
    for (int e = lowest; e < highest; e++)
        for (int i = 1 << (places - 1); i < 1 << places; i++)
            all.push_back(std::ldexp(i, e + 1 - places));
    return all;
}

static numbers without_0(numbers x)
{
    x.erase(x.begin());
    return x;
}

static numbers of_both_signs(numbers x)
{
    for (size_t i = x.size(); i-- > 0;)
        if (x[i] != 0)
            x.push_back(-x[i]);
    return x;
}

/** v_x, which is not 0. */
static numbers ahead()
{
    return of_both_signs(without_0(from_0(0, 1)));
}

static bool hold(const char *what, const numbers (&r)[3], const numbers (&v)[3])
{
    for (tally *t : {&meetings, &partings})
        *t = {t->name, t->within};
    for (double sigma : without_0(from_0(0, 1)))
        for (double x : r[0])
            for (double y : r[1])
                for (double z : r[2])
                    for (double v0 : v[0])
                        for (double v1 : v[1])
                            for (double v2 : v[2])
                                if (!holds({{x, y, z}, {v0, v1, v2}, sigma}))
                                    return false;
    for (tally *t : {&meetings, &partings})
        std::printf("%d bits, %s, %s: %ld inputs, answered %.3f; of %ld with a "
                    "time %.3f, worst %.2f ulp\n",
                    places, what, t->name, t->inputs,
                    (double)t->answered / (double)t->inputs, t->late,
                    (double)t->late_answered / (double)t->late, t->worst);
    return true;
}

static const numbers zero = {0};

static bool holds_in_few_bits()
{
    in_places(3);
    numbers v = of_both_signs(from_0(0, 1)), r = from_0(0, 2);
    if (!hold("in space", {r, r, r}, {ahead(), v, v}))
        return false;
    in_places(4);
    r = from_0(-1, 3), v = of_both_signs(from_0(-1, 2));
    if (!hold("in the plane", {r, r, zero}, {ahead(), v, zero}))
        return false;
    in_places(5);
    r = from_0(0, 2), v = of_both_signs(from_0(0, 1));
    if (!hold("in the plane", {r, r, zero}, {ahead(), v, zero}))
        return false;
    in_places(6);
    r = from_0(0, 2), v = from_0(-1, 1);
    return hold("v along an axis", {r, r, zero}, {ahead(), zero, zero}) &&
           hold("r along an axis", {from_0(-1, 2), zero, zero},
                {ahead(), v, zero});
}

// --- In 53 bits ----------------------------------------------------------------

static bool agree(Small small, double library, const pair_of_balls &x)
{
    if (small.x == no_time || bits_in(small.x) == bits_in(library))
        return true;
    std::printf("not what the library has: r %a %a %a v %a %a %a sigma %a\n",
                x.r[0], x.r[1], x.r[2], x.v[0], x.v[1], x.v[2], x.sigma);
    return false;
}

/** r of any length beside sigma, or within a few ulp of the surface. */
static bool is_the_library()
{
    places = 53;
    for (int i = 0; i < 1000000; i++) {
        int exponents = i % 2 == 0 ? 3 : 40;
        pair_of_balls x;
        Small r[3], v[3];
        for (int k = 0; k < 3; k++) {
            r[k] = Small::of(x.r[k] = random_double(exponents));
            v[k] = Small::of(x.v[k] = random_double(exponents));
        }
        x.sigma = i % 3 == 0 ? std::sqrt((double)dot(x.r, x.r))
                             : std::fabs(random_double(exponents));
        Small sigma = Small::of(x.sigma);
        if (!agree(small_intersection(r, v, sigma),
                   brink_intersection_time(x.r, x.v, x.sigma), x) ||
            !agree(small_disjoint(r, v, sigma),
                   brink_disjoint_time(x.r, x.v, x.sigma), x))
            return false;
    }
    return true;
}

int main()
{
    return !(is_the_library() && holds_in_few_bits());
}
