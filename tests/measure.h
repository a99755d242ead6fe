// SPDX-License-Identifier: MIT
#ifndef TESTS_MEASURE_H
#define TESTS_MEASURE_H
/** How good the answers of a problem's methods are, on random inputs. */
#include "problems.h"

enum { MEASURE_WORST = 5 };

/** What one method made of the cases of a family. */
typedef struct sample {
    int n;
    int count[MEASURES];      // of those where there was something to measure
    double *error[MEASURES];  // theirs, ascending; infinite where wrong
    int wrong[WRONG_KINDS];   // wrong[WRONG_NOT]: the good ones
    int worst[MEASURE_WORST]; // cases, by what is promised; -1: no more
} sample;

/** Methods first to first + methods - 1 over n cases of a family; a sample each.
 * 0, or -1 if memory is out. */
int measure(const problem *p, int first, int methods, int family, int n,
            uint64_t seed, sample *s);
void measure_free(sample *s);

/** Many samples as one, but for the worst cases.  0, or -1 if memory is out. */
int measure_pool(sample *all, int count, const sample *s);

/** The error that a part q of those measured does not exceed; 0 if there are
 * none. */
double measure_quantile(const sample *s, int measure, double q);

/** All wrong answers. */
int measure_wrong(const sample *s);
#endif
