// SPDX-License-Identifier: MIT
#include "bench_tables.h"
#include "bench_count.h"
#include "bench_speed.h"
#include "bench_words.h"
#include "cost.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 24 };

typedef struct columns {
    int count;
    const char *head[COLUMNS];
    char align[COLUMNS];
} columns;

static void add_column(columns *c, const char *head)
{
    c->align[c->count] = c->count == 0 ? 'l' : 'r';
    c->head[c->count++] = head;
}

static int is_seen(const contest *c, int kind)
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

static void put_errors(brink_report *r, const standing *s, int measure)
{
    static const double parts[] = {0.5, 1};
    for (int k = measure == 0 ? 0 : 1; k < 2; k++)
        if (rank_is_sign(s->method->rank))
            brink_report_cell(r, " ");
        else
            brink_report_cell(
                r, "%s",
                bench_error(measure_quantile(&s->all, measure, parts[k])).text);
}

/** Cost, errors, and what was wrong, a line a way. */
void bench_write_summary(brink_report *r, const contest *c, const char *counts)
{
    const problem *p = c->problem;
    columns head = {0};
    double instructions[64];
    char caption[400], second[150] = "";
    bench_count_read(counts, p, instructions);
    if (p->measure[1] != NULL)
        snprintf(second, sizeof second, "; the %s in %s", p->second,
                 p->measure[1]);
    snprintf(caption, sizeof caption,
             "%s cases. Cost, a multiple of the first line's, and instructions a "
             "call, on %s input; errors in %s%s.",
             brink_words_grouped((uint64_t)c->of[0].all.n).text, p->usual,
             p->measure[0], second);
    for (const char *const *h =
             (const char *const[]){"", "cost", "instr.", "median", "worst", NULL};
         *h != NULL; h++)
        add_column(&head, *h);
    if (p->measure[1] != NULL)
        add_column(&head, p->second);
    for (int k = WRONG_NOT + 1; k < WRONG_KINDS; k++)
        if (is_seen(c, k))
            add_column(&head, problem_wrong_names[k]);
    brink_report_table(r, caption, head.count, head.align, head.head);
    for (int k = 0; k < p->methods; k++) {
        const standing *s = &c->of[k];
        brink_report_cell(r, "%s", s->method->label);
        brink_report_cell(r, "%s", bench_ratio(s->ratio).text);
        if (isnan(instructions[k]))
            brink_report_cell(r, " ");
        else
            brink_report_cell(
                r, "%s",
                brink_words_grouped((uint64_t)(instructions[k] + 0.5)).text);
        put_errors(r, s, 0);
        if (p->measure[1] != NULL)
            put_errors(r, s, 1);
        for (int w = WRONG_NOT + 1; w < WRONG_KINDS; w++)
            if (is_seen(c, w))
                put_count(r, s->all.wrong[w]);
    }
    brink_report_table_end(r);
}

/** Whether a method has a column among the wrong: ours always. */
static int is_worth_telling(const standing *s)
{
    return s->method->rank <= RANK_SIGN || measure_wrong(&s->all) > 0;
}

/** Wrong answers, a line a family. */
void bench_write_families(brink_report *r, const contest *c)
{
    const problem *p = c->problem;
    columns head = {0};
    char caption[300];
    snprintf(caption, sizeof caption,
             "Wrong answers, of %s in each family of inputs. Who has no column "
             "was never wrong.",
             brink_words_grouped((uint64_t)c->of[0].family[0].n).text);
    add_column(&head, "family");
    for (int k = 0; k < p->methods; k++)
        if (is_worth_telling(&c->of[k]))
            add_column(&head, c->of[k].method->label);
    brink_report_table(r, caption, head.count, head.align, head.head);
    for (int f = 0; f < p->families; f++) {
        brink_report_cell(r, "%s", p->family(f));
        for (int k = 0; k < p->methods; k++)
            if (is_worth_telling(&c->of[k]))
                put_count(r, measure_wrong(&c->of[k].family[f]));
    }
    brink_report_table_end(r);
}

void bench_write_ways(brink_report *r, const problem *p)
{
    columns head = {0};
    add_column(&head, "");
    add_column(&head, "what it does");
    head.align[1] = 'l';
    brink_report_table(r, "The ways to an answer.", head.count, head.align,
                       head.head);
    for (int k = 0; k < p->methods; k++) {
        brink_report_cell(r, "%s", p->method[k].label);
        brink_report_cell(r, "%s", p->method[k].about);
    }
    brink_report_table_end(r);
}

/** A line below another, NULL for the first; what is the same is not repeated. */
static void write_line(brink_report *r, const speed *s, const speed *above)
{
    const int again = above != NULL && strcmp(above->kernel, s->kernel) == 0;
    brink_report_cell(r, "%s", again ? " " : s->kernel);
    brink_report_cell(r, "%s", s->family);
    brink_report_cell(r, "%s", again ? " " : s->baseline);
    brink_report_cell(r, s->verdict != SPEED_NOT_HERE ? "%.1f" : " ", s->ns);
    brink_report_cell(r, s->verdict != SPEED_NOT_HERE ? "%.2f" : " ", s->ratio);
    brink_report_cell(r, s->at_most > 0 ? "%g" : " ", s->at_most);
    brink_report_cell(r, "%s", speed_words[s->verdict]);
}

void bench_write_speed(brink_report *r, uint64_t seed, double seconds)
{
    const int lines = bench_speed_lines();
    speed *speeds = calloc((size_t)lines, sizeof *speeds);
    int kept = 0, over = 0;
    columns head = {0};
    brink_report_heading(r, 2, "What was asked, and what is measured");
    brink_report_paragraph(
        r,
        "Each line is a kernel on a family of inputs, beside its baseline in the "
        "same process, taking turns over %d inputs: more than a processor's "
        "branch prediction can learn by heart. A batch answers many pairs at a "
        "time and is set beside the scalar loop of its baseline.",
        COST_INPUTS);
    for (int k = 0; speeds != NULL && k < lines; k++)
        if (bench_speed_measure(k, seed, seconds, &speeds[k]) == 0) {
            kept += speeds[k].verdict == SPEED_KEPT;
            over += speeds[k].verdict == SPEED_OVER;
        }
    brink_report_finding(r,
                         "Of %d lines of which something was asked %d are kept.",
                         kept + over, kept);
    for (const char *const *h =
             (const char *const[]){"kernel", "inputs", "beside", "ns", "ratio",
                                   "asked", "", NULL};
         *h != NULL; h++)
        add_column(&head, *h);
    head.align[1] = head.align[2] = head.align[6] = 'l';
    brink_report_table(r,
                       "Nanoseconds a call, the ratio to what it stands beside, "
                       "and what was asked: at most.",
                       head.count, head.align, head.head);
    for (int k = 0; speeds != NULL && k < lines; k++)
        write_line(r, &speeds[k], k > 0 ? &speeds[k - 1] : NULL);
    brink_report_table_end(r);
    free(speeds);
}
