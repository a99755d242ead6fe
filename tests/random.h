// SPDX-License-Identifier: MIT
#ifndef TESTS_RANDOM_H
#define TESTS_RANDOM_H
/** Random numbers for tests: the same everywhere, from a seed that a failure
 * prints, or from bytes that a fuzzer chose. */
#include <math.h>
#include <stddef.h>
#include <stdint.h>

typedef struct stream {
    const unsigned char *bytes; // the next of those given,
    size_t left;                // and how many there are; then
    uint64_t state;             // SplitMix64
} stream;

static inline stream stream_of_seed(uint64_t seed)
{
    return (stream){.state = seed};
}

/** What is made of the same bytes is the same; where they end it goes on. */
static inline stream stream_of_bytes(const unsigned char *bytes, size_t count)
{
    return (stream){.bytes = bytes, .left = count};
}

/** 64 bits, of which the lowest 8 `count` are the next bytes, 1 to 8 of them, if
 * as many are left: a fuzzer that changes one byte is to change one thing. */
static inline uint64_t stream_word(stream *s, unsigned count)
{
    if (s->left >= count) {
        uint64_t word = 0;
        for (unsigned k = 0; k < count; k++)
            word |= (uint64_t)*s->bytes++ << 8 * k;
        s->left -= count;
        return word;
    }
    s->left = 0;
    uint64_t z = s->state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

static inline uint64_t stream_bits(stream *s)
{
    return stream_word(s, 8);
}

/** An integer from low to high, both included. */
static inline int stream_int(stream *s, int low, int high)
{
    const uint64_t kinds = high > low ? (uint64_t)((int64_t)high - low + 1) : 1;
    const unsigned bytes = kinds <= 1 << 8 ? 1 : kinds <= 1 << 16 ? 2 : 4;
    return low + (int)(stream_word(s, bytes) % kinds);
}

/** A double from low to high; all 53 bits random. */
static inline double stream_real(stream *s, double low, double high)
{
    return low + (high - low) * ((double)(stream_bits(s) >> 11) * 0x1p-53);
}

static inline double stream_sign(stream *s)
{
    return stream_word(s, 1) & 1 ? -1 : 1;
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
