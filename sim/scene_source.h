// SPDX-License-Identifier: MIT
#ifndef BRINK_SCENE_SOURCE_H
#define BRINK_SCENE_SOURCE_H
/**
 * A text that is being read, and what is wrong with it.
 *
 * Every complaint has one form, so that people and editors can both follow it:
 *     file:line:column: error: what is wrong
 *       the line
 *          ^ what to do
 * Lines end in LF or CR LF; a column is a character of UTF-8, counted from 1.
 */
#include <stddef.h>
#include <stdio.h>

typedef struct brink_mark { // a place in a text
    int line, column;       // from 1; line 0: no such place
} brink_mark;

typedef struct brink_source {
    const char *name; // of the file, as messages call it
    const char *text;
    size_t size;
    FILE *errors;
    int complaints; // so far
    int line;       // a line found before, and where it begins: complaints come
    size_t begin;   // nearly in order, and none searches the text from its top
} brink_source;

#define BRINK_COMPLAINTS_MOST 1000 // those beyond are counted, and not written

/** `size` bytes of text, which must stay in place as long as the source is used.
 */
brink_source brink_source_of(const char *name, const char *text, size_t size,
                             FILE *errors);

/**
 * Writes one complaint.  The formatted text is in two parts with a newline
 * between them: what is wrong, and what to do.  In the echoed line a tab stays a
 * tab, above and below; what is no text shows as '?', and a long line is cut
 * around the caret.
 */
void brink_complain(brink_source *s, brink_mark at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** 1 if all of it is text: UTF-8, printable or white space, and no line break but
 * LF and CR LF.  Otherwise 0, with a complaint about the first byte that is not.
 */
int brink_source_is_text(brink_source *s);

/** Bytes of the printable character that s begins with, 0 if it begins with none.
 *  A tab is printable, a line break is not. */
size_t brink_character(const char *s, size_t left);
#endif
