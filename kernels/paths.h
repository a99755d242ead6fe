// SPDX-License-Identifier: MIT
#ifndef BRINK_PATHS_H
#define BRINK_PATHS_H
/**
 * One body compiled for several instruction sets, the best one taken at run time;
 * not installed.
 *
 * NAME_body is always inlined.  BRINK_SCALAR_PATHS makes of it NAME_any, for what
 * the compiler was told to build for, and NAME_fma; BRINK_BATCH_PATHS NAME_avx512
 * too. Tests call these by name.  NAME itself looks at the processor: a load, a
 * test and a predicted branch.  fma() is exact whether hardware or libm does it
 * and nothing else is contracted, so all of them give the same bits.
 *
 * The look is at a word that the compiler's run-time library fills in before
 * main.  An ifunc would save the test, but its resolver runs before a sanitizer
 * is ready, and not every C library has it.
 */
#if defined __x86_64__ && defined __GNUC__ && !defined __FMA__
#define BRINK_HAS_PATHS 1
#define BRINK_HAS_FMA                                                            \
    (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
#define BRINK_HAS_AVX512                                                         \
    (BRINK_HAS_FMA && __builtin_cpu_supports("avx512f") &&                       \
     __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))

#define BRINK_PATH(isa, path, result, name, parameters, arguments)               \
    result name##path parameters;                                                \
    __attribute__((target(isa))) result name##path parameters                    \
    {                                                                            \
        return name##_body arguments;                                            \
    }

#define BRINK_SCALAR_PATHS(result, name, parameters, arguments)                  \
    BRINK_PATH("sse2", _any, result, name, parameters, arguments)                \
    BRINK_PATH("avx2,fma", _fma, result, name, parameters, arguments)            \
    result name parameters                                                       \
    {                                                                            \
        return BRINK_HAS_FMA ? name##_fma arguments : name##_any arguments;      \
    }

#define BRINK_BATCH_PATHS(name, parameters, arguments)                           \
    BRINK_PATH("sse2", _any, void, name, parameters, arguments)                  \
    BRINK_PATH("avx2,fma", _fma, void, name, parameters, arguments)              \
    BRINK_PATH("avx2,fma,avx512f,avx512dq,avx512vl", _avx512, void, name,        \
               parameters, arguments)                                            \
    void name parameters                                                         \
    {                                                                            \
        if (BRINK_HAS_AVX512)                                                    \
            name##_avx512 arguments;                                             \
        else if (BRINK_HAS_FMA)                                                  \
            name##_fma arguments;                                                \
        else                                                                     \
            name##_any arguments;                                                \
    }

#else // one path: the machine has fma() throughout, or no other set is known here

#define BRINK_SCALAR_PATHS(result, name, parameters, arguments)                  \
    result name parameters                                                       \
    {                                                                            \
        return name##_body arguments;                                            \
    }
#define BRINK_BATCH_PATHS(name, parameters, arguments)                           \
    BRINK_SCALAR_PATHS(void, name, parameters, arguments)
#endif
#endif
