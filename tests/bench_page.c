// SPDX-License-Identifier: MIT
#include "bench_page.h"
#include "bench_families.h"
#include "bench_made.h"
#include "bench_plots.h"
#include "bench_tables.h"
#include "bench_words.h"
#include "report.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MAIN = 3, // the problems with all there is to them
    HERO = 1  // the one that the page begins with
};

// --- Sections ------------------------------------------------------------------

static void write_text(brink_report *r, char *text)
{
    if (text != NULL)
        brink_report_finding(r, "%s", text);
    free(text);
}

static void draw(brink_report *r, char *script, const problem *p,
                 const char *what, const char *caption)
{
    char name[100];
    snprintf(name, sizeof name, "kernels-%s%s", p->name, what);
    if (script != NULL)
        brink_report_figure(r, name, caption, script);
    free(script);
}

static void draw_scatter(brink_report *r, const contest *c)
{
    char caption[600];
    int has_fast = 0;
    for (int k = 0; k < c->problem->methods; k++)
        has_fast |= c->problem->method[k].rank == RANK_FAST;
    snprintf(caption, sizeof caption,
             "%s: cost against error. Each line is one way to the answer, from "
             "its median error to its worst. A cross: it was wrong about "
             "whether, not only about how much.%s",
             c->problem->title,
             has_fast ? " “brink, _fast” may be, where balls all but graze: what "
                        "it promises is a distance, drawn further down."
                      : "");
    draw(r, bench_scatter(c, 0), c->problem, "", caption);
}

/** A problem that most will look at, with all there is to it. */
static void write_contest(brink_report *r, const contest *c, const char *counts)
{
    const problem *p = c->problem;
    brink_report_heading(r, 2, "%s", p->title);
    brink_report_paragraph(r, "%s", p->about);
    write_text(r, bench_sentences(c));
    if (c->problem != problems[HERO])
        draw_scatter(r, c);
    draw(r, bench_distribution(c, 0), p, "-errors",
         "How many answers are how far off. A curve that falls to the ground has "
         "a worst answer; one that runs into the column at the right has wrong "
         "ones.");
    if (p->measure[1] != NULL)
        draw(r, bench_scatter(c, 1), p, "-gap",
             "The same, measured by what it means: how far from where it should "
             "be the pair is at the time that was answered, in roundings of its "
             "path.");
    bench_write_summary(r, c, counts);
    bench_write_families(r, c);
    bench_write_ways(r, p);
}

static void write_minor(brink_report *r, const contest *c, const char *counts)
{
    brink_report_heading(r, 3, "%s", c->problem->title);
    brink_report_paragraph(r, "%s", c->problem->about);
    draw_scatter(r, c);
    bench_write_summary(r, c, counts);
}

static void write_beginning(brink_report *r, const contest *c)
{
    brink_report_heading(r, 1, "Speed against error");
    brink_report_paragraph(
        r, "Do these two balls meet, and when? Is the pair inside the well or "
           "outside? A simulation asks such questions millions of times a "
           "second, and one wrong answer can end it. This page sets what an "
           "answer costs against how good it is: for brink's kernels, for the "
           "formulas as one finds them in print, for other libraries, and for "
           "arithmetic with more digits.");
    for (int k = 0; k < MAIN; k++)
        write_text(r, bench_headline(&c[k]));
    draw_scatter(r, &c[HERO]);
    brink_report_heading(r, 2, "How to read this");
    brink_report_paragraph(
        r, "A computer's number, a double, holds some 16 decimal digits. The "
           "distance from one double to the next is an ulp, a unit in the last "
           "place. As the truth lies between two of them, no answer can be "
           "expected to be nearer than half an ulp. An error of 1000 ulp has "
           "cost 3 of the 16 digits, one of 10¹⁶ all of them.");
    brink_report_paragraph(
        r, "Worse than lost digits is a wrong answer: a collision that is "
           "missed, or one that is invented; now for later; a root that is not "
           "there. No number of digits measures that, so whoever gave one wrong "
           "answer stands in a column of his own, however good the others were; "
           "the percentage beside his name says how often it happened.");
    brink_report_paragraph(
        r, "In the figures each way to an answer is a line. Its height is what a "
           "call costs, as a multiple of what the plainest formula costs on "
           "ordinary input. It begins with a small dot at the median error and "
           "ends with a large one at the worst. Both axes are logarithmic. Down "
           "and to the left is better.");
    brink_report_paragraph(
        r, "The inputs are random, of families: some ordinary, most made to "
           "break something, each with the same weight. So the percentages do "
           "not say how often a simulation goes wrong; the tables say which "
           "family did it. Everything is judged by MPFR with so many digits that "
           "sums and products are exact.");
    brink_report_paragraph(
        r, "Missed: there is a root, or a meeting, and the answer was none. "
           "Invented: the reverse. Now/later: the time is 0 and the answer was "
           "not, or the reverse. Spurious: 0, infinity or NaN for a number that "
           "is none of these.");
}

static void write_end(brink_report *r, const bench_settings *s)
{
    bench_write_made(r, s->command);
    brink_report_paragraph(
        r,
        "%s cases of each family, a fifth of that for the further kernels, from "
        "seed %" PRIu64
        ". Times are the shortest of many turns that the ways take in one "
        "process; instructions are callgrind's, the loop around the call "
        "included, on the path that it can run: AVX2, not AVX-512. `ulp KERNEL "
        "FAMILY` measures one kernel on one family, and prints the worst inputs.",
        brink_words_grouped((uint64_t)s->cases).text, s->seed);
    brink_report_paragraph(
        r, "[S16] is S. Strobl, M. N. Bannerman and T. Pöschel, Stable algorithm "
           "for event detection in event-driven particle dynamics: logical "
           "states, Computational Particle Mechanics 3 (2016). Goualard 2023 is "
           "F. Goualard, The Ins and Outs of Solving Quadratic Equations with "
           "Floating-Point Arithmetic.");
}

static void write_page(brink_report *r, const contest c[PROBLEMS],
                       const bench_settings *s)
{
    write_beginning(r, c);
    for (int k = 0; k < MAIN; k++)
        write_contest(r, &c[k], s->instructions);
    bench_families(r);
    brink_report_heading(r, 2, "The further kernels");
    for (int k = MAIN; k < PROBLEMS; k++)
        write_minor(r, &c[k], s->instructions);
    fprintf(stderr, "bench: what was asked\n");
    bench_write_speed(r, s->seed, s->seconds / 4);
    write_end(r, s);
}

int bench_page(const bench_settings *s)
{
    brink_report r;
    contest c[PROBLEMS];
    int failed = 0;
    for (int k = 0; k < PROBLEMS; k++) {
        const int cases = k < MAIN ? s->cases : (s->cases + 4) / 5;
        fprintf(stderr, "bench: %s\n", problems[k]->title);
        failed |= contest_hold(&c[k], problems[k], cases, s->seed, s->seconds);
    }
    if (failed) {
        fprintf(stderr, "bench: no memory for %d cases\n", s->cases);
    } else {
        brink_report_open_page(&r, s->out, "kernels", "Speed against error");
        write_page(&r, c, s);
        failed = brink_report_close(&r, stderr);
    }
    for (int k = 0; k < PROBLEMS; k++)
        contest_free(&c[k]);
    return failed;
}
