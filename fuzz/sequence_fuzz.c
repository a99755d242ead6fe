// SPDX-License-Identifier: MIT
/*
 * A few particles: the simulator's events are the reference's, in MPFR numbers,
 * for as long as doubles can know them.
 *
 * How long that is the reference says itself, deflected before every event by
 * some 2^-36 of its velocities and of the box, by SIGNS choices of signs: what
 * they all do, a simulator whose events are each off by less than 2^-47 of them
 * does, too (that number is derived in tests/sequence_test.c).  Before every one:
 * what rounding takes from a pair at speed in a deep well is far more than it
 * would have been before the pair fell in, and far too much when it has climbed
 * out.  Particles are near nothing but by chance: at a tie or a tangent all
 * deflections could do one thing, and a rounding the other.
 */
#include "../tests/reference.h"
#include "adverse.h"
#include "fuzz.h"
#include "run.h"

#define DEFLECTION 0x1p-36
enum { EVENTS = 12, SIGNS = 4, BITS = 256, FAR = 100 };

static int same(const reference_event *a, const reference_event *b, double off)
{
    return a->kind == b->kind && a->i == b->i && a->j == b->j &&
           fabs(a->time - b->time) <= off;
}

/** The run's first events; how many there are in FAR times the time that the
 *  fastest takes across an eighth of the box, as often as the reference looks. */
static int simulate(brink_run *run, reference_event event[EVENTS])
{
    double look = (double)INFINITY;
    for (uint32_t i = 0; i < run->system.count; i++)
        for (int a = 0; a < run->system.dimensions; a++)
            look = fmin(look, run->system.length[a] / 8 /
                                  fabs(run->system.particle[i].v[a]));
    const brink_instant until =
        brink_instant_after(run->system.year, run->now, FAR * look);
    for (int n = 0; n < EVENTS; n++) {
        const enum brink_run_status status =
            brink_run_advance(run, (uint64_t)n + 1, until);
        if (status != BRINK_RUN_REACHED ||
            brink_tally_events(&run->tally) != (uint64_t)n + 1)
            return n;
        event[n] = (reference_event){run->last.kind, run->last.i, run->last.j,
                                     brink_run_time(run)};
    }
    return EVENTS;
}

static void refer(const brink_system *system, unsigned long signs, int events,
                  reference_event event[EVENTS])
{
    reference w;
    reference_create(&w, system, BITS);
    for (int n = 0; n < events; n++) {
        if (signs > 0)
            reference_deflect(&w, DEFLECTION, signs * EVENTS + (unsigned long)n);
        if (!reference_next(&w, &event[n]))
            event[n] = (reference_event){.time = -1};
    }
    reference_destroy(&w);
}

static void compare(const brink_system *begin, int events,
                    const reference_event *event)
{
    reference_event truth[EVENTS], other[SIGNS][EVENTS];
    refer(begin, 0, events, truth);
    for (int k = 0; k < SIGNS; k++)
        refer(begin, (unsigned long)k + 1, events, other[k]);
    for (int n = 0; n < events; n++) {
        double off = 0;
        for (int k = 0; k < SIGNS; k++) {
            if (!same(&truth[n], &other[k][n], (double)INFINITY))
                return;
            off = fmax(off, fabs(truth[n].time - other[k][n].time));
        }
        // Beyond this they no longer stray in proportion to how they were
        // deflected, and it says nothing of how far a run's own roundings lead.
        if (off > 0x1p-10 * truth[n].time)
            return;
        if (same(&truth[n], &event[n], off))
            continue;
        FINDING(
            "sequence: event %d is kind %d of %u and %u at %a; the reference's "
            "kind %d of %u and %u at %a, known to %a",
            n + 1, (int)event[n].kind, event[n].i, event[n].j, event[n].time,
            (int)truth[n].kind, truth[n].i, truth[n].j, truth[n].time, off);
        adverse_tell(begin);
        finding_end();
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stream s = stream_of_bytes(data, size);
    brink_system begin, system;
    brink_run run;
    reference_event event[EVENTS];
    const enum brink_tier tier =
        (enum brink_tier)stream_int(&s, 0, BRINK_TIER_CR);
    adverse_make_few(&s, &begin);
    adverse_copy(&system, &begin);
    LAW(brink_run_create(&run, &system, tier) == 0, "sequence: memory is out");
    compare(&begin, simulate(&run, event), event);
    brink_run_destroy(&run);
    brink_system_destroy(&begin);
    return 0;
}
