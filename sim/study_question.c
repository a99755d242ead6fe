// SPDX-License-Identifier: MIT
#include "study_question.h"
#include "conventional_method.h"
#include "study_words.h"

static const char opening[] =
    "Event-driven simulation moves particles from one event to the next: "
    "between events nothing acts on them, and they fly straight on. Such "
    "programs are exact but for rounding, and they have an old weakness. At "
    "the instant of an event a pair of particles sits on the very edge "
    "between two states, and a number rounded to sixteen digits cannot say on "
    "which side. This page runs the same systems from the same start with six "
    "answers to that question, and shows what becomes of the energy.";

static const char wells[] =
    "Two particles with a square well feel nothing of each other until they "
    "are within a distance σ₂. There the energy of the pair drops by ε, which "
    "goes into their motion: they are captured. To part again they have to "
    "pay it back, and if they are too slow they bounce off the rim and stay. "
    "At σ₁ their hard cores collide. A square shoulder is the same with a "
    "step up instead of down.";

static const char sketch_caption[] =
    "The energy of a pair against its distance. The events of the well: (1) "
    "capture, the pair comes in; (2a) release, it gets out; (2b) bounce, it "
    "is too slow to get out; (3) core, the hard spheres collide. The shoulder "
    "has the same events, but there it is coming in that costs energy.";

static const char trouble[] =
    "So the program has to know of every pair whether it is captured: that "
    "decides which event it can have next. The obvious way is to measure the "
    "distance. But the program has just moved the pair to where its distance "
    "is σ₂, and after rounding it is a hair more or a hair less, about as "
    "often the one as the other. A pair that has just been captured and lies "
    "a hair outside looks as if it were about to be captured. So it is, "
    "again, at the same instant; and again, each time with a gain of energy "
    "that nobody pays for, while the clock stands still.";

static const char remedy[] =
    "Strobl, Bannerman and Pöschel [S16] draw the conclusion: the state of a "
    "pair is information of its own. It is read off the positions once, when "
    "a configuration is first made, and from then on it changes only when a "
    "transfer is executed. Before that, programs have tried other ways:";

static const char fairness[] =
    "All else is equal: the same program, start, impulses and, but for the "
    "last way, event times. How far the two nudged ways move things is a "
    "constant found by trial, here %s of the distance for a position, and for "
    "a time %s of what the pair takes to fly it. Much less and rounding has "
    "its way again; much more and the pair flies past what a third particle "
    "would have done to it, as tables below show. Such constants depend on "
    "the system, and a run that went well does not vouch for the next.";

// The potential of [S16] figure 1 and its events; beside it the shoulder.
static const char sketch[] =
    "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 720 270\" "
    "role=\"img\" "
    "aria-label=\"The square well and the square shoulder, with their events\" "
    "font-family=\"sans-serif\" font-size=\"14\" fill=\"#1d2430\">\n"
    "<defs><marker id=\"tip\" viewBox=\"0 0 8 8\" refX=\"7\" refY=\"4\" "
    "markerWidth=\"11\" markerHeight=\"11\" "
    "markerUnits=\"userSpaceOnUse\" orient=\"auto\">"
    "<path d=\"M0,0 L8,4 L0,8 Z\" fill=\"#d55e00\"/></marker></defs>\n"
    // axes
    "<g stroke=\"#aeb7c4\" fill=\"none\">"
    "<path d=\"M40,100 H380 M430,170 H700\" stroke-dasharray=\"2 4\"/>"
    "<path d=\"M120,30 V230 M270,30 V230 M490,30 V230 M610,30 V230\" "
    "stroke-dasharray=\"2 4\"/></g>\n"
    // the potentials
    "<g stroke=\"#0072b2\" stroke-width=\"3\" fill=\"none\">"
    "<path d=\"M120,30 V180 H270 V100 H380\"/>"
    "<path d=\"M490,30 V100 H610 V170 H700\"/></g>\n"
    // the events
    "<g stroke=\"#d55e00\" stroke-width=\"2\" fill=\"none\" "
    "marker-end=\"url(#tip)\">"
    "<path d=\"M346,80 H276 Q258,80 258,98 V124\"/>"
    "<path d=\"M238,124 V70 Q238,54 254,54 H352\"/>"
    "<path d=\"M206,138 H256 Q264,144 256,150 H202\"/>"
    "<path d=\"M184,156 H134 Q126,162 134,168 H188\"/></g>\n"
    "<g text-anchor=\"middle\" font-weight=\"600\" fill=\"#d55e00\">"
    "<text x=\"358\" y=\"85\">1</text><text x=\"366\" y=\"59\">2a</text>"
    "<text x=\"190\" y=\"149\">2b</text><text x=\"200\" y=\"170\">3</text></g>\n"
    "<g text-anchor=\"middle\"><text x=\"120\" y=\"250\">σ₁</text>"
    "<text x=\"270\" y=\"250\">σ₂</text><text x=\"490\" y=\"250\">σ₁</text>"
    "<text x=\"610\" y=\"250\">σ₂</text>"
    "<text x=\"330\" y=\"250\" fill=\"#5b6575\">distance →</text>"
    "<text x=\"195\" y=\"22\">square well</text>"
    "<text x=\"550\" y=\"22\">square shoulder</text>"
    "<text x=\"80\" y=\"70\" fill=\"#5b6575\">core</text>"
    "<text x=\"460\" y=\"70\" fill=\"#5b6575\">core</text>"
    "<text x=\"325\" y=\"120\" fill=\"#5b6575\">apart</text>"
    "<text x=\"662\" y=\"190\" fill=\"#5b6575\">apart</text>"
    "<text x=\"195\" y=\"200\" fill=\"#5b6575\">captured</text>"
    "<text x=\"550\" y=\"90\" fill=\"#5b6575\">captured</text>"
    "<text x=\"30\" y=\"105\" fill=\"#5b6575\">0</text>"
    "<text x=\"26\" y=\"185\" fill=\"#5b6575\">−ε</text>"
    "<text x=\"422\" y=\"175\" fill=\"#5b6575\">0</text>"
    "<text x=\"418\" y=\"105\" fill=\"#5b6575\">+ε</text></g>\n"
    "</svg>\n";

void brink_question_pose(brink_report *r)
{
    static const char *const head[] = {"way",
                                       "how it tells on which side a pair is"};
    brink_report_paragraph(r, opening);
    brink_report_heading(r, 2, "The question");
    brink_report_paragraph(r, wells);
    brink_report_drawing(r, sketch, sketch_caption);
    brink_report_paragraph(r, trouble);
    brink_report_paragraph(r, remedy);
    brink_report_table(r, "Six ways to tell.", 2, "ll", head);
    for (int k = 0; k < BRINK_METHODS; k++) {
        const brink_rule *rule = brink_method_rule((enum brink_method)k);
        brink_report_cell(r, "%s", rule->name);
        brink_report_cell(r, "%s", rule->idea);
    }
    brink_report_table_end(r);
    brink_report_paragraph(r, fairness,
                           brink_words_scientific(BRINK_PLACE_NUDGE).text,
                           brink_words_scientific(BRINK_TIME_NUDGE).text);
}
