// SPDX-License-Identifier: MIT
#include "scene_value.h"
#include "scene_number.h"
#include <math.h>
#include <string.h>

#define SHOWN 40 // characters of a text that a message quotes

brink_shown brink_value_shown(const brink_node *node)
{
    brink_shown shown = {""};
    const char *from = node->text;
    size_t left = strlen(from), used = 0;
    for (int c = 0; left > 0 && c < SHOWN; c++) {
        const size_t n = brink_character(from, left);
        memcpy(shown.text + used, n ? from : "?", n ? n : 1);
        used += n ? n : 1;
        from += n ? n : 1;
        left -= n ? n : 1;
    }
    if (left > 0)
        memcpy(shown.text + used, "...", 3); // what follows is 0 already
    return shown;
}

static const char *kind_of(const brink_node *node)
{
    if (node->kind == BRINK_NODE_LIST)
        return "a list";
    if (node->kind == BRINK_NODE_MAP)
        return "a map";
    return node->plain ? "a bare word" : "a text in quotes";
}

static int is_scalar(brink_source *s, const brink_node *node, const char *what,
                     const char *wanted)
{
    if (node->kind == BRINK_NODE_LIST || node->kind == BRINK_NODE_MAP)
        brink_complain(s, node->at, "%s is %s where %s is wanted\nwrite %s alone",
                       what, kind_of(node), wanted, wanted);
    return node->kind == BRINK_NODE_SCALAR;
}

static int contains_word(const char *text, const char *const *words, size_t count)
{
    for (size_t k = 0; k < count; k++)
        if (strcmp(text, words[k]) == 0)
            return 1;
    return 0;
}
#define IS_ONE_OF(text, words)                                                   \
    contains_word(text, words, sizeof(words) / sizeof *(words))

static const char *number_advice(const brink_node *node)
{
    static const char *const truths[] = {"true", "false", "yes",  "no",
                                         "on",   "off",   "True", "False"};
    static const char *const beyond[] = {
        ".inf", "-.inf", "+.inf", ".Inf", ".INF", "inf", "-inf",
        "+inf", ".nan",  ".NaN",  ".NAN", "nan",  "NaN", "infinity"};
    const char *t = node->text + (*node->text == '+' || *node->text == '-');
    if (!node->plain)
        return "take off the quotes: in quotes it is a text";
    if (IS_ONE_OF(node->text, truths))
        return "a truth value is not a number";
    if (IS_ONE_OF(node->text, beyond))
        return "write a finite number; .inf stands only for the energy of a hard "
               "core";
    if (strchr(t, ','))
        return "the decimal sign is a point, and thousands have no sign";
    if (strchr(t, '_'))
        return "write the digits without underscores";
    if (t[0] == '0' && t[1] != '\0' && t[1] != '.')
        return "write it in decimal, without leading zeros";
    return "write a number, such as 12, 1.5 or 1.0e-3, without a unit";
}

int brink_value_number(brink_source *s, const brink_node *node, const char *what,
                       double *value)
{
    double v = 0;
    if (!is_scalar(s, node, what, "a number"))
        return 0;
    const int read = node->plain ? brink_number_read(node->text, &v) : 0;
    if (read == 0)
        brink_complain(s, node->at, "%s is '%s', which is not a number\n%s", what,
                       brink_value_shown(node).text, number_advice(node));
    else if (read < 0 || (v != 0 && !(fabs(v) >= BRINK_VALUE_LEAST &&
                                      fabs(v) <= BRINK_VALUE_MOST)))
        brink_complain(
            s, node->at,
            "%s is %s, beyond the magnitudes of %g to %g that are reckoned "
            "with\nchoose units in which it is nearer to 1",
            what, brink_value_shown(node).text, BRINK_VALUE_LEAST,
            BRINK_VALUE_MOST);
    else {
        *value = v;
        return 1;
    }
    return 0;
}

int brink_value_positive(brink_source *s, const brink_node *node,
                         const char *what, double *value)
{
    double v = 0;
    if (!brink_value_number(s, node, what, &v))
        return 0;
    if (v > 0) {
        *value = v;
        return 1;
    }
    brink_complain(s, node->at, "%s is %s\nit must be more than 0", what,
                   brink_value_shown(node).text);
    return 0;
}

// Text that is no string of digits, where one is wanted.
static void complain_of_count(brink_source *s, const brink_node *node,
                              const char *what)
{
    const brink_shown shown = brink_value_shown(node);
    double v = 0;
    if (!node->plain || brink_number_read(node->text, &v) <= 0)
        brink_complain(s, node->at, "%s is '%s', which is not a whole number\n%s",
                       what, shown.text, number_advice(node));
    else if (v < 0)
        brink_complain(s, node->at, "%s is %s\nit cannot be negative", what,
                       shown.text);
    else if (v == floor(v) && v < 0x1p63)
        brink_complain(
            s, node->at,
            "%s is %s, and whole numbers are written in digits\nwrite %.0f", what,
            shown.text, v);
    else
        brink_complain(s, node->at, "%s is %s\nit must be a whole number", what,
                       shown.text);
}

int brink_value_count(brink_source *s, const brink_node *node, const char *what,
                      uint64_t least, uint64_t most, uint64_t *value)
{
    uint64_t n = 0;
    if (!is_scalar(s, node, what, "a whole number"))
        return 0;
    const int read = node->plain ? brink_integer_read(node->text, &n) : 0;
    if (read == 0)
        complain_of_count(s, node, what);
    else if (read < 0 || n > most)
        brink_complain(s, node->at, "%s is %s\nit can be at most %llu", what,
                       brink_value_shown(node).text, (unsigned long long)most);
    else if (n < least)
        brink_complain(s, node->at, "%s is %s\nit must be at least %llu", what,
                       brink_value_shown(node).text, (unsigned long long)least);
    else {
        *value = n;
        return 1;
    }
    return 0;
}

int brink_value_true(brink_source *s, const brink_node *node, const char *what,
                     const char *why_not_false)
{
    if (!is_scalar(s, node, what, "true or false"))
        return 0;
    if (node->plain && strcmp(node->text, "true") == 0)
        return 1;
    if (node->plain && strcmp(node->text, "false") == 0)
        brink_complain(s, node->at, "%s is false\n%s", what, why_not_false);
    else
        brink_complain(s, node->at,
                       "%s is '%s', which is not a truth value\nwrite true", what,
                       brink_value_shown(node).text);
    return 0;
}

int brink_value_text(brink_source *s, const brink_node *node, const char *what,
                     size_t most, const char **value)
{
    if (!is_scalar(s, node, what, "a line of text"))
        return 0;
    const size_t length = strlen(node->text);
    size_t good = 0, n = 0;
    while ((n = brink_character(node->text + good, length - good)) > 0)
        good += n;
    if (good < length)
        brink_complain(s, node->at,
                       "%s has a line break or control character in it\n"
                       "write one line of plain text",
                       what);
    else if (length > most)
        brink_complain(s, node->at,
                       "%s is %zu bytes long\nit can have at most %zu", what,
                       length, most);
    else {
        *value = node->text;
        return 1;
    }
    return 0;
}

int brink_value_list(brink_source *s, const brink_node *node, const char *what,
                     int count, const char *example)
{
    if (node->kind == BRINK_NODE_LIST && node->count == count)
        return 1;
    if (node->kind == BRINK_NODE_LIST)
        brink_complain(s, node->at, "%s has %d %s where %d are wanted\nwrite %s",
                       what, node->count, node->count == 1 ? "item" : "items",
                       count, example);
    else if (node->kind != BRINK_NODE_REFUSED)
        brink_complain(s, node->at,
                       "%s is %s where a list of %d is wanted\nwrite %s", what,
                       kind_of(node), count, example);
    return 0;
}

int brink_value_map(brink_source *s, const brink_node *node, const char *what,
                    const char *example)
{
    if (node->kind != BRINK_NODE_MAP && node->kind != BRINK_NODE_REFUSED)
        brink_complain(s, node->at,
                       "%s is %s where keys with values are wanted\nwrite %s",
                       what, kind_of(node), example);
    return node->kind == BRINK_NODE_MAP;
}

// Letters to change, add or take away to get from a to b [Levenshtein].  Names
// are shorter than NAME; longer ones are as far as can be.
#define NAME 32
static int letters_apart(const char *a, const char *b)
{
    const size_t n = strlen(a), m = strlen(b);
    int row[NAME + 1];
    if (n > NAME || m > NAME)
        return NAME;
    for (size_t j = 0; j <= m; j++)
        row[j] = (int)j;
    for (size_t i = 1; i <= n; i++) {
        int diagonal = row[0];
        row[0] = (int)i;
        for (size_t j = 1; j <= m; j++) {
            const int change = diagonal + (a[i - 1] != b[j - 1]);
            const int gap = 1 + (row[j] < row[j - 1] ? row[j] : row[j - 1]);
            diagonal = row[j];
            row[j] = change < gap ? change : gap;
        }
    }
    return row[m];
}

const char *brink_value_meant(const char *name, const char *const *names,
                              int count)
{
    const char *best = NULL;
    int least = NAME;
    for (int k = 0; k < count; k++) {
        const int apart = letters_apart(name, names[k]);
        const int shared = (int)strlen(names[k]) - apart;
        if (apart < least && apart <= 3 && shared > apart) {
            least = apart;
            best = names[k];
        }
    }
    return best;
}

static void complain_of_key(brink_source *s, const brink_node *key,
                            const char *what, const brink_key *keys, int count)
{
    const char *names[16] = {NULL}; // no map of a scene has more keys
    char list[256] = "";
    for (int k = 0, used = 0; k < count; k++) {
        names[k] = keys[k].name;
        used += snprintf(list + used, sizeof list - (size_t)used, "%s%s",
                         k ? ", " : "", keys[k].name);
    }
    const char *meant = brink_value_meant(key->text, names, count);
    if (meant)
        brink_complain(s, key->at, "%s has no key '%s'\ndid you mean '%s'?", what,
                       brink_value_shown(key).text, meant);
    else
        brink_complain(s, key->at, "%s has no key '%s'\nits keys are: %s", what,
                       brink_value_shown(key).text, list);
}

int brink_value_keys(brink_source *s, const brink_node *map, const char *what,
                     brink_key *keys, int count)
{
    const int before = s->complaints;
    for (const brink_node *key = map->first; key; key = key->next->next) {
        const brink_node *value = key->next;
        brink_key *found = NULL;
        if (!is_scalar(s, key, "a key", "a name"))
            continue;
        for (int k = 0; k < count && !found; k++)
            if (strcmp(key->text, keys[k].name) == 0)
                found = &keys[k];
        if (!found)
            complain_of_key(s, key, what, keys, count);
        else if (found->key)
            brink_complain(s, key->at,
                           "'%s' is given again: it stands in line %d already\n"
                           "keep one of the two",
                           found->name, found->key->at.line);
        else {
            found->key = key;
            if (value->kind == BRINK_NODE_SCALAR && value->plain && !*value->text)
                brink_complain(s, key->at,
                               "'%s' has no value\n"
                               "give one after the colon, or leave it out",
                               found->name);
            else
                found->value = value;
        }
    }
    return s->complaints - before;
}

int brink_value_choose(brink_source *s, const brink_node *map, const char *what,
                       const brink_key *keys, int count)
{
    int chosen = -1;
    for (int k = 0; k < count; k++) {
        if (!keys[k].key)
            continue;
        if (chosen >= 0) {
            brink_complain(s, keys[k].key->at,
                           "%s has both '%s' and '%s'\nkeep one of them", what,
                           keys[chosen].name, keys[k].name);
            return -1;
        }
        chosen = k;
    }
    if (chosen < 0)
        brink_complain(s, map->at,
                       "%s has none of the keys it needs one of\n"
                       "give '%s', for one",
                       what, keys[0].name);
    return chosen;
}
