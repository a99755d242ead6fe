// SPDX-License-Identifier: MIT
#ifndef FUZZ_H
#define FUZZ_H
/**
 * What every target has: an entry that any engine can call, a source of choices,
 * and a way to say what it found.
 *
 * A target makes a case of the bytes it is given, by stream_of_bytes of
 * tests/random.h: a byte or two a choice, so that the first picks a family of
 * adversarial cases and every other one moves a single thing.  Where the bytes
 * end, the choices go on from a fixed seed: any file, an empty one too, is a
 * whole case.
 */
#include "../tests/random.h"
#include <stdio.h>
#include <stdlib.h>

/** One case; 0.  What breaks a law is a finding: it is printed, and the program
 * aborts. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/** Says which law was broken; the case follows, as C literals. */
#define FINDING(...)                                                             \
    (fprintf(stderr, "finding: " __VA_ARGS__), fputc('\n', stderr))

/** What must hold, or else is said to have been broken. */
#define LAW(holds, ...)                                                          \
    do {                                                                         \
        if (!(holds)) {                                                          \
            FINDING(__VA_ARGS__);                                                \
            finding_end();                                                       \
        }                                                                        \
    } while (0)

/** Prints n numbers in hex as the inside of a C initializer, and as a line of
 *  tests/NAME.wc is written. */
static inline void finding_numbers(const char *name, int n, const double *x)
{
    fprintf(stderr, "  const double %s[%d] = {", name, n);
    for (int k = 0; k < n; k++)
        fprintf(stderr, "%s%a", k ? ", " : "", x[k]);
    fputs("};\n", stderr);
}

/** The end of what is said about a finding. */
static inline _Noreturn void finding_end(void)
{
    fflush(NULL);
    abort();
}
#endif
