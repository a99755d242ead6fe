// SPDX-License-Identifier: MIT
// By the school's methods.  Reached only where filters and double-double could
// not decide, so plainness goes before speed; the cost is that of the limbs in
// use.
#include "dyadic.h"

uint64_t brink_dyadic_bits(const brink_dyadic *a, int from, int count)
{
    uint64_t bits = 0;
    for (int i = count - 1; i >= 0; i--) {
        int place = from + i - 32 * a->low; // counted from limb[0]
        uint64_t bit = 0;
        if (place >= 0 && place < 32 * a->count)
            bit = a->limb[place / 32] >> place % 32 & 1;
        bits = bits << 1 | bit;
    }
    return bits;
}

/** Whether |a| has any bit below place `end`. */
static int any_below(const brink_dyadic *a, int end)
{
    int places = end - 32 * a->low; // counted from limb[0]
    for (int i = 0; i < a->count && 32 * i < places; i++) {
        int rest = places - 32 * i;
        uint32_t mask = rest < 32 ? ((uint32_t)1 << rest) - 1 : UINT32_MAX;
        if (a->limb[i] & mask)
            return 1;
    }
    return 0;
}

int brink_dyadic_magnitude(const brink_dyadic *a)
{
    int p = 32 * (a->low + a->count - 1);
    for (uint32_t top = a->limb[a->count - 1]; top; top >>= 1)
        p++;
    return p;
}

static uint32_t limb_at(const brink_dyadic *a, int place)
{
    int i = place - a->low;
    return i >= 0 && i < a->count ? a->limb[i] : 0;
}

/** Drops zero limbs at the top; a number without limbs is 0. */
static void normalise(brink_dyadic *z)
{
    while (z->count > 0 && z->limb[z->count - 1] == 0)
        z->count--;
    if (z->count == 0)
        z->sign = 0;
}

void brink_dyadic_integer(brink_dyadic *z, int64_t m, int e)
{
    uint64_t rest = m < 0 ? -(uint64_t)m : (uint64_t)m;
    int shift = (e % 32 + 32) % 32;
    z->sign = m < 0 ? -1 : 1;
    z->low = (e - shift) / 32;
    z->count = 3; // 64 bits shifted by up to 31
    uint64_t low = (rest & UINT32_MAX) << shift;
    uint64_t high = (rest >> 32 << shift) + (low >> 32);
    z->limb[0] = (uint32_t)low;
    z->limb[1] = (uint32_t)high;
    z->limb[2] = (uint32_t)(high >> 32);
    normalise(z);
}

void brink_dyadic_double(brink_dyadic *z, double x)
{
    int biased = biased_exponent(x);
    int64_t m = (int64_t)(bits_of(x) & UINT64_C(0xfffffffffffff));
    if (biased == 0)
        biased = 1; // subnormals have the exponent of the least normal number
    else
        m |= INT64_C(1) << 52;
    brink_dyadic_integer(z, signbit(x) ? -m : m, biased - 1075);
}

/** |a| - |b| as -1, 0, 1. */
static int compare_magnitudes(const brink_dyadic *a, const brink_dyadic *b)
{
    int low = a->low < b->low ? a->low : b->low;
    int top_a = a->low + a->count, top_b = b->low + b->count;
    for (int place = (top_a > top_b ? top_a : top_b) - 1; place >= low; place--) {
        uint32_t x = limb_at(a, place), y = limb_at(b, place);
        if (x != y)
            return x < y ? -1 : 1;
    }
    return 0;
}

/** z = sign (|a| + way |b|), way +1, or -1 where |a| >= |b|; neither is 0. */
static void combine(brink_dyadic *z, int sign, const brink_dyadic *a,
                    const brink_dyadic *b, int way)
{
    int low = a->low < b->low ? a->low : b->low;
    int top_a = a->low + a->count, top_b = b->low + b->count;
    int top = (top_a > top_b ? top_a : top_b) + 1;
    int64_t carry = 0;
    z->sign = sign;
    z->low = low;
    z->count = top - low;
    for (int place = low; place < top; place++) {
        int64_t sum =
            carry + limb_at(a, place) + way * (int64_t)limb_at(b, place);
        z->limb[place - low] = (uint32_t)((uint64_t)sum & UINT32_MAX);
        carry = sum < 0 ? -1 : sum >> 32;
    }
    normalise(z);
}

/** z = sign |a|. */
static void copy(brink_dyadic *z, int sign, const brink_dyadic *a)
{
    z->sign = sign;
    z->low = a->low;
    z->count = a->count;
    memcpy(z->limb, a->limb, (size_t)a->count * sizeof *a->limb);
}

/** z = a + sign b. */
static void add_signed(brink_dyadic *z, const brink_dyadic *a,
                       const brink_dyadic *b, int sign)
{
    sign *= b->sign;
    if (sign == 0)
        copy(z, a->sign, a);
    else if (a->sign == 0)
        copy(z, sign, b);
    else if (a->sign == sign)
        combine(z, sign, a, b, 1);
    else if (compare_magnitudes(a, b) >= 0)
        combine(z, a->sign, a, b, -1);
    else
        combine(z, sign, b, a, -1);
}

void brink_dyadic_add(brink_dyadic *z, const brink_dyadic *a,
                      const brink_dyadic *b)
{
    add_signed(z, a, b, 1);
}

void brink_dyadic_sub(brink_dyadic *z, const brink_dyadic *a,
                      const brink_dyadic *b)
{
    add_signed(z, a, b, -1);
}

void brink_dyadic_mul(brink_dyadic *z, const brink_dyadic *a,
                      const brink_dyadic *b)
{
    z->sign = a->sign * b->sign;
    z->low = a->low + b->low;
    z->count = a->count + b->count;
    memset(z->limb, 0, (size_t)z->count * sizeof *z->limb);
    for (int i = 0; i < a->count; i++) {
        uint64_t carry = 0;
        for (int j = 0; j < b->count;
             j++) { // (2^32-1)^2 + 2 (2^32-1) = 2^64 - 1: fits
            carry += (uint64_t)a->limb[i] * b->limb[j] + z->limb[i + j];
            z->limb[i + j] = (uint32_t)carry;
            carry >>= 32;
        }
        z->limb[i + b->count] = (uint32_t)carry;
    }
    normalise(z);
}

void brink_dyadic_dot(brink_dyadic *z, int n, const double *x, const double *y)
{
    brink_dyadic sum, a, b, product;
    brink_dyadic_integer(z, 0, 0);
    for (int i = 0; i < n; i++) {
        brink_dyadic_double(&a, x[i]);
        brink_dyadic_double(&b, y[i]);
        brink_dyadic_mul(&product, &a, &b);
        brink_dyadic_add(&sum, z, &product);
        copy(z, sum.sign, &sum);
    }
}

double brink_dyadic_round(const brink_dyadic *a)
{
    if (a->sign == 0)
        return 0;
    int last =
        brink_dyadic_magnitude(a) - 53; // place of the last bit that is kept
    if (last < -1074)
        last = -1074;
    uint64_t m = brink_dyadic_bits(a, last, 53);
    m += brink_dyadic_bits(a, last - 1, 1) &
         (m | (uint64_t)any_below(a, last - 1));
    return a->sign * ldexp((double)m, last);
}

dd brink_dyadic_leading(const brink_dyadic *a, int *e)
{
    *e = 0;
    if (a->sign == 0)
        return (dd){0, 0};
    int p = brink_dyadic_magnitude(a);
    double hi = (double)brink_dyadic_bits(a, p - 53, 53) * 0x1p-53;
    double lo = (double)brink_dyadic_bits(a, p - 106, 53) * 0x1p-106;
    *e = p;
    return fast_two_sum(a->sign * hi,
                        a->sign * lo); // cut off below: < 2^-106 of [1/2, 1]
}
