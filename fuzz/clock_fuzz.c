// SPDX-License-Identifier: MIT
// Instants against exact arithmetic: an instant is epoch * year + offset, and
// what is made of two is that, rounded where the header says so.
#include "clock.h"
#include "fuzz.h"
#include <mpfr.h>

enum {
    BITS = 2300 // from 2^62 years of 2^100 down to the last subnormal: exact
};

static void tell(double year, brink_instant t, double dt)
{
    fprintf(stderr,
            "  const double year = %a, dt = %a;\n"
            "  const brink_instant t = {%lld, %a};\n",
            year, dt, (long long)t.epoch, t.offset);
    finding_end();
}

static void exactly(mpfr_t x, double year, brink_instant t)
{
    mpfr_set_sj(x, t.epoch, MPFR_RNDN);
    mpfr_mul_d(x, x, year, MPFR_RNDN);
    mpfr_add_d(x, x, t.offset, MPFR_RNDN);
}

static int is_never(brink_instant t)
{
    return t.epoch == INT64_MAX;
}

/** Small whole numbers of years, and offsets at their ends, where it matters. */
static brink_instant make_instant(stream *s, double year)
{
    const int family = stream_int(s, 0, 7);
    brink_instant t = {stream_int(s, 0, 3), 0};
    if (family == 0)
        return BRINK_NEVER;
    if (family >= 5) // up to 2^61, which is as far as sums are made
        t.epoch += (int64_t)1 << stream_int(s, 0, 61);
    switch (stream_int(s, 0, 3)) {
    case 0:
        t.offset = ldexp(year, -stream_int(s, 1, 60));
        break;
    case 1:
        t.offset = year - ldexp(year, -stream_int(s, 1, 53));
        break;
    case 2:
        t.offset = stream_real(s, 0, 1) * year;
        break;
    default:
        break;
    }
    return t;
}

static double make_span(stream *s, double year)
{
    switch (stream_int(s, 0, 6)) {
    case 0:
        return 0;
    case 1:
        return (double)INFINITY;
    case 2: // what is missing to the end of the year, or a little more or less
        return fabs(stream_near(s, year * stream_int(s, 0, 5) / 4, 3));
    case 3:
        return fabs(stream_scaled(s, -1074, 1023));
    case 4:
        return fabs(stream_near(s, ldexp(year, stream_int(s, 50, 63)), 2));
    default:
        return fabs(stream_scaled(s, -60, 60)) * year;
    }
}

/** t + dt is the sum of offset and dt, rounded once, in whole years and a rest;
 *  never beyond 2^62 years. */
static void sum_is_rounded_once(double year, brink_instant t, double dt)
{
    const brink_instant u = brink_instant_after(year, t, dt);
    const double sum = t.offset + dt;
    if (is_never(u)) {
        // Refused from 2^61 years on, of either: 2^62 of their sum is beyond.
        const int far = t.epoch > INT64_C(1) << 61 || !(sum / year < 0x1p61);
        if (!is_never(t) && !far) {
            FINDING("clock: a sum is never");
            tell(year, t, dt);
        }
        return;
    }
    mpfr_t x, y;
    mpfr_inits2(BITS, x, y, (mpfr_ptr)0);
    exactly(x, year, u);
    exactly(y, year, (brink_instant){t.epoch, 0});
    mpfr_add_d(y, y, sum, MPFR_RNDN);
    const int same = mpfr_equal_p(x, y);
    mpfr_clears(x, y, (mpfr_ptr)0);
    if (is_never(t) || isinf(dt) || !same || !(u.offset >= 0) ||
        !(u.offset < year)) {
        FINDING("clock: t + dt is {%lld, %a}", (long long)u.epoch, u.offset);
        tell(year, t, dt);
    }
}

static void order_is_that_of_times(double year, brink_instant t, brink_instant u)
{
    mpfr_t x, y;
    mpfr_inits2(BITS, x, y, (mpfr_ptr)0);
    exactly(x, year, t);
    exactly(y, year, u);
    const int right = mpfr_cmp(x, y), got = brink_instant_compare(t, u);
    mpfr_clears(x, y, (mpfr_ptr)0);
    if ((right > 0) - (right < 0) != got || got != -brink_instant_compare(u, t)) {
        FINDING("clock: t against {%lld, %a}: %d", (long long)u.epoch, u.offset,
                got);
        tell(year, t, 0);
    }
}

/* A difference of offsets is rounded once, relative to a year at most; so are the
 * whole years where there are more than 2^53, and the sum of the two. */
static void difference_is_near(double year, brink_instant t, brink_instant u)
{
    const double got = brink_instant_since(year, u, t);
    if (is_never(u)) {
        LAW(got == (double)INFINITY, "clock: since never is %a", got);
        return;
    }
    mpfr_t x, y;
    mpfr_inits2(BITS, x, y, (mpfr_ptr)0);
    exactly(x, year, u);
    exactly(y, year, t);
    mpfr_sub(x, x, y, MPFR_RNDN);
    const double right = mpfr_get_d(x, MPFR_RNDN);
    mpfr_sub_d(x, x, got, MPFR_RNDN);
    const double off = fabs(mpfr_get_d(x, MPFR_RNDA));
    mpfr_clears(x, y, (mpfr_ptr)0);
    if (off > 0x1p-53 * (year + 2.01 * fabs(right))) {
        FINDING("clock: {%lld, %a} since t is %a, off by %a", (long long)u.epoch,
                u.offset, got, off);
        tell(year, t, 0);
    }
}

/** One double is a time from the beginning: nothing is rounded. */
static void at_is_exact(double year, double dt)
{
    const brink_instant u = brink_instant_at(year, dt);
    if (is_never(u))
        return; // seen above, as a sum from the beginning
    mpfr_t x;
    mpfr_init2(x, BITS);
    exactly(x, year, u);
    const int same = mpfr_cmp_d(x, dt) == 0;
    mpfr_clear(x);
    if (!same || (u.epoch < INT64_C(1) << 53 && u.offset == 0 &&
                  brink_instant_time(year, u) != dt)) {
        FINDING("clock: dt as an instant is {%lld, %a}", (long long)u.epoch,
                u.offset);
        tell(year, u, dt);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stream s = stream_of_bytes(data, size);
    const double year = ldexp(1, stream_int(&s, -100, 100));
    const brink_instant t = make_instant(&s, year), u = make_instant(&s, year);
    const double dt = make_span(&s, year), more = make_span(&s, year);
    sum_is_rounded_once(year, t, dt);
    sum_is_rounded_once(year, (brink_instant){0, 0}, dt);
    at_is_exact(year, dt);
    order_is_that_of_times(year, t, u);
    if (!is_never(t))
        difference_is_near(year, t, u);
    LAW(brink_instant_compare(brink_instant_after(year, t, dt),
                              brink_instant_after(year, t, dt + more)) <= 0,
        "clock: later by %a, and less late by %a more", dt, more);
    return 0;
}
