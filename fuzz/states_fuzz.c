// SPDX-License-Identifier: MIT
// Logs of events against a square table of levels, and a state machine written
// down once more.
#include "fuzz.h"
#include "states.h"
#include <string.h>

enum { MOST = 12, KINDS = 3, STEPS = 4, LOG = 250 };

typedef struct entry {
    uint32_t i, j;
    int event, status;
} entry;

typedef struct table {
    brink_system system;
    brink_states states;
    int level[MOST][MOST];
    int logged;
    entry log[LOG];
} table;

static void broken(const table *t, const char *law)
{
    FINDING("states: %s", law);
    for (int a = 0; a < t->system.species_count; a++)
        for (int b = a; b < t->system.species_count; b++) {
            const brink_potential *p =
                &t->system.potential[a * t->system.species_count + b];
            fprintf(stderr, "  // between %d and %d\n", a, b);
            finding_numbers("energy", p->count, p->energy);
        }
    fputs("  // i, j, event (-1 - level: set to it), status\n"
          "  const int log[][4] = {",
          stderr);
    for (int n = 0; n < t->logged; n++)
        fprintf(stderr, "{%u, %u, %d, %d}, ", t->log[n].i, t->log[n].j,
                t->log[n].event, t->log[n].status);
    fputs("};\n", stderr);
    finding_end();
}

static void make_potential(stream *s, brink_potential *p, double *distance,
                           double *energy)
{
    p->count = stream_int(s, 1, STEPS);
    p->distance = distance;
    p->energy = energy;
    for (int k = 0; k < p->count; k++) {
        distance[k] = STEPS + 1 - k;
        energy[k] = stream_int(s, -4, 4) / 4.0;
    }
    if (stream_int(s, 0, 1))
        energy[p->count - 1] = (double)INFINITY;
}

static void make(table *t, stream *s)
{
    static double distance[KINDS * KINDS][STEPS], energy[KINDS * KINDS][STEPS];
    const double box[3] = {64, 64, 64};
    brink_species species[KINDS] = {
        {"A", 1, 1, 0}, {"B", 1, 1, 0}, {"C", 1, 1, 0}};
    brink_potential potential[KINDS * KINDS];
    const int kinds = stream_int(s, 1, KINDS), n = stream_int(s, 2, MOST);
    for (int a = 0; a < kinds; a++)
        for (int b = a; b < kinds; b++) {
            const int k = a * kinds + b;
            make_potential(s, &potential[k], distance[k], energy[k]);
            potential[b * kinds + a] = potential[k];
        }
    memset(t, 0, sizeof *t);
    LAW(brink_system_create(&t->system, 3, box, 1, (uint32_t)n, kinds, species,
                            potential) == 0,
        "states: memory is out");
    for (int i = 0; i < n; i++)
        t->system.particle[i].species = (uint32_t)(i * kinds / n);
    LAW(brink_states_create(&t->states, &t->system) == 0,
        "states: memory is out");
}

/** [S16 fig. 1] as the header of steps says it: 1 and the new level, or 0. */
static int is_legal(const brink_potential *p, int level, int event, int *next)
{
    const int inward = level<p->count, outward = level> 0;
    const int core = inward && isinf(p->energy[level]);
    *next = level + (event == BRINK_CAPTURE) - (event == BRINK_RELEASE);
    switch (event) {
    case BRINK_CAPTURE:
        return inward && !core;
    case BRINK_RELEASE:
        return outward;
    case BRINK_BOUNCE:
        return outward || (inward && !core);
    case BRINK_CORE:
        return core;
    default:
        return 0;
    }
}

static void compare_lists(const table *t, uint32_t i)
{
    const brink_link *link = brink_states_links(&t->states, i);
    uint32_t captured = 0;
    for (uint32_t j = 0; j < t->system.count; j++)
        captured += t->level[i][j] > 0;
    if (brink_states_partners(&t->states, i) != captured)
        broken(t, "a particle has as many partners as it is captured by");
    for (uint32_t k = 0; k < captured; k++)
        if (t->level[i][link[k].partner] != link[k].level)
            broken(t, "a particle's links are those it has");
}

static void compare(const table *t)
{
    const brink_system *s = &t->system;
    double energy = 0; // of quarters: exact
    for (uint32_t i = 0; i < s->count; i++) {
        compare_lists(t, i);
        for (uint32_t j = 0; j < s->count; j++) {
            if (i != j && brink_states_level(&t->states, i, j) != t->level[i][j])
                broken(t, "a level is what the log says");
            const int level = t->level[i][j];
            if (i < j && level > 0)
                energy += brink_system_potential(s, i, j)->energy[level - 1];
        }
    }
    if (brink_states_energy(&t->states, s) != energy)
        broken(t, "the energy is that of the levels");
    if (brink_states_is_valid(&t->states, s))
        broken(t, brink_states_is_valid(&t->states, s));
}

static void step(table *t, stream *s)
{
    const int n = (int)t->system.count;
    const uint32_t i = (uint32_t)stream_int(s, 0, n - 1);
    const uint32_t j = (i + 1 + (uint32_t)stream_int(s, 0, n - 2)) % (uint32_t)n;
    const brink_potential *p = brink_system_potential(&t->system, i, j);
    int event = stream_int(s, -1, BRINK_BOUNCE + 1), next, status, legal = 1;
    if (event < 0) {
        next = stream_int(s, 0, brink_potential_levels(p) - 1);
        event = -1 - next;
        status = brink_states_set(&t->states, &t->system, i, j, next);
    } else {
        legal = is_legal(p, t->level[i][j], event, &next);
        status = brink_states_apply(&t->states, &t->system, i, j,
                                    (enum brink_event_kind)event);
    }
    t->log[t->logged++] = (entry){i, j, event, status};
    if (status != !legal)
        broken(t, "what is legal is applied, and all else refused");
    if (legal)
        t->level[i][j] = t->level[j][i] = next;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static table t;
    stream s = stream_of_bytes(data, size);
    make(&t, &s);
    for (int n = stream_int(&s, 0, LOG); n > 0; n--) {
        step(&t, &s);
        compare(&t);
    }
    brink_states_destroy(&t.states);
    brink_system_destroy(&t.system);
    return 0;
}
