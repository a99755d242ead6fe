// SPDX-License-Identifier: MIT
#include "clock.h"
#include <math.h>

brink_instant brink_instant_after(double year, brink_instant t, double dt)
{
    if (t.epoch == INT64_MAX || !(dt < (double)INFINITY))
        return BRINK_NEVER;
    const double sum = t.offset + dt; // the one rounding
    if (sum < year)
        return (brink_instant){t.epoch, sum};
    // The year is a power of two: quotient, floor and remainder are exact.
    const double years = floor(sum / year);
    if (!(years < 0x1p61) || t.epoch > INT64_C(1) << 61)
        return BRINK_NEVER;
    return (brink_instant){t.epoch + (int64_t)years, fma(-years, year, sum)};
}

double brink_instant_since(double year, brink_instant later,
                           brink_instant earlier)
{
    if (later.epoch == INT64_MAX)
        return (double)INFINITY;
    return fma((double)(later.epoch - earlier.epoch), year,
               later.offset - earlier.offset);
}

double brink_instant_time(double year, brink_instant t)
{
    return brink_instant_since(year, t, (brink_instant){0, 0.0});
}

brink_instant brink_instant_at(double year, double time)
{
    return brink_instant_after(year, (brink_instant){0, 0.0}, time);
}
