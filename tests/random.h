// SPDX-License-Identifier: MIT
#ifndef TESTS_RANDOM_H
#define TESTS_RANDOM_H
/** Random numbers for tests: the same everywhere, from a seed that a failure
 * prints. */
#include <math.h>
#include <stdint.h>

typedef struct stream { // SplitMix64
    uint64_t state;
} stream;

static inline uint64_t stream_bits(stream *s)
{
    uint64_t z = s->state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

/** An integer from low to high, both included. */
static inline int stream_int(stream *s, int low, int high)
{
    return low + (int)(stream_bits(s) % (uint64_t)(high - low + 1));
}

/** A double from low to high; all 53 bits random. */
static inline double stream_real(stream *s, double low, double high)
{
    return low + (high - low) * ((double)(stream_bits(s) >> 11) * 0x1p-53);
}

static inline double stream_sign(stream *s)
{
    return stream_bits(s) & 1 ? -1 : 1;
}

/** A double of either sign, its magnitude spread evenly over 2^low to 2^high on a
 * log scale; subnormal and infinite where that leads. */
static inline double stream_scaled(stream *s, int low, int high)
{
    double m = stream_real(s, 1, 2);
    return stream_sign(s) * ldexp(m, stream_int(s, low, high - 1));
}

/** x moved by up to n ulp either way. */
static inline double stream_near(stream *s, double x, int n)
{
    int ulps = stream_int(s, -n, n);
    for (int i = 0; i < ulps; i++)
        x = nextafter(x, (double)INFINITY);
    for (int i = 0; i > ulps; i--)
        x = nextafter(x, -(double)INFINITY);
    return x;
}

/** Standard normal, by Marsaglia's polar method. */
static inline double stream_normal(stream *s)
{
    for (;;) {
        double x = stream_real(s, -1, 1), y = stream_real(s, -1, 1),
               q = x * x + y * y;
        if (q > 0 && q < 1)
            return x * sqrt(-2 * log(q) / q);
    }
}
#endif
