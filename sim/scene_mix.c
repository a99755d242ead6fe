// SPDX-License-Identifier: MIT
#include "scene_mix.h"
#include <math.h>

enum brink_mix brink_mix_steps(const brink_potential *a, const brink_potential *b,
                               double *distance, double *energy)
{
    if (a->count != b->count)
        return BRINK_MIX_COUNTS;
    for (int k = 0; k < a->count; k++) {
        const double e = a->energy[k], f = b->energy[k];
        distance[k] = (a->distance[k] + b->distance[k]) / 2;
        if (isinf(e) != isinf(f))
            return BRINK_MIX_CORES;
        if ((e < 0 && f > 0) || (e > 0 && f < 0))
            return BRINK_MIX_SIGNS;
        if (k > 0 && !(distance[k] < distance[k - 1]))
            return BRINK_MIX_STEPS;
        // sqrt(e * e) is e, exactly; inf * inf is inf
        energy[k] = copysign(sqrt(e * f), e != 0 ? e : f);
    }
    return BRINK_MIX_GOOD;
}

const char *brink_mix_reason(enum brink_mix mix)
{
    switch (mix) {
    case BRINK_MIX_GOOD:
        break;
    case BRINK_MIX_COUNTS:
        return "their potentials have different numbers of steps";
    case BRINK_MIX_CORES:
        return "one of them has a hard core and the other has none";
    case BRINK_MIX_SIGNS:
        return "a step attracts in one of them and repels in the other";
    case BRINK_MIX_STEPS:
        return "two of their steps would be at one distance";
    }
    return "";
}
