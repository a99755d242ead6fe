// SPDX-License-Identifier: MIT
/**
 * Speed against error, as a page: bench [--out FOLDER] [--cases N] [--seconds S]
 * [--seed N] writes FOLDER/kernels.html.  `./run bench` builds it and calls it.
 */
#include "bench_plots.h"
#include "bench_words.h"
#include "problems_all.h"
#include "report.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct settings {
    const char *out;
    int cases; // a family
    double seconds; // a problem's costs
    uint64_t seed;
} settings;

static int is_seen(const contest *c, enum wrong kind)
{
    int seen = 0;
    for (int k = 0; k < c->problem->methods; k++)
        seen |= c->of[k].all.wrong[kind] > 0;
    return seen;
}

static void put_count(brink_report *r, int count)
{
    if (count == 0)
        brink_report_cell(r, "·");
    else
        brink_report_cell(r, "%s", brink_words_grouped((uint64_t)count).text);
}

/** Way, cost, median, 99.9 %, max, and what was wrong. */
static void write_summary(brink_report *r, const contest *c)
{
    const problem *p = c->problem;
    const char *head[32] = {"", "cost", "ns", "median", "99.9 %", "worst"};
    char align[32] = "lrrrrr";
    int columns = 6;
    if (p->measure[1] != NULL)
        head[columns] = "worst gap", align[columns++] = 'r';
    for (int k = WRONG_NOT + 1; k < WRONG_KINDS; k++)
        if (is_seen(c, (enum wrong)k))
            head[columns] = problem_wrong_names[k], align[columns++] = 'r';
    char caption[400];
    snprintf(caption, sizeof caption,
             "Of %s cases: cost as a multiple of the first line's, on %s input; errors in ulp; "
             "what was wrong, counted.",
             brink_words_grouped((uint64_t)c->of[0].all.n).text, p->usual);
    brink_report_table(r, caption, columns, align, head);
    for (int k = 0; k < p->methods; k++) {
        const standing *s = &c->of[k];
        brink_report_cell(r, "%s", s->method->label);
        brink_report_cell(r, "%s", bench_ratio(s->ratio).text);
        brink_report_cell(r, "%s", bench_ratio(s->ns).text);
        brink_report_cell(r, "%s",
                          bench_error(measure_quantile(&s->all, 0, 0.5)).text);
        brink_report_cell(r, "%s",
                          bench_error(measure_quantile(&s->all, 0, 0.999)).text);
        brink_report_cell(r, "%s", bench_error(standing_max(s, 0)).text);
        if (p->measure[1] != NULL)
            brink_report_cell(r, "%s", bench_error(standing_max(s, 1)).text);
        for (int w = WRONG_NOT + 1; w < WRONG_KINDS; w++)
            if (is_seen(c, (enum wrong)w))
                put_count(r, s->all.wrong[w]);
    }
    brink_report_table_end(r);
}

/** Wrong answers, a line a family. */
static void write_families(brink_report *r, const contest *c)
{
    const problem *p = c->problem;
    const char *head[32] = {"family"};
    char align[32] = "l";
    int columns = 1;
    for (int k = 0; k < p->methods; k++) {
        head[columns] = c->of[k].method->label;
        align[columns++] = 'r';
    }
    char caption[200];
    snprintf(caption, sizeof caption, "Wrong answers of %s in each family of inputs.",
             brink_words_grouped((uint64_t)c->of[0].family[0].n).text);
    brink_report_table(r, caption, columns, align, head);
    for (int f = 0; f < p->families; f++) {
        brink_report_cell(r, "%s", p->family(f));
        for (int k = 0; k < p->methods; k++)
            put_count(r, measure_wrong(&c->of[k].family[f]));
    }
    brink_report_table_end(r);
}

static void draw(brink_report *r, char *script, const char *name,
                 const char *caption)
{
    if (script != NULL)
        brink_report_figure(r, name, caption, script);
    free(script);
}

static void write_contest(brink_report *r, const contest *c)
{
    const problem *p = c->problem;
    char name[100];
    brink_report_heading(r, 2, "%s", p->title);
    brink_report_paragraph(r, "%s", p->about);
    char *sentences = bench_sentences(c);
    if (sentences != NULL)
        brink_report_finding(r, "%s", sentences);
    free(sentences);
    snprintf(name, sizeof name, "kernels-%s", p->name);
    draw(r, bench_scatter(c, 0), name,
         "Each line is a way to the answer, from its median error to its worst one.");
    snprintf(name, sizeof name, "kernels-%s-errors", p->name);
    draw(r, bench_distribution(c, 0), name,
         "The part of the answers whose error exceeds x.");
    if (p->measure[1] != NULL) {
        snprintf(name, sizeof name, "kernels-%s-gap", p->name);
        draw(r, bench_scatter(c, 1), name,
             "The same by the distance from the surface.");
    }
    write_summary(r, c);
    write_families(r, c);
}

static int parse(int argc, char **argv, settings *s)
{
    for (int k = 1; k + 1 < argc; k += 2) {
        if (strcmp(argv[k], "--out") == 0)
            s->out = argv[k + 1];
        else if (strcmp(argv[k], "--cases") == 0)
            s->cases = atoi(argv[k + 1]);
        else if (strcmp(argv[k], "--seconds") == 0)
            s->seconds = atof(argv[k + 1]);
        else
            return -1;
    }
    return argc % 2 == 1 ? 0 : -1;
}

int main(int argc, char **argv)
{
    settings s = {"report", 20000, 2, 1};
    if (parse(argc, argv, &s) != 0)
        return 2;
    brink_report r;
    brink_report_open_page(&r, s.out, "kernels", "Speed against error");
    brink_report_heading(&r, 1, "Speed against error");
    for (int k = 0; k < problem_count; k++) {
        contest c;
        if (contest_hold(&c, problems[k], s.cases, s.seed, s.seconds) == 0)
            write_contest(&r, &c);
        contest_free(&c);
    }
    const int status = brink_report_close(&r, stderr);
    if (status == 0)
        printf("%s/kernels.html\n", s.out);
    return status == 0 ? 0 : 1;
}
