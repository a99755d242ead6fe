// SPDX-License-Identifier: MIT
#include "clock.h"
#include <math.h>

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
