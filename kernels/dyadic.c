// SPDX-License-Identifier: MIT
// By the school's methods.  Reached only where filters and double-double could
// not decide, so plainness goes before speed; the cost is that of the limbs in
// use.
#include "dyadic.h"

uint64_t brink_dyadic_bits(const brink_dyadic *a, int from, int count)
{
    uint64_t bits = 0;
    /*@ loop invariant -1 <= i < count;
      @ loop assigns i, bits;
      @ loop variant i; */
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
    /*@ loop invariant 0 <= i <= a->count;
      @ loop assigns i;
      @ loop variant a->count - i; */
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
    const uint32_t top = a->limb[a->count - 1];
    int bits = 0;
    /*@ loop invariant 0 <= bits <= 32;
      @ loop assigns bits;
      @ loop variant 32 - bits; */
    while (bits < 32 && top >> bits)
        bits++;
    return 32 * (a->low + a->count - 1) + bits;
}

static uint32_t limb_at(const brink_dyadic *a, int place)
{
    int i = place - a->low;
    return i >= 0 && i < a->count ? a->limb[i] : 0;
}

/** Drops zero limbs at the top; a number without limbs is 0. */
static void normalise(brink_dyadic *z)
{
    /*@ loop invariant 0 <= z->count <= \at(z->count, Pre);
      @ loop invariant \forall integer k;
      @     z->count <= k < \at(z->count, Pre) ==> z->limb[k] == 0;
      @ loop assigns z->count;
      @ loop variant z->count; */
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
    int64_t m = (int64_t)(bits_of(x) % (UINT64_C(1) << 52));
    if (biased == 0)
        biased = 1; // subnormals have the exponent of the least normal number
    else
        m += INT64_C(1) << 52;
    brink_dyadic_integer(z, signbit(x) ? -m : m, biased - 1075);
}

/** |a| - |b| as -1, 0, 1. */
static int compare_magnitudes(const brink_dyadic *a, const brink_dyadic *b)
{
    int low = a->low < b->low ? a->low : b->low;
    int top_a = a->low + a->count, top_b = b->low + b->count;
    /*@ loop invariant low - 1 <= place < (top_a > top_b ? top_a : top_b);
      @ loop assigns place;
      @ loop variant place - low + 1; */
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
    /*@ loop invariant low <= place <= top && -1 <= carry <= 1;
      @ loop assigns place, carry, z->limb[0 .. top - low - 1];
      @ loop variant top - place; */
    for (int place = low; place < top; place++) {
        int64_t sum =
            carry + limb_at(a, place) + way * (int64_t)limb_at(b, place);
        z->limb[place - low] = (uint32_t)((uint64_t)sum & UINT32_MAX);
        carry = sum < 0 ? -1 : sum / (INT64_C(1) << 32);
    }
    normalise(z);
}

/** z = sign |a|. */
static void copy(brink_dyadic *z, int sign, const brink_dyadic *a)
{
    z->sign = sign;
    z->low = a->low;
    z->count = a->count;
    /*@ loop invariant 0 <= i <= a->count;
      @ loop invariant \forall integer k; 0 <= k < i ==>
      @     z->limb[k] == a->limb[k];
      @ loop assigns i, z->limb[0 .. a->count - 1];
      @ loop variant a->count - i; */
    for (int i = 0; i < a->count; i++)
        // NOLINTNEXTLINE(clang-analyzer-core.*): those in use have been written
        z->limb[i] = a->limb[i];
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
    /*@ loop invariant 0 <= i <= z->count;
      @ loop invariant \forall integer k; 0 <= k < i ==> z->limb[k] == 0;
      @ loop assigns i, z->limb[0 .. z->count - 1];
      @ loop variant z->count - i; */
    for (int i = 0; i < z->count; i++)
        z->limb[i] = 0;
    /*@ loop invariant 0 <= i <= a->count;
      @ loop assigns i, z->limb[0 .. z->count - 1];
      @ loop variant a->count - i; */
    for (int i = 0; i < a->count; i++) {
        uint64_t carry = 0;
        // (2^32 - 1)^2 + 2 (2^32 - 1) = 2^64 - 1: fits.
        /*@ loop invariant 0 <= j <= b->count && carry <= UINT32_MAX;
          @ loop assigns j, carry, z->limb[i .. i + b->count - 1];
          @ loop variant b->count - j; */
        for (int j = 0; j < b->count; j++) {
            carry += (uint64_t)a->limb[i] * b->limb[j] + z->limb[i + j];
            z->limb[i + j] = (uint32_t)carry;
            carry >>= 32;
        }
        z->limb[i + b->count] = (uint32_t)carry;
    }
    normalise(z);
}

/** z = x y, of doubles. */
static void product_of(brink_dyadic *z, double x, double y)
{
    brink_dyadic a, b;
    brink_dyadic_double(&a, x);
    brink_dyadic_double(&b, y);
    brink_dyadic_mul(z, &a, &b);
}

/** z = z + x y. */
static void add_product(brink_dyadic *z, double x, double y)
{
    brink_dyadic product, sum;
    product_of(&product, x, y);
    //@ assert \at(is_normal(z), Pre) ==> is_normal(z);
    brink_dyadic_add(&sum, z, &product);
    copy(z, sum.sign, &sum);
}

void brink_dyadic_dot(brink_dyadic *z, int n, const double *x, const double *y)
{
    brink_dyadic_integer(z, 0, 0);
    /*@ loop invariant 0 <= i <= n && is_dyadic(z) && is_normal(z);
      @ loop invariant -68 <= z->low && z->low + z->count <= 66 + i;
      @ loop assigns i, *z;
      @ loop variant n - i; */
    for (int i = 0; i < n; i++)
        add_product(z, x[i], y[i]);
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
