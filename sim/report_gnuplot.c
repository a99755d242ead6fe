// SPDX-License-Identifier: MIT
#include "report_gnuplot.h"
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

// Colours: Okabe and Ito's, the two yellows darkened until they show on white.
static const char prologue[] =
    "set terminal svg size 760,500 dynamic enhanced font 'sans-serif,14' "
    "background '#ffffff'\n"
    "set encoding utf8\n"
    "set linetype 1 lc rgb '#0072b2' lw 2.4 pt 7 ps 0.5\n"
    "set linetype 2 lc rgb '#d55e00' lw 2.4 pt 5 ps 0.5\n"
    "set linetype 3 lc rgb '#009e73' lw 2.4 pt 9 ps 0.6\n"
    "set linetype 4 lc rgb '#cc79a7' lw 2.4 pt 11 ps 0.6\n"
    "set linetype 5 lc rgb '#b8860b' lw 2.4 pt 13 ps 0.6\n"
    "set linetype 6 lc rgb '#000000' lw 2.4 pt 6 ps 0.5\n"
    "set linetype 7 lc rgb '#56b4e9' lw 2.4 pt 4 ps 0.5\n"
    "set linetype 8 lc rgb '#e08a00' lw 2.4 pt 8 ps 0.6\n"
    "set linetype 100 lc rgb '#e3e7ed' lw 1\n"
    "set border 3 lc rgb '#5b6575'\n"
    "set tics nomirror textcolor rgb '#1d2430'\n"
    "set grid back lt 100\n";

static int write_script(FILE *out, const char *script)
{
    if (out == NULL)
        return -1;
    int failed = fputs(prologue, out) < 0 || fputs(script, out) < 0;
    return fclose(out) != 0 || failed ? -1 : 0;
}

// In the child.  127, as shells say it: there is no such program.
static _Noreturn void become_gnuplot(const char *folder, const char *recipe,
                                     const char *drawing, int complaints)
{
    int in = open(recipe, O_RDONLY);
    int out = open(drawing, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (in < 0 || out < 0 || dup2(in, 0) < 0 || dup2(out, 1) < 0 ||
        dup2(complaints, 2) < 0 || chdir(folder) != 0)
        _exit(126);
    execlp("gnuplot", "gnuplot", (char *)NULL);
    _exit(127);
}

static int run(const char *folder, const char *recipe, const char *drawing,
               char *trouble, size_t size)
{
    FILE *complaints = tmpfile();
    pid_t child = complaints == NULL ? -1 : fork();
    if (child == 0)
        become_gnuplot(folder, recipe, drawing, fileno(complaints));
    int status = -1;
    if (child < 0 || waitpid(child, &status, 0) != child) {
        snprintf(trouble, size, "cannot start gnuplot: %s", strerror(errno));
    } else if (WIFEXITED(status) && WEXITSTATUS(status) == 127) {
        snprintf(trouble, size,
                 "gnuplot, which draws the figures, was not found: install it "
                 "(Debian, Ubuntu: apt-get install gnuplot-nox)");
    } else if (status != 0) {
        char said[400] = "";
        rewind(complaints);
        said[fread(said, 1, sizeof said - 1, complaints)] = '\0';
        snprintf(trouble, size, "gnuplot failed on %s: %s", recipe, said);
    }
    if (complaints != NULL)
        fclose(complaints);
    return status == 0 ? 0 : -1;
}

// In one page ids must differ, and every drawing of gnuplot's has the same; and
// its title, "Gnuplot", would hang over the figure as a tool tip.
static void make_own(FILE *out, const char *svg, int number)
{
    static const struct {
        const char *found, *written;
    } change[] = {{"id='", "id='f%d-"},
                  {"id=\"", "id=\"f%d-"},
                  {"href='#", "href='#f%d-"},
                  {"url(#", "url(#f%d-"},
                  {"<title>Gnuplot</title>", ""}};
    const size_t changes = sizeof change / sizeof change[0];
    while (*svg != '\0') {
        size_t k = 0;
        while (k < changes &&
               strncmp(svg, change[k].found, strlen(change[k].found)) != 0)
            k++;
        if (k == changes) {
            fputc(*svg++, out);
        } else {
            fprintf(out, change[k].written, number);
            svg += strlen(change[k].found);
        }
    }
}

static char *read_drawing(FILE *in, int number)
{
    struct stat about;
    char *text = NULL, *svg = NULL;
    size_t length = 0;
    if (fstat(fileno(in), &about) == 0)
        text = calloc(1, (size_t)about.st_size + 1);
    if (text != NULL)
        length = fread(text, 1, (size_t)about.st_size, in);
    const char *begin = length == 0 ? NULL : strstr(text, "<svg");
    FILE *out = begin == NULL ? NULL : open_memstream(&svg, &length);
    if (out != NULL) {
        make_own(out, begin, number);
        fclose(out);
    }
    free(text);
    return svg;
}

char *brink_gnuplot_draw(const char *folder, const char *name, const char *script,
                         int number, char *trouble, size_t size)
{
    char recipe[4096], drawing[4096], *svg = NULL;
    int length = snprintf(recipe, sizeof recipe, "%s/%s.gnuplot", folder, name);
    if (length < 0 || (size_t)length >= sizeof recipe) {
        snprintf(trouble, size, "the folder's name is too long: %s", folder);
        return NULL;
    }
    snprintf(drawing, sizeof drawing, "%s/%s.svg", folder, name);
    if (write_script(fopen(recipe, "w"), script) != 0) {
        snprintf(trouble, size, "cannot write %s: %s", recipe, strerror(errno));
    } else if (run(folder, recipe, drawing, trouble, size) == 0) {
        FILE *in = fopen(drawing, "r");
        svg = in == NULL ? NULL : read_drawing(in, number);
        if (svg == NULL)
            snprintf(trouble, size, "gnuplot drew nothing into %s", drawing);
        if (in != NULL)
            fclose(in);
    }
    return svg;
}
