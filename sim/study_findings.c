// SPDX-License-Identifier: MIT
#include "study_findings.h"
#include "study_growth.h"
#include "study_plot.h"
#include "study_position.h"
#include "study_words.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

void brink_findings_file(const brink_case *c, enum brink_method method,
                         const char *ending, char *name, size_t size)
{
    snprintf(name, size, "%s-%s%s", c->name,
             brink_words_slug(brink_method_rule(method)->name).text, ending);
}

static const char figure_caption[] =
    "How far the energy is off, against the number of events done; both "
    "scales are logarithmic. The energy is taken from the positions, for all "
    "ways alike. Points in the shaded band have no error at all; curves that "
    "lie on one another are drawn the wider the deeper they lie. A cross "
    "marks where a way was stopped, because time stood still (the same pair "
    "had over a thousand events at one instant) or the energy was off by more "
    "than |ε| a particle.";

static const char outcomes_caption[] =
    "What became of each. The error is relative to the energy at the start. "
    "Events are counted by the second of the processor, without looks at the "
    "energy: the logical states' while they are being watched, the others' in a "
    "plain loop. What it took is on the wall, everything in it.";

static const char nudging[] =
    "The two nudged ways hang on a constant. With others, from the same start "
    "and for a shorter while, they leave the energy so:";

static const char nudges_caption[] =
    "How far the energy is off after %s events, in |ε|, with other nudges. A "
    "pair whose state was told wrongly, or whose event was missed, costs a "
    "whole |ε|.";

static const char events_caption[] =
    "Events by kind, as each way takes them. Apart from these: crossings of "
    "the cells that the program sorts particles into; events due at once when "
    "they were predicted; and those of the same pair at the same instant as "
    "the event before.";

brink_words brink_findings_outcome(const brink_trial *t)
{
    static const char *const phrase[] = {
        [BRINK_OUTCOME_NONE] = "crashed",
        [BRINK_OUTCOME_DONE] = "did all %s events",
        [BRINK_OUTCOME_AT_REST] = "came to rest after %s events",
        [BRINK_OUTCOME_STANDS_STILL] = "stood still after %s events",
        [BRINK_OUTCOME_ENERGY_OFF] = "had a false energy after %s events",
        [BRINK_OUTCOME_REFUSED] = "was refused an event after %s",
        [BRINK_OUTCOME_NO_MEMORY] = "ran out of memory after %s events",
    };
    brink_words w;
    snprintf(w.text, sizeof w.text, phrase[t->outcome],
             brink_words_grouped(t->events).text);
    return w;
}

static int came_through(const brink_trial *t)
{
    return t->outcome == BRINK_OUTCOME_DONE ||
           t->outcome == BRINK_OUTCOME_AT_REST;
}

static int count_through(const brink_case *c)
{
    int count = 0;
    for (int k = BRINK_METHOD_LOGICAL + 1; k < BRINK_METHODS; k++)
        count += came_through(&c->trial[k]);
    return count;
}

// In |epsilon|, which is what a transfer costs that was told wrongly or missed.
static double steps_off(const brink_trial *t)
{
    return round(fabs(t->energy_end - t->energy_begin) / t->epsilon);
}

// "a, b and c": the conventional methods that came through, with what that cost;
// or those that did not, each with what became of it.
static void list_methods(FILE *out, const brink_case *c, int through, int count)
{
    int listed = 0;
    for (int k = BRINK_METHOD_LOGICAL + 1; k < BRINK_METHODS; k++) {
        const brink_trial *t = &c->trial[k];
        if (came_through(t) != through)
            continue;
        fprintf(out, "%s%s",
                listed == 0           ? ""
                : listed == count - 1 ? " and "
                                      : ", ",
                brink_method_rule(t->method)->name);
        listed++;
        if (!through)
            fprintf(out, " (%s)", brink_findings_outcome(t).text);
        else if (steps_off(t) > 0)
            fprintf(out, " (its energy off by %.0f |ε|)", steps_off(t));
    }
}

static void write_sentences(FILE *out, const brink_case *c)
{
    const brink_trial *logical = &c->trial[BRINK_METHOD_LOGICAL];
    const int others = BRINK_METHODS - 1, through = count_through(c);
    fprintf(
        out,
        "With logical states the run %s, and at every sample point its energy ",
        brink_findings_outcome(logical).text);
    if (logical->energy_worst > 0)
        fprintf(out, "was within %s of what it was at the start. ",
                brink_words_scientific(logical->energy_worst).text);
    else
        fputs("was exactly what it was at the start. ", out);
    if (through == others) {
        fputs("From the same start so did ", out);
        list_methods(out, c, 1, through);
    } else {
        fprintf(out, "From the same start %d of the %d other ways failed: ",
                others - through, others);
        list_methods(out, c, 0, others - through);
    }
    if (through > 0 && through < others) {
        fputs("; while ", out);
        list_methods(out, c, 1, through);
        fputs(" came through", out);
    }
    fputs(".", out);
}

char *brink_findings_sentences(const brink_case *c)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        return NULL;
    write_sentences(out, c);
    return fclose(out) == 0 ? text : NULL;
}

// "A–A: energy −1 within 3, hard core at 1".
static void write_potential(FILE *out, const brink_potential *p)
{
    for (int k = 0; k < p->count; k++) {
        const double energy = p->energy[k];
        fputs(k > 0 ? ", " : "", out);
        if (isinf(energy))
            fprintf(out, "hard core at %g", p->distance[k]);
        else
            fprintf(out, "energy %s%g within %g", energy < 0 ? "−" : "",
                    fabs(energy), p->distance[k]);
    }
}

static void tell_system(brink_report *r, const brink_scene *s)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (out == NULL)
        return;
    for (int a = 0; a < s->species_count; a++)
        for (int b = a; b < s->species_count; b++) {
            fprintf(out, "; %s–%s: ", s->species[a].name, s->species[b].name);
            write_potential(out, &s->potential[a * s->species_count + b]);
        }
    fclose(out);
    brink_report_paragraph(
        r, "%s particles at temperature %g in a box of %g × %g × %g%s.",
        brink_words_grouped(s->count).text, s->temperature, s->length[0],
        s->length[1], s->length[2], text);
    free(text);
}

static uint64_t events_per_second(const brink_trial *t)
{
    return t->seconds > 0 ? (uint64_t)((double)t->events / t->seconds) : 0;
}

static void tell_outcomes(brink_report *r, const brink_case *c)
{
    static const char *const head[] = {"way", "what became of it",
                                       "energy error at the end", "events/s",
                                       "took"};
    static const char *const kinds[] = {"core", "capture", "release", "bounce"};
    brink_report_table(r, outcomes_caption, 5, "llrrr", head);
    for (int k = 0; k < BRINK_METHODS; k++) {
        const brink_trial *t = &c->trial[k];
        const brink_words outcome = brink_findings_outcome(t);
        brink_report_cell(r, "%s", brink_method_rule(t->method)->name);
        if (came_through(t) || t->events == 0)
            brink_report_cell(r, "%s", outcome.text);
        else
            brink_report_cell(
                r, "%s; the last a %s of particles %" PRIu32 " and %" PRIu32,
                outcome.text, kinds[t->last.kind], t->last.i, t->last.j);
        brink_report_cell(r, "%s", brink_words_scientific(t->energy_error).text);
        brink_report_cell(r, "%s",
                          brink_words_grouped(events_per_second(t)).text);
        brink_report_cell(r, "%s", brink_words_duration(t->wall).text);
    }
    brink_report_table_end(r);
}

static void tell_events(brink_report *r, const brink_case *c)
{
    static const char *const head[] = {"way",  "capture", "release", "bounce",
                                       "core", "cell",    "at once", "repeated"};
    brink_report_table(r, events_caption, 8, "lrrrrrrr", head);
    for (int k = 0; k < BRINK_METHODS; k++) {
        const brink_tally *t = &c->trial[k].tally;
        const uint64_t counts[] = {t->capture, t->release, t->bounce,  t->core,
                                   t->cell,    t->clamped, t->repeated};
        brink_report_cell(r, "%s", brink_method_rule(c->trial[k].method)->name);
        for (size_t n = 0; n < sizeof counts / sizeof counts[0]; n++)
            brink_report_cell(r, "%s", brink_words_grouped(counts[n]).text);
    }
    brink_report_table_end(r);
}

static void tell_nudges(brink_report *r, const brink_case *c)
{
    const char *head[1 + BRINK_METHODS] = {"nudge"};
    char caption[400];
    int columns = 1;
    for (int k = 0; k < BRINK_METHODS; k++)
        if (brink_nudge_is_used((enum brink_method)k))
            head[columns++] = brink_method_rule((enum brink_method)k)->name;
    snprintf(caption, sizeof caption, nudges_caption,
             brink_words_grouped(c->nudge_events).text);
    brink_report_table(r, caption, columns, "lrrrrrr", head);
    for (int n = 0; n < BRINK_NUDGES; n++) {
        brink_report_cell(r, "%s",
                          brink_words_scientific(brink_nudge_size(n)).text);
        for (int k = 0; k < BRINK_METHODS; k++) {
            const double off = c->nudge_off[k][n];
            if (brink_nudge_is_used((enum brink_method)k))
                brink_report_cell(r, isinf(off) ? "stood still" : "%.0f", off);
        }
    }
    brink_report_table_end(r);
}

void brink_findings_tell(brink_report *r, const brink_case *c)
{
    char name[80];
    brink_report_heading(r, 2, "%s",
                         c->scene.title[0] != '\0' ? c->scene.title : c->name);
    tell_system(r, &c->scene);
    char *sentences = brink_findings_sentences(c), *script = brink_energy_plot(c);
    brink_report_finding(r, "%s", sentences != NULL ? sentences : "");
    free(sentences);
    snprintf(name, sizeof name, "%s-energy", c->name);
    if (script != NULL)
        brink_report_figure(r, name, figure_caption, script);
    free(script);
    tell_outcomes(r, c);
    brink_growth_tell(r, c);
    brink_report_heading(r, 3, "How much to nudge");
    brink_report_paragraph(r, nudging);
    tell_nudges(r, c);
    brink_position_tell(r, c);
    brink_report_heading(r, 3, "What happened");
    tell_events(r, c);
}
