// SPDX-License-Identifier: MIT
#include "scene_tree.h"
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

// Maps and lists that go on, outermost first, and where the next child of each
// goes.  The first is no node of the file: its only child is the file's root.
struct builder {
    brink_source *source;
    brink_node *open[BRINK_TREE_DEPTH + 1];
    brink_node **tail[BRINK_TREE_DEPTH + 1];
    int depth;
};

static brink_mark mark_of(yaml_mark_t m)
{
    return (brink_mark){(int)m.line + 1, (int)m.column + 1};
}

static void complain_of_memory(brink_source *source, brink_mark at)
{
    brink_complain(source, at,
                   "there is no memory left to read this\n"
                   "make the file smaller, or memory larger");
}

// Adds a node to what is open; NULL if memory is out.
static brink_node *add(struct builder *b, enum brink_node_kind kind,
                       yaml_mark_t mark, const char *text, size_t length)
{
    brink_node *node = calloc(1, sizeof *node + length + 1);
    if (!node) {
        complain_of_memory(b->source, mark_of(mark));
        return NULL;
    }
    node->kind = kind;
    node->at = mark_of(mark);
    memcpy(node->text, text, length);
    // NOLINTNEXTLINE(clang-analyzer-core.*): what is open has a tail
    *b->tail[b->depth] = node;
    b->tail[b->depth] = &node->next;
    b->open[b->depth]->count++;
    return node;
}

static int open_node(struct builder *b, enum brink_node_kind kind,
                     yaml_mark_t mark)
{
    if (b->depth == BRINK_TREE_DEPTH) {
        brink_complain(b->source, mark_of(mark),
                       "maps and lists are nested more than %d deep\n"
                       "a scene needs five; is a bracket not closed?",
                       BRINK_TREE_DEPTH);
        return 0;
    }
    brink_node *node = add(b, kind, mark, "", 0);
    if (!node)
        return 0;
    b->depth++;
    b->open[b->depth] = node;
    b->tail[b->depth] = &node->first;
    return 1;
}

static void refuse_marks(struct builder *b, const yaml_event_t *e,
                         const yaml_char_t *anchor, const yaml_char_t *tag)
{
    if (anchor)
        brink_complain(
            b->source, mark_of(e->start_mark),
            "scenes have no anchors\n"
            "take off the '&' and its name; put a text that begins with '&' "
            "in quotes");
    if (tag)
        brink_complain(
            b->source, mark_of(e->start_mark),
            "scenes have no tags\n"
            "take off the '!' and its name; put a text that begins with '!' "
            "in quotes");
}

static int take_scalar(struct builder *b, const yaml_event_t *e)
{
    const char *text = (const char *)e->data.scalar.value;
    const size_t length = e->data.scalar.length;
    const int has_nul = memchr(text, '\0', length) != NULL;
    refuse_marks(b, e, e->data.scalar.anchor, e->data.scalar.tag);
    if (has_nul)
        brink_complain(b->source, mark_of(e->start_mark),
                       "this text has a NUL character in it\ntake out the \\0");
    brink_node *node = add(b, has_nul ? BRINK_NODE_REFUSED : BRINK_NODE_SCALAR,
                           e->start_mark, text, length);
    if (node)
        node->plain = e->data.scalar.style == YAML_PLAIN_SCALAR_STYLE;
    return node != NULL;
}

// One event into the tree.  1 to go on, 0 at the end or where it cannot go on.
static int take(struct builder *b, const yaml_event_t *e)
{
    switch (e->type) {
    case YAML_DOCUMENT_START_EVENT:
        if (!b->open[0]->first)
            return 1;
        brink_complain(
            b->source, mark_of(e->start_mark),
            "a second document begins here\n"
            "a file is one scene: take off the '---' and what follows");
        return 0;
    case YAML_SCALAR_EVENT:
        return take_scalar(b, e);
    case YAML_ALIAS_EVENT:
        brink_complain(
            b->source, mark_of(e->start_mark),
            "scenes have no aliases\n"
            "write out what is meant; put a text that begins with '*' in "
            "quotes");
        return add(b, BRINK_NODE_REFUSED, e->start_mark, "", 0) != NULL;
    case YAML_SEQUENCE_START_EVENT:
        refuse_marks(b, e, e->data.sequence_start.anchor,
                     e->data.sequence_start.tag);
        return open_node(b, BRINK_NODE_LIST, e->start_mark);
    case YAML_MAPPING_START_EVENT:
        refuse_marks(b, e, e->data.mapping_start.anchor,
                     e->data.mapping_start.tag);
        return open_node(b, BRINK_NODE_MAP, e->start_mark);
    case YAML_SEQUENCE_END_EVENT:
    case YAML_MAPPING_END_EVENT:
        return b->depth-- > 0; // as it always is: libyaml's events nest
    case YAML_STREAM_END_EVENT:
        return 0;
    default:
        return 1;
    }
}

static void complain_of_syntax(brink_source *source, const yaml_parser_t *p)
{
    if (p->error == YAML_MEMORY_ERROR) {
        complain_of_memory(source, mark_of(p->mark));
        return;
    }
    const char *problem = p->problem ? p->problem : "unknown problem";
    if (strstr(problem, "cannot start any token"))
        brink_complain(
            source, mark_of(p->problem_mark),
            "this is not YAML: %s\n"
            "YAML is indented with spaces, never tabs; put a text that "
            "begins with '@' or '`' in quotes",
            problem);
    else
        brink_complain(
            source, mark_of(p->problem_mark),
            "this is not YAML: %s\n"
            "look from line %d on for a missing bracket, quote, colon or "
            "space",
            problem,
            mark_of(p->context ? p->context_mark : p->problem_mark).line);
}

brink_node *brink_tree_read(brink_source *source)
{
    brink_node file = {.first = NULL};
    struct builder b = {.source = source, .open = {&file}, .tail = {&file.first}};
    yaml_parser_t parser;
    if (!yaml_parser_initialize(&parser)) {
        complain_of_memory(source, (brink_mark){1, 1});
        return NULL;
    }
    yaml_parser_set_encoding(&parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&parser, (const unsigned char *)source->text,
                                 source->size);
    int whole = 0, more = 1;
    while (more) {
        yaml_event_t event;
        if (!yaml_parser_parse(&parser, &event)) {
            complain_of_syntax(source, &parser);
            break;
        }
        whole = event.type == YAML_STREAM_END_EVENT;
        more = take(&b, &event);
        yaml_event_delete(&event);
    }
    yaml_parser_delete(&parser);
    if (whole && !file.first)
        brink_complain(source, (brink_mark){1, 1},
                       "there is nothing in this file\n"
                       "write a scene: box, species and potentials at the least");
    if (!whole) {
        brink_tree_destroy(file.first);
        file.first = NULL;
    }
    return file.first;
}

void brink_tree_destroy(brink_node *node)
{
    while (node) { // deep only as trees are, BRINK_TREE_DEPTH
        brink_node *next = node->next;
        brink_tree_destroy(node->first);
        free(node);
        node = next;
    }
}
