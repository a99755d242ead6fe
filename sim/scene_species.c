// SPDX-License-Identifier: MIT
#include "scene_species.h"
#include "scene_mix.h"
#include "scene_value.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// What a particle costs in a run, in bytes: 64 for itself, 26 in the cells, 48
// for a slot in the calendar and up to four days of 4, 8 in the states, twice 32
// for four links in a pool that grows by doubling, and a mark: 227, rounded up.
#define BYTES_PER_PARTICLE 256

#define STEPS_EXAMPLE "steps: [[3, -1], [1, .inf]], outermost first"

static brink_potential *pair(brink_scene *scene, int a, int b)
{
    return &scene->potential[a * scene->species_count + b];
}

// Room for the steps of a pair, one block: distances, then energies.  The two
// orders of a pair share it.  NULL if memory is out.
static double *make_room(brink_source *s, brink_scene *scene, int a, int b,
                         int count, brink_mark at)
{
    double *table = calloc(2 * (size_t)count, sizeof *table);
    if (!table) {
        brink_complain(s, at,
                       "there is no memory for the steps\nmake them fewer");
        return NULL;
    }
    *pair(scene, a, b) = (brink_potential){count, table, table + count};
    *pair(scene, b, a) = *pair(scene, a, b);
    return table;
}

static int is_name(const char *text)
{
    static const char letters[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
    return *text && strchr(letters, *text) &&
           text[1 + strspn(text + 1,
                           "0123456789_+-ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefgh"
                           "ijklmnopqrstuvwxyz")] == '\0';
}

// One species; its own diameter goes into `diameter`, 0 where it gives none.
static int read_one(brink_source *s, const brink_node *name,
                    brink_species *species)
{
    brink_key keys[] = {{"count", 0, 0}, {"mass", 0, 0}, {"diameter", 0, 0}};
    uint64_t count = 0;
    int good = is_name(name->text) && strlen(name->text) < sizeof species->name;
    if (good)
        memcpy(species->name, name->text, strlen(name->text) + 1);
    else if (name->kind == BRINK_NODE_SCALAR)
        brink_complain(
            s, name->at,
            "'%s' cannot be a species' name\n"
            "up to %zu letters, digits, '_', '+' and '-', a letter first",
            brink_value_shown(name).text, sizeof species->name - 1);
    if (!brink_value_map(s, name->next, "a species", "{count: 1000, mass: 1}"))
        return 0;
    good &= !brink_value_keys(s, name->next, "a species", keys, 3);
    if (keys[0].value) {
        good &= brink_value_count(s, keys[0].value, "count", 1,
                                  BRINK_PARTICLES_MOST, &count);
        species->count = (uint32_t)count;
    } else {
        brink_complain(s, name->at,
                       "species '%s' has no count\ngive one: {count: 1000}",
                       brink_value_shown(name).text);
        good = 0;
    }
    species->mass = 1.0;
    if (keys[1].value)
        good &= brink_value_positive(s, keys[1].value, "mass", &species->mass);
    if (keys[2].value)
        good &= brink_value_positive(s, keys[2].value, "diameter",
                                     &species->diameter);
    return good;
}

static int find_species(const brink_scene *scene, const char *name)
{
    for (int a = 0; a < scene->species_count; a++)
        if (strcmp(scene->species[a].name, name) == 0)
            return a;
    return -1;
}

// Reads them all, as far as they can be read: others refer to their names.
static int read_species(brink_source *s, brink_scene *scene,
                        const brink_node *map)
{
    int good = 1;
    uint64_t total = 0;
    if (!brink_value_map(s, map, "species", BRINK_SPECIES_EXAMPLE))
        return 0;
    if (!map->first || map->count > 2 * BRINK_SPECIES_MOST) {
        brink_complain(s, map->at, "there are %d species\nhave 1 to %d of them",
                       map->count / 2, BRINK_SPECIES_MOST);
        return 0;
    }
    const size_t most = (size_t)map->count / 2;
    scene->species = calloc(most, sizeof *scene->species);
    scene->potential = calloc(most * most, sizeof *scene->potential);
    if (!scene->species || !scene->potential) {
        brink_complain(s, map->at,
                       "there is no memory for the species\nhave fewer");
        return 0;
    }
    for (const brink_node *name = map->first; name; name = name->next->next) {
        if (name->kind == BRINK_NODE_SCALAR &&
            find_species(scene, name->text) >= 0) {
            brink_complain(s, name->at,
                           "species '%s' is given again\nkeep one of the two",
                           brink_value_shown(name).text);
            good = 0;
            continue;
        }
        brink_species *next = &scene->species[scene->species_count++];
        good &= read_one(s, name, next);
        total += next->count;
    }
    const uint64_t bytes = total * BYTES_PER_PARTICLE;
    const uint64_t memory =
        (uint64_t)sysconf(_SC_PHYS_PAGES) * (uint64_t)sysconf(_SC_PAGESIZE);
    if (total > BRINK_PARTICLES_MOST)
        brink_complain(
            s, map->at,
            "there are %llu particles\nthere can be at most %llu = 2^30",
            (unsigned long long)total, (unsigned long long)BRINK_PARTICLES_MOST);
    else if (bytes > memory)
        brink_complain(
            s, map->at,
            "%llu particles need %llu bytes, and this machine has %llu\n"
            "have at most %llu particles here",
            (unsigned long long)total, (unsigned long long)bytes,
            (unsigned long long)memory,
            (unsigned long long)(memory / BYTES_PER_PARTICLE));
    else
        scene->count = (uint32_t)total;
    return good && scene->count > 0;
}

// The species that one item of `between` names, or -1.
static int named_species(brink_source *s, const brink_scene *scene,
                         const brink_node *node)
{
    const char *names[BRINK_SPECIES_MOST], *name = NULL;
    if (!brink_value_text(s, node, "a species", sizeof scene->species->name,
                          &name))
        return -1;
    const int a = find_species(scene, name);
    if (a >= 0)
        return a;
    for (int k = 0; k < scene->species_count; k++)
        names[k] = scene->species[k].name;
    const char *meant = brink_value_meant(name, names, scene->species_count);
    brink_complain(s, node->at, "there is no species '%s'\n%s%s%s",
                   brink_value_shown(node).text,
                   meant ? "did you mean '" : "name one of those under `species`",
                   meant ? meant : "", meant ? "'?" : "");
    return -1;
}

static int read_step(brink_source *s, const brink_node *step, int is_last,
                     double *distance, double *energy)
{
    if (!brink_value_list(s, step, "a step", 2, "[distance, energy inside it]"))
        return 0;
    const brink_node *inside = step->first->next;
    const int is_core = inside->kind == BRINK_NODE_SCALAR && inside->plain &&
                        strcmp(inside->text, ".inf") == 0;
    int good =
        brink_value_positive(s, step->first, "the distance of a step", distance);
    if (is_core && is_last)
        *energy = (double)INFINITY;
    else if (is_core)
        brink_complain(
            s, inside->at,
            "a hard core is not the last step\n"
            "nothing gets inside it: take off the steps after it, or list "
            "the outermost first");
    else
        good &= brink_value_number(s, inside, "the energy inside a step", energy);
    return good && !(is_core && !is_last);
}

static int read_steps(brink_source *s, const brink_node *steps, double *distance,
                      double *energy)
{
    int k = 0, good = 1;
    for (const brink_node *step = steps->first; step; step = step->next, k++) {
        good &= read_step(s, step, !step->next, &distance[k], &energy[k]);
        if (k > 0 && distance[k] > 0 && distance[k - 1] > 0 &&
            !(distance[k] < distance[k - 1])) {
            brink_complain(
                s, step->at,
                "this step is at %.17g, and the one before it at %.17g\n"
                "list the steps from the outermost to the innermost",
                distance[k], distance[k - 1]);
            good = 0;
        }
    }
    return good;
}

static int read_potential(brink_source *s, brink_scene *scene,
                          const brink_node *item)
{
    brink_key keys[] = {{"between", 0, 0}, {"steps", 0, 0}};
    if (!brink_value_map(s, item, "a potential",
                         "{between: [A, A], steps: [[1, .inf]]}"))
        return 0;
    int good = !brink_value_keys(s, item, "a potential", keys, 2);
    const brink_node *between = keys[0].value, *steps = keys[1].value;
    if (!between || !steps) {
        if (good)
            brink_complain(s, item->at, "this potential has no '%s'\ngive %s",
                           between ? "steps" : "between",
                           between ? STEPS_EXAMPLE : "between: [A, A]");
        return 0;
    }
    int a = -1, b = -1;
    if (brink_value_list(s, between, "between", 2, "between: [A, B]")) {
        a = named_species(s, scene, between->first);
        b = named_species(s, scene, between->first->next);
    }
    if (steps->kind != BRINK_NODE_LIST || steps->count < 1 ||
        steps->count > BRINK_STEPS_MOST) {
        if (steps->kind != BRINK_NODE_REFUSED)
            brink_complain(s, steps->at,
                           "steps is not a list of 1 to %d steps\ngive %s",
                           BRINK_STEPS_MOST, STEPS_EXAMPLE);
        return 0;
    }
    if (a < 0 || b < 0)
        return 0;
    if (pair(scene, a, b)->count > 0) {
        brink_complain(s, between->at,
                       "a potential between '%s' and '%s' is given again\n"
                       "keep one of the two",
                       scene->species[a].name, scene->species[b].name);
        return 0;
    }
    double *table = make_room(s, scene, a, b, steps->count, steps->at);
    return table && read_steps(s, steps, table, table + steps->count) && good;
}

static int read_potentials(brink_source *s, brink_scene *scene,
                           const brink_node *list)
{
    int good = 1;
    if (!list)
        return 1;
    if (list->kind != BRINK_NODE_LIST) {
        if (list->kind != BRINK_NODE_REFUSED)
            brink_complain(
                s, list->at,
                "potentials is not a list\nbegin each potential with '- '");
        return 0;
    }
    for (const brink_node *item = list->first; item; item = item->next)
        good &= read_potential(s, scene, item);
    return good;
}

// The potential of a species with its like: given, or the core its diameter
// stands for.
static int complete_like(brink_source *s, brink_scene *scene, int a,
                         brink_mark at)
{
    brink_potential *like = pair(scene, a, a);
    brink_species *species = &scene->species[a];
    if (like->count == 0 && species->diameter > 0) {
        double *table = make_room(s, scene, a, a, 1, at);
        if (!table)
            return 0;
        table[0] = species->diameter;
        table[1] = (double)INFINITY;
        return 1;
    }
    if (like->count > 0 && species->diameter == 0) {
        species->diameter = like->distance[like->count - 1];
        return 1;
    }
    brink_complain(
        s, at,
        like->count > 0
            ? "species '%s' has a diameter and a potential with its like\n"
              "keep one: the diameter is short for steps: [[diameter, .inf]]"
            : "nothing says how particles of '%s' meet\n"
              "give the species a diameter, or a potential with its like",
        species->name);
    return 0;
}

static int complete_unlike(brink_source *s, brink_scene *scene, int a, int b,
                           brink_mark at)
{
    const brink_potential *p = pair(scene, a, a), *q = pair(scene, b, b);
    double *table = make_room(s, scene, a, b, p->count, at);
    if (!table)
        return 0;
    const enum brink_mix mix = brink_mix_steps(p, q, table, table + p->count);
    if (mix == BRINK_MIX_GOOD)
        return 1;
    brink_complain(s, at,
                   "the potential between '%s' and '%s' cannot be mixed: %s\n"
                   "give it: - between: [%s, %s], with its steps",
                   scene->species[a].name, scene->species[b].name,
                   brink_mix_reason(mix), scene->species[a].name,
                   scene->species[b].name);
    return 0;
}

int brink_species_read(brink_source *s, brink_scene *scene,
                       const brink_node *species, const brink_node *potentials)
{
    int good = read_species(s, scene, species);
    if (scene->species_count > 0)
        good &= read_potentials(s, scene, potentials);
    if (!good)
        return 0;
    const brink_node *name = species->first;
    for (int a = 0; a < scene->species_count; a++, name = name->next->next)
        good &= complete_like(s, scene, a, name->at);
    for (int a = 0; good && a < scene->species_count; a++)
        for (int b = a + 1; b < scene->species_count; b++)
            if (pair(scene, a, b)->count == 0)
                good &= complete_unlike(s, scene, a, b, species->at);
    return good;
}

void brink_species_destroy(brink_scene *scene)
{
    for (int a = 0; a < scene->species_count; a++)
        for (int b = a; b < scene->species_count; b++)
            free((void *)pair(scene, a, b)->distance);
    free(scene->potential);
    free(scene->species);
}
