// SPDX-License-Identifier: MIT
#ifndef BRINK_SCENE_TREE_H
#define BRINK_SCENE_TREE_H
/**
 * The part of YAML that scenes are written in: maps, lists and scalars, each with
 * the place where it stands.  Anchors, aliases, tags and further documents are
 * refused: what a scene says is written in it once and in full.
 */
#include "scene_source.h"

#define BRINK_TREE_DEPTH 8 // maps and lists in each other: a scene needs five

enum brink_node_kind {
    BRINK_NODE_SCALAR,
    BRINK_NODE_LIST,
    BRINK_NODE_MAP,
    BRINK_NODE_REFUSED // complained about already
};

typedef struct brink_node {
    enum brink_node_kind kind;
    int plain;     // a scalar without quotes: may be a number
    brink_mark at; // where it begins
    int count;     // of a list's items
    struct brink_node
        *first; // a list's items; a map's key, value, key, value ...
    struct brink_node *next;
    char text[]; // a scalar's, NUL-terminated and with no NUL within
} brink_node;

/** The tree of a text that brink_source_is_text; NULL, with a complaint, where
 * there is none.  The tree is the caller's: brink_tree_destroy. */
brink_node *brink_tree_read(brink_source *source);
void brink_tree_destroy(brink_node *node);
#endif
