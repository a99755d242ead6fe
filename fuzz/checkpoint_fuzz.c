// SPDX-License-Identifier: MIT
/*
 * Folders of checkpoints, of which some are cut short, changed, empty, some bear
 * another's number or no checkpoint's name, or are folders: the newest whole one
 * is taken, those that are newer are named, and no others; likewise before an
 * event.  What is saved there is what is taken next, and the one before it stays.
 */
#include "adverse.h"
#include "checkpoint.h"
#include "fuzz.h"
#include <inttypes.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { SAVED = 5, PLACES = SAVED + 1, APART = 3, NAME = 128 };

typedef struct bytes {
    char *byte;
    size_t size;
} bytes;

/** What there is by one checkpoint's name. */
typedef struct place {
    uint64_t number;
    int is_whole, is_folder;
    bytes whole; // what is in it, or was before it was damaged
} place;

/** A folder, by number from the oldest on. */
typedef struct model {
    place place[PLACES];
    int count;
} model;

static char dir[64];

static brink_plan plan = {
    .events = 9, .scene = (char[]){"a scene"}, .scene_size = 7};

static void path_of(char path[NAME], uint64_t number)
{
    snprintf(path, NAME, "%s/checkpoint-%020" PRIu64 ".brink", dir, number);
}

static _Noreturn void broken(const model *m, const char *law)
{
    FINDING("checkpoint: %s", law);
    for (int k = 0; k < m->count; k++)
        fprintf(stderr, "  %" PRIu64 ": %s\n", m->place[k].number,
                m->place[k].is_folder  ? "a folder"
                : m->place[k].is_whole ? "whole"
                                       : "damaged");
    finding_end();
}

// --- The folder ----------------------------------------------------------------

static void write_file(const char *path, const char *byte, size_t size)
{
    FILE *file = fopen(path, "wb");
    LAW(file != NULL, "checkpoint: %s cannot be written", path);
    fwrite(byte, 1, size, file);
    fclose(file);
}

static bytes bytes_of(const brink_run *run)
{
    bytes b = {0};
    FILE *file = open_memstream(&b.byte, &b.size);
    const char *fault = brink_snapshot_write(file, run, &plan);
    fclose(file);
    LAW(fault == NULL, "checkpoint: %s", fault);
    return b;
}

/** The place of a number; a new one, if there is none. */
static place *place_of(model *m, uint64_t number)
{
    int k = m->count;
    while (k > 0 && m->place[k - 1].number >= number)
        k--;
    if (k < m->count && m->place[k].number == number)
        return &m->place[k];
    memmove(&m->place[k + 1], &m->place[k],
            (size_t)(m->count++ - k) * sizeof *m->place);
    m->place[k] = (place){.number = number};
    return &m->place[k];
}

/** The newest whole one below `number`, or NULL. */
static const place *newest(const model *m, uint64_t number)
{
    for (int k = m->count - 1; k >= 0; k--)
        if (m->place[k].is_whole && m->place[k].number < number)
            return &m->place[k];
    return NULL;
}

static const char *const no_checkpoints[] = {
    "checkpoint-1.brink",
    "checkpoint-00000000000000000099.brink~",
    "checkpoint-0000000000000000009x.brink",
    "checkpoint.new",
    "Checkpoint-00000000000000000099.brink",
    "scene.yaml",
};
enum { NO_CHECKPOINTS = sizeof no_checkpoints / sizeof *no_checkpoints };

/** Puts the checkpoint of so many events there, or what has become of it. */
static void put(model *m, stream *s, uint64_t events, bytes whole)
{
    enum { CUT = 4, CHANGED, RENUMBERED, RENAMED, REPLACED, KINDS };
    char path[NAME];
    const int kind = stream_int(s, 0, KINDS - 1);
    size_t size = whole.size;
    if (kind == RENAMED) {
        const char *name = no_checkpoints[stream_int(s, 0, NO_CHECKPOINTS - 1)];
        snprintf(path, sizeof path, "%s/%s", dir, name);
        write_file(path, whole.byte, size);
        free(whole.byte);
        return;
    }
    if (kind == RENUMBERED)
        events += (uint64_t)stream_int(s, 1, 20) << stream_int(s, 0, 59);
    place *p = place_of(m, events);
    if (p->is_folder || p->whole.byte) { // by chance one that was renumbered
        free(whole.byte);
        return;
    }
    *p = (place){events, kind < CUT, kind == REPLACED, whole};
    path_of(path, events);
    if (kind == CUT)
        size = stream_word(s, 2) % size;
    if (kind == CHANGED)
        whole.byte[stream_word(s, 2) % size] ^= (char)(1 << stream_int(s, 0, 7));
    if (kind == REPLACED)
        mkdir(path, 0777);
    else
        write_file(path, whole.byte, size);
}

static void fill(model *m, stream *s, brink_run *run)
{
    const int count = stream_int(s, 0, SAVED);
    for (int n = 0; n < count; n++) {
        put(m, s, brink_tally_events(&run->tally), bytes_of(run));
        const brink_instant until =
            brink_instant_after(run->system.year, run->now, 4 * run->system.year);
        brink_run_advance(run,
                          brink_tally_events(&run->tally) +
                              (uint64_t)stream_int(s, 1, APART),
                          until);
    }
}

static void empty(model *m)
{
    char path[NAME];
    brink_checkpoint_clear(dir);
    for (int k = 0; k < m->count; k++) {
        path_of(path, m->place[k].number);
        if (access(path, F_OK) == 0 && !m->place[k].is_folder)
            broken(m, "what is cleared is gone");
        rmdir(path);
        free(m->place[k].whole.byte);
    }
    for (int k = 0; k < NO_CHECKPOINTS; k++) {
        snprintf(path, sizeof path, "%s/%s", dir, no_checkpoints[k]);
        unlink(path);
    }
    mkdir(dir, 0777);
}

// --- What is read --------------------------------------------------------------

/** Those from `right` to `below` are named as refused, and no others. */
static void check_named(const model *m, const char *said, const place *right,
                        uint64_t below)
{
    char path[NAME];
    for (int k = 0; k < m->count; k++) {
        const place *p = &m->place[k];
        const int is_passed =
            p->number < below && (!right || p->number > right->number);
        path_of(path, p->number);
        if ((strstr(said, path) != NULL) != is_passed) {
            fputs(said, stderr);
            broken(m, "those that are passed over are named, and no others");
        }
    }
}

/** What was read, by `status`: the newest whole one below a number. */
static void check_read(const model *m, int status, const brink_run *run,
                       const brink_plan *read, const char *path, uint64_t below)
{
    static const brink_run none;
    char wanted[NAME];
    const place *right = newest(m, below);
    if (status != (right ? 0 : -1))
        broken(m, "it is read where there is a whole one");
    if (!right) {
        if (run->system.particle || read->scene ||
            run->system.count != none.system.count)
            broken(m, "where nothing is read there is nothing");
        return;
    }
    path_of(wanted, right->number);
    if (strcmp(path, wanted) != 0)
        broken(m, "the newest whole one is read");
    const bytes b = bytes_of(run);
    if (b.size != right->whole.size ||
        memcmp(b.byte, right->whole.byte, b.size) != 0)
        broken(m, "what is read is what was written");
    free(b.byte);
}

/** The newest, or the newest before an event; 0 if there is one, in *run. */
static int read_newest(const model *m, uint64_t below, brink_run *run)
{
    char path[NAME], *said = NULL;
    size_t size = 0;
    brink_plan read = {0};
    FILE *errors = open_memstream(&said, &size);
    memset(run, 0, sizeof *run);
    const int status =
        below == UINT64_MAX
            ? brink_checkpoint_resume(dir, run, &read, path, sizeof path, errors)
            : brink_checkpoint_before(dir, below, run, &read, path, sizeof path,
                                      errors);
    fclose(errors);
    check_read(m, status, run, &read, path, below);
    check_named(m, said, newest(m, below), below);
    if (status == 0)
        brink_plan_destroy(&read);
    free(said);
    return status;
}

// --- What is saved -------------------------------------------------------------

/** Goes on, and saves: that is the newest whole one, and the one before stays. */
static void save(model *m, stream *s, brink_run *run)
{
    brink_run again;
    char path[NAME];
    brink_run_advance(
        run, brink_tally_events(&run->tally) + (uint64_t)stream_int(s, 0, APART),
        brink_instant_after(run->system.year, run->now, 4 * run->system.year));
    const uint64_t events = brink_tally_events(&run->tally);
    place *p = place_of(m, events);
    if (p->is_folder)
        return; // nothing can be renamed into its place
    if (brink_checkpoint_save(dir, run, &plan, stderr))
        broken(m, "it is saved");
    free(p->whole.byte);
    *p = (place){events, 1, 0, bytes_of(run)};
    if (p > m->place) {
        path_of(path, p[-1].number);
        if (access(path, F_OK) != 0)
            broken(m, "the one before it stays");
    }
    if (read_newest(m, UINT64_MAX, &again) == 0)
        brink_run_destroy(&again);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stream s = stream_of_bytes(data, size);
    model m = {.count = 0};
    brink_system system;
    brink_run run, read;
    if (!*dir) {
        strcpy(dir, access("/dev/shm", W_OK) ? "/tmp/fuzz-XXXXXX"
                                             : "/dev/shm/fuzz-XXXXXX");
        LAW(mkdtemp(dir) != NULL, "checkpoint: no folder");
    }
    const uint64_t event = (uint64_t)stream_int(&s, 0, SAVED * APART);
    adverse_make_few(&s, &system);
    LAW(brink_run_create(&run, &system, BRINK_TIER_FAST) == 0,
        "checkpoint: memory is out");
    fill(&m, &s, &run);
    if (brink_checkpoint_count(dir) != m.count)
        broken(&m, "checkpoints are counted");
    if (read_newest(&m, event, &read) == 0)
        brink_run_destroy(&read);
    if (read_newest(&m, UINT64_MAX, &read) == 0) {
        save(&m, &s, &read);
        brink_run_destroy(&read);
    }
    empty(&m);
    brink_run_destroy(&run);
    return 0;
}
