// SPDX-License-Identifier: MIT
#include "session_looks.h"
#include "checkpoint.h"
#include "observe.h"
#include "session_files.h"
#include "session_page.h"
#include "trajectory.h"
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

// Offset of now, counted in the year that the particles' own times count in.
static double offset_now(const brink_run *run)
{
    const brink_instant new_year = {run->system.epoch, 0.0};
    return brink_instant_since(run->system.year, run->now, new_year);
}

static int write_frame(const brink_session *s, FILE *out)
{
    return brink_trajectory_write(out, &s->run.system, offset_now(&s->run),
                                  brink_run_time(&s->run));
}

static brink_instant frame_instant(const brink_session *s)
{
    if (!s->trajectory)
        return BRINK_NEVER;
    return brink_instant_at(s->run.system.year,
                            (double)s->plan.frames * s->scene.trajectory_every);
}

static int write_due_frame(brink_session *s)
{
    if (brink_instant_compare(s->run.now, frame_instant(s)) < 0)
        return 0;
    if (write_frame(s, s->trajectory) || fflush(s->trajectory))
        return brink_files_complain(s->dir, "trajectory.xyz");
    s->plan.frames++;
    s->plan.frame_end = (uint64_t)ftello(s->trajectory);
    return 0;
}

int brink_looks_open_trajectory(brink_session *s)
{
    struct stat about;
    if (s->scene.trajectory_every == 0)
        return 0;
    s->trajectory = brink_files_open(s->dir, "trajectory.xyz", "a");
    if (!s->trajectory)
        return -1;
    const int fd = fileno(s->trajectory);
    if (fstat(fd, &about) == 0 && (uint64_t)about.st_size < s->plan.frame_end) {
        fprintf(stderr,
                "%s/trajectory.xyz: it is shorter than when the checkpoint was "
                "written\n  put the whole file back, then `brink resume %s`\n",
                s->dir, s->dir);
        return -1;
    }
    if (ftruncate(fd, (off_t)s->plan.frame_end) ||
        fseeko(s->trajectory, 0, SEEK_END))
        return brink_files_complain(s->dir, "trajectory.xyz");
    return 0;
}

static int observes(const brink_session *s)
{
    return s->record.wish.every > 0;
}

int brink_looks_begin(brink_session *s)
{
    if (!(s->scene.wish.every > 0) ||
        brink_record_create(&s->record, &s->scene.wish, &s->run) == 0)
        return 0;
    fputs("memory is out\n", stderr);
    return -1;
}

static void take_due_sample(brink_session *s)
{
    const brink_instant due = brink_record_due(&s->record, &s->run);
    if (brink_instant_compare(s->run.now, due) >= 0)
        brink_record_sample(&s->record, &s->run);
}

int brink_looks_resume(brink_session *s, const char *path)
{
    if (brink_looks_begin(s))
        return -1;
    const char *fault =
        observes(s)
            ? brink_record_unpack(&s->record, s->plan.record, s->plan.record_size)
            : NULL;
    if (fault)
        fprintf(stderr, "%s: its observations are refused: %s\n", path, fault);
    return fault ? -1 : 0;
}

brink_instant brink_looks_next(const brink_session *s)
{
    const brink_instant looks[] = {
        brink_instant_at(s->run.system.year, s->plan.until), frame_instant(s),
        brink_record_due(&s->record, &s->run)};
    brink_instant first = looks[0];
    for (int k = 1; k < 3; k++)
        if (brink_instant_compare(looks[k], first) < 0)
            first = looks[k];
    return first;
}

int brink_looks_take(brink_session *s)
{
    take_due_sample(s);
    return write_due_frame(s);
}

static int pack_record(brink_session *s)
{
    free(s->plan.record);
    s->plan.record = NULL;
    if (!observes(s) ||
        brink_record_pack(&s->record, &s->plan.record, &s->plan.record_size) == 0)
        return 0;
    fprintf(stderr, "%s: memory is out: no checkpoint\n", s->dir);
    return -1;
}

// The frames first: a checkpoint must not know of any that a power cut can take.
int brink_looks_save(brink_session *s)
{
    if (pack_record(s))
        return -1;
    if (s->trajectory && fsync(fileno(s->trajectory)))
        return brink_files_complain(s->dir, "trajectory.xyz");
    return brink_checkpoint_save(s->dir, &s->run, &s->plan, stderr);
}

int brink_looks_results(const brink_session *s, const char *stopped)
{
    FILE *out = brink_files_begin(s->dir, "summary.json");
    if (!out)
        return -1;
    int failed = brink_observe_summary(out, &s->run, &s->plan, s->scene.title,
                                       stopped, observes(s) ? &s->record : NULL);
    if (brink_files_end(out, s->dir, "summary.json", failed))
        return -1;
    out = brink_files_begin(s->dir, "final.xyz");
    if (!out)
        return -1;
    failed = write_frame(s, out);
    if (brink_files_end(out, s->dir, "final.xyz", failed))
        return -1;
    return observes(s)
               ? brink_page_write(s->dir, s->scene.title, &s->record, &s->run)
               : 0;
}
