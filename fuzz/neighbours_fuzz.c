// SPDX-License-Identifier: MIT
// Lists of neighbours against all pairs: by homes, as particles move and depart.
#include "adverse.h"
#include "fuzz.h"
#include "neighbours.h"

enum { STEPS = 60 };

typedef struct village {
    brink_system system;
    brink_cells c;
    brink_neighbours n;
} village;

static _Noreturn void broken(const village *v, const char *law)
{
    FINDING("neighbours: %s", law);
    fprintf(stderr, "  const double radius = %a;\n  const uint32_t home[][3] = {",
            v->n.radius);
    for (uint32_t i = 0; i < v->system.count; i++)
        fprintf(stderr, "{0x%08x, 0x%08x, 0x%08x}, ", v->n.home[i].x[0],
                v->n.home[i].x[1], v->n.home[i].x[2]);
    fputs("};\n", stderr);
    adverse_tell(&v->system);
    finding_end();
}

static int times_listed(const village *v, uint32_t i, uint32_t j)
{
    int times = 0;
    for (uint32_t k = 0; k < brink_neighbours_count(&v->n, i); k++)
        times += brink_neighbours_of(&v->n, i)[k] == j;
    return times;
}

static long double between_homes(const village *v, uint32_t i, uint32_t j)
{
    const brink_home *p = &v->n.home[i], *q = &v->n.home[j];
    long double square = 0;
    for (int a = 0; a < 3; a++) {
        const long double d =
            (int32_t)(p->x[a] - q->x[a]) * 0x1p-32L * v->system.length[a];
        square += d * d;
    }
    return sqrtl(square);
}

/** Listed, by both and once, are those whose homes are nearer than their
 *  potential reaches and two balls; beyond, by the slack of 2^-20, nobody is. */
static void check_lists(const village *v)
{
    for (uint32_t i = 0; i < v->system.count; i++)
        for (uint32_t j = i + 1; j < v->system.count; j++) {
            const long double reach =
                (long double)brink_system_potential(&v->system, i, j)
                    ->distance[0] +
                2 * v->n.radius;
            const long double apart = between_homes(v, i, j);
            const int listed = times_listed(v, i, j);
            if (listed != times_listed(v, j, i))
                broken(v, "two are each other's neighbours");
            if (listed != 1 && apart <= reach)
                broken(v, "whoever could be met is a neighbour, once");
            if (listed != 0 && apart > reach * (1 + 0x1p-19))
                broken(v, "whoever cannot be met is no neighbour");
        }
}

/** Home is where it is, to half a unit of 2^-32; and so is the cell. */
static void check_home(const village *v, uint32_t i)
{
    const brink_particle *p = &v->system.particle[i];
    uint64_t home[3];
    for (int a = 0; a < 3; a++) {
        home[a] = (uint64_t)v->n.home[i].x[a] << 32;
        const int64_t off = (int64_t)(p->x[a] - home[a]);
        if (off > INT64_C(1) << 31 || off < -(INT64_C(1) << 31))
            broken(v, "a home is where the particle is when it departs");
    }
    if (v->n.home[i].species != p->species)
        broken(v, "a home's species is its particle's");
    if (brink_cells_at(&v->c, home) != v->c.cell[i])
        broken(v, "a particle is in the cell of its home");
}

/* At that time it is on the edge of its ball: within 8 eps of the radius and the
 * flight, and as much for what is rounded on the way and here; or it is asked for
 * later than that. */
static void check_until(const village *v, uint32_t i, double offset)
{
    const brink_particle *p = &v->system.particle[i];
    const double until = brink_neighbours_until(&v->n, &v->system, i, offset);
    long double square = 0, speed = 0;
    if (!(until >= offset))
        broken(v, "a departure is not before now");
    if (isinf(until)) {
        if (p->v[0] != 0 || p->v[1] != 0 || p->v[2] != 0)
            broken(v, "only who rests never departs");
        return;
    }
    for (int a = 0; a < 3; a++) {
        const uint64_t home = (uint64_t)v->n.home[i].x[a] << 32;
        const long double x =
            (int64_t)(p->x[a] - home) * (long double)v->system.unit[a] +
            p->v[a] * ((long double)until - p->since);
        square += x * x;
        speed += (long double)p->v[a] * p->v[a];
    }
    const long double way = sqrtl(speed) * (fabsl((long double)until) + p->since);
    const long double off = 0x1p-52L * 16 * (v->n.radius + way);
    const long double distance = sqrtl(square);
    if (distance < v->n.radius - off && until > offset)
        broken(v, "who departs is at the edge of its ball");
    if (distance > v->n.radius + off && until > offset)
        broken(v, "who is beyond the edge of its ball departs at once");
}

/** Some way, a short one as a rule, or to where another is. */
static void move(village *v, stream *s, uint32_t i)
{
    const int far = stream_int(s, 0, 5);
    brink_particle *p = &v->system.particle[i];
    const uint32_t to = (uint32_t)stream_int(s, 0, (int)v->system.count - 1);
    for (int a = 0; a < v->system.dimensions; a++)
        if (far == 0)
            p->x[a] = stream_bits(s);
        else if (far == 1)
            p->x[a] = v->system.particle[to].x[a];
        else
            p->x[a] += (uint64_t)(int64_t)stream_int(s, -128, 127) << 53;
}

/** Wide enough for lists, with balls of any size that leaves five cells. */
static int make(village *v, stream *s)
{
    adverse_make(s, &v->system);
    const brink_system *y = &v->system;
    double least = y->length[0];
    for (int a = 1; a < y->dimensions; a++)
        least = fmin(least, y->length[a]);
    const double best = brink_neighbours_radius(y);
    const double room = (least / 5 / (1 + 0x1p-19) - y->range) / 2;
    const double radius =
        stream_int(s, 0, 1) ? best : room * stream_int(s, 1, 255) / 256;
    if (best > 0 && !(least >= 5 * (y->range + 2 * best)))
        broken(v, "lists are kept where the box is five cells across");
    if (!(radius > 0x1p-20 * y->range))
        return 0;
    LAW(brink_cells_create(&v->c, y, y->range + 2 * radius) == 0 &&
            brink_neighbours_create(&v->n, &v->c, y, radius) == 0 &&
            brink_neighbours_fill(&v->n, &v->c, y) == 0,
        "neighbours: memory is out");
    return 1;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static village v;
    stream s = stream_of_bytes(data, size);
    v.n = (brink_neighbours){0};
    if (!make(&v, &s)) {
        brink_system_destroy(&v.system);
        return 0;
    }
    for (uint32_t i = 0; i < v.system.count; i++)
        check_home(&v, i);
    check_lists(&v);
    for (int n = stream_int(&s, 0, STEPS); n > 0; n--) {
        const uint32_t i = (uint32_t)stream_int(&s, 0, (int)v.system.count - 1);
        check_until(&v, i, v.system.year * stream_int(&s, 0, 3) / 4);
        move(&v, &s, i);
        if (brink_neighbours_depart(&v.n, &v.c, &v.system, i))
            broken(&v, "memory is out");
        check_home(&v, i);
        check_lists(&v);
    }
    const char *fault = brink_neighbours_is_valid(&v.n, &v.c, &v.system);
    if (fault)
        broken(&v, fault);
    brink_neighbours_destroy(&v.n);
    brink_cells_destroy(&v.c);
    brink_system_destroy(&v.system);
    return 0;
}
