// SPDX-License-Identifier: MIT
#ifndef BRINK_ARRAY_H
#define BRINK_ARRAY_H
/**
 * Memory for arrays that have an element a particle, a cell or a day.  Of a
 * million particles they are a hundred megabytes read in no order: in pages of
 * 4 KiB nearly every look is one into the page tables as well.
 */
#include <stddef.h>

/** Room for `count` elements of `size` bytes, all bits 0, at a multiple of 64, in
 * large pages as far as there are whole ones of them and the system gives them;
 * free() takes it back.  NULL: no memory, or more than a size_t counts. */
void *brink_array_create(size_t count, size_t size);
#endif
