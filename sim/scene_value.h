// SPDX-License-Identifier: MIT
#ifndef BRINK_SCENE_VALUE_H
#define BRINK_SCENE_VALUE_H
/**
 * What a node of a scene says: a number, a count, a truth value, a text, the keys
 * of a map.  Every reader returns 1 and sets its value, or returns 0 after one
 * complaint. `what` is the name of the thing in messages.  A node that is
 * BRINK_NODE_REFUSED has been complained about, and is not again.
 */
#include "scene_tree.h"
#include <stdint.h>

/**
 * Numbers are 0 or of a magnitude between these two, in whatever units.  Then
 * nothing overflows on the way: the longest product of a run is r.r v.v, and
 * lengths are at most 2^24 (see scene.c) and speeds sqrt(k_B T / m) at most 1
 * times 1e60.
 */
#define BRINK_VALUE_LEAST 1e-60
#define BRINK_VALUE_MOST  1e60

/** A finite number. */
int brink_value_number(brink_source *s, const brink_node *node, const char *what,
                       double *value);
/** A number > 0. */
int brink_value_positive(brink_source *s, const brink_node *node,
                         const char *what, double *value);
/** A whole number written in digits, least <= value <= most. */
int brink_value_count(brink_source *s, const brink_node *node, const char *what,
                      uint64_t least, uint64_t most, uint64_t *value);
/** true; false is refused for the reason given. */
int brink_value_true(brink_source *s, const brink_node *node, const char *what,
                     const char *why_not_false);
/** One line of text, at most `most` bytes: the node's own. */
int brink_value_text(brink_source *s, const brink_node *node, const char *what,
                     size_t most, const char **value);
/** A list of just `count` items, or a map. */
int brink_value_list(brink_source *s, const brink_node *node, const char *what,
                     int count, const char *example);
int brink_value_map(brink_source *s, const brink_node *node, const char *what,
                    const char *example);

/** A key that a map may have, and what the map has there: NULL and NULL for
 * nothing, a key and NULL where its value is missing. */
typedef struct brink_key {
    const char *name;
    const brink_node *key, *value;
} brink_key;

/** Fills in the `count` keys from a map.  Complains of keys unknown, repeated or
 * without a value.  The number of complaints. */
int brink_value_keys(brink_source *s, const brink_node *map, const char *what,
                     brink_key *keys, int count);

/** The one of `count` keys that the map has, where it must have just one of them;
 * -1 after a complaint. */
int brink_value_choose(brink_source *s, const brink_node *map, const char *what,
                       const brink_key *keys, int count);

/** The name nearest to a misspelt one, or NULL where none is near. */
const char *brink_value_meant(const char *name, const char *const *names,
                              int count);

/** A node's text for a message: printable, one line, at most 40 characters. */
typedef struct brink_shown {
    char text[4 * 40 + 4]; // characters of up to 4 bytes, "..."
} brink_shown;
brink_shown brink_value_shown(const brink_node *node);
#endif
