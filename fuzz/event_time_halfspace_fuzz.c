// SPDX-License-Identifier: MIT
#include <brink/event_time.h>

#include "../tests/paths.h"
#include "../tests/walls.h"
#include "laws.h"

typedef double wall_time(const double r[3], const double v[3], const double n[3],
                         const double c[3]);
PATHS_OF(wall_time, brink_halfspace_time)

static void keep_to_paths(const double *x)
{
    wall_time *const on[3] = PATHS(brink_halfspace_time);
    const double t = brink_halfspace_time(x, x + 3, x + 6, x + 9);
    for (int path = 0; path < PATHS_IN_ALL && can_try(path); path++) {
        if (same(t, on[path](x, x + 3, x + 6, x + 9)))
            continue;
        FINDING("halfspace_time: path %d, other bits", path);
        finding_numbers("x", 12, x);
        finding_end();
    }
}

enum { SLANTING = 64 };

/** Of the nearest doubles a turn of the axes, which adds in another order,
 *  changes none; a sum that is taken for better than it is shows in one of some
 *  2^17: so that any byte of the input makes new ones of them all. */
static void turn_slanting(const uint8_t *data, size_t size)
{
    uint64_t seed = size;
    for (size_t k = 0; k < size; k++) // FNV-1a
        seed = (seed ^ data[k]) * UINT64_C(0x100000001b3);
    stream many = stream_of_seed(seed);
    for (int k = 0; k < SLANTING; k++) {
        wall_case w, turned;
        wall_slanting(&many, &w);
        for (int i = 0; i < 3; i++) {
            turned.r[i] = w.r[(i + 1) % 3];
            turned.v[i] = w.v[(i + 1) % 3];
            turned.n[i] = w.n[(i + 1) % 3];
            turned.c[i] = w.c[(i + 1) % 3];
        }
        const double t = brink_halfspace_time(w.r, w.v, w.n, w.c);
        const double t_turned =
            brink_halfspace_time(turned.r, turned.v, turned.n, turned.c);
        if (t == t_turned)
            continue;
        FINDING("halfspace_time: %a, with axes turned %a", t, t_turned);
        finding_numbers("x", 12, w.r);
        finding_end();
    }
}

/** Of whole numbers: f and its rate are whole, below 2^53, and their quotient is
 *  rounded once. */
static void check_whole(stream *s)
{
    double x[12];
    int64_t f = 0, rate = 0;
    const int most = 1 << stream_int(s, 1, 24);
    for (int i = 0; i < 12; i++)
        x[i] = stream_int(s, -most, most);
    if (stream_int(s, 0, 1)) // next to the plane, or on it
        for (int i = 0; i < 3; i++)
            x[9 + i] = x[i] + stream_int(s, -1, 1);
    for (int i = 0; i < 3; i++) {
        f += (int64_t)x[6 + i] * (int64_t)(x[i] - x[9 + i]);
        rate += (int64_t)x[6 + i] * (int64_t)x[3 + i];
    }
    double right = f <= 0 ? 0 : (double)f / -(double)rate;
    if (rate >= 0)
        right = (double)INFINITY;
    const double t = brink_halfspace_time(x, x + 3, x + 6, x + 9);
    if (t == right)
        return;
    FINDING("halfspace_time: %a, in whole numbers %a", t, right);
    finding_numbers("x", 12, x);
    finding_end();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const lawful law = {&problem_halfspace_time, "LLLVVVNNNLLL", "T"};
    stream s = stream_of_bytes(data, size);
    double x[PROBLEM_INPUTS] = {0};
    truth right = {0};
    turn_slanting(data, size);
    check_whole(&s);
    contract_case(&problem_halfspace_time, &s, 12, x);
    problem_halfspace_time.solve(x, &right);
    contract_check(&problem_halfspace_time, RANK_PLAIN, x, &right);
    laws_check(&law, RANK_PLAIN, x, &s);
    keep_to_paths(x);
    return 0;
}
