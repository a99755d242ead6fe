// SPDX-License-Identifier: MIT
#ifndef TESTS_CASES_H
#define TESTS_CASES_H
/** Hard cases: tests/NAME.wc, one case a line, numbers as hex floats, # a
 * comment. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Reads the next case of n numbers into x.  1, or 0 at the end; a malformed line
 * ends the program, as a hard case that is skipped is worse than none. */
static inline int cases_next(FILE *in, int n, double *x)
{
    char line[512];
    while (fgets(line, sizeof line, in)) {
        char *at = line;
        at[strcspn(at, "#\n")] = 0;
        if (at[strspn(at, " \t")] == 0)
            continue;
        for (int i = 0; i < n; i++) {
            char *end;
            x[i] = strtod(at, &end);
            if (end == at) {
                fprintf(stderr, "a case needs %d numbers: %s\n", n, line);
                exit(EXIT_FAILURE);
            }
            at = end;
        }
        if (at[strspn(at, " \t")] != 0) {
            fprintf(stderr, "a case has %d numbers: %s\n", n, line);
            exit(EXIT_FAILURE);
        }
        return 1;
    }
    return 0;
}

/** Opens tests/NAME.wc, or ends the program. */
static inline FILE *cases_open(const char *name)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s.wc", CASES_DIR, name);
    FILE *in = fopen(path, "r");
    if (in == NULL) {
        perror(path);
        exit(EXIT_FAILURE);
    }
    return in;
}
#endif
