// SPDX-License-Identifier: MIT
#include "report.h"
#include "report_gnuplot.h"
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { NARROW = 7 }; // columns; a table of more is set closer

// Drawings keep a light card in the dark, because gnuplot writes its colours into
// them; on a narrow screen they scroll sideways rather than shrink out of
// reading.  So do tables, under their first column and below their caption.
static const char style[] =
    ":root{color-scheme:light dark;--ink:#1d2430;--soft:#5b6575;--line:#d9dee6;"
    "--page:#fff;--card:#f5f7fa;--mark:#0072b2}\n"
    "@media(prefers-color-scheme:dark){:root{--ink:#e4e8ee;--soft:#9aa5b5;"
    "--line:#39424f;--page:#161a20;--card:#1f252d;--mark:#56b4e9}}\n"
    "body{margin:0 auto;padding:2.5rem 1.25rem 4rem;max-width:47rem;"
    "background:var(--page);color:var(--ink);"
    "font:1.0625rem/1.6 system-ui,-apple-system,'Segoe UI',Roboto,sans-serif}\n"
    "h1{font-size:2rem;line-height:1.2;margin:0 0 1rem;text-wrap:balance}\n"
    "h2{font-size:1.45rem;line-height:1.25;margin:3.5rem 0 .75rem;"
    "padding-top:1.25rem;border-top:1px solid var(--line)}\n"
    "h3{font-size:1.1rem;margin:2.25rem 0 .5rem}\n"
    "p{margin:.75rem 0}\n"
    ".finding{margin:1.25rem 0;padding:.9rem 1.1rem;background:var(--card);"
    "border-left:4px solid var(--mark);border-radius:0 6px 6px 0}\n"
    "figure{margin:1.5rem 0}\n"
    ".card{overflow-x:auto;background:#fff;border:1px solid var(--line);"
    "border-radius:8px;padding:.5rem}\n"
    ".card svg{display:block;width:100%;min-width:34rem;height:auto}\n"
    "figcaption,caption{color:var(--soft);font-size:.92rem;line-height:1.45}\n"
    "figcaption{margin-top:.6rem}\n"
    ".table{overflow-x:auto;margin:1.25rem 0}\n"
    "table{border-collapse:separate;border-spacing:0;width:100%;font-size:.94rem;"
    "line-height:1.375rem;font-variant-numeric:tabular-nums}\n"
    "caption{text-align:left;padding-bottom:.5rem}\n"
    "caption span{display:inline-block;position:sticky;left:0;"
    "max-width:calc(100vw - 2.5rem)}\n"
    "th,td{padding:.4375rem .7rem;text-align:left;vertical-align:top;"
    "border-bottom:1px solid var(--line)}\n"
    "th{font-weight:600}thead th{vertical-align:bottom;"
    "border-bottom:2px solid var(--soft)}\n"
    "tbody th{min-width:5.5rem}\n"
    ".wide table{font-size:.84rem;line-height:1.25rem}"
    ".wide th,.wide td{padding:.375rem .45rem}\n"
    "th:first-child{padding-left:0;position:sticky;left:0;"
    "background:var(--page)}\n"
    ".r{text-align:right}td.r{white-space:nowrap}\n"
    "pre{overflow-x:auto;padding:.9rem 1.1rem;background:var(--card);"
    "border-radius:6px;font:.88rem/1.5 ui-monospace,Menlo,Consolas,monospace}\n";

__attribute__((format(printf, 2, 3))) static void fail(brink_report *r,
                                                       const char *format, ...)
{
    if (r->trouble[0] != '\0')
        return;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(r->trouble, sizeof r->trouble, format, arguments);
    va_end(arguments);
}

static int is_well(const brink_report *r)
{
    return r->trouble[0] == '\0';
}

static char *path_in(const brink_report *r, const char *name, const char *ending)
{
    size_t size = strlen(r->folder) + strlen(name) + strlen(ending) + 2;
    char *path = malloc(size);
    if (path != NULL)
        snprintf(path, size, "%s/%s%s", r->folder, name, ending);
    return path;
}

void brink_report_escape(FILE *out, const char *text)
{
    static const char special[] = "&<>\"'";
    static const char *const written[] = {"&amp;", "&lt;", "&gt;", "&quot;",
                                          "&#39;"};
    for (; *text != '\0'; text++) {
        const char *found = strchr(special, *text);
        if (found == NULL)
            fputc(*text, out);
        else
            fputs(written[found - special], out);
    }
}

// An element with escaped text in it; `begin` and `end` are ours.
static void put(brink_report *r, const char *begin, const char *end,
                const char *format, va_list arguments)
{
    va_list again;
    va_copy(again, arguments);
    int length = vsnprintf(NULL, 0, format, arguments);
    char *text = length < 0 ? NULL : malloc((size_t)length + 1);
    if (text == NULL) {
        fail(r, "no memory for a paragraph");
    } else if (is_well(r)) {
        vsnprintf(text, (size_t)length + 1, format, again);
        fputs(begin, r->page);
        brink_report_escape(r->page, text);
        fputs(end, r->page);
    }
    va_end(again);
    free(text);
}

void brink_report_open(brink_report *r, const char *folder, const char *title)
{
    brink_report_open_page(r, folder, "index", title);
}

void brink_report_open_page(brink_report *r, const char *folder, const char *name,
                            const char *title)
{
    *r = (brink_report){.folder = strdup(folder), .name = strdup(name)};
    const int good = r->folder != NULL && r->name != NULL;
    char *path = good ? path_in(r, name, ".html.part") : NULL;
    if (path == NULL) {
        fail(r, "no memory for a page");
        return;
    }
    if (mkdir(folder, 0777) != 0 && errno != EEXIST)
        fail(r, "cannot make the folder %s: %s", folder, strerror(errno));
    else if ((r->page = fopen(path, "w")) == NULL)
        fail(r, "cannot write %s: %s", path, strerror(errno));
    free(path);
    if (!is_well(r))
        return;
    fputs("<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
          "<meta name=\"viewport\" "
          "content=\"width=device-width,initial-scale=1\">\n"
          "<title>",
          r->page);
    brink_report_escape(r->page, title);
    fprintf(r->page, "</title>\n<style>\n%s</style>\n<main>\n", style);
}

void brink_report_heading(brink_report *r, int level, const char *format, ...)
{
    char begin[] = "\n<h1>", end[] = "</h1>\n";
    begin[3] = end[3] = (char)('0' + level);
    va_list arguments;
    va_start(arguments, format);
    put(r, begin, end, format, arguments);
    va_end(arguments);
}

void brink_report_paragraph(brink_report *r, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    put(r, "<p>", "</p>\n", format, arguments);
    va_end(arguments);
}

void brink_report_finding(brink_report *r, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    put(r, "<p class=\"finding\">", "</p>\n", format, arguments);
    va_end(arguments);
}

void brink_report_verbatim(brink_report *r, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    put(r, "<pre>", "</pre>\n", format, arguments);
    va_end(arguments);
}

void brink_report_table(brink_report *r, const char *caption, int columns,
                        const char *align, const char *const head[])
{
    r->columns = columns;
    r->column = 0;
    r->align = align;
    if (!is_well(r))
        return;
    fprintf(r->page, "<div class=\"table%s\"><table><caption><span>",
            columns > NARROW ? " wide" : "");
    brink_report_escape(r->page, caption);
    fputs("</span></caption>\n<thead><tr>", r->page);
    for (int k = 0; k < columns; k++) {
        fprintf(r->page, "<th scope=\"col\" class=\"%c\">", align[k]);
        brink_report_escape(r->page, head[k]);
        fputs("</th>", r->page);
    }
    fputs("</tr></thead>\n<tbody>\n", r->page);
}

void brink_report_cell(brink_report *r, const char *format, ...)
{
    int heads = r->column == 0, ends = r->column == r->columns - 1;
    char begin[64], end[32];
    snprintf(begin, sizeof begin, "%s<%s class=\"%c\">", heads ? "<tr>" : "",
             heads ? "th scope=\"row\"" : "td", r->align[r->column]);
    snprintf(end, sizeof end, "</%s>%s", heads ? "th" : "td",
             ends ? "</tr>\n" : "");
    r->column = ends ? 0 : r->column + 1;
    va_list arguments;
    va_start(arguments, format);
    put(r, begin, end, format, arguments);
    va_end(arguments);
}

void brink_report_table_end(brink_report *r)
{
    if (is_well(r))
        fputs("</tbody></table></div>\n", r->page);
}

void brink_report_drawing(brink_report *r, const char *svg, const char *caption)
{
    if (!is_well(r))
        return;
    fprintf(r->page, "<figure><div class=\"card\">\n%s</div><figcaption>", svg);
    brink_report_escape(r->page, caption);
    fputs("</figcaption></figure>\n", r->page);
}

void brink_report_figure(brink_report *r, const char *name, const char *caption,
                         const char *script)
{
    if (!is_well(r))
        return;
    char trouble[sizeof r->trouble];
    char *svg = brink_gnuplot_draw(r->folder, name, script, ++r->figures, trouble,
                                   sizeof trouble);
    if (svg == NULL)
        fail(r, "%s", trouble);
    else
        brink_report_drawing(r, svg, caption);
    free(svg);
}

int brink_report_close(brink_report *r, FILE *errors)
{
    const int good = r->folder != NULL && r->name != NULL;
    char *part = good ? path_in(r, r->name, ".html.part") : NULL;
    char *place = good ? path_in(r, r->name, ".html") : NULL;
    if (r->page != NULL) {
        fputs("</main>\n</html>\n", r->page);
        int bad = ferror(r->page);
        if (fclose(r->page) != 0 || bad)
            fail(r, "cannot write the page: %s", strerror(errno));
        if (part == NULL || place == NULL)
            fail(r, "no memory for a page");
        else if (is_well(r) ? rename(part, place) != 0 : unlink(part) != 0)
            fail(r, "cannot put %s in place: %s", place, strerror(errno));
    }
    free(part);
    free(place);
    free(r->folder);
    free(r->name);
    r->page = NULL;
    r->folder = r->name = NULL;
    if (is_well(r))
        return 0;
    fprintf(errors, "report: %s\n", r->trouble);
    return -1;
}
