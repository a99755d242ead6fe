// SPDX-License-Identifier: MIT
// One event.
#include "witness_parts.h"
#include <brink/impulse.h>
#include <brink/overlap.h>
#include <math.h>

/** [S16 fig. 1]: what it does to a level, and which step it is at. */
static int is_legal(const brink_potential *p, const brink_happening *e, int level,
                    enum brink_direction *way)
{
    const double inner = level < p->count ? p->distance[level] : -1;
    const int core = level < p->count && isinf(p->energy[level]);
    const int change = (e->kind == BRINK_CAPTURE) - (e->kind == BRINK_RELEASE);
    *way = e->distance == inner ? BRINK_INWARD : BRINK_OUTWARD;
    if (e->level_before != level || e->level_after != level + change)
        return 0;
    if (*way == BRINK_OUTWARD &&
        (level == 0 || e->distance != p->distance[level - 1]))
        return 0;
    return e->kind == BRINK_CORE      ? core && *way == BRINK_INWARD
           : e->kind == BRINK_CAPTURE ? !core && *way == BRINK_INWARD
           : e->kind == BRINK_RELEASE ? *way == BRINK_OUTWARD
                                      : *way == BRINK_OUTWARD || !core;
}

/* At the step, and on its way to it: the radial speed may have the other sign by
 * what the separation's error turns the line of centres. */
static void look_at_contact(witness *w, enum brink_direction way)
{
    const brink_run *run = w->run;
    const brink_happening *e = &run->last;
    const double bound = witness_contact_bound(w);
    double r[3], square = 0, b = 0, speed = 0;
    brink_system_separation(&run->system, e->i, e->j, e->when.offset, r);
    for (int a = 0; a < 3; a++) {
        const double v =
            w->before.particle[e->i].v[a] - w->before.particle[e->j].v[a];
        square += r[a] * r[a];
        b += r[a] * v;
        speed += v * v;
    }
    const double distance = sqrt(square);
    const double off = fabs(distance - e->distance);
    w->counted.contact_error_max =
        fmax(w->counted.contact_error_max, off / e->distance);
    if (!(off <= bound))
        witness_break(w, "an event %a off its step, at most %a allowed", off,
                      bound);
    if (!((int)way * b >= -4 * sqrt(speed) * bound))
        witness_break(w, "an event of a pair that goes the other way: b = %a", b);
}

// BRINK_RIM_ANGLE of their relative speed is then 2^-48 of their speeds.
int witness_is_hidden(const witness *w, uint32_t i, uint32_t j)
{
    const double *vi = w->run->system.particle[i].v;
    const double *vj = w->run->system.particle[j].v;
    double apart = 0, together = 0;
    for (int a = 0; a < 3; a++) {
        apart += (vi[a] - vj[a]) * (vi[a] - vj[a]);
        together += vi[a] * vi[a] + vj[a] * vj[a];
    }
    return apart <= 0x1p-48 * together;
}

/* In through all steps and out again, and once more for a contact a rounding off.
 * A pair that bounced on without time moving on would be held up for ever: the
 * rim rule of <brink/impulse.h>. */
static void look_at_progress(witness *w, const brink_happening *e, int again)
{
    const int steps = brink_system_potential(&w->begin, e->i, e->j)->count;
    const int same = again && e->i == w->last.i && e->j == w->last.j;
    w->repeats = same ? w->repeats + 1 : 0;
    w->last = *e;
    if (w->repeats > 2 * steps + 1 && !witness_is_hidden(w, e->i, e->j))
        witness_break(w, "%d events of one pair at one instant", w->repeats + 1);
}

/* Who is turned back goes the other way afterwards: from a step's inside at the
 * angle of the rim rule or more, from its outside, or a core, not in again,
 * unless the two move together so fast that their roundings hide it. */
static void look_at_parting(const witness *w, enum brink_direction way)
{
    const brink_system *s = &w->run->system;
    const brink_happening *e = &w->run->last;
    const double *vi = s->particle[e->i].v, *vj = s->particle[e->j].v;
    double r[3], v[3], square = 0, speed = 0, b = 0;
    if (e->level_before != e->level_after || witness_is_hidden(w, e->i, e->j))
        return;
    brink_system_separation(s, e->i, e->j, e->when.offset, r);
    for (int a = 0; a < 3; a++) {
        v[a] = vi[a] - vj[a];
        square += r[a] * r[a];
        speed += v[a] * v[a];
        b += r[a] * v[a];
    }
    // Velocities are rounded to 2^-53 of themselves, so the angle to 2^-5 of it.
    if (way == BRINK_OUTWARD &&
        -b < BRINK_RIM_ANGLE * (1 - 0x1p-4) * sqrt(square * speed))
        witness_break(w, "a bounce along the rim: b = %a", b);
    if (way == BRINK_INWARD && brink_ball_overlap_rate_sign(r, v) < 0)
        witness_break(w, "turned back, and still going in: b = %a", b);
}

static void count(witness *w, const brink_happening *e)
{
    brink_tally *t = &w->counted;
    uint64_t *const kinds[] = {&t->core, &t->capture, &t->release, &t->bounce};
    const int again = brink_tally_events(t) > 0 &&
                      brink_instant_compare(e->when, w->since) == 0;
    ++*kinds[e->kind];
    t->zero_time += (uint64_t)again;
    look_at_progress(w, e, again);
}

void witness_look_at_event(witness *w)
{
    const brink_happening *e = &w->run->last;
    enum brink_direction way;
    if (e->i >= e->j || e->j >= w->begin.count)
        witness_break(w, "an event of no pair");
    int *level = witness_level(w, e->i, e->j);
    if (!is_legal(brink_system_potential(&w->begin, e->i, e->j), e, *level, &way))
        witness_break(w, "an event that is not legal at level %d", *level);
    if (brink_instant_compare(e->when, w->run->now) != 0)
        witness_break(w, "an event at another instant than now");
    look_at_contact(w, way);
    look_at_parting(w, way);
    count(w, e);
    *level = e->level_after;
}
