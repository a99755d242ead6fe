// SPDX-License-Identifier: MIT
#ifndef BRINK_SCENE_MIX_H
#define BRINK_SCENE_MIX_H
/**
 * The potential of an unlike pair that is not given, from those of the two like
 * pairs, step by step: distances by the arithmetic mean (Lorentz), energies by
 * the geometric mean with the sign the two have in common (Berthelot), a hard
 * core with a hard core.
 */
#include <brink/step.h>

enum brink_mix {
    BRINK_MIX_GOOD,
    BRINK_MIX_COUNTS, // the two have different numbers of steps
    BRINK_MIX_CORES,  // one has a hard core, the other has none
    BRINK_MIX_SIGNS,  // a step attracts in one and repels in the other
    BRINK_MIX_STEPS   // two mean distances round to the same double
};

/** Fills distance and energy, of a->count values each, from two valid potentials.
 * Two that are the same give just that one again.  Energies and distances within
 *  1e-150 .. 1e150 do not over- or underflow on the way. */
enum brink_mix brink_mix_steps(const brink_potential *a, const brink_potential *b,
                               double *distance, double *energy);

/** Why not, as the end of a sentence that begins "the pair cannot be mixed: ". */
const char *brink_mix_reason(enum brink_mix mix);
#endif
