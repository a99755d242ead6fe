// SPDX-License-Identifier: MIT
#include "trajectory.h"
#include "scene_number.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#define COLUMNS_MOST 64

static const char elements[] =
    " H He Li Be B C N O F Ne Na Mg Al Si P S Cl Ar K Ca Sc Ti V Cr Mn Fe Co Ni "
    "Cu Zn "
    "Ga Ge As Se Br Kr Rb Sr Y Zr Nb Mo Tc Ru Rh Pd Ag Cd In Sn Sb Te I Xe Cs Ba "
    "La Ce "
    "Pr Nd Pm Sm Eu Gd Tb Dy Ho Er Tm Yb Lu Hf Ta W Re Os Ir Pt Au Hg Tl Pb Bi "
    "Po At Rn "
    "Fr Ra Ac Th Pa U Np Pu Am Cm Bk Cf Es Fm Md No Lr ";

static const char *symbol_of(const char *name)
{
    char word[sizeof((brink_species *)0)->name + 2];
    snprintf(word, sizeof word, " %s ", name);
    return strstr(elements, word) ? name : "X";
}

int brink_trajectory_write(FILE *out, const brink_system *system, double offset,
                           double time)
{
    const double *length = system->length;
    fprintf(out, "%" PRIu32 "\n", system->count);
    fprintf(out, "Lattice=\"%.17g 0 0 0 %.17g 0 0 0 %.17g\" ", length[0],
            length[1], length[2]);
    fputs("Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:id:I:1 ",
          out);
    fprintf(out, "pbc=\"T T %c\" Time=%.17g names=\"",
            system->dimensions == 3 ? 'T' : 'F', time);
    for (int a = 0; a < system->species_count; a++)
        fprintf(out, "%s%s:%" PRIu32, a ? " " : "", system->species[a].name,
                system->species[a].count);
    fputs("\"\n", out);
    for (uint32_t i = 0; i < system->count; i++) {
        brink_particle here = system->particle[i];
        brink_system alone =
            *system; // to move a copy by the system's own arithmetic
        alone.particle = &here;
        brink_system_advance(&alone, 0, offset);
        const brink_species *species = &system->species[here.species];
        fputs(symbol_of(species->name), out);
        for (int a = 0; a < 3; a++)
            fprintf(out, " %.17g", brink_system_coordinate(system, a, here.x[a]));
        for (int a = 0; a < 3; a++)
            fprintf(out, " %.17g", here.v[a]);
        fprintf(out, " %.17g %.17g %" PRIu32 "\n", species->diameter / 2,
                species->mass, i);
    }
    return ferror(out) ? -1 : 0;
}

typedef struct reader {
    FILE *in;
    const char *name;
    FILE *errors;
    char *line;
    size_t room;
    char *names; // "A:400 B:100", or NULL
    int columns; // on a particle's line; where its properties begin, or -1
    int species, pos, velo, id;
} reader;

// One line without its end; 0 at the end of the file.
static int next_line(reader *r)
{
    const ssize_t length = getline(&r->line, &r->room, r->in);
    if (length < 0)
        return 0;
    r->line[strcspn(r->line, "\r\n")] = '\0';
    return 1;
}

// Lines read so far.  The file is counted through again: an error is told but
// once.
static long lines_read(FILE *in)
{
    const long end = ftell(in);
    long lines = 0;
    rewind(in);
    for (long k = 0; k < end; k++)
        lines += getc(in) == '\n';
    return lines;
}

static int complain(reader *r, const char *what, const char *about)
{
    fprintf(r->errors, "%s:%ld: error: %s%s\n", r->name, lines_read(r->in), what,
            about);
    return -1;
}

// Copies the value of a key of the comment line; NULL where it has none.  Keys
// within a quoted value are part of that value.
static char *value_of(const char *comment, const char *key)
{
    const size_t length = strlen(key);
    const char *p = comment;
    while (*p) {
        p += strspn(p, " \t");
        const char *name = p;
        p += strcspn(p, "= \t");
        const int is_it =
            (size_t)(p - name) == length && !strncmp(name, key, length);
        if (*p != '=')
            continue;
        const int is_quoted = *++p == '"';
        p += is_quoted;
        const size_t size = strcspn(p, is_quoted ? "\"" : " \t");
        if (is_it)
            return strndup(p, size);
        p += size;
        p += *p == '"';
    }
    return NULL;
}

static int split(char *line, char *word[], int most)
{
    int n = 0;
    char *rest = NULL;
    for (char *w = strtok_r(line, " \t", &rest); w;
         w = strtok_r(NULL, " \t", &rest)) {
        if (n == most)
            return most + 1;
        word[n++] = w;
    }
    return n;
}

// Lattice="ax ay az bx by bz cx cy cz": the diagonal.
static int read_lattice(reader *r, double length[3])
{
    char *word[9];
    int good = 0;
    char *lattice = value_of(r->line, "Lattice");
    if (lattice && split(lattice, word, 9) == 9) {
        good = 1;
        for (int k = 0; k < 9; k++) {
            double x = 0;
            good &= brink_number_read(word[k], &x) == 1 &&
                    (k % 4 == 0 ? x > 0 : x == 0);
            if (k % 4 == 0)
                length[k / 4] = x;
        }
    }
    free(lattice);
    return good ? 0
                : complain(r, "no box: the second line needs ",
                           "Lattice=\"Lx 0 0 0 Ly 0 0 0 Lz\"");
}

static int take_property(reader *r, const char *name, char type, int count)
{
    const struct {
        const char *name;
        char type;
        int count, *where;
    } known[] = {{"species", 'S', 1, &r->species},
                 {"pos", 'R', 3, &r->pos},
                 {"velo", 'R', 3, &r->velo},
                 {"id", 'I', 1, &r->id}};
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        if (strcmp(name, known[k].name) != 0)
            continue;
        if (type != known[k].type || count != known[k].count ||
            *known[k].where >= 0)
            return -1;
        *known[k].where = r->columns;
    }
    r->columns += count;
    return r->columns <= COLUMNS_MOST ? 0 : -1;
}

static int read_properties(reader *r)
{
    static const char bare[] = "species:S:1:pos:R:3"; // what a plain XYZ has
    char *given = value_of(r->line, "Properties");
    char *list = given ? given : strdup(bare), *rest = NULL;
    int good = list != NULL;
    r->columns = 0;
    r->species = r->pos = r->velo = r->id = -1;
    for (char *name = list ? strtok_r(list, ":", &rest) : NULL; name && good;
         name = strtok_r(NULL, ":", &rest)) {
        const char *type = strtok_r(NULL, ":", &rest);
        const char *count = strtok_r(NULL, ":", &rest);
        uint64_t n = 0;
        good = type && count && strlen(type) == 1 && strchr("SRIL", *type) &&
               brink_integer_read(count, &n) == 1 && n >= 1 &&
               n <= COLUMNS_MOST && take_property(r, name, *type, (int)n) == 0;
    }
    free(list);
    if (good && r->species >= 0 && r->pos >= 0)
        return 0;
    return complain(r, "Properties needs species:S:1 and pos:R:3, as in ",
                    "Properties=species:S:1:pos:R:3:velo:R:3");
}

// Name of the particle `id`, from "A:400 B:100".
static int name_of(const char *names, uint64_t id, char name[16])
{
    uint64_t end = 0;
    for (const char *p = names; *p; p += strspn(p, " ")) {
        char word[48], *colon = NULL;
        const size_t length = strcspn(p, " ");
        uint64_t count = 0;
        if (length >= sizeof word)
            return -1;
        memcpy(word, p, length);
        word[length] = '\0';
        p += length;
        colon = strchr(word, ':');
        if (!colon || colon - word > 15 ||
            brink_integer_read(colon + 1, &count) != 1 ||
            count > BRINK_PARTICLES_MOST)
            return -1;
        *colon = '\0';
        end += count;
        if (id < end) {
            memcpy(name, word, strlen(word) + 1);
            return 0;
        }
    }
    return -1;
}

static int read_three(char *word[], double x[3])
{
    int good = 1;
    for (int a = 0; a < 3; a++)
        good &= brink_number_read(word[a], &x[a]) == 1;
    return good;
}

static int read_particle(reader *r, brink_frame *frame, uint32_t i)
{
    char *word[COLUMNS_MOST];
    uint64_t id = 0;
    if (split(r->line, word, COLUMNS_MOST) != r->columns)
        return complain(
            r, "a particle's line has not as many columns as Properties", "");
    if (!read_three(word + r->pos, frame->x[i]))
        return complain(r, "a position is not three finite numbers", "");
    if (frame->v && !read_three(word + r->velo, frame->v[i]))
        return complain(r, "a velocity is not three finite numbers", "");
    if (r->names) {
        if (r->id < 0 || brink_integer_read(word[r->id], &id) != 1 ||
            name_of(r->names, id, frame->species[i]))
            return complain(r,
                            "a particle's id does not go with names=", r->names);
    } else if (strlen(word[r->species]) >= sizeof *frame->species) {
        return complain(
            r, "a species' name is longer than 15 letters: ", word[r->species]);
    } else {
        memcpy(frame->species[i], word[r->species], strlen(word[r->species]) + 1);
    }
    return 0;
}

// Room for `capacity` particles.  It grows as lines come in: the number that the
// file gives of itself is not to be trusted with memory.
static int grow(brink_frame *frame, size_t capacity, int has_velocities)
{
    void *species = realloc(frame->species, capacity * sizeof *frame->species);
    frame->species = species ? species : frame->species;
    void *x = realloc(frame->x, capacity * sizeof *frame->x);
    frame->x = x ? x : frame->x;
    if (!has_velocities)
        return species && x ? 0 : -1;
    void *v = realloc(frame->v, capacity * sizeof *frame->v);
    frame->v = v ? v : frame->v;
    return species && x && v ? 0 : -1;
}

static int read_particles(reader *r, brink_frame *frame)
{
    size_t capacity = 0;
    for (uint32_t i = 0; i < frame->count; i++) {
        if (i == capacity) {
            capacity = capacity ? 2 * capacity : 64;
            if (grow(frame, capacity, r->velo >= 0))
                return complain(r, "there is no memory for the particles", "");
        }
        if (!next_line(r))
            return complain(r, "the file ends before its last particle", "");
        if (read_particle(r, frame, i))
            return -1;
    }
    return 1;
}

static int read_frame(reader *r, brink_frame *frame)
{
    uint64_t count = 0;
    do {
        if (!next_line(r))
            return ferror(r->in) ? complain(r, "this file cannot be read", "")
                                 : 0;
    } while (r->line[strspn(r->line, " \t")] == '\0');
    char *word[1];
    if (split(r->line, word, 1) != 1 ||
        brink_integer_read(word[0], &count) != 1 || count < 1 ||
        count > BRINK_PARTICLES_MOST)
        return complain(r, "a frame begins with the number of its particles", "");
    if (!next_line(r))
        return complain(r, "the file ends within a frame", "");
    frame->count = (uint32_t)count;
    r->names = value_of(r->line, "names");
    if (read_lattice(r, frame->length) || read_properties(r))
        return -1;
    return read_particles(r, frame);
}

int brink_trajectory_read(FILE *in, const char *name, brink_frame *frame,
                          FILE *errors)
{
    reader r = {.in = in, .name = name, .errors = errors};
    *frame = (brink_frame){0};
    const int status = read_frame(&r, frame);
    free(r.line);
    free(r.names);
    if (status != 1)
        brink_frame_destroy(frame);
    return status;
}

void brink_frame_destroy(brink_frame *frame)
{
    free(frame->species);
    free(frame->x);
    free(frame->v);
    *frame = (brink_frame){0};
}
