// SPDX-License-Identifier: MIT
#include "bench_chart.h"
#include <float.h>
#include <stdlib.h>
#include <string.h>

/** A line of text, as a part of the height. */
static const double TEXT = 0.035;

/** The column for what is wrong, as a part of the width to its left. */
static const double COLUMN = 0.13;

/** Stands for an error of 0 where a logarithm is taken: far to the left. */
static const double NOTHING = 1e-30;

#define SOFT "tc rgb '#5b6575' font ',13'"

/** Blue and green for brink, warm colours for formulas, greys for wider
 * arithmetic. */
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

static double decades(double x)
{
    return log10(fmax(x, NOTHING));
}

static void mark_make(mark *m, const contest *c, int k, int measure)
{
    const standing *s = &c->of[k];
    const double max = standing_max(s, measure);
    *m = (mark){
        .of = s,
        .colour = colour_of(c, k),
        .is_ours = s->method->rank <= RANK_SIGN,
        .is_wrong = isinf(max) || (measure == 0 && measure_wrong(&s->all) > 0),
        .share = measure == 0 ? standing_wrong(s)
                              : standing_above(s, measure, DBL_MAX),
        .cost = decades(s->ratio),
        .median = decades(measure_quantile(&s->all, measure, 0.5)),
        .max = decades(max),
    };
}

int chart_make(chart *g, const contest *c, int measure)
{
    const int methods = c->problem->methods;
    *g = (chart){.measure = measure,
                 .mark = calloc((size_t)methods, sizeof(mark)),
                 .left = measure == 0 ? -1 : -2,
                 .right = 2,
                 .high = 1};
    g->out = open_memstream(&g->script, &g->size);
    for (int k = 0; g->mark != NULL && k < methods; k++) {
        mark *m = &g->mark[g->marks];
        if (rank_is_sign(c->of[k].method->rank)) // has no error
            continue;
        mark_make(m, c, k, measure);
        if (!m->is_wrong)
            g->right = fmax(g->right, ceil(m->max + 0.2));
        if (isfinite(m->median))
            g->right = fmax(g->right, ceil(m->median + 0.2));
        g->low = fmin(g->low, m->cost);
        g->high = fmax(g->high, m->cost);
        g->marks++;
    }
    g->end = g->right + COLUMN * (g->right - g->left);
    g->low -= 0.25;
    g->high += 0.3;
    return g->out == NULL || g->mark == NULL ? -1 : 0;
}

char *chart_end(chart *g)
{
    free(g->mark);
    if (g->out == NULL)
        return NULL;
    const int bad = ferror(g->out);
    if (fclose(g->out) != 0 || bad) {
        free(g->script);
        return NULL;
    }
    return g->script;
}

void chart_write_frame(const chart *g, const char *unit)
{
    fprintf(g->out, "set terminal svg size 860,620 dynamic enhanced font "
                    "'sans-serif,15' background '#ffffff'\n"
                    "set style textbox opaque noborder margins 0.3,0.1\n"
                    "unset key\nset tmargin 3\nset logscale xy\n");
    const int is_ulp = strcmp(unit, "ulp") == 0; // of the answer itself
    fprintf(g->out, "set xrange [10**%g:10**%g]\nset xlabel 'error in %s%s'\n",
            g->left, g->end, unit,
            is_ulp ? ", units in the last of a double’s 16 digits" : "");
    fprintf(g->out, "set xtics scale 1,0 (");
    const int is_wide = g->right - g->left > 9;
    for (int d = is_wide ? 0 : (int)g->left; d < g->right; d += is_wide ? 3 : 1)
        if (d <= 3)
            fprintf(g->out, "'%g' 1e%d, ", pow(10, d), d);
        else
            fprintf(g->out, "'10^{%d}' 1e%d, ", d, d);
    fprintf(g->out, "'wrong' 10**%g)\n", (g->right + g->end) / 2);
    fprintf(g->out,
            "set object 1 rectangle from first 10**%g, graph 0 to first 10**%g, "
            "graph 1 behind fillcolor rgb '#f6eeee' fillstyle solid noborder\n",
            g->right, g->end);
    if (is_ulp)
        fprintf(g->out, "set arrow 1 from 0.5, graph 0 to 0.5, graph 1.02 nohead "
                        "lc rgb '#5b6575' dt 3 lw 1.5\n"
                        "set label 1 '½ ulp: nothing is nearer' at 0.5, graph "
                        "1.03 center offset 0,0.3 " SOFT "\n");
}

static int by_cost(const void *a, const void *b)
{
    const mark *const *x = a, *const *y = b;
    return ((*x)->cost > (*y)->cost) - ((*x)->cost < (*y)->cost);
}

void chart_spread(chart *g, int wrong, double raise)
{
    mark **column = calloc((size_t)g->marks, sizeof *column);
    int n = 0;
    const double line = TEXT * (g->high - g->low);
    for (int k = 0; column != NULL && k < g->marks; k++)
        if (g->mark[k].is_wrong == wrong)
            column[n++] = &g->mark[k];
    if (n > 0)
        qsort(column, (size_t)n, sizeof *column, by_cost);
    for (int k = 0; k < n; k++)
        column[k]->label = fmax(column[k]->cost + raise * line,
                                k > 0 ? column[k - 1]->label + line : -HUGE_VAL);
    free(column);
}

void chart_line(const chart *g, int tag, double x, double y, double to_x,
                double to_y, const char *colour, const char *how)
{
    fprintf(g->out, "set arrow %d from 10**%.4f, 10**%.4f to 10**%.4f, 10**%.4f ",
            tag, x, y, to_x, to_y);
    fprintf(g->out, "nohead lc rgb '%s' %s\n", colour, how);
}

void chart_point(const chart *g, int tag, double x, double y, const char *how,
                 const char *colour)
{
    fprintf(g->out, "set label %d '' at 10**%.4f, 10**%.4f point %s ", tag, x, y,
            how);
    fprintf(g->out, "lc rgb '%s' front\n", colour);
}

void chart_name(const chart *g, int tag, double x, double y, const char *how,
                const mark *m, const char *rest)
{
    fprintf(g->out, "set label %d '%s", tag, m->is_ours ? "{/:Bold " : "");
    for (const char *c = m->of->method->label; *c != '\0'; c++)
        if (*c == '\'') // as enhanced text between single quotes wants it
            fprintf(g->out, "''");
        else if (*c == '_')
            fprintf(g->out, "\\_");
        else
            fputc(*c, g->out);
    fprintf(g->out, "%s%s' at 10**%.4f, 10**%.4f ", m->is_ours ? "}" : "", rest,
            x, y);
    fprintf(g->out, "tc rgb '%s' font ',15' %s\n", m->colour, how);
}
