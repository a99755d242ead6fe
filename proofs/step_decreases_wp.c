// SPDX-License-Identifier: MIT
// with: -wp-prop @lemma
/**
 * What step_wp.c takes for granted of numbers that decrease: with one more that
 * is less than the last of them, they still do.
 */
#include "step_wp.h"
