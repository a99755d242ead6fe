// SPDX-License-Identifier: MIT
/*
 * Scenes: any bytes are refused with a complaint that an editor can follow, or
 * within every bound that is stated; what is accepted means the same with other
 * ends of lines, and a small one can be started.  And scenes written from known
 * values: these are read, and one fault put in is complained of in its line.
 */
#include "fuzz.h"
#include "run.h"
#include "scene.h"
#include "scene_species.h"
#include "scene_value.h"
#include "start.h"
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST = 8192, STARTED_MOST = 64 };

static const char name[] = "s.yaml";

typedef struct text {
    size_t size;
    char byte[LONGEST];
} text;

static _Noreturn void broken(const text *t, const char *law)
{
    FINDING("scene: %s", law);
    fwrite(t->byte, 1, t->size, stderr);
    finding_end();
}

// --- Complaints ----------------------------------------------------------------

static long lines_of(const text *t)
{
    long lines = 1;
    for (size_t k = 0; k < t->size; k++)
        lines += t->byte[k] == '\n';
    return lines;
}

/** The first complaint, after which the next begin: "s.yaml:LINE:COLUMN: error:",
 *  a line and a caret.  Its line; 0 where there is none. */
static long next_complaint(const text *t, const char **said)
{
    const size_t begin = strlen(name);
    char *end;
    if (**said == '\0')
        return 0;
    if (strncmp(*said, name, begin) != 0 || (*said)[begin] != ':')
        broken(t, "a complaint begins with the file's name");
    const long line = strtol(*said + begin + 1, &end, 10);
    const long column = *end == ':' ? strtol(end + 1, &end, 10) : 0;
    if (line < 1 || line > lines_of(t) + 1 || column < 1 ||
        strncmp(end, ": error: ", 9) != 0)
        broken(t, "a complaint says where, file:line:column");
    for (int lines = 0; lines < 3; lines++) { // it has three
        const char *lf = strchr(*said, '\n');
        if (!lf || (lines > 0 && strncmp(*said, "  ", 2) != 0) ||
            (lines == 2 && !memchr(*said, '^', (size_t)(lf - *said))))
            broken(t, "a complaint shows the line, and a caret under it");
        *said = lf + 1;
    }
    return line;
}

/** How many complaints, and whether one is of this line. */
static int check_complaints(const text *t, const char *said, int complaints,
                            long wanted)
{
    int found = 0;
    for (int n = 0; n < complaints && n < BRINK_COMPLAINTS_MOST; n++) {
        const long line = next_complaint(t, &said);
        if (line == 0)
            broken(t, "as many complaints are told as there are");
        found |= line == wanted;
    }
    if (*said && complaints < BRINK_COMPLAINTS_MOST)
        broken(t, "no more complaints are told than there are");
    return found;
}

/** 0 a good scene; or how many complaints, in `wanted` line one of them. */
static int parse(const text *t, brink_scene *scene, long wanted)
{
    char *said = NULL;
    size_t size = 0;
    FILE *errors = open_memstream(&said, &size);
    char *exact = malloc(t->size + 1); // its end is watched
    memcpy(exact, t->byte, t->size);
    const int faults = brink_scene_parse(exact, t->size, name, "", scene, errors);
    fclose(errors);
    free(exact);
    const int found = check_complaints(t, said, faults, wanted);
    if (wanted && !found) {
        fprintf(stderr, "%s  // line %ld\n", said, wanted);
        broken(t, "a fault is complained of in its line");
    }
    if (faults && (scene->title || scene->text || scene->species || scene->count))
        broken(t, "of a bad scene nothing is kept");
    free(said);
    return faults;
}

// --- Bounds --------------------------------------------------------------------

static int is_magnitude(double x)
{
    return fabs(x) >= BRINK_VALUE_LEAST && fabs(x) <= BRINK_VALUE_MOST;
}

static void check_potential(const text *t, const brink_scene *s, int a, int b)
{
    const int kinds = s->species_count;
    const brink_potential *p = &s->potential[a * kinds + b];
    const brink_potential *mirror = &s->potential[b * kinds + a];
    if (!brink_potential_is_valid(p) || p->count > BRINK_STEPS_MOST)
        broken(t, "steps have decreasing distances and energies");
    for (int k = 0; k < p->count; k++) {
        if (!is_magnitude(p->distance[k]) ||
            (isfinite(p->energy[k]) && p->energy[k] != 0 &&
             !is_magnitude(p->energy[k])))
            broken(t, "distances and energies have a bounded magnitude");
        if (mirror->count != p->count || mirror->distance[k] != p->distance[k] ||
            mirror->energy[k] != p->energy[k])
            broken(t, "a potential is the same seen from either side");
        for (int d = 0; d < s->dimensions; d++)
            if (!(s->length[d] > 2 * p->distance[k]))
                broken(t, "the box is wider than twice the range");
    }
}

static void check_wish(const text *t, const brink_scene *s)
{
    const brink_wish *w = &s->wish;
    if (!(w->every >= 0) || !isfinite(w->every) || !(w->from >= 0) ||
        w->distance_bins < 0 || w->lags < 0 ||
        !(2 * w->distance_most <= fmin(s->length[0], s->length[1])))
        broken(t, "what is to be measured can be");
}

static void check_bounds(const text *t, const brink_scene *s)
{
    uint64_t count = 0;
    if (strlen(s->title) > BRINK_TITLE_MOST || strpbrk(s->title, "\r\n"))
        broken(t, "a title is one line, not too long");
    if (s->seed > BRINK_SEED_MOST || (s->dimensions != 2 && s->dimensions != 3))
        broken(t, "the seed and the dimensions are within bounds");
    if (s->species_count < 1 || s->species_count > BRINK_SPECIES_MOST)
        broken(t, "there are species, not too many");
    for (int a = 0; a < s->species_count; a++) {
        if (!(s->species[a].mass > 0) || !is_magnitude(s->species[a].mass) ||
            s->species[a].count < 1 || !s->species[a].name[0])
            broken(t, "a species has a name, a mass and particles");
        count += s->species[a].count;
        for (int b = 0; b < s->species_count; b++)
            check_potential(t, s, a, b);
        for (int b = 0; b < a; b++)
            if (strcmp(s->species[a].name, s->species[b].name) == 0)
                broken(t, "species have names of their own");
    }
    for (int a = 0; a < 3; a++)
        if (!(s->length[a] > 0) || !isfinite(s->length[a]))
            broken(t, "the box has lengths");
    if (count != s->count || count > BRINK_PARTICLES_MOST)
        broken(t, "particles are counted, and not too many");
    if (!(s->temperature > 0) || !(s->target_value > 0) ||
        !(s->trajectory_every >= 0) || !(s->checkpoint_every > 0))
        broken(t, "temperature, target and intervals are more than nothing");
    if (brink_scene_events(s) == 0)
        broken(t, "a scene asks for events");
    check_wish(t, s);
}

// --- The same meaning ----------------------------------------------------------

static void compare(const text *t, const brink_scene *a, const brink_scene *b)
{
    const int kinds = a->species_count;
    if (strcmp(a->title, b->title) != 0 || a->seed != b->seed ||
        a->dimensions != b->dimensions || a->count != b->count ||
        kinds != b->species_count || a->start != b->start ||
        a->temperature != b->temperature || a->target != b->target ||
        a->target_value != b->target_value ||
        memcmp(a->length, b->length, sizeof a->length) != 0)
        broken(t, "with other ends of lines it is the same scene");
    for (int k = 0; k < kinds; k++)
        if (a->species[k].mass != b->species[k].mass ||
            a->species[k].count != b->species[k].count ||
            strcmp(a->species[k].name, b->species[k].name) != 0)
            broken(t, "with other ends of lines it has the same species");
    for (int k = 0; k < kinds * kinds; k++)
        if (a->potential[k].count != b->potential[k].count ||
            a->potential[k].distance[0] != b->potential[k].distance[0])
            broken(t, "with other ends of lines it has the same potentials");
}

/** LF as CR LF, a mark at the beginning, and a comment at the end. */
static void rewrite(const text *t, const brink_scene *scene)
{
    static text other;
    static const char mark[] = "\xef\xbb\xbf";
    brink_scene again;
    if (2 * t->size + 8 > LONGEST || (t->size > 2 && !memcmp(t->byte, mark, 3)))
        return;
    memcpy(other.byte, mark, 3);
    other.size = 3;
    for (size_t k = 0; k < t->size; k++) {
        if (t->byte[k] == '\n' && (k == 0 || t->byte[k - 1] != '\r'))
            other.byte[other.size++] = '\r';
        other.byte[other.size++] = t->byte[k];
    }
    if (parse(&other, &again, 0) != 0)
        broken(t, "with other ends of lines it is still a scene");
    compare(t, scene, &again);
    brink_scene_destroy(&again);
}

/** Started, or refused with a complaint; start files are no business here. */
static void start(const text *t, const brink_scene *scene)
{
    brink_system system;
    char *said = NULL;
    size_t size = 0;
    if (scene->count > STARTED_MOST || scene->start == BRINK_START_FILE)
        return;
    FILE *errors = open_memstream(&said, &size);
    const int status = brink_start_make(scene, name, &system, errors);
    fclose(errors);
    check_complaints(t, said, status != 0, 0);
    free(said);
    if (status)
        return;
    const char *fault = brink_system_is_valid(&system);
    if (fault)
        broken(t, fault);
    brink_run run;
    LAW(brink_run_create(&run, &system, BRINK_TIER_FAST) == 0,
        "scene: memory is out");
    fault = brink_run_is_valid(&run);
    if (fault)
        broken(t, fault);
    brink_run_destroy(&run);
}

static int take(const text *t, long wanted)
{
    brink_scene scene;
    if (parse(t, &scene, wanted) != 0)
        return 0;
    check_bounds(t, &scene);
    rewrite(t, &scene);
    start(t, &scene);
    brink_scene_destroy(&scene);
    return 1;
}

// --- Scenes of known values ----------------------------------------------------

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
    text t;
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
    w->t.size += (size_t)vsnprintf(to, LONGEST - w->t.size, format, list);
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
    w->count = (uint32_t)stream_int(s, 2, 8);
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
    if (parse(&w->t, &s, 0) != 0)
        broken(&w->t, "a scene of sound values is accepted");
    const brink_potential *p = &s.potential[0];
    if (s.seed != w->seed || s.dimensions != w->dimensions ||
        s.count != w->count || s.species[0].mass != w->mass ||
        s.temperature != w->temperature || p->count != 2 ||
        p->distance[0] != w->distance[0] || p->distance[1] != w->distance[1] ||
        p->energy[0] != w->energy || !isinf(p->energy[1]) ||
        s.length[0] != w->length || brink_scene_events(&s) != 7)
        broken(&w->t, "a scene says what was written");
    brink_scene_destroy(&s);
}

/** A few bytes changed: of a scene that nearly is one. */
static void damage(text *t, stream *s)
{
    static const char bytes[] =
        " \n\r\t:,-[]{}'\"#&*!|>%@.0123456789einfax~?\xc3";
    for (int n = stream_int(s, 1, 4); n > 0; n--)
        t->byte[stream_word(s, 2) % t->size] =
            bytes[stream_int(s, 0, (int)sizeof bytes - 2)];
}

static void take_written(stream *s)
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
    else if (take(&w.t, w.at))
        broken(&w.t, "a scene with a fault is refused");
    take(&w.t, w.at);
    damage(&w.t, s);
    take(&w.t, 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static text t;
    stream s = stream_of_bytes(data, size);
    // What begins as scenes do is one.
    if (size > 0 && memchr("\nabdoprst#{-'\"\xef", data[0], 16)) {
        t.size = size < LONGEST ? size : LONGEST;
        memcpy(t.byte, data, t.size);
        take(&t, 0);
    } else {
        take_written(&s);
    }
    return 0;
}
