// SPDX-License-Identifier: MIT
#ifndef SMALL_FORMAT_H
#define SMALL_FORMAT_H
// The kernels' own sources, in numbers of `places` bits.  A file of kernels/ that
// is included after `#define double Small` is what the library is made from,
// but for what stands in its place and is trusted: this class, two lanes written
// as two numbers, and constant(), the constants that go with precision.  In 53
// bits all must answer what the library does, bit for bit: each program
// shows that first, on a million random inputs.
//
// Exponents are those of double: nothing over- or underflows.  A sum, product,
// quotient or root of numbers of p bits, 2 p + 2 <= 53, rounded to double and
// then to p bits is rounded as if once (Figueroa); fma goes by way of odd.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <float.h>
#include <immintrin.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#undef isfinite
#undef signbit
#undef __SSE2__ // the portable choices of exact.h
#undef __AVX__
#undef __FMA__

static int places = 53;

static uint64_t bits_in(double x)
{
    uint64_t b;
    std::memcpy(&b, &x, sizeof b);
    return b;
}

static double of_bits(uint64_t b)
{
    double x;
    std::memcpy(&x, &b, sizeof x);
    return x;
}

static double to_places(double x)
{
    int last = 53 - places;
    if (last == 0 || !std::isfinite(x))
        return x;
    uint64_t b = bits_in(x), half = UINT64_C(1) << (last - 1);
    b += half - 1 + (b >> last & 1);
    return of_bits(b & ~(2 * half - 1));
}

/** x y + z, rounded once.  x y is exact if 2 places <= 53. */
static double fused(double x, double y, double z)
{
    if (places == 53)
        return std::fma(x, y, z);
    double p = x * y, s = p + z, t = s - p, lost = (p - (s - t)) + (z - t);
    if (lost != 0 && std::isfinite(s) && (bits_in(s) & 1) == 0)
        s = of_bits(bits_in(s) + ((lost > 0) == (s > 0) ? 1 : -1));
    return to_places(s);
}

/** A constant of the source in so few places: the including program's. */
static double constant(double in_source);

class Small
{
  public:
    double x;
    Small() = default;
    Small(double c) : x(places == 53 ? c : constant(c))
    {
    }
    static Small of(double rounded)
    {
        Small s;
        s.x = rounded;
        return s;
    }
    friend Small operator+(Small a, Small b)
    {
        return of(to_places(a.x + b.x));
    }
    friend Small operator-(Small a, Small b)
    {
        return of(to_places(a.x - b.x));
    }
    friend Small operator*(Small a, Small b)
    {
        return of(to_places(a.x * b.x));
    }
    friend Small operator/(Small a, Small b)
    {
        return of(to_places(a.x / b.x));
    }
    Small operator-() const
    {
        return of(-x);
    }
    Small &operator+=(Small b)
    {
        return *this = *this + b;
    }
    Small &operator-=(Small b)
    {
        return *this = *this - b;
    }
    Small &operator*=(Small b)
    {
        return *this = *this * b;
    }
    friend bool operator<(Small a, Small b)
    {
        return a.x < b.x;
    }
    friend bool operator>(Small a, Small b)
    {
        return a.x > b.x;
    }
    friend bool operator<=(Small a, Small b)
    {
        return a.x <= b.x;
    }
    friend bool operator>=(Small a, Small b)
    {
        return a.x >= b.x;
    }
    friend bool operator==(Small a, Small b)
    {
        return a.x == b.x;
    }
    friend bool operator!=(Small a, Small b)
    {
        return a.x != b.x;
    }
};

static inline Small sqrt(Small a)
{
    return Small::of(to_places(std::sqrt(a.x)));
}
static inline Small fabs(Small a)
{
    return Small::of(std::fabs(a.x));
}
static inline Small fma(Small a, Small b, Small c)
{
    return Small::of(fused(a.x, b.x, c.x));
}
static inline Small fmin(Small a, Small b)
{
    return Small::of(std::fmin(a.x, b.x));
}
static inline Small copysign(Small a, Small b)
{
    return Small::of(std::copysign(a.x, b.x));
}
static inline Small ldexp(Small a, int e)
{
    return Small::of(std::ldexp(a.x, e));
}
static inline bool isfinite(Small a)
{
    return std::isfinite(a.x);
}
static inline bool signbit(Small a)
{
    return std::signbit(a.x);
}

/** Stands for the vector of lanes.h. */
struct two_lanes {
    Small lane[2];
    Small operator[](int i) const
    {
        return lane[i];
    }
    Small &operator[](int i)
    {
        return lane[i];
    }
    two_lanes operator-() const
    {
        return {-lane[0], -lane[1]};
    }
    friend two_lanes operator+(two_lanes a, two_lanes b)
    {
        return {a[0] + b[0], a[1] + b[1]};
    }
    friend two_lanes operator-(two_lanes a, two_lanes b)
    {
        return {a[0] - b[0], a[1] - b[1]};
    }
    friend two_lanes operator*(two_lanes a, two_lanes b)
    {
        return {a[0] * b[0], a[1] * b[1]};
    }
    friend two_lanes operator/(two_lanes a, two_lanes b)
    {
        return {a[0] / b[0], a[1] / b[1]};
    }
};

// For the comparison with the library.
static uint64_t next_random()
{
    static uint64_t state = 20260601; // splitmix64
    uint64_t z = state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

static double random_double(int exponents)
{
    uint64_t z = next_random();
    int e = (int)((z >> 52 & 0x7ff) % (unsigned)exponents) - exponents / 2;
    return std::ldexp(
        of_bits((z & ~(UINT64_C(0x7ff) << 52)) | UINT64_C(0x3ff) << 52), e);
}
#endif
