// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_MADE_H
#define TESTS_BENCH_MADE_H
/** The end of the bench's pages: by which command, compiler and machine. */
#include "report.h"

void bench_write_made(brink_report *r, const char *command);
#endif
