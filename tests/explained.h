// SPDX-License-Identifier: MIT
#ifndef EXPLAINED_H
#define EXPLAINED_H
/** What stands on a page of `brink explain`. */
#include <check.h>
#include <stdio.h>
#include <string.h>

/** A copy of the line on `name`, behind the one that is `head`.  Not inlined: gcc
 * would take a place on the page for one in the variable that points to it. */
static __attribute__((noinline, unused)) const char *
line_of(const char *text, const char *head, const char *name)
{
    static char line[300];
    const char *at = strstr(text, head);
    ck_assert_msg(at != NULL, "there is no '%s' in:\n%s", head, text);
    at = strstr(at, name);
    ck_assert_msg(at != NULL, "there is no '%s' behind '%s' in:\n%s", name, head,
                  text);
    while (at > text && at[-1] != '\n')
        at--;
    snprintf(line, sizeof line, "%.*s", (int)strcspn(at, "\n"), at);
    return line;
}

/** The number in decimal on a line, which is the same in hex. */
static inline double number_of(const char *text, const char *head,
                               const char *name)
{
    const char *line = line_of(text, head, name);
    double decimal, hex;
    const int columns = 34; // of names
    ck_assert_msg(sscanf(line + columns, "%lf %la", &decimal, &hex) == 2 &&
                      decimal == hex,
                  "%s", line);
    return decimal;
}

static inline void expect_words(const char *text, const char *head,
                                const char *name, const char *words)
{
    const char *line = line_of(text, head, name);
    ck_assert_msg(strstr(line, words) != NULL, "not '%s': %s", words, line);
}
#endif
