// SPDX-License-Identifier: MIT
#ifndef TESTS_RATIONED_H
#define TESTS_RATIONED_H
/**
 * Memory that runs out, at any allocation one likes.  The linker's --wrap puts
 * what is below between the program and the C library: see tests/CMakeLists.txt.
 */
#include <errno.h>
#include <stdlib.h>

static long ration = -1; // allocations until one is refused; below 0: none is

// By the names that --wrap gives to what is called, and to who asks.
void *real_malloc(size_t size) __asm__("__real_malloc");
void *real_calloc(size_t n, size_t size) __asm__("__real_calloc");
void *real_realloc(void *p, size_t size) __asm__("__real_realloc");
char *real_strdup(const char *text) __asm__("__real_strdup");
int real_posix_memalign(void **p, size_t alignment,
                        size_t size) __asm__("__real_posix_memalign");
void *rationed_malloc(size_t size) __asm__("__wrap_malloc");
void *rationed_calloc(size_t n, size_t size) __asm__("__wrap_calloc");
void *rationed_realloc(void *p, size_t size) __asm__("__wrap_realloc");
char *rationed_strdup(const char *text) __asm__("__wrap_strdup");
int rationed_posix_memalign(void **p, size_t alignment,
                            size_t size) __asm__("__wrap_posix_memalign");

static int is_refused(void)
{
    return ration >= 0 && ration-- == 0;
}

void *rationed_malloc(size_t size)
{
    return is_refused() ? NULL : real_malloc(size);
}

void *rationed_calloc(size_t n, size_t size)
{
    return is_refused() ? NULL : real_calloc(n, size);
}

void *rationed_realloc(void *p, size_t size)
{
    return is_refused() ? NULL : real_realloc(p, size);
}

char *rationed_strdup(const char *text)
{
    return is_refused() ? NULL : real_strdup(text);
}

int rationed_posix_memalign(void **p, size_t alignment, size_t size)
{
    return is_refused() ? ENOMEM : real_posix_memalign(p, alignment, size);
}

/** What something answers, the allocation after `n` others being refused, and
 * whether it came to that. */
static inline int with_ration(int something(void), long n, int *refused)
{
    ration = n;
    const int answer = something();
    *refused = ration < 0;
    ration = -1;
    return answer;
}
#endif
