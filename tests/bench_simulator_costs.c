// SPDX-License-Identifier: MIT
#include "bench_curves.h"
#include "bench_simulator_parts.h"
#include <stdlib.h>

/** Hard spheres, with more and more of something. */
typedef struct sweep {
    const char *heading, *figure, *caption;
    const char *what; // there is more of, as the table calls it
    const char *axis; // of it, for bench_curves
    int count;
    race_course (*course)(int k);
    double (*amount)(const race_course *c);
    brink_words (*in_words)(double amount);
} sweep;

static double size(const race_course *c)
{
    return race_particles(c);
}

static brink_words size_in_words(double particles)
{
    return brink_words_grouped((uint64_t)particles);
}

static brink_words packing_in_words(double packing)
{
    brink_words w;
    snprintf(w.text, sizeof w.text, "%.4g", packing);
    return w;
}

static const sweep sizes = {
    "Cost against size",
    "simulator-size",
    "Hard spheres at packing 0.45. With more particles the work for an event is "
    "the same; that it costs more is because they no longer fit into caches.",
    "particles",
    "set xrange [300:2e6]\nset xlabel 'particles'\n"
    "set xtics scale 1,0 ('1 000' 1e3, '10 000' 1e4, '100 000' 1e5, "
    "'1 000 000' 1e6)\n",
    SIZES,
    bench_size,
    size,
    size_in_words,
};

static const sweep densities = {
    "Cost against density",
    "simulator-density",
    "Hard spheres, from a gas to where they freeze. A dilute particle crosses "
    "many cells from one event to the next; a dense one has many neighbours.",
    "packing",
    "set xrange [3e-4:1]\nset xlabel 'packing fraction'\n"
    "set xtics scale 1,0 ('0.001' 1e-3, '0.01' 0.01, '0.1' 0.1, '0.5' 0.5)\n",
    DENSITIES,
    bench_density,
    race_packing,
    packing_in_words,
};

enum { MOST = SIZES > DENSITIES ? SIZES : DENSITIES };

static void write_costs(brink_report *r, const sweep *s, const double *amount,
                        const race_result *const *results)
{
    const char *const head[] = {
        s->what, "brink", "plain", "ratio", "crossings, brink", "plain"};
    brink_report_table(r, "Nanoseconds of processor time an event.", 6, "rrrrrr",
                       head);
    for (int k = 0; k < s->count; k++) {
        brink_report_cell(r, "%s", s->in_words(amount[k]).text);
        for (enum racer who = 0; who < RACERS; who++)
            bench_put_count(r, race_ns(results[k], who));
        bench_put_ratio(r, results[k]->ratio);
        bench_put_pair(r, results[k]->crossings);
    }
    brink_report_table_end(r);
}

static void write_sweep(brink_report *r, const bench_races *races, const sweep *s)
{
    const race_result *results[MOST];
    double amount[MOST];
    for (int k = 0; k < s->count; k++) {
        results[k] = bench_race_over(races, s->course(k));
        amount[k] = s->amount(&results[k]->course);
    }
    char *script = bench_curves(s->axis, s->count, amount, results);
    brink_report_heading(r, 2, "%s", s->heading);
    if (script != NULL)
        brink_report_figure(r, s->figure, s->caption, script);
    free(script);
    write_costs(r, s, amount, results);
}

void bench_write_sizes(brink_report *r, const bench_races *races)
{
    write_sweep(r, races, &sizes);
}

void bench_write_densities(brink_report *r, const bench_races *races)
{
    write_sweep(r, races, &densities);
}

static void write_memory_of(brink_report *r, const char *what,
                            const race_result *of, double asked)
{
    brink_report_cell(r, "%s", what);
    brink_report_cell(r, "%s", bench_particles(of).text);
    brink_report_cell(r, of->captured > 0 ? "%.1f" : " ", of->captured);
    for (int who = 0; who < RACERS; who++)
        bench_put_count(r, of->bytes[who]);
    bench_put_count(r, asked);
}

void bench_write_memory(brink_report *r, const bench_races *races)
{
    static const char *const head[] = {"",      "particles", "partners",
                                       "brink", "plain",     "asked"};
    brink_report_heading(r, 2, "Memory");
    brink_report_table(
        r,
        "Bytes a particle, as malloc gives them out, after the race; what was "
        "asked is: at most.",
        6, "lrrrrr", head);
    for (int k = 0; k < SIZES; k += SIZES / 2)
        write_memory_of(r, "hard spheres, packing 0.45",
                        bench_race_over(races, bench_size(k)), 300);
    write_memory_of(r, "square well, λ = 1.75, density 0.5",
                    bench_race_over(races, bench_well_12), 600);
    brink_report_table_end(r);
}
