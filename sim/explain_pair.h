// SPDX-License-Identifier: MIT
#ifndef BRINK_EXPLAIN_PAIR_H
#define BRINK_EXPLAIN_PAIR_H
/**
 * What there is to know of one pair at one moment, and of its meeting a step, on
 * paper: every number in decimal (%.17g) and in hex (%a), signs and decisions as
 * the kernels have them.  Needs no run: a finding of a fuzzer or of a test can be
 * printed with it.
 */
#include <brink/step.h>
#include <stdio.h>

typedef struct brink_explained {
    double r[3], v1[3], v2[3]; // r = x1 - x2
    double m1, m2;
    const brink_potential *potential;
    int level;
} brink_explained;

/** r, velocities, masses, the potential with its levels. */
void brink_explain_pair(FILE *out, const brink_explained *pair);

/** The sphere of that diameter: f, its rate, their exact signs, the quadratic and
 * its roots, the distance from the surface, and every tier's time inward and
 * outward. */
void brink_explain_ball(FILE *out, const double r[3], const double v[3],
                        double sigma);

/** The plane through c, of which n points to the valid side, likewise. */
void brink_explain_halfspace(FILE *out, const double r[3], const double v[3],
                             const double n[3], const double c[3]);

/** The spheres of the steps that the pair can meet from its level. */
void brink_explain_surfaces(FILE *out, const brink_explained *pair);

/**
 * The pair met the step next to its level in direction `way`, *owed being what
 * roundings have taken so far (see <brink/impulse.h>): whether it crosses, and
 * why; its level, its velocities, energies and the account afterwards, which are
 * the pair's then.  A step that there is not is refused and changes nothing.
 */
void brink_explain_meeting(FILE *out, brink_explained *pair,
                           enum brink_direction way, double *owed);
#endif
