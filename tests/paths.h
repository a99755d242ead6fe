// SPDX-License-Identifier: MIT
#ifndef TESTS_PATHS_H
#define TESTS_PATHS_H
/** A kernel's instruction set paths, each by its name. */
#include <math.h>
#include <stddef.h>
#include <string.h>

enum { PATHS_IN_ALL = 3 };

// Not weak, so that they are linked from an archive; where a build has one path
// only, under the plain names, there is nothing to declare.
#if defined __x86_64__ && !defined BRINK_ONE_PATH
#define PATHS_OF(type, name) extern type name##_any, name##_fma, name##_avx512;
#define PATHS(name)                                                              \
    {                                                                            \
        name##_any, name##_fma, name##_avx512                                    \
    }
#else
#define PATHS_OF(type, name)
#define PATHS(name)                                                              \
    {                                                                            \
        NULL, NULL, NULL                                                         \
    }
#endif

/** Whether path 0 (any), 1 (fma) or 2 (avx512) can be tried here. */
static inline int can_try(int path)
{
#if defined __x86_64__ && !defined BRINK_ONE_PATH
    int fma = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    int avx512 = __builtin_cpu_supports("avx512f") &&
                 __builtin_cpu_supports("avx512dq") &&
                 __builtin_cpu_supports("avx512vl");
    return path == 0 || (fma && (path == 1 || avx512));
#else
    return 0 * path; // there are none
#endif
}

/** The same bits, but for which NaN it is. */
static inline int same(double x, double y)
{
    return memcmp(&x, &y, sizeof x) == 0 || (isnan(x) && isnan(y));
}
#endif
