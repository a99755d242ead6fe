// SPDX-License-Identifier: MIT
#include "array.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#define LINE ((size_t)64) // of cache
#define PAGE                                                                     \
    ((size_t)1 << 21) // a large one: of x86-64, and of ARM with 4 KiB ones

void *brink_array_create(size_t count, size_t size)
{
    if (size > 0 && count > SIZE_MAX / size)
        return NULL;
    const size_t bytes = count * size;
    void *array = NULL;
    if (posix_memalign(&array, bytes < PAGE ? LINE : PAGE, bytes))
        return NULL;
#ifdef MADV_HUGEPAGE
    // A wish: where it is not granted the array is as good, and slower.  What is
    // left after the last whole page stays in small ones.
    if (bytes >= PAGE)
        (void)madvise(array, bytes / PAGE * PAGE, MADV_HUGEPAGE);
#endif
    return memset(array, 0, bytes);
}
