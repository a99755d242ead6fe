// SPDX-License-Identifier: MIT
#ifndef TESTS_COUNTED_TIMES_H
#define TESTS_COUNTED_TIMES_H
/**
 * Counts how often one event time asks another, of a file of its own: the linker
 * leads the calls through here (tests/CMakeLists.txt).  A filter that let
 * everything pass would cost no digit, but time.
 */
#include <brink/event_time.h>

static int counted; // calls of those that COUNT_CALLS names

// By the names that the linker's --wrap gives to what is called, and to who asks;
// one for each instruction set that the kernels are compiled for.
typedef double time_of(const double r[3], const double v[3], double sigma);
#define COUNT_CALLS_OF(name)                                                     \
    time_of real_##name __asm__("__real_brink_" #name);                          \
    time_of counted_##name __asm__("__wrap_brink_" #name);                       \
    double counted_##name(const double r[3], const double v[3], double sigma)    \
    {                                                                            \
        counted++;                                                               \
        return real_##name(r, v, sigma);                                         \
    }
#ifdef BRINK_DISPATCH
#define COUNT_CALLS(name)                                                        \
    COUNT_CALLS_OF(name##_any)                                                   \
    COUNT_CALLS_OF(name##_fma)                                                   \
    COUNT_CALLS_OF(name##_avx512)
#else
#define COUNT_CALLS(name) COUNT_CALLS_OF(name)
#endif
#endif
