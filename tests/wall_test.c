// SPDX-License-Identifier: MIT
#include "suite.h"
#include "wall.h"
#include <time.h>

START_TEST(it_goes_on_by_seconds_and_never_back)
{
    const struct timespec some = {0, 20000000};
    const double begin = brink_wall_clock();
    ck_assert_int_eq(nanosleep(&some, NULL), 0);
    double before = brink_wall_clock();
    // Not less than was slept, but for the rounding of the difference.
    ck_assert_double_ge(before - begin, 0.02 - before * 0x1p-52);
    for (int k = 0; k < 1000; k++) {
        const double now = brink_wall_clock();
        ck_assert_double_ge(now, before);
        before = now;
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE("wall", 60, it_goes_on_by_seconds_and_never_back);
}
