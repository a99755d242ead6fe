// SPDX-License-Identifier: MIT
#include "bench_chart.h"
#include "bench_plots.h"

/** Decades from one point of a curve to the next. */
static const double STEP = 0.05;

static double above(const chart *g, const mark *m, double x)
{
    return standing_above(m->of, g->measure, pow(10, x));
}

/** Errors are told apart up to 10^18 ulp: beyond, the exponent is wrong as
 * well. */
static void set_axes(chart *g, const contest *c)
{
    g->right = 18;
    g->end = 19.5;
    g->low = floor(log10(0.5 / c->of[0].all.n)); // one answer is above the ground
    g->high = 0;
    chart_write_frame(g, c->problem->measure[g->measure]);
    fprintf(g->out, "set lmargin 10\nset rmargin 23\nset yrange [10**%g:1]\n",
            g->low);
    fprintf(g->out, "set ylabel 'part of the answers with a larger error' offset "
                    "1,0\nset ytics scale 1,0 ('all' 1, '1 in 10' 0.1, '1 in "
                    "100' 0.01, '1 in 1000' 1e-3");
    for (int d = -4; d >= (int)g->low; d--)
        fprintf(g->out, ", '10^{%d}' 1e%d", d, d);
    fprintf(g->out, ")\n");
}

/** Until nothing is above; then down. */
static void write_curve(const chart *g, const mark *m, int k)
{
    double part = 1;
    fprintf(g->out, "$curve%d << E\n", k);
    for (double x = g->left; x <= g->end && part > 0; x += STEP) {
        part = above(g, m, x);
        fprintf(g->out, "%.6g %.6g\n", pow(10, x), fmax(part, pow(10, g->low)));
    }
    fprintf(g->out, "E\n");
}

/** Where a curve has come down to `level`. */
static double crossing(const chart *g, const mark *m, double level)
{
    double x = g->left;
    while (x < g->right && above(g, m, x) > pow(10, level))
        x += STEP;
    return x;
}

/** Names of the right ones stand in a column beside where most have fallen, each
 * with a line to its curve; those of the wrong ones where their curves end. */
static void write_names(chart *g)
{
    double column = 0, level = -1;
    for (int k = 0; k < g->marks; k++) {
        mark *m = &g->mark[k];
        if (!m->is_wrong && m->max < 1.5)
            column = fmax(column, m->max);
        m->cost = log10(fmax(m->share, pow(10, g->low)));
    }
    chart_spread(g, 1, 0);
    for (int k = 0; k < g->marks; k++) {
        const mark *m = &g->mark[k];
        if (m->is_wrong) {
            chart_name(g, 10 + k, g->end, m->label, "offset 0.8,0", m, "");
            continue;
        }
        const double at = crossing(g, m, level), x = fmax(at, column) + 0.4;
        chart_line(g, 10 + k, at, level, x, level, m->colour, "lw 0.7");
        chart_name(g, 10 + k, x, level, "offset 0.3,0 front boxed", m, "");
        level -= 0.4;
    }
}

char *bench_distribution(const contest *c, int measure)
{
    chart g;
    if (chart_make(&g, c, measure) == 0) {
        set_axes(&g, c);
        for (int k = 0; k < g.marks; k++) {
            g.mark[k].share = above(&g, &g.mark[k], g.end);
            write_curve(&g, &g.mark[k], k);
        }
        write_names(&g);
        fprintf(g.out, "plot NaN");
        for (int k = 0; k < g.marks; k++)
            fprintf(g.out, ", \\\n    $curve%d with lines lc rgb '%s' lw %s", k,
                    g.mark[k].colour, g.mark[k].is_ours ? "3.5" : "1.8");
        fprintf(g.out, "\n");
    }
    return chart_end(&g);
}
