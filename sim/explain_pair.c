// SPDX-License-Identifier: MIT
#include "explain_pair.h"
#include "explain_put.h"
#include "run_meeting.h"
#include "sum.h"
#include <brink/event_time.h>
#include <brink/overlap.h>
#include <brink/quadratic.h>
#include <math.h>

static void relative(const brink_explained *pair, double v[3])
{
    for (int a = 0; a < 3; a++)
        v[a] = pair->v1[a] - pair->v2[a];
}

static double dot(const double x[3], const double y[3])
{
    return brink_ball_overlap_rate(x, y);
}

// --- The pair ------------------------------------------------------------------

void brink_explain_pair(FILE *out, const brink_explained *pair)
{
    const brink_potential *p = pair->potential;
    double v[3];
    char words[100];
    relative(pair, v);
    if (pair->level == 0)
        snprintf(words, sizeof words, "0: outside all of %d steps", p->count);
    else
        snprintf(words, sizeof words, "%d: inside step %d of %d", pair->level,
                 pair->level, p->count);
    put_words(out, "level", words);
    put_vector(out, "r = r1 - r2", pair->r);
    put_number(out, "|r|", sqrt(dot(pair->r, pair->r)));
    put_vector(out, "v = v1 - v2", v);
    put_number(out, "|v|", sqrt(dot(v, v)));
    put_vector(out, "v1", pair->v1);
    put_vector(out, "v2", pair->v2);
    put_number(out, "m1", pair->m1);
    put_number(out, "m2", pair->m2);
    for (int k = 0; k < p->count; k++) {
        snprintf(words, sizeof words, "step %d: distance", k + 1);
        put_number(out, words, p->distance[k]);
        put_number(out, "        energy inside it", p->energy[k]);
    }
}

// --- Its surfaces --------------------------------------------------------------

static void put_sign(FILE *out, const char *name, double x, int sign,
                     const char *const words[3])
{
    char remark[60];
    snprintf(remark, sizeof remark, "sign %2d: %s", sign, words[sign + 1]);
    put_remark(out, name, x, remark);
}

static const char *const sides[3] = {"inside", "on it", "outside"};
static const char *const ways[3] = {"approaching", "neither", "parting"};

// a t^2 + 2 b t + c, of coefficients that are rounded: what the kernels do not
// rely on.
static void put_quadratic(FILE *out, double a, double b, double c)
{
    double root[2];
    const double ac = a * c, rest = fma(a, c, -ac);    // a c, exactly, and so
    const double discriminant = fma(b, b, -ac) - rest; // nothing cancels unseen
    const int roots = brink_quadratic_roots_cr(a, 2 * b, c, &root[0], &root[1]);
    put_number(out, "a = v.v", a);
    put_number(out, "b = r.v", b);
    put_number(out, "c = r.r - distance^2", c);
    put_number(out, "b^2 - a c", discriminant);
    if (roots <= 0)
        put_words(out, "roots of a t^2 + 2 b t + c", "none");
    for (int k = 0; k < roots; k++)
        put_number(out, k ? "" : "roots of a t^2 + 2 b t + c", root[k]);
}

static void put_distance_from(FILE *out, double f, double length, double sigma)
{
    const double gap = f / (length + sigma); // |r| - sigma, nothing cancels
    const double ulp = nextafter(sigma, (double)INFINITY) - sigma;
    put_number(out, "|r| - distance, relative", gap / sigma);
    put_number(out, "    in ulp of the distance", gap / ulp);
}

void brink_explain_ball(FILE *out, const double r[3], const double v[3],
                        double sigma)
{
    const double f = brink_ball_overlap(r, sigma), rate = dot(r, v);
    put_sign(out, "f = r.r - distance^2", f, brink_ball_overlap_sign(r, sigma),
             sides);
    put_sign(out, "rate = r.v", rate, brink_ball_overlap_rate_sign(r, v), ways);
    put_distance_from(out, f, sqrt(dot(r, r)), sigma);
    put_quadratic(out, dot(v, v), rate, f);
    put_number(out, "intersection time, fast",
               brink_intersection_time_fast(r, v, sigma));
    put_number(out, "                   plain",
               brink_intersection_time(r, v, sigma));
    put_number(out, "                   cr",
               brink_intersection_time_cr(r, v, sigma));
    put_number(out, "disjoint time, fast", brink_disjoint_time_fast(r, v, sigma));
    put_number(out, "               plain", brink_disjoint_time(r, v, sigma));
    put_number(out, "               cr", brink_disjoint_time_cr(r, v, sigma));
}

void brink_explain_halfspace(FILE *out, const double r[3], const double v[3],
                             const double n[3], const double c[3])
{
    put_sign(out, "f = n.(r - c)", brink_halfspace_overlap(r, n, c),
             brink_halfspace_overlap_sign(r, n, c), sides);
    put_sign(out, "rate = n.v", brink_halfspace_overlap_rate(v, n),
             brink_halfspace_overlap_rate_sign(v, n), ways);
    put_number(out, "halfspace time", brink_halfspace_time(r, v, n, c));
}

static void put_surface(FILE *out, const brink_explained *pair, int step,
                        const char *which)
{
    const double sigma = pair->potential->distance[step];
    double v[3];
    char head[120];
    relative(pair, v);
    snprintf(head, sizeof head, "%s: step %d, distance %.17g = %a", which,
             step + 1, sigma, sigma);
    put_head(out, head);
    brink_explain_ball(out, pair->r, v, sigma);
}

void brink_explain_surfaces(FILE *out, const brink_explained *pair)
{
    if (pair->level < pair->potential->count)
        put_surface(out, pair, pair->level, "the surface inside");
    if (pair->level > 0)
        put_surface(out, pair, pair->level - 1, "the surface outside");
}

// --- Its meeting a step --------------------------------------------------------

// sum += m v.v, m v's rounding included.
static void add_energy(brink_sum *sum, double m, const double v[3])
{
    for (int a = 0; a < 3; a++) {
        const double p = m * v[a];
        brink_sum_product(sum, p, v[a]);
        brink_sum_product(sum, fma(m, v[a], -p), v[a]);
    }
}

static double kinetic_energy(const brink_explained *pair)
{
    brink_sum twice = {0, 0};
    add_energy(&twice, pair->m1, pair->v1);
    add_energy(&twice, pair->m2, pair->v2);
    return brink_sum_value(&twice) / 2;
}

// What the account does not account for.
static double left_over(const brink_explained *before,
                        const brink_explained *after, double step, double owed,
                        double owed_after)
{
    brink_sum twice = {0, 0};
    add_energy(&twice, after->m1, after->v1);
    add_energy(&twice, after->m2, after->v2);
    add_energy(&twice, -before->m1, before->v1);
    add_energy(&twice, -before->m2, before->v2);
    brink_sum_add(&twice, 2 * step);
    brink_sum_add(&twice, -2 * owed);
    brink_sum_add(&twice, 2 * owed_after);
    return brink_sum_value(&twice) / 2;
}

static void put_question(FILE *out, const brink_explained *pair, double rise)
{
    const double m1 = pair->m1, m2 = pair->m2;
    double v[3];
    relative(pair, v);
    const double b = dot(pair->r, v), rr = dot(pair->r, pair->r);
    put_number(out, "energy across it", rise);
    put_number(out, "m1 m2 b^2", m1 * m2 * b * b);
    put_number(out, "2 energy r.r (m1 + m2)", 2 * rise * rr * (m1 + m2));
}

static const char *answer(const brink_meeting *met, enum brink_direction way)
{
    switch (met->kind) {
    case BRINK_CORE:
        return "bounced: a hard core; nothing suffices (kind: core)";
    case BRINK_CAPTURE:
        return "crossed: the former is larger (kind: capture)";
    case BRINK_RELEASE:
        return "crossed: the former is larger (kind: release)";
    case BRINK_BOUNCE:
        break;
    }
    if (met->rim)
        return "bounced, and turned inward by the rim rule (kind: bounce)";
    return way == BRINK_INWARD ? "bounced: the former is not larger, and stays "
                                 "outside (kind: bounce)"
                               : "bounced: the former is not larger, and stays "
                                 "inside (kind: bounce)";
}

static void put_after(FILE *out, const brink_explained *before,
                      const brink_explained *after, double step, double owed,
                      double owed_after)
{
    const double energy = kinetic_energy(before), now = kinetic_energy(after);
    double v[3];
    relative(after, v);
    put_head(out, "afterwards");
    put_vector(out, "v1", after->v1);
    put_vector(out, "v2", after->v2);
    put_number(out, "b = r.v", dot(after->r, v));
    put_number(out, "kinetic energy before", energy);
    put_number(out, "               after", now);
    put_number(out, "potential energy gained", step);
    put_number(out, "owed before", owed);
    put_number(out, "     after", owed_after);
    put_number(out, "unaccounted for",
               left_over(before, after, step, owed, owed_after));
}

void brink_explain_meeting(FILE *out, brink_explained *pair,
                           enum brink_direction way, double *owed)
{
    const brink_explained before = *pair;
    const double owed_before = *owed;
    const double rise = brink_step_rise(pair->potential, pair->level, way);
    char words[60];
    put_head(out, way == BRINK_INWARD ? "the decision, at the step inside"
                                      : "the decision, at the step outside");
    put_question(out, pair, rise);
    if (isnan(rise)) {
        put_words(out, "answer",
                  "refused: from this level there is no such step");
        return;
    }
    const brink_meeting met = brink_meeting_at(pair->r, pair->m1, pair->m2, rise,
                                               way, pair->v1, pair->v2, owed);
    brink_step_next(pair->potential, pair->level, met.kind, &pair->level);
    put_words(out, "answer", answer(&met, way));
    snprintf(words, sizeof words, "%d -> %d", before.level, pair->level);
    put_words(out, "level", words);
    put_after(out, &before, pair, pair->level == before.level ? 0 : rise,
              owed_before, *owed);
}
