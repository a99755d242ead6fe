// SPDX-License-Identifier: MIT
#include "plain_simulator.h"
#include "baselines.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NOBODY UINT32_MAX

static void *resized(void *memory, size_t count, size_t size)
{
    void *more = realloc(memory, count * size);
    if (more == NULL) {
        fputs("plain simulator: no memory\n", stderr);
        exit(EXIT_FAILURE);
    }
    return more;
}

// --- The heap ------------------------------------------------------------------

static int is_stale(const plain_simulator *s, const plain_event *e)
{
    return s->particle[e->i].count != e->count_i ||
           (e->kind != PLAIN_CROSSING && s->particle[e->j].count != e->count_j);
}

static void sift_down(plain_simulator *s, size_t at)
{
    plain_event *const h = s->heap, sinking = h[at];
    for (size_t child; (child = 2 * at + 1) < s->waiting; at = child) {
        if (child + 1 < s->waiting && h[child + 1].time < h[child].time)
            child++;
        if (!(h[child].time < sinking.time))
            break;
        h[at] = h[child];
    }
    h[at] = sinking;
}

/** What is stale goes when the heap is full; it grows if that was not half. */
static void make_room(plain_simulator *s)
{
    size_t kept = 0;
    for (size_t k = 0; k < s->waiting; k++)
        if (!is_stale(s, &s->heap[k]))
            s->heap[kept++] = s->heap[k];
    s->waiting = kept;
    for (size_t k = kept / 2; k-- > 0;)
        sift_down(s, k);
    if (kept > s->room / 2) {
        s->room *= 2;
        s->heap = resized(s->heap, s->room, sizeof *s->heap);
    }
}

static void push(plain_simulator *s, plain_event e)
{
    if (s->waiting == s->room)
        make_room(s);
    size_t at = s->waiting++;
    // NOLINTNEXTLINE(clang-analyzer-core.*): what is above has been pushed before
    for (; at > 0 && e.time < s->heap[(at - 1) / 2].time; at = (at - 1) / 2)
        s->heap[at] = s->heap[(at - 1) / 2];
    s->heap[at] = e;
}

static plain_event pop(plain_simulator *s)
{
    const plain_event first = s->heap[0];
    s->heap[0] = s->heap[--s->waiting];
    sift_down(s, 0);
    return first;
}

// --- Partners ------------------------------------------------------------------

int plain_is_captured(const plain_simulator *s, uint32_t i, uint32_t j)
{
    const plain_circle *c = &s->circle[i];
    for (uint32_t k = 0; k < c->count; k++)
        if (c->who[k] == j)
            return 1;
    return 0;
}

static void add_partner(plain_simulator *s, uint32_t i, uint32_t j)
{
    plain_circle *c = &s->circle[i];
    if (c->count == c->room) {
        c->room += c->room + 4;
        c->who = resized(c->who, c->room, sizeof *c->who);
    }
    c->who[c->count++] = j;
}

static void remove_partner(plain_simulator *s, uint32_t i, uint32_t j)
{
    plain_circle *c = &s->circle[i];
    uint32_t k = 0;
    while (c->who[k] != j)
        k++;
    c->who[k] = c->who[--c->count];
}

static void make_partners(plain_simulator *s, uint32_t i, uint32_t j)
{
    add_partner(s, i, j);
    add_partner(s, j, i);
}

// --- Prediction ----------------------------------------------------------------

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void plain_relative(const plain_simulator *s, uint32_t i, uint32_t j, double r[3],
                    double u[3])
{
    const plain_particle *p = &s->particle[i], *q = &s->particle[j];
    for (int a = 0; a < 3; a++) {
        const double half = s->length[a] / 2;
        r[a] = p->x[a] + p->v[a] * (s->now - p->since) -
               (q->x[a] + q->v[a] * (s->now - q->since));
        r[a] -= r[a] > half ? s->length[a] : r[a] < -half ? -s->length[a] : 0;
        u[a] = p->v[a] - q->v[a];
    }
}

/** The pair's next event [S16, algorithm 3], if there is any. */
static void predict(plain_simulator *s, uint32_t i, uint32_t j)
{
    const int captured = plain_is_captured(s, i, j);
    double r[3], u[3];
    plain_relative(s, i, j, r, u);
    s->predictions += 1 + (uint64_t)captured; // in, and out of it
    const double in = baseline_intersection(r, u, captured ? s->core : s->range);
    const double out =
        captured ? baseline_disjoint(r, u, s->range) : (double)INFINITY;
    const double soonest = fmin(in, out);
    const enum plain_kind kind = out < in ? PLAIN_OUTWARD : PLAIN_INWARD;
    if (soonest < (double)INFINITY)
        push(s, (plain_event){s->now + soonest, i, j, s->particle[i].count,
                              s->particle[j].count, kind});
}

static void predict_crossing(plain_simulator *s, uint32_t i)
{
    const plain_particle *p = &s->particle[i];
    uint32_t first = 0;
    double soonest = (double)INFINITY;
    for (uint32_t a = 0; a < 3; a++) {
        const double wall = s->side[a] * (p->cell[a] + (p->v[a] > 0));
        const double dt =
            p->v[a] == 0 ? (double)INFINITY : fmax(0, (wall - p->x[a]) / p->v[a]);
        if (dt < soonest) {
            soonest = dt;
            first = a;
        }
    }
    if (soonest < (double)INFINITY)
        push(s, (plain_event){s->now + soonest, i, first, p->count, 0,
                              PLAIN_CROSSING});
}

// --- Cells ---------------------------------------------------------------------

static uint32_t *list_of(const plain_simulator *s, const int cell[3])
{
    int at[3];
    for (int a = 0; a < 3; a++)
        at[a] = cell[a] < 0             ? cell[a] + s->cells[a]
                : cell[a] < s->cells[a] ? cell[a]
                                        : cell[a] - s->cells[a];
    return &s->first[(at[2] * s->cells[1] + at[1]) * s->cells[0] + at[0]];
}

static void put_into_cell(plain_simulator *s, uint32_t i)
{
    uint32_t *list = list_of(s, s->particle[i].cell);
    s->particle[i].next = *list;
    *list = i;
}

static void take_from_cell(plain_simulator *s, uint32_t i)
{
    uint32_t *link = list_of(s, s->particle[i].cell);
    while (*link != i)
        link = &s->particle[*link].next;
    *link = s->particle[i].next;
}

typedef void visit(plain_simulator *s, uint32_t i, uint32_t j);

/** i with everybody else in the cells from its own + low to its own + high. */
static inline void visit_near(plain_simulator *s, uint32_t i, const int low[3],
                              const int high[3], visit *with)
{
    const int *own = s->particle[i].cell;
    int c[3];
    for (c[2] = own[2] + low[2]; c[2] <= own[2] + high[2]; c[2]++)
        for (c[1] = own[1] + low[1]; c[1] <= own[1] + high[1]; c[1]++)
            for (c[0] = own[0] + low[0]; c[0] <= own[0] + high[0]; c[0]++)
                for (uint32_t j = *list_of(s, c); j != NOBODY;
                     j = s->particle[j].next)
                    if (j != i)
                        with(s, i, j);
}

static const int below[3] = {-1, -1, -1}, above[3] = {1, 1, 1};

// --- Events --------------------------------------------------------------------

static void move(plain_simulator *s, uint32_t i)
{
    plain_particle *p = &s->particle[i];
    for (int a = 0; a < 3; a++)
        p->x[a] += p->v[a] * (s->now - p->since);
    p->since = s->now;
}

static void look_around(plain_simulator *s, uint32_t i)
{
    visit_near(s, i, below, above, predict);
    predict_crossing(s, i);
}

/** Into the next cell; there it sees the nine beyond for the first time. */
static void cross(plain_simulator *s, uint32_t i, uint32_t axis)
{
    plain_particle *p = &s->particle[i];
    const int way = p->v[axis] > 0 ? 1 : -1, cells = s->cells[axis];
    int low[3] = {-1, -1, -1}, high[3] = {1, 1, 1};
    move(s, i);
    take_from_cell(s, i);
    p->cell[axis] += way;
    if (p->cell[axis] < 0 || p->cell[axis] == cells) { // around the box
        p->cell[axis] -= way * cells;
        p->x[axis] -= way * s->length[axis];
    }
    put_into_cell(s, i);
    s->crossings++;
    low[axis] = high[axis] = way;
    visit_near(s, i, low, high, predict);
    predict_crossing(s, i);
}

/** b = r.u becomes -b where the pair is reflected, and else what the rise of the
 * potential leaves of it; the reduced mass is half the mass. */
static void meet(plain_simulator *s, const plain_event *e)
{
    const uint32_t i = e->i, j = e->j;
    const int outward = e->kind == PLAIN_OUTWARD;
    const int at_core = !outward && (s->range == s->core || // no step around it
                                     plain_is_captured(s, i, j));
    const double rise = at_core   ? (double)INFINITY
                        : outward ? -s->energy
                                  : s->energy;
    double r[3], u[3];
    move(s, i);
    move(s, j);
    plain_relative(s, i, j, r, u);
    const double a = dot(r, r), b = dot(r, u),
                 left = b * b - 4 * rise * a / s->mass;
    const double after = !(left > 0) ? -b : outward ? sqrt(left) : -sqrt(left);
    for (int k = 0; k < 3; k++) {
        s->particle[i].v[k] += (after - b) / (2 * a) * r[k];
        s->particle[j].v[k] -= (after - b) / (2 * a) * r[k];
    }
    s->last.kind = at_core ? BRINK_CORE : BRINK_BOUNCE;
    if (left > 0 && outward) {
        s->last.kind = BRINK_RELEASE;
        remove_partner(s, i, j);
        remove_partner(s, j, i);
    } else if (left > 0) {
        s->last.kind = BRINK_CAPTURE;
        make_partners(s, i, j);
    }
    s->last.i = i < j ? i : j;
    s->last.j = i < j ? j : i;
    s->events++;
    s->particle[i].count++;
    s->particle[j].count++;
    look_around(s, i);
    look_around(s, j);
}

void plain_advance(plain_simulator *s, uint64_t events)
{
    while (s->events < events && s->waiting > 0) {
        const plain_event e = pop(s);
        if (is_stale(s, &e))
            continue;
        s->now = e.time;
        if (e.kind == PLAIN_CROSSING)
            cross(s, e.i, e.j);
        else
            meet(s, &e);
    }
}

// --- Beginning and end ---------------------------------------------------------

/** As wide as the range, or wider, so that they are no more than particles. */
static void choose_cells(plain_simulator *s)
{
    const double volume = s->length[0] * s->length[1] * s->length[2];
    const double width = fmax(s->range, cbrt(volume / s->count));
    size_t total = 1;
    for (int a = 0; a < 3; a++) {
        s->cells[a] = (int)fmax(PLAIN_CELLS, floor(s->length[a] / width));
        s->side[a] = s->length[a] / s->cells[a];
        total *= (size_t)s->cells[a];
    }
    s->first = resized(NULL, total, sizeof *s->first);
    for (size_t k = 0; k < total; k++)
        s->first[k] = NOBODY;
}

static void place(plain_simulator *s, uint32_t i, const brink_system *start)
{
    plain_particle *p = &s->particle[i];
    brink_system_position(start, i, 0, p->x);
    memcpy(p->v, start->particle[i].v, sizeof p->v);
    for (int a = 0; a < 3; a++) {
        const int cell = (int)(p->x[a] / s->side[a]);
        p->cell[a] = cell < s->cells[a] ? cell : s->cells[a] - 1;
    }
    put_into_cell(s, i);
}

/** The level is told from position, this once. */
static void meet_first(plain_simulator *s, uint32_t i, uint32_t j)
{
    double r[3], u[3];
    plain_relative(s, i, j, r, u);
    if (s->range > s->core && dot(r, r) < s->range * s->range)
        make_partners(s, i, j);
    predict(s, i, j);
}

void plain_create(plain_simulator *s, const brink_system *start)
{
    const brink_potential *p = &start->potential[0];
    const uint32_t n = start->count;
    *s = (plain_simulator){.count = n,
                           .mass = start->species[0].mass,
                           .range = p->distance[0],
                           .core = p->distance[p->count - 1],
                           .energy = p->count > 1 ? p->energy[0] : 0,
                           .room = 16 * (size_t)n};
    memcpy(s->length, start->length, sizeof s->length);
    s->particle = resized(NULL, n, sizeof *s->particle);
    s->circle = resized(NULL, n, sizeof *s->circle);
    memset(s->particle, 0, n * sizeof *s->particle);
    memset(s->circle, 0, n * sizeof *s->circle);
    s->heap = resized(NULL, s->room, sizeof *s->heap);
    choose_cells(s);
    for (uint32_t i = 0; i < n; i++) { // each meets those who are there already
        place(s, i, start);
        visit_near(s, i, below, above, meet_first);
        predict_crossing(s, i);
    }
}

void plain_destroy(plain_simulator *s)
{
    for (uint32_t i = 0; i < s->count; i++)
        free(s->circle[i].who);
    free(s->circle);
    free(s->particle);
    free(s->first);
    free(s->heap);
}

double plain_energy(const plain_simulator *s)
{
    double kinetic = 0, partners = 0;
    for (uint32_t i = 0; i < s->count; i++) {
        kinetic += s->mass / 2 * dot(s->particle[i].v, s->particle[i].v);
        partners += s->circle[i].count;
    }
    return kinetic + s->energy * partners / 2;
}
