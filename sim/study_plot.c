// SPDX-License-Identifier: MIT
#include "study_plot.h"
#include "study_words.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

// All in decades.  A line of text is a little less than one high in the plot.
#define TOP        1.0     // errors can exceed 1
#define BOTTOM     (-16.5) // half of what a double can tell from 1 is 10^-15.95
#define LANE       0.4     // between the lanes of the band for zeros
#define TEXT       1.05    // between labels
#define BELOW_TEXT 0.7     // from a lane with a label in the plot to the next

typedef struct curve {
    const brink_trial *trial;
    int stopped;
    double lane; // where its zeros stand
    double end;  // where it ends
    double label;
} curve;

static int is_stopped(const brink_trial *t)
{
    return t->outcome != BRINK_OUTCOME_DONE &&
           t->outcome != BRINK_OUTCOME_AT_REST;
}

// Those that were stopped while their error was 0 have a label beside the band's
// lane, and come last.
static int rank(const curve *c)
{
    return !c->stopped ? 0 : c->trial->energy_error > 0 ? 1 : 2;
}

static double assign_lanes(curve *curves)
{
    double lane = BOTTOM - 0.5;
    for (int wanted = 0; wanted < 3; wanted++)
        for (int k = 0; k < BRINK_METHODS; k++)
            if (rank(&curves[k]) == wanted) {
                lane -= wanted == 2 ? BELOW_TEXT : LANE;
                curves[k].lane = lane;
            }
    return lane - BELOW_TEXT;
}

// Labels of one column, from the lowest up: none nearer to the next than a line.
static void spread_labels(curve *curves, int stopped)
{
    curve *column[BRINK_METHODS];
    int count = 0;
    for (int k = 0; k < BRINK_METHODS; k++) {
        int at = count;
        if (curves[k].stopped != stopped)
            continue;
        for (; at > 0 && column[at - 1]->end > curves[k].end; at--)
            column[at] = column[at - 1];
        column[at] = &curves[k];
        count++;
    }
    for (int k = 0; k < count; k++) {
        const double least = k > 0 ? column[k - 1]->label + TEXT : -HUGE_VAL;
        column[k]->label = fmax(column[k]->end, least);
    }
    // Those pushed out at the top press the others down again.
    for (int k = count - 1; k >= 0; k--) {
        const double most =
            k < count - 1 ? column[k + 1]->label - TEXT : TOP - 0.5;
        column[k]->label = fmin(column[k]->label, most);
    }
}

static void write_frame(FILE *out, uint64_t events, double bottom)
{
    fprintf(out, "set logscale xy\nset xrange [1:%" PRIu64 "]\n", events);
    fprintf(out, "set yrange [10**(%.2f):10**(%.2f)]\n", bottom, TOP);
    fprintf(
        out,
        "set xlabel 'events'\nset ylabel 'relative energy error' offset 1,0\n");
    fprintf(out, "set lmargin 13\nset rmargin 20\nunset key\n");
    fprintf(out, "set xtics scale 1,0 ('1' 1");
    for (int decade = 1; decade <= log10((double)events); decade++)
        fprintf(out, ", '10^{%d}' 1e%d", decade, decade);
    fprintf(out, ")\nset ytics ('1' 1");
    for (int decade = -4; decade >= -16; decade -= 4)
        fprintf(out, ", '10^{%d}' 1e%d", decade, decade);
    fprintf(out, ", 'exactly 0' 10**(%.2f))\n", (BOTTOM + bottom) / 2);
    fprintf(out,
            "set object 1 rectangle from graph 0, graph 0 to graph 1, first "
            "10**(%.2f) "
            "behind fillcolor rgb '#f1f4f8' fillstyle solid noborder\n",
            BOTTOM);
}

static void write_label(FILE *out, const curve *c)
{
    const brink_trial *t = c->trial;
    const uint64_t events =
        t->events > 0 ? t->events : 1; // crashed: at the beginning
    const int method = (int)t->method, tag = 2 * method + 1;
    const char *name = brink_method_rule(t->method)->name;
    if (!c->stopped) {
        fprintf(out,
                "set label %d '%s' at graph 1, first 10**(%.2f) offset 1,0 tc lt "
                "%d\n",
                tag, name, c->label, method + 1);
        return;
    }
    fprintf(out,
            "set label %d '' at %" PRIu64
            ", 10**(%.2f) point lt %d pt 2 ps 1.3 front\n",
            tag + 1, events, c->end, method + 1);
    fprintf(out,
            "set label %d '%s: %s' at %" PRIu64
            ", 10**(%.2f) offset 1.5,0 tc lt %d\n",
            tag, name, brink_findings_outcome(t).text, events, c->label,
            method + 1);
}

// Each wider than those before it, and drawn before them: none hides another.
// Points of size 1 are some nine times as wide as lines of width 1.
static void write_curve(FILE *out, const brink_case *c, const curve *of)
{
    char file[200];
    const int line = (int)of->trial->method + 1;
    const double width = 1.4 + 0.8 * line;
    brink_findings_file(c, of->trial->method, ".dat", file, sizeof file);
    fprintf(out, ", \\\n    '%s' using 1:($3 > 0 ? $3 : NaN) with linespoints ",
            file);
    fprintf(out, "lt %d lw %.1f pt 7 ps %.2f, ", line, width, width / 9);
    fprintf(
        out,
        "'' using 1:($3 > 0 ? NaN : 10**(%.2f)) with points lt %d pt 7 ps 0.3",
        of->lane, line);
}

char *brink_energy_plot(const brink_case *c)
{
    curve curves[BRINK_METHODS];
    char *script = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&script, &size);
    if (out == NULL)
        return NULL;
    for (int k = 0; k < BRINK_METHODS; k++)
        curves[k] =
            (curve){.trial = &c->trial[k], .stopped = is_stopped(&c->trial[k])};
    const double bottom = assign_lanes(curves);
    for (int k = 0; k < BRINK_METHODS; k++) {
        const double error = curves[k].trial->energy_error;
        curves[k].end = error > 0 ? log10(error) : curves[k].lane;
    }
    spread_labels(curves, 0);
    spread_labels(curves, 1);
    write_frame(out, c->events, bottom);
    for (int k = 0; k < BRINK_METHODS; k++)
        write_label(out, &curves[k]);
    fputs("plot NaN", out); // there may be no curve at all
    for (int k = BRINK_METHODS - 1; k >= 0; k--)
        if (curves[k].trial->events > 0)
            write_curve(out, c, &curves[k]);
    fputs("\n", out);
    return fclose(out) == 0 ? script : NULL;
}
