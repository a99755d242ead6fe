// SPDX-License-Identifier: MIT
#include "scene.h"
#include "scene_box.h"
#include "scene_observe.h"
#include "scene_species.h"
#include "scene_tree.h"
#include "scene_value.h"
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SIZE_MOST ((size_t)1 << 20)
#define PATH_MOST 4096 // bytes of a start file's path

// Events are counted in doubles on the way from the file: exactly, up to here.
#define EVENTS_MOST (UINT64_C(1) << 53)

enum top {
    TITLE,
    SEED,
    DIMENSIONS,
    BOX,
    SPECIES,
    START,
    TEMPERATURE,
    POTENTIALS,
    RUN,
    OUTPUT,
    OBSERVE,
    TOP_KEYS
};

static void set_defaults(brink_scene *scene)
{
    *scene = (brink_scene){.seed = 1,
                           .dimensions = 3,
                           .length = {1, 1, 1},
                           .temperature = 1.0,
                           .target = BRINK_TARGET_PER_PARTICLE,
                           .target_value = 100.0,
                           .checkpoint_every = 60.0};
}

static void read_title(brink_source *s, brink_scene *scene,
                       const brink_node *node)
{
    const char *text = "";
    if (node)
        brink_value_text(s, node, "title", BRINK_TITLE_MOST, &text);
    scene->title = strdup(text);
}

static void read_lattice(brink_source *s, brink_scene *scene,
                         const brink_node *node)
{
    static const char *const names[] = {"fcc", "sc", "square", "hexagonal"};
    const int first = scene->dimensions == 3 ? 0 : 2;
    const char *text = NULL;
    if (!brink_value_text(s, node, "lattice", PATH_MOST, &text))
        return;
    for (int k = first; k < first + 2; k++) {
        if (strcmp(text, names[k]) == 0) {
            scene->start = (enum brink_lattice)k;
            return;
        }
    }
    brink_complain(s, node->at,
                   "'%s' is no lattice in %d dimensions\nwrite %s or %s",
                   brink_value_shown(node).text, scene->dimensions, names[first],
                   names[first + 1]);
}

static void read_file(brink_source *s, brink_scene *scene, const brink_node *node,
                      const char *folder)
{
    const char *path = NULL;
    if (!brink_value_text(s, node, "file", PATH_MOST, &path))
        return;
    const int is_relative = *path != '/' && *folder;
    const size_t room = strlen(folder) + strlen(path) + 2;
    scene->start = BRINK_START_FILE;
    scene->start_file = malloc(room);
    if (scene->start_file)
        snprintf(scene->start_file, room, "%s%s%s", is_relative ? folder : "",
                 is_relative ? "/" : "", path);
}

static void read_start(brink_source *s, brink_scene *scene,
                       const brink_node *node, const char *folder)
{
    brink_key keys[] = {{"lattice", 0, 0}, {"random", 0, 0}, {"file", 0, 0}};
    scene->start =
        scene->dimensions == 3 ? BRINK_START_FCC : BRINK_START_HEXAGONAL;
    if (!node || !brink_value_map(s, node, "start", "start: {lattice: fcc}"))
        return;
    const int faults = brink_value_keys(s, node, "start", keys, 3);
    switch (faults ? -1 : brink_value_choose(s, node, "start", keys, 3)) {
    case 0:
        read_lattice(s, scene, keys[0].value);
        break;
    case 1:
        if (brink_value_true(s, keys[1].value, "random",
                             "give a lattice instead"))
            scene->start = BRINK_START_RANDOM;
        break;
    case 2:
        read_file(s, scene, keys[2].value, folder);
        break;
    default:
        break;
    }
}

static void read_run(brink_source *s, brink_scene *scene, const brink_node *node,
                     int have_species)
{
    brink_key keys[] = {
        {"events_per_particle", 0, 0}, {"events", 0, 0}, {"time", 0, 0}};
    if (!node ||
        !brink_value_map(s, node, "run", "run: {events_per_particle: 100}"))
        return;
    const int faults = brink_value_keys(s, node, "run", keys, 3);
    const int chosen = faults ? -1 : brink_value_choose(s, node, "run", keys, 3);
    uint64_t events = 0;
    if (chosen < 0)
        return;
    const brink_node *value = keys[chosen].value;
    scene->target = (enum brink_target)chosen;
    if (scene->target != BRINK_TARGET_EVENTS)
        brink_value_positive(s, value, keys[chosen].name, &scene->target_value);
    else if (brink_value_count(s, value, "events", 1, EVENTS_MOST, &events))
        scene->target_value = (double)events;
    if (have_species && scene->target == BRINK_TARGET_PER_PARTICLE &&
        scene->target_value * scene->count > (double)EVENTS_MOST)
        brink_complain(s, value->at,
                       "%s events for each of %u particles are more than 2^53\n"
                       "ask for fewer",
                       brink_value_shown(value).text, scene->count);
    if (have_species && scene->target != BRINK_TARGET_TIME && scene->count == 1)
        brink_complain(s, value->at,
                       "one particle meets nobody: there are no events to count\n"
                       "ask for a time, as in run: {time: 100}");
}

static void read_output(brink_source *s, brink_scene *scene,
                        const brink_node *node)
{
    brink_key keys[] = {{"trajectory", 0, 0}, {"checkpoint", 0, 0}};
    if (!node || !brink_value_map(s, node, "output", "output: {trajectory: 0.1}"))
        return;
    brink_value_keys(s, node, "output", keys, 2);
    if (keys[0].value)
        brink_value_positive(s, keys[0].value, "trajectory",
                             &scene->trajectory_every);
    if (keys[1].value)
        brink_value_positive(s, keys[1].value, "checkpoint",
                             &scene->checkpoint_every);
}

static void read_scene(brink_source *s, brink_scene *scene,
                       const brink_node *root, const char *folder)
{
    brink_key keys[TOP_KEYS] = {[TITLE] = {"title", 0, 0},
                                [SEED] = {"seed", 0, 0},
                                [DIMENSIONS] = {"dimensions", 0, 0},
                                [BOX] = {"box", 0, 0},
                                [SPECIES] = {"species", 0, 0},
                                [START] = {"start", 0, 0},
                                [TEMPERATURE] = {"temperature", 0, 0},
                                [POTENTIALS] = {"potentials", 0, 0},
                                [RUN] = {"run", 0, 0},
                                [OUTPUT] = {"output", 0, 0},
                                [OBSERVE] = {"observe", 0, 0}};
    uint64_t dimensions = 3;
    int have_species = 0;
    if (!brink_value_map(s, root, "a scene", "`key: value`, one a line"))
        return;
    brink_value_keys(s, root, "a scene", keys, TOP_KEYS);
    read_title(s, scene, keys[TITLE].value);
    if (keys[SEED].value)
        brink_value_count(s, keys[SEED].value, "seed", 0, BRINK_SEED_MOST,
                          &scene->seed);
    if (keys[DIMENSIONS].value)
        brink_value_count(s, keys[DIMENSIONS].value, "dimensions", 2, 3,
                          &dimensions);
    scene->dimensions = (int)dimensions;
    if (keys[SPECIES].value)
        have_species = brink_species_read(s, scene, keys[SPECIES].value,
                                          keys[POTENTIALS].value);
    if (keys[BOX].value)
        brink_box_read(s, scene, keys[BOX].value, have_species);
    read_start(s, scene, keys[START].value, folder);
    if (keys[TEMPERATURE].value)
        brink_value_positive(s, keys[TEMPERATURE].value, "temperature",
                             &scene->temperature);
    read_run(s, scene, keys[RUN].value, have_species);
    read_output(s, scene, keys[OUTPUT].value);
    brink_observe_read(s, scene, keys[OBSERVE].value);

    if (!keys[BOX].key)
        brink_complain(s, root->at,
                       "the scene has no box\ngive it: " BRINK_BOX_EXAMPLE);
    if (!keys[SPECIES].key)
        brink_complain(
            s, root->at,
            "the scene has no species\ngive it: " BRINK_SPECIES_EXAMPLE);
    scene->start_at = keys[START].key ? keys[START].key->at : root->at;
    if (!keys[START].key && keys[BOX].key)
        scene->start_at = keys[BOX].key->at;
    if (keys[TEMPERATURE].key)
        scene->temperature_at = keys[TEMPERATURE].key->at;
}

int brink_scene_parse(const char *text, size_t size, const char *name,
                      const char *folder, brink_scene *scene, FILE *errors)
{
    static const char bom[] = "\xef\xbb\xbf"; // some editors begin a file with it
    if (size >= 3 && memcmp(text, bom, 3) == 0) {
        text += 3;
        size -= 3;
    }
    brink_source source = brink_source_of(name, text, size, errors);
    set_defaults(scene);
    if (size > SIZE_MOST)
        brink_complain(&source, (brink_mark){1, 1},
                       "the file is larger than 1 MiB\nis this the right file?");
    else if (brink_source_is_text(&source)) {
        brink_node *root = brink_tree_read(&source);
        if (root)
            read_scene(&source, scene, root, folder);
        brink_tree_destroy(root);
    }
    if (source.complaints == 0) {
        scene->text_size = size;
        scene->text = calloc(size + 1, 1);
        if (scene->text)
            memcpy(scene->text, text, size);
        if (!scene->text || !scene->title ||
            (scene->start == BRINK_START_FILE && !scene->start_file))
            brink_complain(
                &source, (brink_mark){1, 1},
                "there is no memory left to read this\nmake some free");
    }
    if (source.complaints > 0)
        brink_scene_destroy(scene);
    return source.complaints;
}

// Everything up to the last '/' of a path: "" where there is none.
static char *folder_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    const size_t length = slash ? (size_t)(slash - path) : 0;
    char *folder = calloc(length + 1, 1);
    return folder ? memcpy(folder, path, length) : NULL;
}

int brink_scene_read(const char *path, brink_scene *scene, FILE *errors)
{
    int faults = 1;
    size_t size = 0;
    errno = ENOMEM;
    char *text = malloc(SIZE_MOST + 1), *folder = folder_of(path);
    FILE *file = text && folder ? fopen(path, "rb") : NULL;
    if (file)
        size = fread(text, 1, SIZE_MOST + 1, file);
    if (!file || ferror(file)) {
        brink_source nothing = brink_source_of(path, "", 0, errors);
        brink_complain(&nothing, (brink_mark){1, 1},
                       "this file cannot be read: %s\n"
                       "name a scene file, such as sim/scenes/square-well.yaml",
                       strerror(errno));
        *scene = (brink_scene){0};
    } else {
        faults = brink_scene_parse(text, size, path, folder, scene, errors);
    }
    if (file)
        fclose(file);
    free(folder);
    free(text);
    return faults;
}

void brink_scene_destroy(brink_scene *scene)
{
    brink_species_destroy(scene);
    free(scene->title);
    free(scene->start_file);
    free(scene->text);
    *scene = (brink_scene){0};
}

uint64_t brink_scene_events(const brink_scene *scene)
{
    if (scene->target == BRINK_TARGET_TIME)
        return UINT64_MAX;
    if (scene->target == BRINK_TARGET_EVENTS)
        return (uint64_t)scene->target_value;
    return (uint64_t)ceil(scene->target_value * scene->count);
}
