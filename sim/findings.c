// SPDX-License-Identifier: MIT
#include "findings.h"
#include "energy_plot.h"
#include "words.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

void brink_findings_file(const brink_case *c, enum brink_method method,
                         char *name, size_t size)
{
    snprintf(name, size, "%s-%s.dat", c->name,
             brink_words_slug(brink_method_rule(method)->name).text);
}

void brink_findings_outcome(const brink_trial *t, char *text, size_t size)
{
    const brink_words n = brink_words_grouped(t->events);
    const char *events = n.text;
    switch (t->outcome) {
    case BRINK_OUTCOME_DONE:
        snprintf(text, size, "did all %s events", events);
        break;
    case BRINK_OUTCOME_AT_REST:
        snprintf(text, size, "came to rest after %s events", events);
        break;
    case BRINK_OUTCOME_STANDS_STILL:
        snprintf(text, size, "stood still after %s events", events);
        break;
    case BRINK_OUTCOME_ENERGY_OFF:
        snprintf(
            text, size,
            "had its energy off by more than |ε| a particle within %s events",
            events);
        break;
    case BRINK_OUTCOME_REFUSED:
        snprintf(text, size, "was refused an event after %s", events);
        break;
    case BRINK_OUTCOME_NO_MEMORY:
        snprintf(text, size, "ran out of memory after %s events", events);
        break;
    case BRINK_OUTCOME_NONE:
        snprintf(text, size, "crashed");
        break;
    }
}

static int came_through(const brink_trial *t)
{
    return t->outcome == BRINK_OUTCOME_DONE ||
           t->outcome == BRINK_OUTCOME_AT_REST;
}

// "a, b and c": the names of the conventional methods that came through, or did
// not.
static int list_methods(const brink_case *c, int through, char *text, size_t size)
{
    int count = 0, listed = 0;
    size_t at = 0;
    for (int k = BRINK_METHOD_LOGICAL + 1; k < BRINK_METHODS; k++)
        count += came_through(&c->trial[k]) == through;
    text[0] = '\0';
    for (int k = BRINK_METHOD_LOGICAL + 1; k < BRINK_METHODS; k++) {
        const brink_trial *t = &c->trial[k];
        char outcome[160];
        if (came_through(t) != through)
            continue;
        const char *link = listed == 0           ? ""
                           : listed == count - 1 ? " and "
                                                 : ", ";
        brink_findings_outcome(t, outcome, sizeof outcome);
        listed++;
        at +=
            (size_t)snprintf(text + at, size - at, through ? "%s%s" : "%s%s (%s)",
                             link, brink_method_rule(t->method)->name, outcome);
        if (at >= size)
            break;
    }
    return count;
}

void brink_findings_sentences(const brink_case *c, char *text, size_t size)
{
    const brink_trial *logical = &c->trial[BRINK_METHOD_LOGICAL];
    char outcome[160], failed[900], through[400], error[160];
    const int failures = list_methods(c, 0, failed, sizeof failed);
    const int successes = list_methods(c, 1, through, sizeof through);
    brink_findings_outcome(logical, outcome, sizeof outcome);
    if (logical->energy_worst > 0)
        snprintf(error, sizeof error, "was never further off than %s of itself",
                 brink_words_scientific(logical->energy_worst).text);
    else
        snprintf(error, sizeof error, "was exactly what it was at the start");
    size_t at = (size_t)snprintf(text, size,
                                 "With logical states the run %s, and at all "
                                 "sample points its energy %s. ",
                                 outcome, error);
    if (at >= size)
        return;
    if (failures == 0)
        snprintf(text + at, size - at, "So did %s.", through);
    else if (successes == 0)
        snprintf(text + at, size - at, "None of the others came that far: %s.",
                 failed);
    else
        snprintf(text + at, size - at,
                 "From the same start %d of the %d other ways failed – %s – "
                 "while %s came "
                 "through.",
                 failures, BRINK_METHODS - 1, failed, through);
}

// "A–A: energy −1 inside 3, hard core at 1".
static void tell_potentials(brink_report *r, const brink_scene *s)
{
    char text[1000];
    size_t at = 0;
    text[0] = '\0';
    for (int a = 0; a < s->species_count; a++)
        for (int b = a; b < s->species_count; b++) {
            const brink_potential *p = &s->potential[a * s->species_count + b];
            for (int k = 0; k < p->count && at < sizeof text; k++) {
                if (k == 0)
                    at +=
                        (size_t)snprintf(text + at, sizeof text - at,
                                         "%s%s–%s: ", at > 0 ? "; " : "",
                                         s->species[a].name, s->species[b].name);
                else
                    at += (size_t)snprintf(text + at, sizeof text - at, ", ");
                if (at < sizeof text)
                    at +=
                        (size_t)(isinf(p->energy[k])
                                     ? snprintf(text + at, sizeof text - at,
                                                "hard core at %g", p->distance[k])
                                     : snprintf(text + at, sizeof text - at,
                                                "energy %g within %g",
                                                p->energy[k], p->distance[k]));
            }
        }
    brink_report_paragraph(
        r, "%s particles at temperature %g, %g × %g × %g in size; %s.",
        brink_words_grouped(s->count).text, s->temperature, s->length[0],
        s->length[1], s->length[2], text);
}

static void tell_outcomes(brink_report *r, const brink_case *c)
{
    static const char *const head[] = {"way", "what became of it",
                                       "energy error at the end", "µs an event"};
    static const char *const kinds[] = {"core", "capture", "release", "bounce"};
    brink_report_table(
        r,
        "What became of each. The error is relative to the energy at the "
        "start. Times are of this machine, the conventional ways' in a plain "
        "loop and the logical states' while being watched.",
        4, "llrr", head);
    for (int k = 0; k < BRINK_METHODS; k++) {
        const brink_trial *t = &c->trial[k];
        char outcome[160];
        brink_findings_outcome(t, outcome, sizeof outcome);
        brink_report_cell(r, "%s", brink_method_rule(t->method)->name);
        if (came_through(t) || t->events == 0)
            brink_report_cell(r, "%s", outcome);
        else
            brink_report_cell(
                r, "%s; the last a %s of particles %" PRIu32 " and %" PRIu32,
                outcome, kinds[t->last.kind], t->last.i, t->last.j);
        brink_report_cell(r, "%s", brink_words_scientific(t->energy_error).text);
        brink_report_cell(r, "%.1f", t->seconds / (double)t->events * 1e6);
    }
    brink_report_table_end(r);
}

static void tell_events(brink_report *r, const brink_case *c)
{
    static const char *const head[] = {"way",  "capture", "release", "bounce",
                                       "core", "cell",    "at once", "repeated"};
    brink_report_table(
        r,
        "Events by kind, as each way takes them. Apart from these: crossings "
        "of the cells that the program sorts particles into; events due at "
        "once when they were predicted; and those of the same pair at the "
        "same instant as the event before.",
        8, "lrrrrrrr", head);
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

// What [S16] section 5 found an event, for a square well or a shoulder; else 0.
static double paper_says(const brink_scene *s)
{
    const brink_potential *p = &s->potential[0];
    if (s->species_count != 1 || p->count != 2 || !isinf(p->energy[1]))
        return 0;
    return p->energy[0] < 0 ? 1.4e-7 : 2.6e-7;
}

static void tell_doubt(brink_report *r, const char *what, uint64_t count,
                       uint64_t of, double paper)
{
    brink_report_cell(r, "%s", what);
    brink_report_cell(r, "%s", brink_words_grouped(count).text);
    brink_report_cell(r, "%s", brink_words_grouped(of).text);
    brink_report_cell(r, "%s", brink_words_frequency(count, of).text);
    if (paper > 0)
        brink_report_cell(r, "%s",
                          brink_words_scientific(paper * (double)of).text);
    else
        brink_report_cell(r, "–");
}

static void tell_doubts(brink_report *r, const brink_case *c)
{
    static const char *const head[] = {"position shows another state", "seen",
                                       "looks", "frequency",
                                       "[S16] would expect"};
    const brink_trial *t = &c->trial[BRINK_METHOD_LOGICAL];
    const brink_doubts *d = &t->doubts;
    const double paper = paper_says(&c->scene);
    brink_report_paragraph(r, "In the run with logical states one can look at "
                              "what the positions would have "
                              "said, and count how often it is wrong.");
    brink_report_table(
        r,
        "Inconsistencies between position and logical state, with counting "
        "errors (none seen: 95 % bound).",
        5, "lrrrr", head);
    tell_doubt(r, "(A) when an event is executed, just before it", d->before,
               d->events, paper);
    tell_doubt(r, "(B) right after it, where the pair is looked at again",
               d->after, d->events, paper);
    tell_doubt(
        r, "(C) the pair looked at again at the next event of either particle",
        d->later, d->looks_later, paper);
    tell_doubt(r, "hard cores that overlap by a rounding when they collide",
               d->overlaps, t->tally.core, 0);
    brink_report_table_end(r);
}

// Which of the definitions comes near to the paper's figure: within three
// counting errors.
static void tell_paper(brink_report *r, const brink_case *c)
{
    const brink_doubts *d = &c->trial[BRINK_METHOD_LOGICAL].doubts;
    const double paper = paper_says(&c->scene);
    const struct {
        const char *name;
        uint64_t count, of;
    } kinds[] = {{"(A)", d->before, d->events},
                 {"(B)", d->after, d->events},
                 {"(C)", d->later, d->looks_later}};
    char near[40] = "";
    if (paper == 0)
        return;
    for (size_t k = 0; k < 3; k++) {
        const double expected = paper * (double)kinds[k].of;
        const double off = fabs((double)kinds[k].count - expected);
        if (off <= 3 * sqrt(fmax(expected, 1)))
            snprintf(near + strlen(near), sizeof near - strlen(near), "%s%s",
                     near[0] != '\0' ? " and " : "", kinds[k].name);
    }
    brink_report_paragraph(r,
                           "[S16] gives %s an event for this potential, of 32 "
                           "000 particles and 3.2 × 10⁸ "
                           "events, and does not say what was counted. %s%s%s",
                           brink_words_scientific(paper).text,
                           near[0] != '\0' ? "Near to it comes "
                                           : "None of these ",
                           near[0] != '\0' ? near : "comes near to it",
                           paper * (double)d->looks_later < 3
                               ? "; but a run of this size is too short to tell "
                                 "so rare a thing from one that "
                                 "never happens."
                               : ".");
}

void brink_findings_tell(brink_report *r, const brink_case *c)
{
    char text[2000], name[80];
    brink_report_heading(r, 2, "%s",
                         c->scene.title[0] != '\0' ? c->scene.title : c->name);
    tell_potentials(r, &c->scene);
    brink_findings_sentences(c, text, sizeof text);
    brink_report_finding(r, "%s", text);
    char *script = brink_energy_plot(c);
    snprintf(name, sizeof name, "%s-energy", c->name);
    if (script != NULL)
        brink_report_figure(
            r, name,
            "How far the energy is off, against the number of events done; both "
            "scales are "
            "logarithmic. The energy is taken from the positions, for all ways "
            "alike. A "
            "cross marks where a way was stopped, because time stood still (the "
            "same pair "
            "had over a thousand events at one instant) or the energy was off by "
            "more than "
            "|ε| a particle. Points in the shaded band have no error at all.",
            script);
    free(script);
    tell_outcomes(r, c);
    brink_report_heading(r, 3, "How often position is wrong");
    tell_doubts(r, c);
    tell_paper(r, c);
    brink_report_heading(r, 3, "What happened");
    tell_events(r, c);
}
