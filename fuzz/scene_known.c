// SPDX-License-Identifier: MIT
#include "scene_known.h"
#include "fuzz.h"
#include <math.h>
#include <stdarg.h>
#include <string.h>

enum fault {
    NONE,
    BAD_NUMBER,
    BAD_COUNT,
    BAD_STEPS,
    BAD_CORE,
    BAD_PAIR,
    BAD_BOX,
    BAD_SEED,
    BAD_DIMENSIONS,
    UNKNOWN_KEY,
    REPEATED_KEY,
    FAULTS
};

typedef struct writer {
    scene_text t;
    stream *s;
    enum fault fault;
    long line, at; // written so far; where the fault is
    double mass, temperature, distance[2], energy, length;
    uint32_t count, seed;
    int dimensions;
} writer;

static void line(writer *w, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void line(writer *w, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    char *to = w->t.byte + w->t.size;
    w->t.size +=
        (size_t)vsnprintf(to, SCENE_TEXT_LONGEST - w->t.size, format, list);
    va_end(list);
    w->t.byte[w->t.size++] = '\n';
    w->line++;
}

/** Marks the line that is written next as the one with the fault. */
static int has(writer *w, enum fault fault)
{
    if (w->fault != fault)
        return 0;
    w->at = w->line + 1;
    return 1;
}

static const char *one_of(stream *s, const char *const *words, int count)
{
    return words[stream_int(s, 0, count - 1)];
}
#define ONE_OF(s, ...)                                                           \
    one_of(s, (const char *const[]){__VA_ARGS__},                                \
           (int)(sizeof((const char *[]){__VA_ARGS__}) / sizeof(char *)))

/** Where a number > 0 is wanted. */
static const char *bad_number(stream *s)
{
    return ONE_OF(s, "-1", "0", "-0.0", ".inf", "-.inf", ".nan", "1e61", "1e-61",
                  "1e400", "0x10", "1,5", "01", "1_0", "'1'", "one", "[1]", "+",
                  "-1e-60", "1e", "{a: 1}");
}

static void write_head(writer *w)
{
    line(w, "title: a scene of known values");
    if (has(w, BAD_SEED))
        line(w, "seed: %s", ONE_OF(w->s, "4294967296", "-1", "1.5", "1e3", "''"));
    else
        line(w, "seed: %u", w->seed);
    if (has(w, BAD_DIMENSIONS))
        line(w, "dimensions: %s", ONE_OF(w->s, "1", "4", "3.0", "-2", "two"));
    else
        line(w, "dimensions: %d", w->dimensions);
}

static void write_box(writer *w)
{
    double length = w->length;
    if (has(w, BAD_BOX)) // down from twice the range
        length = 2 * w->distance[0] * (1 - stream_int(w->s, 0, 200) / 256.0);
    line(w,
         w->dimensions == 3 ? "box: {size: [%.17g, %.17g, %.17g]}"
                            : "box: {size: [%.17g, %.17g]}",
         length, w->length, w->length);
}

static void write_species(writer *w)
{
    line(w, "species:");
    char count[32];
    snprintf(count, sizeof count, "%u", w->count);
    const char *how_many =
        has(w, BAD_COUNT)
            ? ONE_OF(w->s, "0", "-3", "1.5", "1e2", "5000000000", "x", "[]")
            : count;
    if (w->fault == BAD_NUMBER && stream_int(w->s, 0, 1)) {
        has(w, BAD_NUMBER);
        line(w, "  A: {count: %s, mass: %s}", how_many, bad_number(w->s));
    } else {
        line(w, "  A: {count: %s, mass: %.17g}", how_many, w->mass);
    }
    if (w->fault == BAD_NUMBER && w->at)
        w->fault = NONE; // one is enough
}

static void write_potential(writer *w)
{
    const double *d = w->distance;
    line(w, "potentials:");
    line(w, "  - between: [A, %s]", has(w, BAD_PAIR) ? "B" : "A");
    if (has(w, BAD_STEPS)) // the two the wrong way round, or the same
        line(w, "    steps: [[%.17g, %.17g], [%.17g, .inf]]", d[1], w->energy,
             stream_int(w->s, 0, 1) ? d[0] : d[1]);
    else if (has(w, BAD_CORE))
        line(w, "    steps: [[%.17g, .inf], [%.17g, %.17g]]", d[0], d[1],
             w->energy);
    else
        line(w, "    steps: [[%.17g, %.17g], [%.17g, .inf]]", d[0], w->energy,
             d[1]);
}

static void write_rest(writer *w)
{
    if (has(w, BAD_NUMBER))
        line(w, "temperature: %s", bad_number(w->s));
    else
        line(w, "temperature: %.17g", w->temperature);
    line(w, "run: {events: 7}");
    if (has(w, UNKNOWN_KEY))
        line(w, "%s: 1", ONE_OF(w->s, "sead", "Seed", "x", "box ize", "'seed '"));
    if (has(w, REPEATED_KEY))
        line(w, "%s",
             ONE_OF(w->s, "seed: 1", "run: {events: 7}", "title: again",
                    "dimensions: 3", "box: {size: [9, 9, 9]}", "'seed': 1"));
}

static void make(writer *w, stream *s)
{
    w->s = s;
    w->fault = (enum fault)stream_int(s, 0, FAULTS - 1);
    w->seed = (uint32_t)stream_word(s, 4);
    w->dimensions = stream_int(s, 2, 3);
    w->count = (uint32_t)stream_int(s, 2, 8); // one has no events
    w->mass = fabs(stream_scaled(s, -40, 40));
    w->temperature = fabs(stream_scaled(s, -40, 40));
    w->energy = stream_scaled(s, -20, 20);
    w->distance[1] = fabs(stream_scaled(s, -20, 20));
    w->distance[0] = w->distance[1] * stream_real(s, 1.001, 3);
    w->length = w->distance[0] * stream_real(s, 8, 100);
}

static void compare_values(const writer *w)
{
    brink_scene s;
    if (scene_parse(&w->t, &s, 0) != 0)
        scene_broken(&w->t, "a scene of sound values is accepted");
    const brink_potential *p = &s.potential[0];
    if (s.seed != w->seed || s.dimensions != w->dimensions ||
        s.count != w->count || s.species[0].mass != w->mass ||
        s.temperature != w->temperature || p->count != 2 ||
        p->distance[0] != w->distance[0] || p->distance[1] != w->distance[1] ||
        p->energy[0] != w->energy || !isinf(p->energy[1]) ||
        s.length[0] != w->length || brink_scene_events(&s) != 7)
        scene_broken(&w->t, "a scene says what was written");
    brink_scene_destroy(&s);
}

void scene_known_check(stream *s, scene_text *t)
{
    static writer w;
    memset(&w, 0, sizeof w);
    make(&w, s);
    write_head(&w);
    write_box(&w);
    write_species(&w);
    write_potential(&w);
    write_rest(&w);
    if (w.at == 0)
        compare_values(&w);
    if (scene_take(&w.t, w.at) != (w.at == 0))
        scene_broken(&w.t, "a scene with a fault is refused");
    *t = w.t;
}
