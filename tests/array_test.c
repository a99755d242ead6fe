// SPDX-License-Identifier: MIT
// sim/array.h: every element 0, whatever was in that memory before, and aligned
// as promised, below and above the size from which large pages are asked for.
#include "array.h"
#include "suite.h"
#include <stdint.h>
#include <string.h>

static void is_clean(size_t count, size_t size)
{
    unsigned char *array = brink_array_create(count, size);
    ck_assert_ptr_nonnull(array);
    ck_assert_uint_eq((uintptr_t)array % 64, 0);
    size_t k = 0;
    while (k < count * size && array[k] == 0)
        k++;
    ck_assert_uint_eq(k, count * size);
    memset(array, 0xff, count * size); // for who gets this memory next
    free(array);
}

START_TEST(every_element_is_zero_and_the_first_on_a_line_of_cache)
{
    static const size_t counts[] = {1, 3, 1000, 32768, 32769, 100001};
    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++)
        for (int again = 0; again < 3; again++) {
            is_clean(counts[k], 64);
            is_clean(counts[k], 12);
            is_clean(counts[k], 1);
        }
}
END_TEST

START_TEST(more_than_can_be_counted_is_no_memory)
{
    // 2^61 + 1 elements of 8 bytes are 8 bytes, if one counts past the end.
    ck_assert_ptr_null(brink_array_create(SIZE_MAX / 8 + 2, 8));
    ck_assert_ptr_null(brink_array_create(SIZE_MAX, 64));
}
END_TEST

int main(void)
{
    return RUN_SUITE("array", 60,
                     every_element_is_zero_and_the_first_on_a_line_of_cache,
                     more_than_can_be_counted_is_no_memory);
}
