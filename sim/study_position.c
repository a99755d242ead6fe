// SPDX-License-Identifier: MIT
#include "study_position.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char counting[] =
    "In the run with logical states one can look at what the positions would "
    "have said, and count how often that is wrong. An event at a step σ takes "
    "the pair's level from ℓ to ℓ′ at time t; s(r) is the level that a "
    "separation r shows. There are several moments at which to ask.";

static const char doubts_caption[] =
    "Inconsistencies between position and logical state, an event, with counting "
    "errors √n (none seen: bound at 95 %% confidence, 3/n). %s events; not every "
    "event has every look.";

static const char overlaps[] =
    "Apart from these, hard cores overlap by a rounding when they collide: %s "
    "times in %s collisions. There is no other state to mistake their state for.";

static const char formulas_caption[] =
    "Formulas for the next time at a step, in plain doubles, asked right after "
    "each event about the pair that had it; against the kernel's answer, which "
    "is "
    "exact in never, now or later.";

static const char gaps_caption[] =
    "What a tolerance makes of it. Falling: position is wrong by more than the "
    "tolerance, in parts of σ. Rising: it is within the tolerance of the step, "
    "rightly or not, so that a program that knows separations no better would "
    "be in doubt.%s";

// By kind, in the order of their letters: when to ask, and what is wrong then.
static const struct {
    const char *when, *wrong;
} definitions[BRINK_DOUBTS] = {
    [BRINK_DOUBT_TESTED] =
        {"at t₁ > t, when the pair is next tested: at an event "
         "of either, or when either crosses a cell's wall",
         "s(r(t₁))\u00a0≠\u00a0ℓ′"},
    [BRINK_DOUBT_NEXT] = {"at t₂ > t, the next event of either, with a third",
                          "s(r(t₂))\u00a0≠\u00a0ℓ′"},
    [BRINK_DOUBT_SYSTEM] =
        {"at t₃ > t, the next event of the system, if it is another pair's",
         "s(r(t₃))\u00a0≠\u00a0ℓ′"},
    [BRINK_DOUBT_EXECUTED] =
        {"at execution, positions advanced, before the impulse",
         "s(r(t))\u00a0≠\u00a0ℓ"},
    [BRINK_DOUBT_STORED] = {"at execution, by the separation from which the "
                            "event was predicted, at t₀",
                            "s(r(t₀))\u00a0≠\u00a0ℓ"},
    [BRINK_DOUBT_MOVED] =
        {"at execution, by that separation brought to the event",
         "s(r(t₀) + v(t\u00a0−\u00a0t₀))\u00a0≠\u00a0ℓ"},
    [BRINK_DOUBT_AFTER] =
        {"right after the impulse, where the pair is tested at once",
         "s(r(t))\u00a0≠\u00a0ℓ′"},
};

double brink_paper_frequency(const brink_scene *s)
{
    const brink_potential *p = &s->potential[0];
    if (s->species_count != 1 || p->count != 2 || !isinf(p->energy[1]))
        return 0;
    return p->energy[0] < 0 ? 1.4e-7 : 2.6e-7;
}

enum brink_standing brink_standing_of(uint64_t count, uint64_t events,
                                      double frequency)
{
    const double expected = frequency * (double)events;
    if (count == 0) // the bound -ln 0.05 is below half of what is expected
        return -log(0.05) < expected / 2 ? BRINK_FAR_LESS : BRINK_UNDECIDED;
    return (double)count > 2 * expected   ? BRINK_FAR_MORE
           : (double)count < expected / 2 ? BRINK_FAR_LESS
                                          : BRINK_NEAR;
}

static void tell_definitions(brink_report *r)
{
    static const char *const head[] = {"", "when position is asked",
                                       "and shows another state"};
    brink_report_table(r, "Seven moments to ask.", 3, "lll", head);
    for (int k = 0; k < BRINK_DOUBTS; k++) {
        brink_report_cell(r, "%c", 'A' + k);
        brink_report_cell(r, "%s", definitions[k].when);
        brink_report_cell(r, "%s", definitions[k].wrong);
    }
    brink_report_table_end(r);
}

static void tell_counts(brink_report *r, const brink_doubts *d, double paper)
{
    static const char *const head[] = {"", "looks", "seen", "an event",
                                       "times [S16]'s"};
    char caption[400];
    snprintf(caption, sizeof caption, doubts_caption,
             brink_words_grouped(d->events).text);
    brink_report_table(r, caption, paper > 0 ? 5 : 4, "lrrrr", head);
    for (int k = 0; k < BRINK_DOUBTS; k++) {
        const brink_doubt *of = &d->of[k];
        const int seen = of->wrong > 0;
        brink_report_cell(r, "%c", 'A' + k);
        brink_report_cell(r, "%s", brink_words_grouped(of->looks).text);
        brink_report_cell(r, "%s", brink_words_grouped(of->wrong).text);
        brink_report_cell(r, "%s",
                          brink_words_frequency(of->wrong, d->events).text);
        if (!(paper > 0))
            continue;
        const double count = seen ? (double)of->wrong : -log(0.05);
        brink_report_cell(
            r, "%s%s", seen ? "" : "< ",
            brink_words_scientific(count / (paper * (double)d->events)).text);
    }
    brink_report_table_end(r);
}

static void tell_formulas(brink_report *r, const brink_doubts *d)
{
    static const char *const head[] = {"formula", "asked", "another of the three",
                                       "an event", "over 10⁻⁶ off in time"};
    static const char *const names[BRINK_FORMULAS] = {
        [BRINK_FORMULA_INWARD] = "inward: algorithm 1",
        [BRINK_FORMULA_OUTWARD] = "outward: algorithm 2, its branches put right",
        [BRINK_FORMULA_PRINTED] = "outward: algorithm 2 as printed",
    };
    brink_report_table(r, formulas_caption, 5, "lrrrr", head);
    for (int k = 0; k < BRINK_FORMULAS; k++) {
        const brink_answers *a = &d->answers[k];
        brink_report_cell(r, "%s", names[k]);
        brink_report_cell(r, "%s", brink_words_grouped(a->asked).text);
        brink_report_cell(r, "%s", brink_words_grouped(a->other).text);
        brink_report_cell(r, "%s",
                          brink_words_frequency(a->other, d->events).text);
        brink_report_cell(r, "%s", brink_words_grouped(a->astray).text);
    }
    brink_report_table_end(r);
}

typedef uint64_t gap_count(const brink_doubt *, int exponent);

// Points as far as there are events to count, by powers of two.
static void write_curve(FILE *out, const brink_doubts *d, int kind,
                        gap_count *counted)
{
    fprintf(out, "$of%d << END\n", kind);
    for (int k = 0; k < BRINK_GAPS - 1; k++) {
        const uint64_t n = counted(&d->of[kind], k);
        if (n > 0)
            fprintf(out, "%.6g %.6g\n", ldexp(1, -k),
                    (double)n / (double)d->events);
    }
    fputs("END\n", out);
}

static char *draw(const brink_doubts *d, double paper)
{
    char *script = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&script, &size);
    if (out == NULL)
        return NULL;
    write_curve(out, d, BRINK_DOUBT_EXECUTED, brink_doubt_beyond);
    write_curve(out, d, BRINK_DOUBT_AFTER, brink_doubt_beyond);
    write_curve(out, d, BRINK_DOUBT_SYSTEM, brink_doubt_within);
    write_curve(out, d, BRINK_DOUBT_TESTED, brink_doubt_within);
    write_curve(out, d, BRINK_DOUBT_NEXT, brink_doubt_within);
    fputs("set logscale xy\nset xrange [1e-18:1]\nset yrange [1e-9:3]\n"
          "set format x '10^{%T}'\nset format y '10^{%T}'\n"
          "set xlabel 'tolerance / σ'\nset ylabel 'frequency an event' offset "
          "1,0\nset lmargin 13\nset key center top\n",
          out);
    if (paper > 0)
        fprintf(
            out,
            "set arrow 1 from graph 0, first %g to graph 1, first %g nohead "
            "dt 2\nset label 1 '[S16]' at graph 0.02, first %g offset 0,0.6\n",
            paper, paper, paper);
    fprintf(out,
            "plot $of%d with lines lt 1 lw 2 title 'D wrong by more', "
            "$of%d with lines lt 2 lw 2 title 'G wrong by more', "
            "$of%d with lines lt 3 lw 2 title 'C within', "
            "$of%d with lines lt 4 lw 2 title 'A within', "
            "$of%d with lines lt 5 lw 2 title 'B within'\n",
            BRINK_DOUBT_EXECUTED, BRINK_DOUBT_AFTER, BRINK_DOUBT_SYSTEM,
            BRINK_DOUBT_TESTED, BRINK_DOUBT_NEXT);
    return fclose(out) == 0 ? script : NULL;
}

// The letters of the definitions that stand so beside [S16]'s frequency.
static brink_words letters(const brink_doubts *d, enum brink_standing standing,
                           double paper)
{
    brink_words w = {""};
    for (int k = 0; k < BRINK_DOUBTS; k++)
        if (brink_standing_of(d->of[k].wrong, d->events, paper) == standing) {
            const size_t at = strlen(w.text);
            snprintf(w.text + at, sizeof w.text - at, "%s%c", at > 0 ? ", " : "",
                     'A' + k);
        }
    if (w.text[0] == '\0')
        strcpy(w.text, "none");
    return w;
}

// The tolerance within which a pair is found so often, in parts of the step; NaN
// where that is beyond what was counted.
static double tolerance_at(const brink_doubt *d, double expected)
{
    for (int k = BRINK_GAPS - 2; k > 0; k--) {
        const double less = (double)brink_doubt_within(d, k);
        const double more = (double)brink_doubt_within(d, k - 1);
        if (less > 0 && less <= expected && expected < more)
            return exp2(log(expected / less) / log(more / less) - k);
    }
    return (double)NAN;
}

static void tell_tolerance(brink_report *r, const brink_case *c, double paper)
{
    const brink_trial *t = &c->trial[BRINK_METHOD_LOGICAL];
    const brink_doubts *d = &t->doubts;
    const double sigma = c->scene.potential[0].distance[0];
    const double speed = sqrt(c->scene.temperature / c->scene.species[0].mass);
    const double expected = paper * (double)d->events;
    const double system = tolerance_at(&d->of[BRINK_DOUBT_SYSTEM], expected);
    const double next = tolerance_at(&d->of[BRINK_DOUBT_NEXT], expected);
    if (isnan(system) || isnan(next))
        return;
    brink_report_paragraph(
        r,
        "As frequent as [S16] says is that at the next event of the system a "
        "pair "
        "lies within %s σ of the step, and at the next event of either particle "
        "within %s σ. For comparison: coordinates kept as doubles, counted from "
        "the corner of this box, are rounded by up to %s σ; and one double for "
        "the time is at the end of this run rounded by what a particle flies %s "
        "σ "
        "in.",
        brink_words_scientific(system).text, brink_words_scientific(next).text,
        brink_words_scientific(c->scene.length[0] * 0x1p-54 / sigma).text,
        brink_words_scientific(speed * t->time * 0x1p-53 / sigma).text);
}

static void tell_paper(brink_report *r, const brink_case *c, double paper)
{
    const brink_doubts *d = &c->trial[BRINK_METHOD_LOGICAL].doubts;
    brink_report_finding(
        r,
        "[S16] gives %s an event for this potential, with 32 000 particles and "
        "3.2 × 10⁸ events, and does not say what was counted. Near it, from half "
        "of it to twice, comes: %s. More frequent: %s. Less frequent: %s. Not "
        "seen, in a run too short to tell: %s.",
        brink_words_scientific(paper).text, letters(d, BRINK_NEAR, paper).text,
        letters(d, BRINK_FAR_MORE, paper).text,
        letters(d, BRINK_FAR_LESS, paper).text,
        letters(d, BRINK_UNDECIDED, paper).text);
    tell_tolerance(r, c, paper);
}

void brink_position_tell(brink_report *r, const brink_case *c)
{
    const brink_trial *t = &c->trial[BRINK_METHOD_LOGICAL];
    const brink_doubts *d = &t->doubts;
    const double paper = brink_paper_frequency(&c->scene);
    char name[80], caption[600];
    brink_report_heading(r, 3, "How often position is wrong");
    if (d->events == 0) {
        brink_report_paragraph(r, "Nothing was counted.");
        return;
    }
    brink_report_paragraph(r, counting);
    tell_definitions(r);
    tell_counts(r, d, paper);
    brink_report_paragraph(r, overlaps, brink_words_grouped(d->overlaps).text,
                           brink_words_grouped(t->tally.core).text);
    if (paper > 0)
        tell_paper(r, c, paper);
    snprintf(name, sizeof name, "%s-gaps", c->name);
    snprintf(caption, sizeof caption, gaps_caption,
             paper > 0 ? " The dashed line is what [S16] gives." : "");
    char *script = draw(d, paper);
    if (script != NULL)
        brink_report_figure(r, name, caption, script);
    free(script);
    tell_formulas(r, d);
}
