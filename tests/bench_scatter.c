// SPDX-License-Identifier: MIT
#include "bench_chart.h"
#include "bench_plots.h"
#include "bench_words.h"

static void write_axes(const chart *g, const contest *c)
{
    chart_write_frame(g, c->problem->measure[g->measure]);
    fprintf(g->out, "set lmargin 8\nset rmargin 28\nset yrange [10**%g:10**%g]\n",
            g->low, g->high);
    fprintf(g->out, "set ylabel 'cost, as a multiple of “%s”' offset 1,0\n",
            c->of[0].method->label);
    fprintf(g->out,
            "set ytics scale 1,0 ('1×' 1, '2×' 2, '5×' 5, '10×' 10, "
            "'100×' 100, '1000×' 1000, '10 000×' 1e4)\n"
            "set label 2 '↙ {/:Bold better}' at screen 0.012, 0.03 tc rgb "
            "'#0072b2' font ',15'\n"
            "set label 3 'cost, and how often wrong' at graph 1, graph 1.03 "
            "offset 0.5,0.3 tc rgb '#5b6575' font ',13'\n");
}

/** A cross in the column, and the name in the margin. */
static void write_wrong(const chart *g, const mark *m, int tag, double x)
{
    char rest[150];
    snprintf(rest, sizeof rest, "  %s×  %s", bench_ratio(m->of->ratio).text,
             bench_percent(m->share).text);
    chart_point(g, tag, x, m->cost, "pt 2 ps 0.9 lw 2", m->colour);
    chart_line(g, tag, x, m->cost, g->end, m->label, m->colour, "lw 0.7");
    chart_name(g, tag + 1, g->end, m->label, "offset 0.5,0", m, rest);
}

/** A dot, and the name above it: out of the way of others' lines. */
static void write_right(const chart *g, const mark *m, int tag, double x)
{
    char rest[100];
    const int has_room = x < g->right - 0.35 * (g->right - g->left);
    snprintf(rest, sizeof rest, "  %s×", bench_ratio(m->of->ratio).text);
    chart_point(g, tag, x, m->cost, "pt 7 ps 1.1", m->colour);
    chart_name(g, tag + 1, x, m->label,
               has_room ? "offset 0.9,0 front boxed"
                        : "offset -0.5,0 right front boxed",
               m, rest);
}

/** `place` of six is where in the column it stands, as several cost the same. */
static void write_mark(const chart *g, const mark *m, int tag, int place)
{
    const double column = g->right + (g->end - g->right) * (0.16 + 0.14 * place);
    const double begin = isinf(m->median) ? column : fmax(m->median, g->left);
    const double end = m->is_wrong ? column : fmax(m->max, begin);
    chart_line(g, tag, begin, m->cost, end, m->cost, m->colour,
               m->is_ours ? "lw 4 front" : "lw 1.6 back");
    chart_point(g, tag, begin, m->cost, "pt 7 ps 0.55", m->colour);
    if (m->is_wrong)
        write_wrong(g, m, tag + 1, end);
    else
        write_right(g, m, tag + 1, end);
}

char *bench_scatter(const contest *c, int measure)
{
    chart g;
    if (chart_make(&g, c, measure) == 0) {
        int wrong = 0;
        write_axes(&g, c);
        chart_spread(&g, 0, 1);
        chart_spread(&g, 1, 0);
        for (int k = 0; k < g.marks; k++) {
            write_mark(&g, &g.mark[k], 10 + 4 * k, wrong % 6);
            wrong += g.mark[k].is_wrong;
        }
        fprintf(g.out, "plot NaN\n");
    }
    return chart_end(&g);
}
