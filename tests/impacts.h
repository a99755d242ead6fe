// SPDX-License-Identifier: MIT
#ifndef TESTS_IMPACTS_H
#define TESTS_IMPACTS_H
/** Two particles at a step: random ones, and what is conserved there. */
#include "oracle_impulse.h"
#include "pairs.h"
#include "suite.h"
#include <brink/impulse.h>

enum { IMPACTS = 4000, SEED = 1 };

typedef struct impact {
    double r[3], m1, m2, rise, v1[3], v2[3];
    enum brink_direction way;
} impact;

static inline void stop(const char *what, int i, const impact *p,
                        const double v1[3], const double v2[3])
{
    ck_abort_msg("%s, case %d (seed %d):\nr %a %a %a  m %a %a  rise %a  way %d\n"
                 "v1 %a %a %a  v2 %a %a %a\nafter %a %a %a  %a %a %a",
                 what, i, SEED, p->r[0], p->r[1], p->r[2], p->m1, p->m2, p->rise,
                 p->way, p->v1[0], p->v1[1], p->v1[2], p->v2[0], p->v2[1],
                 p->v2[2], v1[0], v1[1], v1[2], v2[0], v2[1], v2[2]);
}

/** The pair's energy, changed by `rise`, and its momentum keep their bounds. */
static inline void keep_what_is_conserved(int i, const impact *p, double rise,
                                          const double v1[3], const double v2[3])
{
    const oracle_pair before = {p->m1, p->m2, p->v1, p->v2};
    const oracle_pair after = {p->m1, p->m2, v1, v2};
    if (!(oracle_energy_error(&before, &after, rise) <= BRINK_IMPULSE_ENERGY_ULP))
        stop("energy", i, p, v1, v2);
    if (!(oracle_momentum_error(&before, &after) <= BRINK_IMPULSE_MOMENTUM_ULP))
        stop("momentum", i, p, v1, v2);
}

/** A pair at a step, on the surface to a few ulp; masses up to 1e12 apart. */
static inline void random_impact(stream *s, impact *p)
{
    fill_normal(s, p->r, 1);
    resize(p->r, 1 + stream_int(s, -4, 4) * 0x1p-52);
    p->m1 = stream_real(s, 0.5, 2);
    p->m2 = stream_real(s, 0.5, 2);
    if (stream_int(s, 0, 1))
        p->m2 *= pow(10, stream_real(s, -11.5, 11.5));
    fill_normal(s, p->v1, 1);
    fill_normal(s, p->v2, stream_int(s, 0, 1) ? 1 : sqrt(p->m1 / p->m2));
    double b = 0, vv = 0;
    for (int k = 0; k < 3; k++) {
        b += p->r[k] * (p->v1[k] - p->v2[k]);
        vv += (p->v1[k] - p->v2[k]) * (p->v1[k] - p->v2[k]);
    }
    p->way = b < 0 ? BRINK_INWARD : BRINK_OUTWARD;
    double mu = p->m1 / (p->m1 + p->m2) * p->m2;
    switch (stream_int(s, 0, 3)) {
    case 0:
        p->rise = stream_real(s, -1, 1) * mu * vv;
        break;
    case 1:
        p->rise = stream_scaled(s, -60, 4) * mu * vv;
        break;
    case 2: // on the brink
        p->rise = stream_near(s, mu * b * b / 2, 3);
        break;
    default: // a small step, as of a potential mapped to many
        p->rise = stream_real(s, -1, 1) * 0x1p-10 * mu * b * b;
    }
}
#endif
