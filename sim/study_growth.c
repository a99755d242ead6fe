// SPDX-License-Identifier: MIT
#include "study_growth.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

// Sums for a straight line through points (x, y) by least squares.
typedef struct line {
    double n, x, y, xx, xy, yy;
} line;

static void add_point(line *l, double x, double y)
{
    l->n++;
    l->x += x;
    l->y += y;
    l->xx += x * x;
    l->xy += x * y;
    l->yy += y * y;
}

// Its slope and the standard error of that.
static void fit(const line *l, double *slope, double *error)
{
    const double sxx = l->xx - l->x * l->x / l->n;
    const double sxy = l->xy - l->x * l->y / l->n;
    const double syy = l->yy - l->y * l->y / l->n;
    *slope = *error = (double)NAN;
    if (l->n < 3 || !(sxx > 0))
        return;
    *slope = sxy / sxx;
    *error = sqrt(fmax(0, syy - *slope * sxy) / (l->n - 2) / sxx);
}

brink_growth brink_growth_of(const brink_trial *t)
{
    brink_growth g = {0};
    line l = {0};
    double squares = 0;
    uint64_t events = 0;
    for (int k = 0; k < t->samples; k++) {
        const brink_sample *s = &t->sample[k];
        const double gain = s->kept - g.end, in = (double)(s->events - events);
        g.end = s->kept;
        events = s->events;
        squares += in > 0 ? gain * gain / in : 0;
        if (in > 0 && fabs(gain) > 0)
            add_point(&l, log(in), log(fabs(gain)));
    }
    g.walk = t->samples > 0 ? sqrt(squares / t->samples) : 0;
    fit(&l, &g.exponent, &g.error);
    return g;
}

static const char growth_caption[] =
    "How far the energy is off with logical states, now as the states have it: "
    "kinetic energy and counted levels, summed to some thirty digits, for in "
    "sixteen the whole sum would round away what a single event loses. What the "
    "roundings of an event take is put down and paid at the next one, so nothing "
    "adds up; the line is how far a random walk with such steps would come, with "
    "the square root of the number of events.";

static char *draw(const brink_case *c, const brink_growth *g)
{
    const brink_trial *t = &c->trial[BRINK_METHOD_LOGICAL];
    char *script = NULL, file[200];
    size_t size = 0;
    FILE *out = open_memstream(&script, &size);
    if (out == NULL)
        return NULL;
    brink_findings_file(c, BRINK_METHOD_LOGICAL, ".dat", file, sizeof file);
    fprintf(out, "set logscale xy\nset xrange [1:%" PRIu64 "]\n", t->events + 1);
    fputs("set format x '10^{%T}'\nset format y '10^{%T}'\n"
          "set xlabel 'events'\nset ylabel 'relative energy error' offset 1,0\n"
          "set lmargin 13\nset key left top\n",
          out);
    fprintf(out,
            "plot '%s' using 1:(abs($5) > 0 ? abs($5) : NaN) with linespoints "
            "lt 1 pt 7 ps 0.4 title '%s', \\\n     %.6g * sqrt(x) lt 2 lw 2 "
            "title 'random walk'\n",
            file, c->name, g->walk);
    return fclose(out) == 0 ? script : NULL;
}

static void tell_exponent(brink_report *r, const brink_growth *g)
{
    if (isnan(g->exponent)) {
        brink_report_paragraph(r, "That is too little to fit an exponent to.");
        return;
    }
    brink_report_paragraph(
        r,
        "Between two sample points it gains or loses what goes with the number "
        "of events there to the power of %.3f ± %.3f, fitted by least squares to "
        "logarithms; of a steady drift that is 1, of a random walk 1/2, of what "
        "does not add up 0.",
        g->exponent, g->error);
}

void brink_growth_tell(brink_report *r, const brink_case *c)
{
    const brink_trial *t = &c->trial[BRINK_METHOD_LOGICAL];
    const brink_growth g = brink_growth_of(t);
    char name[80];
    brink_report_heading(r, 3, "How energy strays");
    if (!(g.walk > 0)) {
        brink_report_paragraph(r, "With logical states it did not, at all.");
        return;
    }
    snprintf(name, sizeof name, "%s-growth", c->name);
    char *script = draw(c, &g);
    if (script != NULL)
        brink_report_figure(r, name, growth_caption, script);
    free(script);
    brink_report_paragraph(r,
                           "After %s events the energy was off by %s of "
                           "itself.",
                           brink_words_grouped(t->events).text,
                           brink_words_scientific(fabs(g.end)).text);
    tell_exponent(r, &g);
}
