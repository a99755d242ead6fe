// SPDX-License-Identifier: MIT
#ifndef BRINK_EXPLAIN_PUT_H
#define BRINK_EXPLAIN_PUT_H
/**
 * Lines of an explanation: what it is, in decimal, in hex, in three columns.
 */
#include <stdio.h>

static inline void put_head(FILE *out, const char *text)
{
    fprintf(out, "\n%s\n", text);
}

static inline void put_number(FILE *out, const char *name, double x)
{
    fprintf(out, "  %-30s  %-24.17g  %a\n", name, x, x);
}

/** A number and a remark on it. */
static inline void put_remark(FILE *out, const char *name, double x,
                              const char *remark)
{
    fprintf(out, "  %-30s  %-24.17g  %-24a  %s\n", name, x, x, remark);
}

static inline void put_words(FILE *out, const char *name, const char *words)
{
    fprintf(out, "  %-30s  %s\n", name, words);
}

static inline void put_vector(FILE *out, const char *name, const double x[3])
{
    put_number(out, name, x[0]);
    put_number(out, "", x[1]);
    put_number(out, "", x[2]);
}
#endif
