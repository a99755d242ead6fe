// SPDX-License-Identifier: MIT
#ifndef BRINK_CLOCK_H
#define BRINK_CLOCK_H
/**
 * Time that does not wear out.  An instant is a whole number of years and an
 * offset into the year; the year is a power of two, chosen once a run and of the
 * order of a mean free time, so the offset resolves the last event of a run of
 * 10^12 as finely as the first: to 2^-53 years.
 */
#include <stdint.h>

typedef struct brink_instant {
    int64_t epoch; // years gone by, >= 0; INT64_MAX is "never"
    double offset; // 0 <= offset < year
} brink_instant;

#define BRINK_NEVER ((brink_instant){INT64_MAX, 0.0})

/** t + dt.  dt >= 0 or +inf; NEVER for +inf, for a sum beyond 2^62 years and
 * where t is NEVER.  The sum is rounded once, to a double offset counted from t's
 * own year. */
static inline brink_instant brink_instant_after(double year, brink_instant t,
                                                double dt)
{
    if (t.epoch == INT64_MAX || !(dt <= 0x1.fffffffffffffp1023))
        return BRINK_NEVER;
    const double sum = t.offset + dt; // the one rounding
    if (sum < year)
        return (brink_instant){t.epoch, sum};
    // The year is a power of two: quotient, product and remainder are exact.
    const double years = sum / year;
    if (!(years < 0x1p61) || t.epoch > INT64_C(1) << 61)
        return BRINK_NEVER;
    const int64_t whole = (int64_t)years;
    return (brink_instant){t.epoch + whole, sum - (double)whole * year};
}

/** -1, 0, 1 as a is before, at, after b. */
static inline int brink_instant_compare(brink_instant a, brink_instant b)
{
    if (a.epoch != b.epoch)
        return a.epoch < b.epoch ? -1 : 1;
    return (a.offset > b.offset) - (a.offset < b.offset);
}

/** later - earlier, rounded: negative the other way round, +inf if `later` is
 * NEVER. */
double brink_instant_since(double year, brink_instant later,
                           brink_instant earlier);

/** The time as one double, for people to read; never for the dynamics. */
double brink_instant_time(double year, brink_instant t);

/** The instant that a time as one double names: time >= 0 or +inf. */
brink_instant brink_instant_at(double year, double time);
#endif
