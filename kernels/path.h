// SPDX-License-Identifier: MIT
#ifndef BRINK_PATH_H
#define BRINK_PATH_H
/**
 * The same source compiled for several instruction sets, the best one taken at
 * run time; not installed.
 *
 * A file that includes this first is compiled once more for each path, with
 * BRINK_PATH defined to `any`, `fma` (AVX2 and FMA) or `avx512`; its functions,
 * those listed below, then are brink_NAME_PATH, and path.c holds brink_NAME.
 * Without BRINK_PATH it is compiled once, under the names it is written with.
 * fma() is exact whether hardware or libm does it and nothing else is contracted,
 * so every path gives the same bits.
 */
#ifdef BRINK_PATH
#define BRINK_GLUE_(name, path) name##_##path
#define BRINK_GLUE(name, path)  BRINK_GLUE_(name, path)
#define BRINK_ON_PATH(name)     BRINK_GLUE(name, BRINK_PATH)

#define brink_quadratic_roots         BRINK_ON_PATH(brink_quadratic_roots)
#define brink_quadratic_roots_cr      BRINK_ON_PATH(brink_quadratic_roots_cr)
#define brink_intersection_time       BRINK_ON_PATH(brink_intersection_time)
#define brink_intersection_time_fast  BRINK_ON_PATH(brink_intersection_time_fast)
#define brink_intersection_time_cr    BRINK_ON_PATH(brink_intersection_time_cr)
#define brink_intersection_time_slow  BRINK_ON_PATH(brink_intersection_time_slow)
#define brink_disjoint_time           BRINK_ON_PATH(brink_disjoint_time)
#define brink_disjoint_time_fast      BRINK_ON_PATH(brink_disjoint_time_fast)
#define brink_disjoint_time_cr        BRINK_ON_PATH(brink_disjoint_time_cr)
#define brink_disjoint_time_slow      BRINK_ON_PATH(brink_disjoint_time_slow)
#define brink_halfspace_time          BRINK_ON_PATH(brink_halfspace_time)
#define brink_core_impulse            BRINK_ON_PATH(brink_core_impulse)
#define brink_step_impulse            BRINK_ON_PATH(brink_step_impulse)
#define brink_rim_impulse             BRINK_ON_PATH(brink_rim_impulse)
#define brink_intersection_times      BRINK_ON_PATH(brink_intersection_times)
#define brink_intersection_times_fast BRINK_ON_PATH(brink_intersection_times_fast)
#define brink_disjoint_times          BRINK_ON_PATH(brink_disjoint_times)
#define brink_disjoint_times_fast     BRINK_ON_PATH(brink_disjoint_times_fast)
#endif
#endif
