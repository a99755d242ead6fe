// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_FAMILIES_H
#define TESTS_BENCH_FAMILIES_H
/** What the families of inputs are, as a section of the page. */
#include "report.h"

void bench_families(brink_report *r);
#endif
