// SPDX-License-Identifier: MIT
#ifndef BRINK_SCENE_NUMBER_H
#define BRINK_SCENE_NUMBER_H
/**
 * Decimal numbers as files write them, strictly: the whole string or nothing, a
 * decimal point, no spaces, underscores, leading zeros, hexadecimals, nan or inf.
 * The program never calls setlocale, so strtod and printf speak the C locale.
 */
#include <stdint.h>

/** The nearest double.  1; 0 where the text is no decimal number, -1 where it is
 * one but too large for a double or, not being zero, too small: *value is then
 * untouched. */
int brink_number_read(const char *text, double *value);

/** Digits alone, exactly.  1; 0 where the text is anything else, -1 beyond 2^64
 * - 1. */
int brink_integer_read(const char *text, uint64_t *value);
#endif
