// SPDX-License-Identifier: MIT
#include "bench_profile.h"
#include "bench_simulator_parts.h"
#include <string.h>

static void write_rates(brink_report *r, const bench_races *races)
{
    static const char *const head[] = {"",      "particles", "brink",  "plain",
                                       "ratio", "lowest",    "highest"};
    brink_report_table(
        r,
        "Events a second of processor time, and their ratio: medians of five "
        "pieces; the lowest and the highest ratio of a piece.",
        7, "lrrrrrr", head);
    for (int k = 0; k < COURSES; k++) {
        const bench_course *c = &bench_courses[k];
        const race_result *result = bench_race_over(races, c->course);
        brink_report_cell(r, "%s", c->name);
        brink_report_cell(r, "%s", bench_particles(result).text);
        for (int who = 0; who < RACERS; who++)
            bench_put_count(r, result->rate[who]);
        bench_put_ratio(r, result->ratio);
        bench_put_ratio(r, result->least);
        bench_put_ratio(r, result->most);
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
        "The same on another machine, a quiet Zen 4, not on this one: what was "
        "asked of brink there, and what two other programs were measured to do "
        "there, Smallenburg's in the better of its variants.",
        5, "lrrrr", head);
    for (int k = 0; k < COURSES; k++) {
        const bench_course *c = &bench_courses[k];
        brink_report_cell(r, "%s", c->name);
        brink_report_cell(r, "%s",
                          brink_words_grouped(race_particles(&c->course)).text);
        bench_put_count(r, c->asked);
        bench_put_count(r, c->dynamo);
        bench_put_count(r, c->smallenburg);
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
        "What an event takes: instructions, predictions of a pair at a step, "
        "crossings of a cell's wall.",
        8, "lrrrrrrr", head);
    for (int k = 0; k < COUNTED; k++) {
        bench_profile p;
        bench_profile_read(counts, bench_courses[k].key, &p);
        const race_result *result =
            bench_race_over(races, bench_courses[k].course);
        brink_report_cell(r, "%s", bench_courses[k].name);
        for (int who = 0; who < RACERS; who++)
            bench_put_count(r, p.instructions[who]);
        bench_put_ratio(r,
                        p.instructions[RACE_BRINK] / p.instructions[RACE_PLAIN]);
        bench_put_pair(r, p.pairs);
        bench_put_pair(r, result->crossings);
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

void bench_write_systems(brink_report *r, const bench_races *races,
                         const char *counts)
{
    brink_report_heading(r, 2, "Systems that were asked for");
    write_rates(r, races);
    write_elsewhere(r);
    write_counts(r, races, counts);
    brink_report_paragraph(
        r,
        "Instructions are callgrind's, over %s events of systems that have "
        "settled, on the path it can run: AVX2, not AVX-512. They leave out "
        "what waiting for memory costs, and a vector's instruction counts as "
        "one. A system of a million particles is not counted: it would take too "
        "long.",
        brink_words_grouped(RACE_COUNTED).text);
    brink_report_heading(r, 2, "Where brink's instructions go");
    for (int k = 0; k < COURSES; k++)
        if (bench_courses[k].is_profiled)
            write_profile(r, &bench_courses[k], counts);
    brink_report_paragraph(
        r, "Functions as the compiler left them: what it has built into another "
           "counts as that other's.");
}
