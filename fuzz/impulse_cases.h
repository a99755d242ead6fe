// SPDX-License-Identifier: MIT
#ifndef FUZZ_IMPULSE_CASES_H
#define FUZZ_IMPULSE_CASES_H
/** Pairs at a step, as the problems have them, and what is odder. */
#include "../tests/oracle_impulse.h"
#include "contract.h"
#include <brink/impulse.h>
#include <string.h>

/** r m1 m2 v1 v2 rise way, as problem_step's inputs. */
typedef struct impact {
    double r[3], m1, m2, v1[3], v2[3], rise, way;
} impact;

/** What an impulse leaves and answers. */
typedef struct aftermath {
    double v1[3], v2[3], virial, owed;
    int crossed;
} aftermath;

static inline aftermath before_impact(const impact *p, double owed)
{
    aftermath a = {.owed = owed};
    memcpy(a.v1, p->v1, sizeof a.v1);
    memcpy(a.v2, p->v2, sizeof a.v2);
    return a;
}

static inline oracle_pair pair_before(const impact *p)
{
    return (oracle_pair){p->m1, p->m2, p->v1, p->v2};
}

static inline oracle_pair pair_after(const impact *p, const aftermath *a)
{
    return (oracle_pair){p->m1, p->m2, a->v1, a->v2};
}

static inline enum brink_direction way_of(const impact *p)
{
    return p->way < 0 ? BRINK_INWARD : BRINK_OUTWARD;
}

static inline _Noreturn void impact_broken(const char *what, const impact *p,
                                           const aftermath *a, double got)
{
    FINDING("%s", what);
    finding_numbers("r", 3, p->r);
    finding_numbers("m", 2, &p->m1);
    finding_numbers("v1", 3, p->v1);
    finding_numbers("v2", 3, p->v2);
    finding_numbers("rise", 1, &p->rise);
    finding_numbers("way", 1, &p->way);
    finding_numbers("v1_after", 3, a->v1);
    finding_numbers("v2_after", 3, a->v2);
    fprintf(stderr, "  crossed %d, owed %a, virial %a; %a\n", a->crossed, a->owed,
            a->virial, got);
    finding_end();
}

/** mu b^2 / 2 r.r = i j k^2 r.r is the rise, in whole numbers, or beside it by an
 *  ulp: m1 = 2 i (i + j), m2 = 2 j (i + j), v1 - v2 = k r. */
static inline void whole_impact(stream *s, impact *p)
{
    const double i = stream_int(s, 1, 256), j = stream_int(s, 1, 256),
                 k = stream_int(s, 1, 256);
    double rr = 0;
    p->m1 = 2 * i * (i + j);
    p->m2 = 2 * j * (i + j);
    for (int axis = 0; axis < 3; axis++) {
        p->r[axis] = stream_int(s, -256, 256);
        p->v2[axis] = stream_int(s, -8, 8);
        p->v1[axis] = p->v2[axis] - p->way * k * p->r[axis];
        rr += p->r[axis] * p->r[axis];
    }
    p->way = -p->way;
    p->rise = stream_near(s, i * j * k * k * rr, 1);
}

/** An impact of the families, or a rarer one made of it; r is not 0. */
static inline impact some_impact(stream *s)
{
    double x[PROBLEM_INPUTS] = {0};
    impact p;
    const int kind = stream_int(s, 0, 9);
    contract_case(&problem_step, s, 12, x);
    memcpy(&p, x, sizeof p);
    const double scale = p.rise;
    switch (kind) {
    case 0: // met from where it comes
        p.way = -p.way;
        break;
    case 1:
        p.rise = 0;
        break;
    case 2:
        p.rise = scale * stream_scaled(s, -60, 40);
        break;
    case 3:
        whole_impact(s, &p);
        break;
    case 4: // all but at relative rest
        for (int k = 0; k < 3; k++)
            p.v1[k] = stream_near(s, p.v2[k], 1);
        break;
    default:
        break;
    }
    return p;
}

/** The same, all but along the rim. */
static inline impact some_rim_impact(stream *s)
{
    double x[PROBLEM_INPUTS] = {0};
    impact p;
    contract_case(&problem_rim, s, 11, x);
    memcpy(&p, x, sizeof p);
    p.way = BRINK_OUTWARD;
    return p;
}

static inline int is_at_one_place(const impact *p)
{
    return p->r[0] == 0 && p->r[1] == 0 && p->r[2] == 0;
}
#endif
