// SPDX-License-Identifier: MIT
#include "bench_simulator.h"
#include "bench_curves.h"
#include "bench_made.h"
#include "bench_profile.h"
#include "bench_races.h"
#include "bench_words.h"
#include "report.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

// --- Numbers -------------------------------------------------------------------

/** A count, to three digits; a blank for 0 or NaN. */
static void put_count(brink_report *r, double x)
{
    if (!(x > 0)) {
        brink_report_cell(r, " ");
        return;
    }
    const double unit = pow(10, fmax(0, floor(log10(x)) - 2));
    brink_report_cell(
        r, "%s", brink_words_grouped((uint64_t)(round(x / unit) * unit)).text);
}

static void put_ratio(brink_report *r, double x)
{
    brink_report_cell(r, "%s", isnan(x) ? " " : bench_ratio(x).text);
}

static void put_pair(brink_report *r, const double x[RACERS])
{
    for (int who = 0; who < RACERS; who++)
        if (isnan(x[who]))
            brink_report_cell(r, " ");
        else
            brink_report_cell(r, x[who] < 10 ? "%.2f" : "%.0f", x[who]);
}

static brink_words particles(const race_result *of)
{
    return brink_words_grouped(race_particles(&of->course));
}

// --- The systems ---------------------------------------------------------------

static void write_rates(brink_report *r, const bench_races *races)
{
    static const char *const head[] = {"",      "particles", "brink",  "plain",
                                       "ratio", "lowest",    "highest"};
    brink_report_table(
        r,
        "Events a second of processor time, and their ratio: medians "
        "of five pieces; the lowest and the highest ratio of a piece.",
        7, "lrrrrrr", head);
    for (int k = 0; k < COURSES; k++) {
        const bench_course *c = &bench_courses[k];
        const race_result *result = bench_race_over(races, c->course);
        brink_report_cell(r, "%s", c->name);
        brink_report_cell(r, "%s", particles(result).text);
        for (int who = 0; who < RACERS; who++)
            put_count(r, result->rate[who]);
        put_ratio(r, result->ratio);
        put_ratio(r, result->least);
        put_ratio(r, result->most);
    }
    brink_report_table_end(r);
}

/** Of whole systems, whatever the most particles are here. */
static void write_elsewhere(brink_report *r)
{
    static const char *const head[] = {"", "particles", "asked of brink",
                                       "DynamO", "Smallenburg"};
    brink_report_table(
        r,
        "The same on another machine, a quiet Zen 4, not on this one: "
        "what was asked of brink there, and what two other programs "
        "were measured to do there, Smallenburg's in the better of "
        "its variants.",
        5, "lrrrr", head);
    for (int k = 0; k < COURSES; k++) {
        const bench_course *c = &bench_courses[k];
        brink_report_cell(r, "%s", c->name);
        brink_report_cell(r, "%s",
                          brink_words_grouped(race_particles(&c->course)).text);
        put_count(r, c->asked);
        put_count(r, c->dynamo);
        put_count(r, c->smallenburg);
    }
    brink_report_table_end(r);
}

static void write_counts(brink_report *r, const bench_races *races,
                         const char *counts)
{
    static const char *const head[] = {
        "",      "instr., brink",    "plain", "ratio", "predictions, brink",
        "plain", "crossings, brink", "plain"};
    brink_report_table(
        r,
        "What an event takes: instructions, predictions of a pair at "
        "a step, crossings of a cell's wall.",
        8, "lrrrrrrr", head);
    for (int k = 0; k < COURSES; k++) {
        bench_profile p;
        bench_profile_read(counts, bench_courses[k].key, &p);
        const race_result *result =
            bench_race_over(races, bench_courses[k].course);
        brink_report_cell(r, "%s", bench_courses[k].name);
        for (int who = 0; who < RACERS; who++)
            put_count(r, p.instructions[who]);
        put_ratio(r, p.instructions[RACE_BRINK] / p.instructions[RACE_PLAIN]);
        put_pair(r, p.pairs);
        put_pair(r, result->crossings);
    }
    brink_report_table_end(r);
}

static void write_profile(brink_report *r, const bench_course *c,
                          const char *counts)
{
    static const char *const head[] = {"function", "share", "in"};
    bench_profile p;
    char caption[300];
    bench_profile_read(counts, c->key, &p);
    if (p.costs == 0)
        return;
    snprintf(caption, sizeof caption,
             "brink, %s: the functions with most instructions of their own.",
             c->name);
    brink_report_table(r, caption, 3, "lrl", head);
    for (int k = 0; k < p.costs; k++) {
        brink_report_cell(r, "%s", p.cost[k].function);
        brink_report_cell(r, "%.1f %%", p.cost[k].percent);
        brink_report_cell(r, "%s",
                          strcmp(p.cost[k].file, "-") ? p.cost[k].file : " ");
    }
    brink_report_table_end(r);
}

static void write_systems(brink_report *r, const bench_races *races,
                          const char *counts)
{
    brink_report_heading(r, 2, "Systems that were asked for");
    write_rates(r, races);
    write_elsewhere(r);
    write_counts(r, races, counts);
    brink_report_paragraph(
        r,
        "Instructions are callgrind's, over %s events of systems that have "
        "settled, on the path it can run: AVX2, not AVX-512. They leave out what "
        "waiting for memory costs, and a vector's instruction counts as one. "
        "A system of a million particles is not counted: it would take too long.",
        brink_words_grouped(RACE_COUNTED).text);
    brink_report_heading(r, 2, "Where brink's instructions go");
    for (int k = 0; k < COURSES; k++)
        if (bench_courses[k].is_profiled)
            write_profile(r, &bench_courses[k], counts);
    brink_report_paragraph(
        r, "Functions as the compiler left them: what it has built into another "
           "counts as that other's.");
}

// --- Size, memory, density -----------------------------------------------------

static void draw(brink_report *r, const char *name, const char *caption,
                 const char *axis, int count, const double *x,
                 const race_result *const *results)
{
    char *script = bench_curves(axis, count, x, results);
    if (script != NULL)
        brink_report_figure(r, name, caption, script);
    free(script);
}

static void write_costs(brink_report *r, const char *first, const char *caption,
                        int count, const race_result *const *results)
{
    const char *const head[] = {
        first, "brink", "plain", "ratio", "crossings, brink", "plain"};
    brink_report_table(r, caption, 6, "rrrrrr", head);
    for (int k = 0; k < count; k++) {
        const race_result *result = results[k];
        if (count == SIZES)
            brink_report_cell(r, "%s", particles(result).text);
        else
            brink_report_cell(r, "%.4g", race_packing(&result->course));
        for (enum racer who = 0; who < RACERS; who++)
            put_count(r, race_ns(result, who));
        put_ratio(r, result->ratio);
        put_pair(r, result->crossings);
    }
    brink_report_table_end(r);
}

static void write_sizes(brink_report *r, const bench_races *races)
{
    const race_result *results[SIZES];
    double x[SIZES];
    for (int k = 0; k < SIZES; k++) {
        results[k] = bench_race_over(races, bench_size(k));
        x[k] = race_particles(&results[k]->course);
    }
    brink_report_heading(r, 2, "Cost against size");
    draw(
        r, "simulator-size",
        "Hard spheres at packing 0.45. With more particles the work for an event "
        "is "
        "the same; that it costs more is because they no longer fit into caches.",
        "set xrange [300:2e6]\nset xlabel 'particles'\nset xtics scale 1,0 "
        "('1 000' 1e3, '10 000' 1e4, '100 000' 1e5, '1 000 000' 1e6)\n",
        SIZES, x, results);
    write_costs(r, "particles", "Nanoseconds of processor time an event.", SIZES,
                results);
}

static void write_densities(brink_report *r, const bench_races *races)
{
    const race_result *results[DENSITIES];
    double x[DENSITIES];
    for (int k = 0; k < DENSITIES; k++) {
        results[k] = bench_race_over(races, bench_density(k));
        x[k] = race_packing(&results[k]->course);
    }
    brink_report_heading(r, 2, "Cost against density");
    draw(
        r, "simulator-density",
        "Hard spheres, from a gas to where they freeze. A dilute particle "
        "crosses "
        "many cells from one event to the next; a dense one has many neighbours.",
        "set xrange [3e-4:1]\nset xlabel 'packing fraction'\nset xtics scale 1,0 "
        "('0.001' 1e-3, '0.01' 0.01, '0.1' 0.1, '0.5' 0.5)\n",
        DENSITIES, x, results);
    write_costs(r, "packing", "Nanoseconds of processor time an event.",
                DENSITIES, results);
}

static void write_memory_of(brink_report *r, const char *what,
                            const race_result *of, double asked)
{
    brink_report_cell(r, "%s", what);
    brink_report_cell(r, "%s", particles(of).text);
    brink_report_cell(r, of->captured > 0 ? "%.1f" : " ", of->captured);
    for (int who = 0; who < RACERS; who++)
        put_count(r, of->bytes[who]);
    put_count(r, asked);
}

static void write_memory(brink_report *r, const bench_races *races)
{
    static const char *const head[] = {"",      "particles", "partners",
                                       "brink", "plain",     "asked"};
    brink_report_heading(r, 2, "Memory");
    brink_report_table(
        r,
        "Bytes a particle, as malloc gives them out, after the race; "
        "what was asked is: at most.",
        6, "lrrrrr", head);
    for (int k = 0; k < SIZES; k++)
        write_memory_of(r, "hard spheres, packing 0.45",
                        bench_race_over(races, bench_size(k)), 300);
    write_memory_of(r, "square well, λ = 1.75, density 0.5",
                    bench_race_over(races, bench_well_12), 600);
    brink_report_table_end(r);
}

// --- The page ------------------------------------------------------------------

static void write_findings(brink_report *r, const bench_races *races)
{
    double least = (double)INFINITY, most = 0;
    for (int k = 0; k < COURSES; k++) {
        const double ratio =
            bench_race_over(races, bench_courses[k].course)->ratio;
        least = fmin(least, ratio);
        most = fmax(most, ratio);
    }
    brink_report_finding(r,
                         "In a second of processor time brink executes %s to %s "
                         "times as many events "
                         "as the plain simulator.",
                         bench_ratio(least).text, bench_ratio(most).text);
    const race_result *first = bench_race_over(races, bench_size(0)),
                      *last = bench_race_over(races, bench_size(SIZES - 1));
    brink_report_finding(
        r,
        "From %s to %s particles, what an event costs differs by a factor of %s; "
        "asked was less than 2.5. The plain simulator's differs by %s.",
        particles(first).text, particles(last).text,
        bench_ratio(bench_size_spread(races, RACE_BRINK)).text,
        bench_ratio(bench_size_spread(races, RACE_PLAIN)).text);
}

static void write_beginning(brink_report *r, const bench_races *races)
{
    brink_report_heading(r, 1, "The simulator beside a plain one");
    brink_report_paragraph(
        r,
        "How fast is brink's simulator? A number of events a second says little "
        "on another machine. So a second simulator runs here beside it: what a "
        "competent person writes in an afternoon. One binary heap holds every "
        "collision ahead, and what has become stale is dropped when it comes up; "
        "there is one list of cells; pairs are predicted one by one, by the "
        "formulas as they stand in print. Both run the same systems from the "
        "same "
        "start, in one process, taking turns, and until rounding parts them they "
        "execute the same events, which is tested.");
    write_findings(r, races);
}

static void write_end(brink_report *r, const bench_simulator_settings *s)
{
    bench_write_made(r, s->command);
    brink_report_paragraph(
        r,
        "Systems begin on a lattice and settle for %d events a particle before "
        "anything is measured. A piece is so many events as brink executes in "
        "%g s, and at least one a particle. An event is a pair's: what happens "
        "at a "
        "core or at a step; crossings of cells are none. brink's times are the "
        "certified ones, as in any run. The plain simulator keeps what pairs are "
        "captured in a list with each particle. It is tests/plain_simulator.c.",
        RACE_SETTLING, s->seconds);
}

int bench_simulator(const bench_simulator_settings *s)
{
    bench_races races = {.seconds = s->seconds, .most = s->particles};
    brink_report r;
    if (bench_hold_races(&races) != 0)
        return -1;
    brink_report_open_page(&r, s->out, "simulator",
                           "The simulator beside a plain one");
    write_beginning(&r, &races);
    write_systems(&r, &races, s->counts);
    write_sizes(&r, &races);
    write_memory(&r, &races);
    write_densities(&r, &races);
    write_end(&r, s);
    return brink_report_close(&r, stderr);
}
