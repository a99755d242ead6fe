// SPDX-License-Identifier: MIT
#include "scene_source.h"
#include <stdarg.h>
#include <stdint.h>
#include <string.h>

#define ECHO_WIDTH  76 // characters of a line shown: 80 less the margin
#define ECHO_BEFORE 50 // of them before the caret, where a line is cut

brink_source brink_source_of(const char *name, const char *text, size_t size,
                             FILE *errors)
{
    return (brink_source){
        .name = name, .text = text, .size = size, .errors = errors, .line = 1};
}

// What libyaml's reader lets pass, less the three line breaks that only it sees
// (U+0085, U+2028, U+2029): its lines and an editor's are then the same.
static int is_printable(uint32_t c)
{
    if (c < 0xa0)
        return c == '\t' || (c >= 0x20 && c < 0x7f);
    if (c == 0x2028 || c == 0x2029 || c == 0xfeff)
        return 0;
    return c < 0xd800 || (c >= 0xe000 && c <= 0xfffd) ||
           (c >= 0x10000 && c <= 0x10ffff);
}

size_t brink_character(const char *s, size_t left)
{
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000}; // by length
    if (left == 0)
        return 0;
    const uint32_t head = (unsigned char)s[0];
    const size_t n = head < 0x80         ? 1
                     : head >> 5 == 0x6  ? 2
                     : head >> 4 == 0xe  ? 3
                     : head >> 3 == 0x1e ? 4
                                         : 0;
    if (n == 0 || n > left)
        return 0;
    uint32_t c = n == 1 ? head : head & (0x7fU >> n);
    for (size_t k = 1; k < n; k++) {
        const uint32_t tail = (unsigned char)s[k];
        if (tail >> 6 != 2)
            return 0;
        c = c << 6 | (tail & 0x3f);
    }
    return c >= least[n] && is_printable(c) ? n : 0;
}

// A character, or one byte that is none.
static size_t width(const char *s, size_t left)
{
    const size_t n = brink_character(s, left);
    return n ? n : 1;
}

// Where the line begins; beyond the last line, the end of the text.
static size_t find_line(brink_source *s, int line)
{
    if (line < s->line) {
        s->line = 1;
        s->begin = 0;
    }
    while (s->line < line) {
        const char *from = s->text + s->begin;
        const char *lf =
            s->begin < s->size ? memchr(from, '\n', s->size - s->begin) : NULL;
        if (!lf)
            return s->size;
        s->begin += (size_t)(lf - from) + 1;
        s->line++;
    }
    return s->begin;
}

static void echo(brink_source *s, brink_mark at, const char *advice)
{
    const size_t begin = find_line(s, at.line);
    size_t end = begin;
    int columns = 0, cut = 0;
    for (; end < s->size && s->text[end] != '\n' && s->text[end] != '\r';
         columns++)
        end += width(s->text + end, s->size - end);
    if (columns > ECHO_WIDTH && at.column > ECHO_BEFORE)
        cut = at.column - ECHO_BEFORE;
    size_t p = begin;
    for (int c = 0; c < cut && p < end; c++)
        p += width(s->text + p, end - p);
    const size_t shown = p;
    const char *const margin = cut ? "  ..." : "  ";
    fputs(margin, s->errors);
    for (int c = 0; c < ECHO_WIDTH && p < end; c++) {
        const size_t n = brink_character(s->text + p, end - p);
        if (n)
            fwrite(s->text + p, 1, n, s->errors);
        else
            fputc('?', s->errors);
        p += n ? n : 1;
    }
    fprintf(s->errors, "%s\n%*s", p < end ? "..." : "", (int)strlen(margin), "");
    p = shown;
    for (int c = cut + 1; c < at.column; c++) {
        fputc(p < end && s->text[p] == '\t' ? '\t' : ' ', s->errors);
        p += p < end ? width(s->text + p, end - p) : 0;
    }
    fprintf(s->errors, "^ %s\n", advice);
}

void brink_complain(brink_source *s, brink_mark at, const char *format, ...)
{
    char message[640]; // longer ones are cut: what they quote is bounded
    if (++s->complaints > BRINK_COMPLAINTS_MOST)
        return;
    va_list list;
    va_start(list, format);
    vsnprintf(message, sizeof message, format, list);
    va_end(list);
    char *advice = strchr(message, '\n');
    if (advice)
        *advice++ = '\0';
    fprintf(s->errors, "%s:%d:%d: error: %s\n", s->name, at.line, at.column,
            message);
    echo(s, at, advice ? advice : "");
    if (s->complaints == BRINK_COMPLAINTS_MOST)
        fprintf(s->errors, "%s: errors after the first %d are not listed\n",
                s->name, BRINK_COMPLAINTS_MOST);
}

int brink_source_is_text(brink_source *s)
{
    brink_mark at = {1, 1};
    for (size_t p = 0; p < s->size; at.column++) {
        const char *c = s->text + p;
        const size_t crlf = *c == '\r' && p + 1 < s->size && c[1] == '\n';
        if (*c == '\n' || crlf) {
            at = (brink_mark){at.line + 1, 0};
            p += 1 + crlf;
            continue;
        }
        const size_t n = brink_character(c, s->size - p);
        if (n == 0) {
            brink_complain(s, at,
                           "byte %zu, 0x%02x, is not text\n"
                           "a scene is UTF-8 text without control characters; is "
                           "this the right file?",
                           p, (unsigned)(unsigned char)*c);
            return 0;
        }
        p += n;
    }
    return 1;
}
