// SPDX-License-Identifier: MIT
// The paths between two events.
#include "witness_parts.h"
#include <math.h>

/** The nearest and the furthest that |r + v t| gets from 0 to h. */
static void extremes(const long double r[3], const long double v[3],
                     long double h, long double *least, long double *most)
{
    long double a = 0, b = 0, t = 0, end[3] = {0};
    for (int k = 0; k < 3; k++) {
        a += v[k] * v[k];
        b += v[k] * r[k];
    }
    if (a > 0)
        t = fminl(fmaxl(-b / a, 0), h);
    for (int k = 0; k < 3; k++) {
        const long double x = r[k] + v[k] * t, z = r[k] + v[k] * h;
        end[0] += r[k] * r[k];
        end[1] += z * z;
        end[2] += x * x;
    }
    *least = sqrtl(fminl(end[2], fminl(end[0], end[1])));
    *most = sqrtl(fmaxl(end[0], end[1]));
}

/** Which images, -1, 0, 1 lengths along an axis, come within `reach`; how many.
 */
static int images_in_reach(long double x, long double v, long double h,
                           double length, double reach, long double at[3])
{
    int n = 0;
    for (int shift = -1; shift <= 1; shift++) {
        const long double here = x + shift * length, there = here + v * h;
        if (!((here > reach && there > reach) ||
              (here < -reach && there < -reach)))
            at[n++] = here;
    }
    return n;
}

/** A captured pair has one image that is where its level says; all others, and
 *  all of a pair that is not, are outside of the outermost step. */
static void look_at_path(const witness *w, uint32_t i, uint32_t j,
                         const long double r[3], const long double v[3],
                         long double h)
{
    const brink_system *s = &w->begin;
    const brink_potential *p = brink_system_potential(s, i, j);
    const int level = *witness_level(w, i, j);
    const double off = witness_contact_bound(w), reach = p->distance[0] + off;
    const double inner = level < p->count ? p->distance[level] - off : -1;
    const double outer = level > 0 ? p->distance[level - 1] + off : reach;
    long double at[3][3] = {{0}}; // of a plane 0 is all there is
    int n[3] = {1, 1, 1}, inside = 0, right = level == 0;
    for (int a = 0; a < (s->dimensions == 3 ? 3 : 2); a++)
        n[a] = images_in_reach(r[a], v[a], h, s->length[a], reach, at[a]);
    for (int k = 0; k < n[0] * n[1] * n[2]; k++) {
        const long double image[3] = {at[0][k % n[0]], at[1][k / n[0] % n[1]],
                                      at[2][k / n[0] / n[1]]};
        long double least, most;
        extremes(image, v, h, &least, &most);
        inside += least < p->distance[0] - off;
        right |= least >= inner && most <= outer;
    }
    if (!right || inside > (level > 0))
        witness_break(
            w,
            "%u and %u at level %d are not where it says: r = {%La, %La, "
            "%La}, v = {%La, %La, %La}, for %La",
            i, j, level, r[0], r[1], r[2], v[0], v[1], v[2], h);
}

enum { PARTS = 64 }; // of a flight; longer ones are looked at no further

/** In parts of which none is longer than a quarter of the box, so that the images
 *  around the nearest are all there are. */
static void look_at_flight(const witness *w, uint32_t i, uint32_t j,
                           long double left)
{
    const brink_system *s = &w->before;
    const brink_particle *p = &s->particle[i], *q = &s->particle[j];
    const brink_instant year = {s->epoch, 0};
    const long double now = brink_instant_since(s->year, w->since, year);
    long double x[3], v[3], part = left;
    for (int a = 0; a < 3; a++) {
        v[a] = (long double)p->v[a] - q->v[a];
        x[a] = (int64_t)(p->x[a] - q->x[a]) * (long double)s->unit[a] +
               p->v[a] * (now - p->since) - q->v[a] * (now - q->since);
        if (a < s->dimensions)
            part = fminl(part, s->length[a] / 4 / fabsl(v[a]));
    }
    for (int n = 0; n < PARTS && left >= 0; n++, left -= part) {
        for (int a = 0; a < (s->dimensions == 3 ? 3 : 2); a++)
            x[a] -= s->length[a] * rintl(x[a] / s->length[a]);
        look_at_path(w, i, j, x, v, fminl(part, left));
        for (int a = 0; a < 3; a++)
            x[a] += v[a] * part;
        if (!(part < left))
            return;
    }
}

void witness_look_at_flights(const witness *w)
{
    const long double h =
        brink_instant_since(w->begin.year, w->run->now, w->since);
    for (uint32_t i = 0; i < w->begin.count; i++)
        for (uint32_t j = i + 1; j < w->begin.count; j++)
            look_at_flight(w, i, j, h);
}
