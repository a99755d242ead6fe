// SPDX-License-Identifier: MIT
#include "study_progress.h"
#include "checkpoint.h"
#include "codec.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// FNV-1a: http://www.isthe.com/chongo/tech/comp/fnv
#define FNV_BEGIN UINT64_C(0xcbf29ce484222325)
#define FNV_PRIME UINT64_C(0x100000001b3)

static uint64_t mix(uint64_t hash, const void *bytes, size_t count)
{
    const unsigned char *b = bytes;
    for (size_t k = 0; k < count; k++)
        hash = (hash ^ b[k]) * FNV_PRIME;
    return hash;
}

// The version does not change with every change of the program; its file does.
static uint64_t mix_program(uint64_t hash)
{
    static const char about[] = BRINK_VERSION "\n" BRINK_COMPILER;
    struct stat file;
    hash = mix(hash, about, sizeof about);
    if (stat("/proc/self/exe", &file) != 0)
        return hash; // not everywhere is there such a thing
    const int64_t made[] = {file.st_mtim.tv_sec, file.st_mtim.tv_nsec,
                            file.st_size};
    return mix(hash, made, sizeof made);
}

uint64_t brink_progress_key(const brink_scene *scene, const brink_system *start,
                            enum brink_method method)
{
    const char *name = brink_method_rule(method)->name;
    uint64_t hash = mix_program(FNV_BEGIN);
    hash = mix(hash, scene->text, scene->text_size);
    hash = mix(hash, name, strlen(name));
    return mix(hash, start->particle, start->count * sizeof *start->particle);
}

static void code_figures(brink_codec *c, brink_progress *p)
{
    uint64_t key = p->key;
    brink_code_u64(c, &key);
    if (!c->fault && key != p->key) {
        c->fault = "the scene or the program has changed";
        return;
    }
    brink_code_bytes(c, &p->attempt.trial, sizeof p->attempt.trial);
    brink_code_int(c, &p->nudges);
    brink_code_bytes(c, p->nudge_off, sizeof p->nudge_off);
}

// What there is beside the run: of the doubter what it remembers, of a house its
// calendar and what it has seen.
static void code_tables(brink_codec *c, brink_attempt *a, uint32_t count)
{
    brink_conventional *house = &a->conventional;
    if (a->trial.method == BRINK_METHOD_LOGICAL) {
        brink_code_bytes(c, a->doubter.memory, count * sizeof *a->doubter.memory);
        return;
    }
    brink_calendar *calendar = &house->house.calendar;
    brink_code_u32(c, &house->still);
    brink_code_bytes(c, house->seen, count * sizeof *house->seen);
    for (uint32_t slot = 0; slot < 2 * count; slot++) {
        brink_entry entry = calendar->entry[slot];
        brink_code_bytes(c, &entry, sizeof entry);
        if (c->reading && !c->fault)
            brink_calendar_set(calendar, slot, &entry);
    }
}

// The doubter's figures are the trial's at samples alone; here they are in
// between.
static void code_attempt(brink_codec *c, brink_progress *p, uint32_t count)
{
    brink_doubter *d = &p->attempt.doubter;
    code_figures(c, p);
    brink_code_bytes(c, &d->seen, sizeof d->seen);
    if (c->fault == NULL)
        code_tables(c, &p->attempt, count);
    brink_codec_seal(c);
}

static int pack(const brink_progress *p, uint32_t count, brink_plan *plan)
{
    size_t size = 0;
    FILE *out = open_memstream(&plan->record, &size);
    if (out == NULL)
        return -1;
    brink_codec c;
    brink_progress shown = *p; // a codec does not change what it writes
    brink_codec_write_to(&c, out);
    code_attempt(&c, &shown, count);
    const int failed = fclose(out) != 0 || c.fault != NULL;
    plan->record_size = size;
    return failed ? -1 : 0;
}

// A house's calendar is none of a run's: an empty one stands in for it.
static int save_run(const brink_attempt *a, const char *folder,
                    const brink_plan *plan, FILE *errors)
{
    brink_run shown = *brink_attempt_run(a);
    if (a->trial.method == BRINK_METHOD_LOGICAL)
        return brink_checkpoint_save(folder, &shown, plan, errors);
    if (brink_calendar_create(&shown.calendar, shown.system.count,
                              shown.system.year, 1))
        return -1;
    const int status = brink_checkpoint_save(folder, &shown, plan, errors);
    brink_calendar_destroy(&shown.calendar);
    return status;
}

int brink_progress_save(const brink_progress *p, const char *folder, FILE *errors)
{
    brink_plan plan = {.events = p->attempt.events};
    if (mkdir(folder, 0777) != 0 && errno != EEXIST) {
        fprintf(errors, "%s: the folder cannot be made: %s\n", folder,
                strerror(errno));
        return -1;
    }
    int status = pack(p, p->attempt.trial.particles, &plan);
    if (status != 0)
        fputs("memory is out: no checkpoint\n", errors);
    else
        status = save_run(&p->attempt, folder, &plan, errors);
    brink_plan_destroy(&plan);
    return status;
}

// Puts the run that was read into the attempt, with tables to be filled.
static int take_run(brink_attempt *a, brink_run *run)
{
    if (a->trial.method != BRINK_METHOD_LOGICAL)
        return brink_conventional_assemble(&a->conventional, run,
                                           brink_method_rule(a->trial.method));
    a->run = *run;
    memset(run, 0, sizeof *run);
    return brink_doubter_create(&a->doubter, &a->run);
}

static const char *unpack(brink_progress *p, brink_run *run,
                          const brink_plan *plan)
{
    const uint32_t count = run->system.count;
    FILE *in = plan->record_size > 0
                   ? fmemopen(plan->record, plan->record_size, "r")
                   : NULL;
    if (in == NULL)
        return "it is not of a study";
    brink_codec c;
    brink_codec_read_from(&c, in);
    if (take_run(&p->attempt, run))
        c.fault = "memory is out";
    code_attempt(&c, p, count);
    brink_codec_close(&c);
    fclose(in);
    return c.fault;
}

int brink_progress_resume(brink_progress *p, const char *folder, FILE *errors)
{
    char path[4300];
    brink_run run;
    brink_plan plan;
    if (brink_checkpoint_resume(folder, &run, &plan, path, sizeof path, errors))
        return -1;
    brink_progress read = {.key = p->key,
                           .attempt = {.events = p->attempt.events}};
    read.attempt.trial.method = p->attempt.trial.method;
    const char *fault = unpack(&read, &run, &plan);
    brink_run_destroy(&run);
    brink_plan_destroy(&plan);
    if (fault != NULL) {
        fprintf(errors, "%s: %s\n", path, fault);
        brink_attempt_destroy(&read.attempt);
        return -1;
    }
    *p = read;
    return 0;
}

int brink_progress_store(const brink_progress *p, const char *file, FILE *errors)
{
    char fresh[4300];
    brink_codec c;
    brink_progress shown = *p;
    snprintf(fresh, sizeof fresh, "%s.new", file);
    FILE *out = fopen(fresh, "wb");
    int failed = out == NULL;
    if (out != NULL) {
        brink_codec_write_to(&c, out);
        code_figures(&c, &shown);
        brink_codec_seal(&c);
        failed = c.fault != NULL || fsync(fileno(out)) != 0;
        failed |= fclose(out) != 0;
        failed = failed || rename(fresh, file) != 0;
    }
    if (failed)
        fprintf(errors, "%s: it cannot be written: %s\n", file, strerror(errno));
    return failed ? -1 : 0;
}

const char *brink_progress_load(brink_progress *p, const char *file)
{
    FILE *in = fopen(file, "rb");
    if (in == NULL)
        return strerror(errno);
    brink_codec c;
    brink_progress read = {.key = p->key};
    brink_codec_read_from(&c, in);
    code_figures(&c, &read);
    brink_codec_seal(&c);
    brink_codec_close(&c);
    fclose(in);
    if (c.fault != NULL)
        return c.fault;
    p->attempt.trial = read.attempt.trial;
    p->nudges = read.nudges;
    memcpy(p->nudge_off, read.nudge_off, sizeof p->nudge_off);
    return NULL;
}
