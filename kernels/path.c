// SPDX-License-Identifier: MIT
/**
 * Which path a call takes: see path.h.  Compiled with BRINK_DISPATCH where the
 * build made more than one.
 *
 * It is decided at every call, by a load, a test and a predicted branch.  The
 * word looked at is filled in by the compiler's run-time library before main.  An
 * ifunc would save the test, but its resolver runs before a sanitizer is ready,
 * and not every C library has it; a pointer of our own would be global state.
 */
#include "exact.h"

#ifdef BRINK_DISPATCH
#include "event_time.h"
#include "impulse.h"
#include "quadratic.h"

#define HAS_FMA (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
#define HAS_AVX512                                                               \
    (HAS_FMA && __builtin_cpu_supports("avx512f") &&                             \
     __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))

#define SCALAR(result, name, parameters, arguments)                              \
    result name##_any parameters;                                                \
    result name##_fma parameters;                                                \
    result name parameters                                                       \
    {                                                                            \
        return HAS_FMA ? name##_fma arguments : name##_any arguments;            \
    }

#define ROOTS(name)                                                              \
    SCALAR(int, name, (double a, double b, double c, double *x0, double *x1),    \
           (a, b, c, x0, x1))

#define TIME(name)                                                               \
    SCALAR(double, name, (const double r[3], const double v[3], double sigma),   \
           (r, v, sigma))

#define TIMES_ON(name)                                                           \
    void name(size_t n, const double *rx, const double *ry, const double *rz,    \
              const double *vx, const double *vy, const double *vz,              \
              const double *sigma, double *t)

#define TIMES(name)                                                              \
    TIMES_ON(name##_any);                                                        \
    TIMES_ON(name##_fma);                                                        \
    TIMES_ON(name##_avx512);                                                     \
    TIMES_ON(name)                                                               \
    {                                                                            \
        if (HAS_AVX512)                                                          \
            name##_avx512(n, rx, ry, rz, vx, vy, vz, sigma, t);                  \
        else if (HAS_FMA)                                                        \
            name##_fma(n, rx, ry, rz, vx, vy, vz, sigma, t);                     \
        else                                                                     \
            name##_any(n, rx, ry, rz, vx, vy, vz, sigma, t);                     \
    }

ROOTS(brink_quadratic_roots)
ROOTS(brink_quadratic_roots_cr)
TIME(brink_intersection_time)
TIME(brink_intersection_time_fast)
TIME(brink_intersection_time_cr)
TIME(brink_disjoint_time)
TIME(brink_disjoint_time_fast)
TIME(brink_disjoint_time_cr)
SCALAR(double, brink_halfspace_time,
       (const double r[3], const double v[3], const double n[3],
        const double c[3]),
       (r, v, n, c))
SCALAR(double, brink_core_impulse,
       (const double r[3], double m1, double m2, double v1[3], double v2[3]),
       (r, m1, m2, v1, v2))
SCALAR(int, brink_step_impulse,
       (const double r[3], double m1, double m2, double rise,
        enum brink_direction way, double v1[3], double v2[3], double *virial),
       (r, m1, m2, rise, way, v1, v2, virial))
SCALAR(int, brink_rim_impulse,
       (const double r[3], double m1, double m2, double v1[3], double v2[3]),
       (r, m1, m2, v1, v2))
TIMES(brink_intersection_times)
TIMES(brink_intersection_times_fast)
TIMES(brink_disjoint_times)
TIMES(brink_disjoint_times_fast)
#endif
