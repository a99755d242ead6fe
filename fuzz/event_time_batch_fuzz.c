// SPDX-License-Identifier: MIT
#include <brink/event_time.h>

#include "../tests/batches.h"
#include "../tests/pairs.h"
#include "fuzz.h"

enum { BLOCK = 128, MOST = 2 * BLOCK + 40, SHIFTS = 8, UNTOUCHED = -12345 };

/** Pairs as a structure of arrays: each array begins anywhere, and t may be one
 *  of them. */
typedef struct batch_case {
    double room[8][MOST + SHIFTS];
    int n, from[8]; // where the seven inputs and t begin
    int over;       // the array whose room t is written to; 7: its own
} batch_case;

/** A few pairs as a rule; else whole blocks, and what is left of one. */
static int some_size(stream *s)
{
    if (stream_int(s, 0, 7))
        return stream_int(s, 0, 40);
    return BLOCK * stream_int(s, 1, 2) + stream_int(s, -9, 40);
}

static void set_pair(batch_case *c, int i, const pair_case *p)
{
    for (int k = 0; k < 3; k++) {
        c->room[k][c->from[k] + i] = p->r[k];
        c->room[3 + k][c->from[3 + k] + i] = p->v[k];
    }
    c->room[6][c->from[6] + i] = p->sigma;
}

/** Pairs of one family, or of several, one in eight out of the domain where it is
 *  so decided for all. */
static void make_pairs(batch_case *c, stream *s)
{
    const int mixed = stream_int(s, 0, 2), broken = stream_int(s, 0, 3) == 0;
    int family = stream_int(s, 0, PAIR_FAMILIES - 1);
    for (int i = 0; i < c->n; i++) {
        pair_case p;
        if (mixed)
            family = stream_int(s, 0, PAIR_FAMILIES - 1);
        pair_families[family].make(s, &p);
        if (broken && stream_int(s, 0, 7) == 0)
            *(stream_sign(s) > 0 ? &p.sigma : &p.v[1]) = (double)NAN;
        if (broken && stream_int(s, 0, 7) == 0)
            p.sigma = -p.sigma;
        set_pair(c, i, &p);
    }
}

static _Noreturn void broken(const struct tier *tier, int way,
                             const batch_case *c, int i, double got, double right)
{
    FINDING("%s, way %d: %a, alone %a; %d of %d, t over array %d", tier->name,
            way, got, right, i, c->n, c->over);
    double x[7];
    for (int k = 0; k < 7; k++)
        x[k] = c->room[k][c->from[k] + i];
    finding_numbers("x", 7, x);
    finding_end();
}

static double alone(const struct tier *tier, const batch_case *c, int i)
{
    double x[7];
    for (int k = 0; k < 7; k++)
        x[k] = c->room[k][c->from[k] + i];
    return tier->one(x, x + 3, x[6]);
}

/** Nothing before t or behind it is written to. */
static void expect_margins(const struct tier *tier, int way, const batch_case *c,
                           const batch_case *after)
{
    for (int i = 0; i < MOST + SHIFTS; i++) {
        const int k = i - c->from[c->over];
        const double was = c->room[c->over][i], is = after->room[c->over][i];
        if ((k < 0 || k >= c->n) && !same(is, was))
            broken(tier, way, c, 0, is, was);
    }
}

static void check(const struct tier *tier, int way, const batch_case *c)
{
    static batch_case after;
    const double *in[7];
    after = *c;
    for (int k = 0; k < 7; k++)
        in[k] = after.room[k] + c->from[k];
    double *t = after.room[c->over] + c->from[c->over];
    batch_of(tier, way)((size_t)c->n, in[0], in[1], in[2], in[3], in[4], in[5],
                        in[6], t);
    for (int i = 0; i < c->n; i++) {
        const double right = alone(tier, c, i);
        if (!same(t[i], right))
            broken(tier, way, c, i, t[i], right);
    }
    expect_margins(tier, way, c, &after);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static batch_case c;
    stream s = stream_of_bytes(data, size);
    c.n = some_size(&s);
    c.over = stream_int(&s, 0, 1) ? 7 : stream_int(&s, 0, 6);
    for (int k = 0; k < 8; k++) {
        c.from[k] = stream_int(&s, 0, SHIFTS - 1);
        for (int i = 0; i < MOST + SHIFTS; i++)
            c.room[k][i] = UNTOUCHED;
    }
    make_pairs(&c, &s);
    for (int k = 0; k < TIERS; k++)
        for (int way = 0; way < WAYS && has_way(way); way++)
            check(&tiers[k], way, &c);
    return 0;
}
