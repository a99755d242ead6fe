// SPDX-License-Identifier: MIT
// Trajectories: any bytes are a frame or refused with a line's number; what was
// read is written and read again to the same bits; and what is written is read.
#include "adverse.h"
#include "fuzz.h"
#include "scene_value.h"
#include "trajectory.h"
#include <stdlib.h>
#include <string.h>

static const char name[] = "f.xyz";

typedef struct text {
    char *bytes;
    size_t size;
} text;

static _Noreturn void broken(const text *t, const char *law)
{
    FINDING("trajectory: %s", law);
    fwrite(t->bytes, 1, t->size, stderr);
    finding_end();
}

/** "f.xyz:LINE: error: ...", a line that there is. */
static void check_complaint(const text *t, const char *said)
{
    const size_t begin = strlen(name);
    char *end = NULL;
    long lines = 1;
    for (size_t k = 0; k < t->size; k++)
        lines += t->bytes[k] == '\n';
    if (strncmp(said, name, begin) != 0 || said[begin] != ':')
        broken(t, "a complaint begins with the file's name");
    const long line = strtol(said + begin + 1, &end, 10);
    if (line < 0 || line > lines || strncmp(end, ": error: ", 9) != 0)
        broken(t, "a complaint says at which line");
}

/** 1 a frame, 0 the end, -1 a complaint. */
static int read_frame(const text *t, FILE *in, brink_frame *frame)
{
    text said = {0};
    FILE *errors = open_memstream(&said.bytes, &said.size);
    const int status = brink_trajectory_read(in, name, frame, errors);
    fclose(errors);
    if ((status < 0) != (said.size > 0))
        broken(t, "there is a complaint where there is an error");
    if (status < 0)
        check_complaint(t, said.bytes);
    if (status != 1 && (frame->count || frame->species || frame->x || frame->v))
        broken(t, "there is nothing in a frame that is none");
    free(said.bytes);
    return status;
}

static void check_vector(const text *t, const double x[3])
{
    for (int a = 0; a < 3; a++)
        if (!isfinite(x[a]))
            broken(t, "numbers are finite");
}

static void check_frame(const text *t, const brink_frame *f)
{
    if (f->count < 1 || f->count > BRINK_PARTICLES_MOST)
        broken(t, "a frame has particles");
    for (int a = 0; a < 3; a++)
        if (!(f->length[a] > 0) || !isfinite(f->length[a]))
            broken(t, "a box has lengths");
    for (uint32_t i = 0; i < f->count; i++) {
        if (memchr(f->species[i], '\0', sizeof f->species[i]) == NULL)
            broken(t, "a species' name ends within its room");
        check_vector(t, f->x[i]);
        if (f->v)
            check_vector(t, f->v[i]);
    }
}

// --- Written and read again ----------------------------------------------------

static const double step = 0x1p-40, hard = (double)INFINITY;
static const brink_potential core = {1, &step, &hard};

/** A system of one species of what a frame says. */
static void system_of(const brink_frame *f, const char *species,
                      brink_system *system)
{
    brink_species only = {.mass = 1, .diameter = step, .count = f->count};
    strcpy(only.name, species);
    LAW(brink_system_create(system, 3, f->length, 1, f->count, 1, &only, &core) ==
            0,
        "trajectory: memory is out");
    for (uint32_t i = 0; i < f->count; i++)
        for (int a = 0; a < 3; a++) {
            system->particle[i].x[a] =
                brink_system_fraction(system, a, f->x[i][a]);
            system->particle[i].v[a] = f->v ? f->v[i][a] : 0;
        }
}

static void compare(const text *t, const brink_system *s, double offset,
                    const brink_frame *f)
{
    if (f->count != s->count || !f->v ||
        memcmp(f->length, s->length, sizeof f->length) != 0)
        broken(t, "what is written has the particles and the box it had");
    for (uint32_t i = 0; i < s->count; i++) {
        double x[3];
        brink_system_position(s, i, offset, x);
        if (strcmp(f->species[i], s->species[s->particle[i].species].name) != 0)
            broken(t, "a species' name is read as it was written");
        if (memcmp(x, f->x[i], sizeof x) != 0 ||
            memcmp(s->particle[i].v, f->v[i], sizeof x) != 0)
            broken(t, "numbers are read as they were written");
    }
}

static text write_system(const brink_system *s, double offset)
{
    text t = {0};
    FILE *out = open_memstream(&t.bytes, &t.size);
    const int status = brink_trajectory_write(out, s, offset, offset);
    fclose(out);
    if (status)
        broken(&t, "a system is written");
    return t;
}

static void write_and_read(const brink_system *s, double offset)
{
    const text t = write_system(s, offset);
    brink_frame f;
    FILE *in = fmemopen(t.bytes, t.size, "r");
    if (read_frame(&t, in, &f) != 1)
        broken(&t, "what is written is read");
    compare(&t, s, offset, &f);
    brink_frame_destroy(&f);
    if (read_frame(&t, in, &f) != 0)
        broken(&t, "a frame ends where it ends");
    fclose(in);
    free(t.bytes);
}

static int has_a_name_to_write(const brink_frame *f)
{
    const char *n = f->species[0];
    return *n && strcspn(n, " \t\":\r\n") == strlen(n);
}

/** What a run reckons with: boxes that are no subnormals, numbers up to 1e60. */
static int is_of_a_scene(const brink_frame *f)
{
    for (int a = 0; a < 3; a++) {
        if (!(f->length[a] >= BRINK_VALUE_LEAST) ||
            !(f->length[a] <= BRINK_VALUE_MOST))
            return 0;
        for (uint32_t i = 0; i < f->count; i++)
            if (!(fabs(f->x[i][a]) <= BRINK_VALUE_MOST))
                return 0;
    }
    return has_a_name_to_write(f);
}

static void read_all(const text *t)
{
    FILE *in = fmemopen(t->bytes, t->size ? t->size : 1, "r");
    brink_frame f;
    while (read_frame(t, in, &f) == 1) {
        check_frame(t, &f);
        if (is_of_a_scene(&f)) {
            brink_system s;
            system_of(&f, f.species[0], &s);
            write_and_read(&s, 0);
            brink_system_destroy(&s);
        }
        brink_frame_destroy(&f);
    }
    fclose(in);
}

/** A few characters of a whole file changed, out or in: such as files have. */
static void damage(text *t, stream *s)
{
    static const char characters[] = "0123456789.eE+- \t\n\r\"=:XSRinfa\0\xff";
    for (int n = stream_int(s, 0, 4); n > 0 && t->size > 1; n--) {
        const size_t at = stream_word(s, 2) % t->size;
        const char c = characters[stream_int(s, 0, (int)sizeof characters - 2)];
        if (stream_int(s, 0, 3)) {
            t->bytes[at] = c;
        } else {
            memmove(t->bytes + at, t->bytes + at + 1, t->size - at - 1);
            t->size--;
        }
    }
}

/** Numbers as strange as a file may have them. */
static void make_strange(brink_system *s, stream *bytes)
{
    for (int n = stream_int(bytes, 0, 4); n > 0; n--) {
        brink_particle *p = &s->particle[stream_int(bytes, 0, (int)s->count - 1)];
        const int a = stream_int(bytes, 0, s->dimensions - 1);
        p->x[a] = stream_bits(bytes);
        p->v[a] = stream_scaled(bytes, -1074, 1000);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stream s = stream_of_bytes(data, size);
    if (stream_int(&s, 0, 3) == 0) { // the bytes themselves
        const size_t left = s.left;
        char *bytes = malloc(left + 1);
        memcpy(bytes, s.bytes, left);
        read_all(&(text){bytes, left});
        free(bytes);
        return 0;
    }
    brink_system system;
    adverse_make(&s, &system);
    const double offset = system.year * stream_int(&s, 0, 255) / 256;
    write_and_read(&system, offset);
    make_strange(&system, &s);
    write_and_read(&system, 0);
    text t = write_system(&system, 0);
    damage(&t, &s);
    read_all(&t);
    free(t.bytes);
    brink_system_destroy(&system);
    return 0;
}
