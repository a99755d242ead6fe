// SPDX-License-Identifier: MIT
#ifndef BRINK_PATH_H
#define BRINK_PATH_H
/**
 * The same source compiled for several instruction sets, and the best of them
 * taken at run time; not installed.
 *
 * Where the build defines BRINK_PATH, to `any`, `fma` (AVX2 and FMA) or `avx512`,
 * a file that includes this first is being compiled for that path, and its
 * functions, those listed below, are brink_NAME_any and so on.  ROOM_path.c then
 * makes brink_NAME of them, with BRINK_DISPATCH defined.  Without either a file
 * is compiled once, under the names it is written with.  fma() is exact whether
 * hardware or libm does it and nothing else is contracted, so every path gives
 * the same bits.
 *
 * The path is chosen at every call, by a load, a test and a predicted branch.
 * The word that is looked at is filled in by the compiler's run-time library
 * before main.  An ifunc would save the test, but its resolver runs before a
 * sanitizer is ready, and not every C library has it; a pointer of our own would
 * be global state.
 */
#ifdef BRINK_PATH
#define BRINK_GLUE_(name, path) name##_##path
#define BRINK_GLUE(name, path)  BRINK_GLUE_(name, path)
#define BRINK_ON_PATH(name)     BRINK_GLUE(name, BRINK_PATH)

#define brink_ball_overlap         BRINK_ON_PATH(brink_ball_overlap)
#define brink_ball_overlap_rate    BRINK_ON_PATH(brink_ball_overlap_rate)
#define brink_ball_overlap_at      BRINK_ON_PATH(brink_ball_overlap_at)
#define brink_ball_overlap_sign_at BRINK_ON_PATH(brink_ball_overlap_sign_at)
#define brink_ball_overlap_rate_at BRINK_ON_PATH(brink_ball_overlap_rate_at)
#define brink_ball_overlap_rate_sign_at                                          \
    BRINK_ON_PATH(brink_ball_overlap_rate_sign_at)
#define brink_halfspace_overlap      BRINK_ON_PATH(brink_halfspace_overlap)
#define brink_halfspace_overlap_rate BRINK_ON_PATH(brink_halfspace_overlap_rate)
#define brink_halfspace_overlap_at   BRINK_ON_PATH(brink_halfspace_overlap_at)
#define brink_halfspace_overlap_sign_at                                          \
    BRINK_ON_PATH(brink_halfspace_overlap_sign_at)
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
#define brink_intersection_times      BRINK_ON_PATH(brink_intersection_times)
#define brink_intersection_times_fast BRINK_ON_PATH(brink_intersection_times_fast)
#define brink_disjoint_times          BRINK_ON_PATH(brink_disjoint_times)
#define brink_disjoint_times_fast     BRINK_ON_PATH(brink_disjoint_times_fast)
#define brink_core_impulse_balanced   BRINK_ON_PATH(brink_core_impulse_balanced)
#define brink_core_impulse            BRINK_ON_PATH(brink_core_impulse)
#define brink_step_impulse_balanced   BRINK_ON_PATH(brink_step_impulse_balanced)
#define brink_step_impulse            BRINK_ON_PATH(brink_step_impulse)
#define brink_rim_impulse_balanced    BRINK_ON_PATH(brink_rim_impulse_balanced)
#define brink_rim_impulse             BRINK_ON_PATH(brink_rim_impulse)
#define brink_predict                 BRINK_ON_PATH(brink_predict)
#define brink_cells_stay              BRINK_ON_PATH(brink_cells_stay)
#endif

#ifdef BRINK_DISPATCH
#define BRINK_HAS_FMA                                                            \
    (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
#define BRINK_HAS_AVX512                                                         \
    (BRINK_HAS_FMA && __builtin_cpu_supports("avx512f") &&                       \
     __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))

/** Defines NAME of a scalar function: AVX-512 has nothing to offer it. */
#define BRINK_CHOOSE(result, name, parameters, arguments)                        \
    result name##_any parameters;                                                \
    result name##_fma parameters;                                                \
    result name parameters                                                       \
    {                                                                            \
        return BRINK_HAS_FMA ? name##_fma arguments : name##_any arguments;      \
    }

/** Defines NAME of a batch. */
#define BRINK_CHOOSE_BATCH(name, parameters, arguments)                          \
    void name##_any parameters;                                                  \
    void name##_fma parameters;                                                  \
    void name##_avx512 parameters;                                               \
    void name parameters                                                         \
    {                                                                            \
        if (BRINK_HAS_AVX512)                                                    \
            name##_avx512 arguments;                                             \
        else if (BRINK_HAS_FMA)                                                  \
            name##_fma arguments;                                                \
        else                                                                     \
            name##_any arguments;                                                \
    }
#endif
#endif
