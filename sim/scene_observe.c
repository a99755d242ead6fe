// SPDX-License-Identifier: MIT
#include "scene_observe.h"
#include "scene_value.h"
#include <math.h>

#define EXAMPLE   "observe: {every: 0.1}"
#define BINS_MOST 10000
#define LAGS_MOST 1000 // of which each has its own average

// Of the shortest box, how far a particle of thermal speed may get between two
// samples.  Displacements are told from images half a box off: that is eight
// times as far, and of 10^15 components of velocities one is eight times as
// fast.
#define STEP_MOST (1.0 / 16)

static double shortest(const brink_scene *scene)
{
    const double plane = fmin(scene->length[0], scene->length[1]);
    return scene->dimensions == 3 ? fmin(plane, scene->length[2]) : plane;
}

// Of the lightest species: sqrt(k_B T / m) along an axis.
static double thermal_speed(const brink_scene *scene)
{
    double lightest = (double)INFINITY;
    for (int a = 0; a < scene->species_count; a++)
        lightest = fmin(lightest, scene->species[a].mass);
    return sqrt(scene->temperature / lightest);
}

static void read_distances(brink_source *s, brink_scene *scene,
                           const brink_node *node)
{
    brink_key keys[] = {{"up_to", 0, 0}, {"bins", 0, 0}};
    brink_wish *w = &scene->wish;
    uint64_t bins = 100;
    if (!brink_value_map(s, node, "distances", "distances: {up_to: 3}") ||
        brink_value_keys(s, node, "distances", keys, 2))
        return;
    if (!keys[0].key)
        brink_complain(s, node->at,
                       "distances has no 'up_to'\n"
                       "give the longest: distances: {up_to: 3}");
    else if (brink_value_positive(s, keys[0].value, "up_to", &w->distance_most) &&
             s->complaints == 0 && w->distance_most > shortest(scene) / 2)
        brink_complain(s, keys[0].value->at,
                       "%s is more than half the box, which is %.6g long\n"
                       "at most %.6g",
                       brink_value_shown(keys[0].value).text, shortest(scene),
                       shortest(scene) / 2);
    if (keys[1].value)
        brink_value_count(s, keys[1].value, "bins", 1, BINS_MOST, &bins);
    w->distance_bins = (int)bins;
}

static void read_displacements(brink_source *s, brink_scene *scene,
                               const brink_node *node)
{
    brink_key keys[] = {{"up_to", 0, 0}};
    brink_wish *w = &scene->wish;
    double most = 0;
    if (!brink_value_map(s, node, "displacements", "displacements: {up_to: 5}") ||
        brink_value_keys(s, node, "displacements", keys, 1))
        return;
    if (!keys[0].key) {
        brink_complain(s, node->at,
                       "displacements has no 'up_to'\n"
                       "give the longest time: displacements: {up_to: 5}");
        return;
    }
    const brink_node *value = keys[0].value;
    if (!brink_value_positive(s, value, "up_to", &most) || !(w->every > 0))
        return;
    // A quotient that is whole in the scene's decimals is off by 3u here, and its
    // product by one more: 8u brings it back.
    const double lags = floor(most / w->every * (1 + 0x1p-50));
    if (lags < 2 || lags > LAGS_MOST) {
        brink_complain(s, value->at,
                       "%s is %.6g times 'every': it has to be 2 to %d times\n"
                       "from %.6g to %.6g, or change 'every'",
                       brink_value_shown(value).text, most / w->every, LAGS_MOST,
                       2 * w->every, LAGS_MOST * w->every);
        return;
    }
    w->lags = (int)lags;
    const double longest = STEP_MOST * shortest(scene) / thermal_speed(scene);
    if (s->complaints == 0 && w->every > longest)
        brink_complain(s, value->at,
                       "between two samples particles get too far to be followed "
                       "round the box\nmake 'every' at most %.6g",
                       longest);
}

void brink_observe_read(brink_source *s, brink_scene *scene,
                        const brink_node *node)
{
    enum { EVERY, FROM, DISTANCES, DISPLACEMENTS, SPEEDS, KEYS };
    brink_key keys[KEYS] = {[EVERY] = {"every", 0, 0},
                            [FROM] = {"from", 0, 0},
                            [DISTANCES] = {"distances", 0, 0},
                            [DISPLACEMENTS] = {"displacements", 0, 0},
                            [SPEEDS] = {"speeds", 0, 0}};
    brink_wish *w = &scene->wish;
    if (!node || !brink_value_map(s, node, "observe", EXAMPLE))
        return;
    brink_value_keys(s, node, "observe", keys, KEYS);
    if (!keys[EVERY].key)
        brink_complain(s, node->at,
                       "observe has no 'every'\n"
                       "give the time between two samples: " EXAMPLE);
    else if (keys[EVERY].value)
        brink_value_positive(s, keys[EVERY].value, "every", &w->every);
    if (keys[FROM].value &&
        brink_value_number(s, keys[FROM].value, "from", &w->from) && w->from < 0)
        brink_complain(s, keys[FROM].value->at,
                       "'from' cannot be negative: a run begins at time 0\n"
                       "give the time that it needs to settle");
    if (keys[DISTANCES].value)
        read_distances(s, scene, keys[DISTANCES].value);
    if (keys[DISPLACEMENTS].value)
        read_displacements(s, scene, keys[DISPLACEMENTS].value);
    if (keys[SPEEDS].value)
        w->speeds = brink_value_true(s, keys[SPEEDS].value, "speeds",
                                     "leave the key out");
}
