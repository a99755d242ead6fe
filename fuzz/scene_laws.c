// SPDX-License-Identifier: MIT
#include "scene_laws.h"
#include "fuzz.h"
#include "run.h"
#include "scene_species.h"
#include "scene_value.h"
#include "start.h"
#include <stdlib.h>
#include <string.h>

enum { STARTED_MOST = 64 };

static const char name[] = "s.yaml";

_Noreturn void scene_broken(const scene_text *t, const char *law)
{
    FINDING("scene: %s", law);
    fwrite(t->byte, 1, t->size, stderr);
    finding_end();
}

// --- Complaints ----------------------------------------------------------------

static long lines_of(const scene_text *t)
{
    long lines = 1;
    for (size_t k = 0; k < t->size; k++)
        lines += t->byte[k] == '\n';
    return lines;
}

/** The first complaint, after which the next begin: "s.yaml:LINE:COLUMN: error:",
 *  a line and a caret.  Its line; 0 where there is none. */
static long next_complaint(const scene_text *t, const char **said)
{
    const size_t begin = strlen(name);
    char *end;
    if (**said == '\0')
        return 0;
    if (strncmp(*said, name, begin) != 0 || (*said)[begin] != ':')
        scene_broken(t, "a complaint begins with the file's name");
    const long line = strtol(*said + begin + 1, &end, 10);
    const long column = *end == ':' ? strtol(end + 1, &end, 10) : 0;
    if (line < 1 || line > lines_of(t) + 1 || column < 1 ||
        strncmp(end, ": error: ", 9) != 0)
        scene_broken(t, "a complaint says where, file:line:column");
    for (int lines = 0; lines < 3; lines++) { // it has three
        const char *lf = strchr(*said, '\n');
        if (!lf || (lines > 0 && strncmp(*said, "  ", 2) != 0) ||
            (lines == 2 && !memchr(*said, '^', (size_t)(lf - *said))))
            scene_broken(t, "a complaint shows the line, and a caret under it");
        *said = lf + 1;
    }
    return line;
}

/** How many complaints, and whether one is of this line. */
static int check_complaints(const scene_text *t, const char *said, int complaints,
                            long wanted)
{
    int found = 0;
    for (int n = 0; n < complaints && n < BRINK_COMPLAINTS_MOST; n++) {
        const long line = next_complaint(t, &said);
        if (line == 0)
            scene_broken(t, "as many complaints are told as there are");
        found |= line == wanted;
    }
    if (*said && complaints < BRINK_COMPLAINTS_MOST)
        scene_broken(t, "no more complaints are told than there are");
    return found;
}

int scene_parse(const scene_text *t, brink_scene *scene, long wanted)
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
        scene_broken(t, "a fault is complained of in its line");
    }
    if (faults && (scene->title || scene->text || scene->species || scene->count))
        scene_broken(t, "of a bad scene nothing is kept");
    free(said);
    return faults;
}

// --- Bounds --------------------------------------------------------------------

static int is_magnitude(double x)
{
    return fabs(x) >= BRINK_VALUE_LEAST && fabs(x) <= BRINK_VALUE_MOST;
}

static void check_potential(const scene_text *t, const brink_scene *s, int a,
                            int b)
{
    const int kinds = s->species_count;
    const brink_potential *p = &s->potential[a * kinds + b];
    const brink_potential *mirror = &s->potential[b * kinds + a];
    if (!brink_potential_is_valid(p) || p->count > BRINK_STEPS_MOST)
        scene_broken(t, "steps have decreasing distances and energies");
    for (int k = 0; k < p->count; k++) {
        if (!is_magnitude(p->distance[k]) ||
            (isfinite(p->energy[k]) && p->energy[k] != 0 &&
             !is_magnitude(p->energy[k])))
            scene_broken(t, "distances and energies have a bounded magnitude");
        if (mirror->count != p->count || mirror->distance[k] != p->distance[k] ||
            mirror->energy[k] != p->energy[k])
            scene_broken(t, "a potential is the same seen from either side");
        for (int d = 0; d < s->dimensions; d++)
            if (!(s->length[d] > 2 * p->distance[k]))
                scene_broken(t, "the box is wider than twice the range");
    }
}

static void check_wish(const scene_text *t, const brink_scene *s)
{
    const brink_wish *w = &s->wish;
    if (!(w->every >= 0) || !isfinite(w->every) || !(w->from >= 0) ||
        w->distance_bins < 0 || w->lags < 0 ||
        !(2 * w->distance_most <= fmin(s->length[0], s->length[1])))
        scene_broken(t, "what is to be measured can be");
}

static void check_bounds(const scene_text *t, const brink_scene *s)
{
    uint64_t count = 0;
    if (strlen(s->title) > BRINK_TITLE_MOST || strpbrk(s->title, "\r\n"))
        scene_broken(t, "a title is one line, not too long");
    if (s->seed > BRINK_SEED_MOST || (s->dimensions != 2 && s->dimensions != 3))
        scene_broken(t, "the seed and the dimensions are within bounds");
    if (s->species_count < 1 || s->species_count > BRINK_SPECIES_MOST)
        scene_broken(t, "there are species, not too many");
    for (int a = 0; a < s->species_count; a++) {
        if (!(s->species[a].mass > 0) || !is_magnitude(s->species[a].mass) ||
            s->species[a].count < 1 || !s->species[a].name[0])
            scene_broken(t, "a species has a name, a mass and particles");
        count += s->species[a].count;
        for (int b = 0; b < s->species_count; b++)
            check_potential(t, s, a, b);
        for (int b = 0; b < a; b++)
            if (strcmp(s->species[a].name, s->species[b].name) == 0)
                scene_broken(t, "species have names of their own");
    }
    for (int a = 0; a < 3; a++)
        if (!(s->length[a] > 0) || !isfinite(s->length[a]))
            scene_broken(t, "the box has lengths");
    if (count != s->count || count > BRINK_PARTICLES_MOST)
        scene_broken(t, "particles are counted, and not too many");
    if (!(s->temperature > 0) || !(s->target_value > 0) ||
        !(s->trajectory_every >= 0) || !(s->checkpoint_every > 0))
        scene_broken(t,
                     "temperature, target and intervals are more than nothing");
    if (brink_scene_events(s) == 0)
        scene_broken(t, "a scene asks for events");
    check_wish(t, s);
}

// --- The same meaning ----------------------------------------------------------

static void compare(const scene_text *t, const brink_scene *a,
                    const brink_scene *b)
{
    const int kinds = a->species_count;
    if (strcmp(a->title, b->title) != 0 || a->seed != b->seed ||
        a->dimensions != b->dimensions || a->count != b->count ||
        kinds != b->species_count || a->start != b->start ||
        a->temperature != b->temperature || a->target != b->target ||
        a->target_value != b->target_value ||
        memcmp(a->length, b->length, sizeof a->length) != 0)
        scene_broken(t, "with other ends of lines it is the same scene");
    for (int k = 0; k < kinds; k++)
        if (a->species[k].mass != b->species[k].mass ||
            a->species[k].count != b->species[k].count ||
            strcmp(a->species[k].name, b->species[k].name) != 0)
            scene_broken(t, "with other ends of lines it has the same species");
    for (int k = 0; k < kinds * kinds; k++)
        if (a->potential[k].count != b->potential[k].count ||
            a->potential[k].distance[0] != b->potential[k].distance[0])
            scene_broken(t,
                         "with other ends of lines it has the same potentials");
}

/** LF as CR LF, a mark at the beginning, and a comment at the end. */
static void rewrite(const scene_text *t, const brink_scene *scene)
{
    static scene_text other;
    static const char mark[] = "\xef\xbb\xbf";
    brink_scene again;
    if (2 * t->size + 8 > SCENE_TEXT_LONGEST ||
        (t->size > 2 && !memcmp(t->byte, mark, 3)))
        return;
    memcpy(other.byte, mark, 3);
    other.size = 3;
    for (size_t k = 0; k < t->size; k++) {
        if (t->byte[k] == '\n' && (k == 0 || t->byte[k - 1] != '\r'))
            other.byte[other.size++] = '\r';
        other.byte[other.size++] = t->byte[k];
    }
    if (scene_parse(&other, &again, 0) != 0)
        scene_broken(t, "with other ends of lines it is still a scene");
    compare(t, scene, &again);
    brink_scene_destroy(&again);
}

/** Started, or refused with a complaint; start files are no business here. */
static void start(const scene_text *t, const brink_scene *scene)
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
        scene_broken(t, fault);
    brink_run run;
    LAW(brink_run_create(&run, &system, BRINK_TIER_FAST) == 0,
        "scene: memory is out");
    fault = brink_run_is_valid(&run);
    if (fault)
        scene_broken(t, fault);
    brink_run_destroy(&run);
}

int scene_take(const scene_text *t, long wanted)
{
    brink_scene scene;
    if (scene_parse(t, &scene, wanted) != 0)
        return 0;
    check_bounds(t, &scene);
    rewrite(t, &scene);
    start(t, &scene);
    brink_scene_destroy(&scene);
    return 1;
}
