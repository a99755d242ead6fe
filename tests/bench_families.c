// SPDX-License-Identifier: MIT
#include "bench_families.h"
#include "problems_all.h"
#include <string.h>

/** After pairs.h, quadratics.h and problem_impulse.c, where they are made. */
static const struct {
    const char *name, *words;
} families[] = {
    {"benign", "coefficients of order one"},
    {"roots", "from two roots of any ratio"},
    {"double", "the discriminant is 0 up to a few ulp of its terms"},
    {"square",
     "(p x + q)² with p and q of 26 bits: a double root, or all but one"},
    {"integers", "small integers, zeros among them"},
    {"scaled",
     "one of the others times powers of two, up to the ends of the range"},
    {"wild",
     "every number of a magnitude of its own, zeros and subnormals among them"},
    {"subnormal", "subnormal coefficients, or nearly"},
    {"huge", "coefficients near the largest doubles"},
    {"midpoint", "a root all but halfway between two doubles"},
    {"sqrt", "a root like √(1 + 2 ulp), as near to halfway as one can be"},
    {"tiny", "a root that is subnormal, or nearly, beside one that is not"},
    {"close",
     "in integers, the discriminant down to 10⁻³² of its terms, but not 0"},
    {"dilute", "somewhere in a box of 20 diameters: most pairs never meet"},
    {"hits", "aimed at each other from up to 20 diameters away"},
    {"neighbours", "1 to 1.6 diameters apart, any velocity: a dense fluid"},
    {"contact",
     "on the surface to a few ulp: just after an event, or before one"},
    {"captured", "one inside the reach of the other"},
    {"grazing", "passing within a few ulp of the rim"},
    {"far", "passing the rim as closely, from up to 10¹² diameters away"},
    {"rim", "at the rim, moving all but along it"},
    {"tangent", "along an exact tangent, in integers, or an ulp beside it"},
    {"line", "head on, where a time can lie exactly between two doubles"},
    {"axial", "on the rim, moving along an axis"},
    {"cancelling", "r·v and r·r - σ² both cancel, all but entirely"},
    {"passing", "passing outside, all but at the closest approach"},
    {"missing", "r·v cancels all but entirely, far from contact"},
    {"closing",
     "r·r - σ² is down to 10⁻³² of either: on the surface to twice the digits"},
    {"triple", "r·r - σ² is 0 but for what √3 was rounded by, in integers"},
    {"upright", "r·v is 0 but for what 1/n was rounded by, in integers"},
    {"skimming", "just off the surface, hardly steep enough to reach it"},
    {"remainder", "r·v and r·r - σ² cancel twice over"},
    {"sideways", "moving all but along the surface, at any distance from it"},
    {"edge", "where squares, products or the answer all but underflow"},
    {"equal", "of equal masses, on the surface to a few ulp"},
    {"masses", "of masses up to 10¹² apart"},
    {"brink", "with the energy to cross the step, to a few ulp"},
    {"small", "at a step that is small beside their energy"},
};

static const char *words_for(const char *name)
{
    for (size_t k = 0; k < sizeof families / sizeof *families; k++)
        if (strcmp(families[k].name, name) == 0)
            return families[k].words;
    return "undescribed";
}

static void write_table(brink_report *r, const problem *p, const char *caption)
{
    const char *const head[] = {"family", "what it is"};
    brink_report_table(r, caption, 2, "ll", head);
    for (int f = 0; f < p->families; f++) {
        brink_report_cell(r, "%s", p->family(f));
        brink_report_cell(r, "%s", words_for(p->family(f)));
    }
    brink_report_table_end(r);
}

void bench_families(brink_report *r)
{
    brink_report_heading(r, 2, "The families of inputs");
    write_table(r, &problem_intersection, "Pairs.");
    write_table(r, &problem_quadratic, "Quadratics.");
    write_table(r, &problem_step, "Pairs at a step.");
}
