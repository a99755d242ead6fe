// SPDX-License-Identifier: MIT
#include "session_page.h"
#include "observe_figures.h"
#include "report.h"
#include "session_files.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

#define PLUS_MINUS "\xc2\xb1"

/** Writes what was observed, as a table or as a plot's script. */
typedef void writer(FILE *out, const brink_record *record, const brink_system *s);

static int write_table(const char *dir, const char *name, writer *table,
                       const brink_record *record, const brink_system *s)
{
    FILE *out = brink_files_begin(dir, name);
    if (!out)
        return -1;
    table(out, record, s);
    return brink_files_end(out, dir, name, ferror(out));
}

static void table_speeds(FILE *out, const brink_record *record,
                         const brink_system *s)
{
    (void)s;
    brink_figures_speeds(out, record);
}

static int write_tables(const char *dir, const brink_record *record,
                        const brink_system *s)
{
    const brink_wish *w = &record->wish;
    if (w->distance_bins > 0 &&
        write_table(dir, "distances.dat", brink_figures_distances, record, s))
        return -1;
    if (w->lags > 0 && write_table(dir, "displacements.dat",
                                   brink_figures_displacements, record, s))
        return -1;
    return w->speeds ? write_table(dir, "speeds.dat", table_speeds, record, s)
                     : 0;
}

static void put_number(brink_report *page, const char *before, int digits,
                       double x)
{
    if (isfinite(x))
        brink_report_cell(page, "%s%.*g", before, digits, x);
    else
        brink_report_cell(page, "not yet");
}

static void put_row(brink_report *page, const char *what, const char *unit,
                    brink_figure f)
{
    brink_report_cell(page, "%s", what);
    put_number(page, "", 7, f.mean);
    put_number(page, PLUS_MINUS " ", 1, f.error);
    brink_report_cell(page, "%s", unit);
}

static void put_averages(brink_report *page, const brink_record *record,
                         const brink_system *s)
{
    static const char *const head[] = {"", "mean", "error", "in units of"};
    brink_report_table(page, "Averages and their standard errors", 4, "lrrl",
                       head);
    put_row(page, "pressure", "energy / length^d",
            brink_figures_of(&record->pressure));
    put_row(page, "temperature k_B T", "energy",
            brink_figures_of(&record->temperature));
    put_row(page, "potential energy of a particle", "energy",
            brink_figures_of(&record->energy));
    put_row(page, "mean free time", "time", brink_figures_free_time(record));
    for (int k = 0; k < s->species_count && record->wish.lags > 0; k++) {
        char what[100];
        snprintf(what, sizeof what, "diffusion coefficient of %s",
                 s->species[k].name);
        put_row(page, what, "length^2 / time",
                brink_figures_diffusion(record, k));
    }
    brink_report_table_end(page);
}

static void put_plot(brink_report *page, const char *name, const char *caption,
                     writer *plot, const brink_record *record,
                     const brink_system *s)
{
    char *script = NULL;
    size_t size;
    FILE *out = open_memstream(&script, &size);
    if (!out)
        return;
    plot(out, record, s);
    fclose(out);
    if (script)
        brink_report_figure(page, name, caption, script);
    free(script);
}

// Bars of one error either way: the errors stand in the column behind `column`.
static void put_bars(FILE *out, int column, int line)
{
    fprintf(out,
            ", '' using 1:($%d-$%d):(0):(2*$%d) with vectors nohead lt %d lw 1.2 "
            "notitle",
            column, column + 1, column + 1, line);
}

static void plot_distances(FILE *out, const brink_record *record,
                           const brink_system *s)
{
    fprintf(
        out,
        "set xlabel 'distance r'\nset ylabel 'g(r)'\nset yrange [0:*]\n"
        "set xrange [0:%.9g]\nset key %s\nset arrow from 0,1 to %.9g,1 nohead "
        "lt 100 lw 2\nplot ",
        record->distances.most, s->species_count > 1 ? "top right" : "off",
        record->distances.most);
    for (int b = 0, kind = 0; b < s->species_count; b++)
        for (int a = 0; a <= b; a++, kind++) {
            fprintf(out,
                    "%s'distances.dat' using 1:%d with histeps lt %d lw 1.5 "
                    "title '%s-%s'",
                    kind > 0 ? ", " : "", 2 * kind + 2, kind % 8 + 1,
                    s->species[a].name, s->species[b].name);
            put_bars(out, 2 * kind + 2, kind % 8 + 1);
        }
    fputs("\n", out);
}

static void plot_displacements(FILE *out, const brink_record *record,
                               const brink_system *s)
{
    fprintf(out, "set xlabel 'time'\nset ylabel 'mean squared displacement'\n"
                 "set logscale xy\nset key top left\n"
                 "set format x '10^{%%T}'\nset format y '10^{%%T}'\nplot ");
    for (int k = 0; k < s->species_count; k++) {
        const char *name = s->species[k].name;
        const brink_figure d = brink_figures_diffusion(record, k);
        fprintf(out,
                "%s'displacements.dat' using 1:%d with points lt %d title '%s'",
                k > 0 ? ", " : "", 2 * k + 2, k % 8 + 1, name);
        put_bars(out, 2 * k + 2, k % 8 + 1);
        if (d.mean > 0)
            fprintf(out,
                    ", %.9g * x with lines lt %d lw 1.5 dt 2 title "
                    "'%d D t, D = %.4g'",
                    2 * s->dimensions * d.mean, k % 8 + 1, 2 * s->dimensions,
                    d.mean);
    }
    fputs("\n", out);
}

// Maxwell's speeds at the temperature measured, in units of that at the start.
static void plot_speeds(FILE *out, const brink_record *record,
                        const brink_system *s)
{
    const double hotter =
        brink_series_mean(&record->temperature) / record->thermal;
    fprintf(out,
            "set xlabel 'speed in sqrt(k_BT/m) of the start'\n"
            "set ylabel 'density'\nset xrange [0:5]\nset samples 400\n"
            "T = %.9g\nmaxwell(u) = %s * exp(-u**2 / (2*T))\n"
            "plot maxwell(x) with lines lt 2 lw 1.5 title 'Maxwell', "
            "'speeds.dat' using 1:2 with points lt 1 title 'observed'",
            hotter, s->dimensions == 3 ? "sqrt(2/pi) * u**2 / T**1.5" : "u / T");
    put_bars(out, 2, 1);
    fputs("\n", out);
}

int brink_page_write(const char *dir, const char *title,
                     const brink_record *record, const brink_run *run)
{
    const brink_system *s = &run->system;
    const brink_wish *w = &record->wish;
    const char *heading = *title ? title : "What was observed";
    brink_report page;
    if (write_tables(dir, record, s))
        return -1;
    brink_report_open_page(&page, dir, "observed", heading);
    brink_report_heading(&page, 1, "%s", heading);
    brink_report_paragraph(
        &page,
        "%" PRIu32 " particles, %" PRIu64
        " samples from time %g on, one every %g. "
        "Errors are one standard deviation, by block averages (Flyvbjerg and "
        "Petersen 1989), the largest that blocks of any length give of which "
        "there "
        "are %d or more.",
        s->count, record->samples, w->from, w->every, BRINK_SERIES_BLOCKS);
    put_averages(&page, record, s);
    if (w->lags > 0 && !brink_displacements_trusted(&record->displacements))
        brink_report_finding(
            &page,
            "Between two samples a particle got %.2g of the way round the box: "
            "too "
            "far to be sure that it did not get round. Displacements are not "
            "answered for; take a shorter `every`.",
            record->displacements.farthest);
    if (record->samples >= BRINK_SERIES_BLOCKS && w->distance_bins > 0)
        put_plot(&page, "distances",
                 "How many pairs are at a distance, to how many there would be "
                 "without interaction.",
                 plot_distances, record, s);
    if (w->lags > 0 && brink_displacements_trusted(&record->displacements) &&
        record->displacements.looks > (uint64_t)w->lags * BRINK_SERIES_BLOCKS)
        put_plot(
            &page, "displacements",
            "How far particles get: first in straight lines, as t^2, and when "
            "they have forgotten their velocity, by diffusion, as t. D is the "
            "slope over the second half: it holds if the points run along their "
            "line there.",
            plot_displacements, record, s);
    if (record->samples >= BRINK_SERIES_BLOCKS && w->speeds)
        put_plot(&page, "speeds", "The speeds of all particles.", plot_speeds,
                 record, s);
    brink_report_close(&page, stderr);
    return 0;
}
