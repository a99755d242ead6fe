// SPDX-License-Identifier: MIT
// A finding's system, in hex and as a scene.
#include "adverse.h"
#include "start_placement.h"
#include "trajectory.h"
#include <math.h>
#include <stdlib.h>

static void tell_hex(const brink_system *s)
{
    fprintf(stderr,
            "  const double box[3] = {%a, %a, %a}, year = %a;\n"
            "  const brink_particle particle[%u] = {\n",
            s->length[0], s->length[1], s->length[2], s->year, s->count);
    for (uint32_t i = 0; i < s->count; i++) {
        const brink_particle *p = &s->particle[i];
        fprintf(stderr,
                "    {{0x%016llx, 0x%016llx, 0x%016llx}, {%a, %a, %a}, %a, %u, "
                "%u},\n",
                (unsigned long long)p->x[0], (unsigned long long)p->x[1],
                (unsigned long long)p->x[2], p->v[0], p->v[1], p->v[2], p->since,
                p->generation, p->species);
    }
    fputs("  };\n", stderr);
}

static void write_potential(FILE *out, const brink_system *s, int a, int b)
{
    const brink_potential *p = &s->potential[a * s->species_count + b];
    fprintf(out, "  - between: [%s, %s]\n    steps: [", s->species[a].name,
            s->species[b].name);
    for (int k = 0; k < p->count; k++)
        if (isinf(p->energy[k]))
            fprintf(out, "%s[%.17g, .inf]", k ? ", " : "", p->distance[k]);
        else
            fprintf(out, "%s[%.17g, %.17g]", k ? ", " : "", p->distance[k],
                    p->energy[k]);
    fputs("]\n", out);
}

/** Species of which there are none are left out, as a scene has none such. */
static void write_scene(FILE *out, const brink_system *s, const char *positions)
{
    fprintf(out, "title: a finding\ndimensions: %d\nbox: {size: [%.17g, %.17g",
            s->dimensions, s->length[0], s->length[1]);
    if (s->dimensions == 3)
        fprintf(out, ", %.17g", s->length[2]);
    fputs("]}\nspecies:\n", out);
    for (int a = 0; a < s->species_count; a++)
        if (s->species[a].count > 0)
            fprintf(out, "  %s: {count: %u, mass: %.17g}\n", s->species[a].name,
                    s->species[a].count, s->species[a].mass);
    fprintf(out, "start: {file: %s}\npotentials:\n", positions);
    for (int a = 0; a < s->species_count; a++)
        for (int b = a; b < s->species_count; b++)
            if (s->species[a].count > 0 && s->species[b].count > 0)
                write_potential(out, s, a, b);
    fputs("run: {events: 1000}\n", out);
}

/** BRINK_FINDING_DIR/NAME, or standard error. */
static FILE *open_place(const char *name)
{
    const char *folder = getenv("BRINK_FINDING_DIR");
    char path[4096];
    FILE *file = NULL;
    if (folder) {
        snprintf(path, sizeof path, "%s/%s", folder, name);
        file = fopen(path, "w");
    }
    if (file)
        fprintf(stderr, "  // see %s\n", path);
    else
        fprintf(stderr, "  // %s:\n", name);
    return file ? file : stderr;
}

static void close_place(FILE *file)
{
    if (file != stderr)
        fclose(file);
}

static int is_of_doubles(const brink_system *s)
{
    for (uint32_t i = 0; i < s->count; i++)
        for (int a = 0; a < s->dimensions; a++) {
            const uint64_t x = s->particle[i].x[a];
            const double c = brink_system_coordinate(s, a, x);
            if (brink_system_fraction(s, a, c) != x)
                return 0;
        }
    return 1;
}

void adverse_tell(const brink_system *system)
{
    uint32_t i, j;
    tell_hex(system);
    if (!is_of_doubles(system))
        fputs(
            "  // positions finer than the coordinates of a file: in hex alone\n",
            stderr);
    if (brink_placement_overlap(system, &i, &j) == 1)
        fputs("  // cores overlap by a rounding: `brink run` refuses that\n",
              stderr);
    FILE *file = open_place("finding.yaml");
    write_scene(file, system, "finding.xyz");
    close_place(file);
    file = open_place("finding.xyz");
    brink_trajectory_write(file, system, 0, 0);
    close_place(file);
}
