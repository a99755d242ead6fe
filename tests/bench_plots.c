// SPDX-License-Identifier: MIT
#include "bench_plots.h"
#include "bench_words.h"
#include <float.h>
#include <stdio.h>
#include <stdlib.h>

// All positions are in decades.
#define LINE  0.042 // a line of text, as a part of the height
#define BAND  0.13  // the column for what is wrong, as a part of the width to its left
#define FRAME                                                                    \
    "set terminal svg size 860,540 dynamic enhanced font 'sans-serif,15' "       \
    "background '#ffffff'\nunset key\nset tmargin 3\n"                           \
    "set style textbox opaque noborder margins 0.3,0.1\n"
#define SMALL 1e-30  // for errors that are 0, and so far to the left

typedef struct mark {
    const standing *of;
    const char *colour;
    int is_ours, is_wrong;
    double share; // of what is wrong
    double cost, median, max; // decades
    double label;             // where its label stands
} mark;

typedef struct chart {
    FILE *out;
    int marks;
    mark *mark;
    double left, right; // of the errors; those that are smaller are drawn at the left
    double end;         // of the column for what is wrong, which begins at the right
    double low, high;
} chart;

/** Blue and green for brink, warm colours for formulas, greys for wider arithmetic. */
static const char *colour_of(const contest *c, int k)
{
    static const char *const formulas[] = {"#d55e00", "#e08a00", "#cc79a7"};
    static const char *const libraries[] = {"#a0522d", "#8a5a9e"};
    static const char *const wide[] = {"#9aa5b5", "#76818f", "#4b545f"};
    int nth = 0;
    for (int i = 0; i < k; i++)
        nth += c->of[i].method->rank == c->of[k].method->rank;
    switch (c->of[k].method->rank) {
    case RANK_FAST:
        return "#56b4e9";
    case RANK_PLAIN:
        return "#0072b2";
    case RANK_CR:
        return "#009e73";
    case RANK_FORMULA:
        return formulas[nth % 3];
    case RANK_LIBRARY:
        return libraries[nth % 2];
    case RANK_WIDE:
        return wide[nth % 3];
    default:
        return "#000000";
    }
}

/** A way's name, for gnuplot's enhanced text between single quotes. */
static brink_words name_of(const standing *s)
{
    brink_words w;
    size_t n = 0;
    for (const char *c = s->method->label; *c != '\0' && n < sizeof w.text - 3; c++) {
        if (*c == '\'')
            w.text[n++] = *c;
        else if (*c == '_')
            w.text[n++] = '\\';
        w.text[n++] = *c;
    }
    w.text[n] = '\0';
    return w;
}

static double decades(double x)
{
    return log10(fmax(x, SMALL));
}

static int chart_make(chart *g, const contest *c, int measure, char **script,
                      size_t *size)
{
    const int n = c->problem->methods;
    *g = (chart){.out = open_memstream(script, size),
                 .mark = calloc((size_t)n, sizeof(mark)),
                 .left = measure == 0 ? -1 : -2,
                 .right = 2,
                 .high = 1};
    for (int k = 0; g->mark != NULL && k < n; k++) {
        const standing *s = &c->of[k];
        if (s->method->rank == RANK_SIGN) // has no error
            continue;
        const double max = standing_max(s, measure);
        mark *m = &g->mark[g->marks++];
        *m = (mark){
            .of = s,
            .colour = colour_of(c, k),
            .is_ours = s->method->rank < RANK_FORMULA,
            .is_wrong = isinf(max) || (measure == 0 && measure_wrong(&s->all) > 0),
            .share = measure == 0 ? standing_wrong(s) : standing_above(s, measure, DBL_MAX),
            .cost = decades(s->ratio),
            .median = decades(measure_quantile(&s->all, measure, 0.5)),
            .max = decades(max),
        };
        if (!m->is_wrong)
            g->right = fmax(g->right, ceil(m->max + 0.2));
        if (isfinite(m->median))
            g->right = fmax(g->right, ceil(m->median + 0.2));
        g->low = fmin(g->low, m->cost);
        g->high = fmax(g->high, m->cost);
    }
    g->end = g->right + BAND * (g->right - g->left);
    g->low -= 0.25;
    g->high += 0.3;
    return g->out == NULL || g->mark == NULL ? -1 : 0;
}

static char *chart_end(chart *g, char **script)
{
    free(g->mark);
    if (g->out == NULL)
        return NULL;
    const int bad = ferror(g->out);
    if (fclose(g->out) != 0 || bad) {
        free(*script);
        return NULL;
    }
    return *script;
}

/** x axis in errors with the column of the wrong ones, and the half ulp. */
static void write_error_axis(const chart *g, const char *unit, int measure)
{
    FILE *out = g->out;
    fprintf(out, "set logscale xy\nset xrange [10**%g:10**%g]\n", g->left, g->end);
    fprintf(out, "set xtics scale 1,0 (");
    for (int d = (int)g->left; d < (int)g->right; d += d < 3 && g->right < 9 ? 1 : 3)
        if (d <= 3)
            fprintf(out, "'%g' 1e%d, ", pow(10, d), d);
        else
            fprintf(out, "'10^{%d}' 1e%d, ", d, d);
    fprintf(out, "'wrong' 10**%g)\n", (g->right + g->end) / 2);
    fprintf(out,
            "set object 1 rectangle from first 10**%g, graph 0 to first 10**%g, "
            "graph 1 behind fillcolor rgb '#f6eeee' fillstyle solid noborder\n",
            g->right, g->end);
    fprintf(out, "set xlabel 'error in %s'\n", unit);
    if (measure == 0)
        fprintf(out,
                "set arrow 1 from 0.5, graph 0 to 0.5, graph 1.02 nohead lc rgb "
                "'#5b6575' dt 3 lw 1.5\n"
                "set label 1 '½ ulp: nothing is nearer' at 0.5, graph 1.03 center offset "
                "0,0.3 tc rgb '#5b6575' font ',13'\n");
}

static int by_cost(const void *a, const void *b)
{
    const mark *const *x = a, *const *y = b;
    return ((*x)->cost > (*y)->cost) - ((*x)->cost < (*y)->cost);
}

/** Labels of the wrong, or of the right ones, no nearer to each other than a line.  Those
 * of the right ones stand above their marks, out of the way of others' lines. */
static void spread_labels(chart *g, int wrong)
{
    mark *column[64];
    int n = 0;
    const double line = LINE * (g->high - g->low);
    for (int k = 0; k < g->marks && n < 64; k++)
        if (g->mark[k].is_wrong == wrong)
            column[n++] = &g->mark[k];
    qsort(column, (size_t)n, sizeof *column, by_cost);
    for (int k = 0; k < n; k++)
        column[k]->label = fmax(column[k]->cost + (wrong ? 0 : 0.75 * line),
                                k > 0 ? column[k - 1]->label + line : -HUGE_VAL);
}

/** What stands in the column: a cross, and the name in the margin. */
static void write_wrong(const chart *g, const mark *m, int tag, double x)
{
    const standing *s = m->of;
    fprintf(g->out,
            "set label %d '' at 10**%.4f, 10**%.4f point pt 2 ps 0.9 lc rgb '%s' lw 2 "
            "front\n",
            tag, x, m->cost, m->colour);
    fprintf(g->out,
            "set arrow %d from 10**%.4f, 10**%.4f to 10**%.4f, 10**%.4f nohead lc rgb "
            "'%s' lw 0.7\n",
            tag, x, m->cost, g->end, m->label, m->colour);
    fprintf(g->out,
            "set label %d '%s%s  %s×%s  %s' at 10**%.4f, 10**%.4f offset 0.5,0 tc rgb '%s' "
            "font ',14'\n",
            tag + 1, m->is_ours ? "{/:Bold " : "", name_of(s).text,
            bench_ratio(s->ratio).text, m->is_ours ? "}" : "",
            bench_percent(m->share).text, g->end, m->label, m->colour);
}

static void write_right(const chart *g, const mark *m, int tag, double x)
{
    const standing *s = m->of;
    // Where there is no room to the right of it, it stands to the left.
    const int far = m->max > g->right - 0.35 * (g->right - g->left);
    fprintf(g->out,
            "set label %d '' at 10**%.4f, 10**%.4f point pt 7 ps 1.1 lc rgb '%s' "
            "front\n",
            tag, x, m->cost, m->colour);
    fprintf(g->out,
            "set label %d '%s%s  %s×%s' at 10**%.4f, 10**%.4f offset %s,0 %s tc rgb '%s' "
            "font ',14' front\n",
            tag + 1, m->is_ours ? "{/:Bold " : "", name_of(s).text,
            bench_ratio(s->ratio).text, m->is_ours ? "}" : "", x, m->label,
            far ? "-0.5" : "0.9", far ? "right" : "left", m->colour);
}

static void write_mark(const chart *g, const mark *m, int tag, int place)
{
    const double column = g->right + (g->end - g->right) * (0.16 + 0.14 * place);
    const double begin = isinf(m->median) ? column : fmax(m->median, g->left);
    const double end = m->is_wrong ? column : fmax(m->max, begin);
    fprintf(g->out,
            "set arrow %d from 10**%.4f, 10**%.4f to 10**%.4f, 10**%.4f nohead lc rgb "
            "'%s' lw %s %s\n",
            tag, begin, m->cost, end, m->cost, m->colour, m->is_ours ? "4" : "1.6",
            m->is_ours ? "front" : "back");
    fprintf(g->out,
            "set label %d '' at 10**%.4f, 10**%.4f point pt 7 ps 0.55 lc rgb '%s' "
            "front\n",
            tag, begin, m->cost, m->colour);
    if (m->is_wrong)
        write_wrong(g, m, tag + 1, end);
    else
        write_right(g, m, tag + 1, end);
}

char *bench_scatter(const contest *c, int measure)
{
    char *script = NULL;
    size_t size = 0;
    chart g;
    if (chart_make(&g, c, measure, &script, &size) == 0) {
        write_error_axis(&g, c->problem->measure[measure], measure);
        fprintf(g.out, FRAME "set lmargin 8\nset rmargin 28\n"
                       "set label 2 '↙ better' at screen 0.012, 0.035 tc rgb "
                       "'#5b6575' font ',13'\n");
        fprintf(g.out, "set label 3 'cost, and part wrong' at graph 1, graph 1.03 offset "
                       "0.5,0.3 tc rgb '#5b6575' font ',13'\n");
        fprintf(g.out, "set ylabel 'cost, as a multiple of “%s”' offset 1,0\n",
                name_of(&c->of[0]).text);
        fprintf(g.out, "set yrange [10**%g:10**%g]\n", g.low, g.high);
        fprintf(g.out, "set ytics scale 1,0 ('1×' 1, '2×' 2, '5×' 5, '10×' 10, '100×' "
                       "100, '1000×' 1000, '10 000×' 1e4, '100 000×' 1e5)\n");
        spread_labels(&g, 0);
        spread_labels(&g, 1);
        int wrong = 0;
        for (int k = 0; k < g.marks; k++) {
            write_mark(&g, &g.mark[k], 10 + 4 * k, wrong % 6);
            wrong += g.mark[k].is_wrong;
        }
        fprintf(g.out, "plot NaN\n");
    }
    return chart_end(&g, &script);
}

// --- Distributions -------------------------------------------------------------------

/** A curve a twentieth of a decade at a time, until nothing is above; then down. */
static void write_curve(const chart *g, const mark *m, int k, int measure,
                        double bottom)
{
    fprintf(g->out, "$d%d << E\n", k);
    for (double x = g->left; x <= g->end; x += 0.05) {
        const double above = standing_above(m->of, measure, pow(10, x));
        fprintf(g->out, "%.6g %.6g\n", pow(10, x), fmax(above, bottom));
        if (above == 0)
            break;
    }
    fprintf(g->out, "E\n");
}

/** Where a curve has come down to `level`. */
static double crossing(const chart *g, const mark *m, int measure, double level)
{
    double x = g->left;
    while (x < g->right && standing_above(m->of, measure, pow(10, x)) > level)
        x += 0.05;
    return x;
}

/** The names of those that were wrong stand where their curves end, in the margin. */
static void write_margin_label(const chart *g, const mark *m, int tag)
{
    fprintf(g->out,
            "set label %d '%s%s%s' at graph 1, first 10**%.4f offset 0.8,0 tc rgb '%s' "
            "font ',14'\n",
            tag, m->is_ours ? "{/:Bold " : "", name_of(m->of).text,
            m->is_ours ? "}" : "", m->label, m->colour);
}

/** The others' in a column beside where they fall, each with a line to its curve. */
static void write_curve_label(const chart *g, const mark *m, int tag, int nth,
                              int measure, double column)
{
    const double level = -1 - 0.4 * nth, at = crossing(g, m, measure, pow(10, level));
    const double x = fmax(at, column) + 0.4;
    fprintf(g->out,
            "set arrow %d from 10**%.4f, 10**%.4f to 10**%.4f, 10**%.4f nohead lc rgb "
            "'%s' lw 0.7\n",
            tag, at, level, x, level, m->colour);
    fprintf(g->out,
            "set label %d '%s%s%s' at 10**%.4f, 10**%.4f offset 0.3,0 tc rgb '%s' font "
            "',14' front boxed\n",
            tag, m->is_ours ? "{/:Bold " : "", name_of(m->of).text,
            m->is_ours ? "}" : "", x, level, m->colour);
}

char *bench_distribution(const contest *c, int measure)
{
    char *script = NULL;
    size_t size = 0;
    chart g;
    if (chart_make(&g, c, measure, &script, &size) == 0) {
        const int n = c->of[0].all.n;
        g.right = 18;
        g.end = g.right + BAND / 2 * (g.right - g.left);
        g.low = floor(log10(0.5 / n));
        g.high = 0;
        write_error_axis(&g, c->problem->measure[measure], measure);
        fprintf(g.out, FRAME "set lmargin 10\nset rmargin 23\n"
                       "set ylabel 'part of the answers with a larger error' offset 1,0\n"
                       "set yrange [10**%g:1]\nset format y '10^{%%T}'\n"
                       "set ytics scale 1,0 ('all' 1, '1 in 10' 0.1, '1 in 100' 0.01, "
                       "'1 in 1000' 1e-3, '10^{-4}' 1e-4, '10^{-5}' 1e-5, '10^{-6}' "
                       "1e-6)\n",
                g.low);
        int right = 0;
        double column = 0; // where those that are not far off have fallen
        for (int k = 0; k < g.marks; k++) {
            if (!g.mark[k].is_wrong && g.mark[k].max < 1.5)
                column = fmax(column, g.mark[k].max);
            g.mark[k].cost = decades(standing_above(g.mark[k].of, measure, 1e19));
        }
        spread_labels(&g, 1);
        for (int k = 0; k < g.marks; k++) {
            write_curve(&g, &g.mark[k], k, measure, pow(10, g.low));
            if (g.mark[k].is_wrong)
                write_margin_label(&g, &g.mark[k], 10 + k);
            else
                write_curve_label(&g, &g.mark[k], 10 + k, right++, measure, column);
        }
        fprintf(g.out, "plot NaN");
        for (int k = 0; k < g.marks; k++)
            fprintf(g.out, ", \\\n    $d%d with lines lc rgb '%s' lw %s", k,
                    g.mark[k].colour, g.mark[k].is_ours ? "3.5" : "1.8");
        fprintf(g.out, "\n");
    }
    return chart_end(&g, &script);
}
