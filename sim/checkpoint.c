// SPDX-License-Identifier: MIT
#include "checkpoint.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define PREFIX "checkpoint-"
#define SUFFIX ".brink"
#define NAME   64 // enough for PREFIX, 20 digits and SUFFIX

static void name_of(char name[NAME], uint64_t events)
{
    snprintf(name, NAME, PREFIX "%020" PRIu64 SUFFIX, events);
}

static int is_checkpoint(const char *name)
{
    const size_t length = strlen(PREFIX) + 20 + strlen(SUFFIX);
    return strlen(name) == length && strncmp(name, PREFIX, strlen(PREFIX)) == 0 &&
           strspn(name + strlen(PREFIX), "0123456789") == 20 &&
           strcmp(name + length - strlen(SUFFIX), SUFFIX) == 0;
}

static int newest_first(const void *a, const void *b)
{
    return strcmp(b, a); // zero-padded numbers: the order of text is theirs
}

// The names of DIR's checkpoints, newest first; their number, -1 if DIR cannot be
// read.
static int list(const char *dir, char (**names)[NAME])
{
    *names = NULL;
    DIR *d = opendir(dir);
    if (!d)
        return -1;
    int count = 0;
    for (struct dirent *e; (e = readdir(d));) {
        if (!is_checkpoint(e->d_name))
            continue;
        char(*more)[NAME] = realloc(*names, (size_t)(count + 1) * sizeof *more);
        if (!more)
            break;
        *names = more;
        strcpy((*names)[count++], e->d_name);
    }
    closedir(d);
    if (count > 1)
        qsort(*names, (size_t)count, sizeof **names, newest_first);
    return count;
}

int brink_checkpoint_count(const char *dir)
{
    char(*names)[NAME];
    const int count = list(dir, &names);
    free(names);
    return count < 0 ? 0 : count;
}

static char *join(const char *dir, const char *name)
{
    const size_t size = strlen(dir) + strlen(name) + 2;
    char *path = malloc(size);
    if (path)
        snprintf(path, size, "%s/%s", dir, name);
    return path;
}

static void remove_from(const char *dir, char (*names)[NAME], int first,
                        int count)
{
    for (int k = first; k < count; k++) {
        char *path = join(dir, names[k]);
        if (path)
            unlink(path);
        free(path);
    }
}

void brink_checkpoint_clear(const char *dir)
{
    char(*names)[NAME];
    const int count = list(dir, &names);
    remove_from(dir, names, 0, count);
    free(names);
    rmdir(dir);
}

// Those older than the one before `newest`.  What is newer than that has been
// passed over: it is nothing to go on from, and makes no whole one superfluous.
static void remove_old(const char *dir, const char *newest)
{
    char(*names)[NAME];
    const int count = list(dir, &names);
    int k = 0;
    while (k < count && strcmp(names[k], newest) > 0)
        k++;
    remove_from(dir, names, k + 2, count);
    free(names);
}

static void sync_folder(const char *dir)
{
    const int fd = open(dir, O_RDONLY);
    if (fd >= 0) {
        fsync(fd); // some file systems cannot; the file itself is synced
        close(fd);
    }
}

const char *brink_checkpoint_remedy(int error)
{
    switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
        return "make room there";
    case EACCES:
    case EPERM:
    case EROFS:
        return "make the folder writable";
    case ENOENT:
    case ENOTDIR:
        return "the folder is gone: put it back";
    default:
        return "put this right";
    }
}

int brink_checkpoint_save(const char *dir, const brink_run *run,
                          const brink_plan *plan, FILE *errors)
{
    char name[NAME];
    name_of(name, brink_tally_events(&run->tally));
    char *path = join(dir, name), *fresh = join(dir, "checkpoint.new");
    int status = -1;
    FILE *file = path && fresh ? fopen(fresh, "wb") : NULL;
    if (file) {
        status =
            brink_snapshot_write(file, run, plan) || fsync(fileno(file)) ? -1 : 0;
        const int error = errno; // of the first thing that failed
        if (fclose(file) == 0 || status)
            errno = error;
        else
            status = -1;
    }
    if (status == 0)
        status = rename(fresh, path);
    if (status == 0) {
        sync_folder(dir);
        remove_old(dir, name);
    } else {
        const int error = errno;
        fprintf(errors,
                "%s: the checkpoint could not be written: %s\n"
                "  earlier ones are untouched: %s and go on from there, or use "
                "another --out\n",
                dir, strerror(error), brink_checkpoint_remedy(error));
        if (file)
            unlink(fresh);
    }
    free(path);
    free(fresh);
    return status;
}

int brink_checkpoint_load(const char *path, brink_run *run, brink_plan *plan,
                          FILE *errors)
{
    FILE *file = fopen(path, "rb");
    const char *fault =
        file ? brink_snapshot_read(file, run, plan) : strerror(errno);
    if (file)
        fclose(file);
    if (fault)
        fprintf(errors, "%s: this checkpoint is refused: %s\n", path, fault);
    return fault ? -1 : 0;
}

// One whose name says another number of events would be taken for newer than it
// is.
static int load_as_named(const char *path, const char *name, brink_run *run,
                         brink_plan *plan, FILE *errors)
{
    char right[NAME];
    if (brink_checkpoint_load(path, run, plan, errors))
        return -1;
    name_of(right, brink_tally_events(&run->tally));
    if (strcmp(name, right) == 0)
        return 0;
    fprintf(errors, "%s: this checkpoint is refused: its name should be %s\n",
            path, right);
    brink_run_destroy(run);
    brink_plan_destroy(plan);
    return -1;
}

// The newest whole one of those from `first` on, which are newest first.
static int load_newest(const char *dir, char (*names)[NAME], int first, int count,
                       brink_run *run, brink_plan *plan, char *path,
                       size_t path_size, FILE *errors)
{
    int status = -1;
    for (int k = first; k < count && status; k++) {
        snprintf(path, path_size, "%s/%s", dir, names[k]);
        status = load_as_named(path, names[k], run, plan, errors);
    }
    return status;
}

int brink_checkpoint_before(const char *dir, uint64_t event, brink_run *run,
                            brink_plan *plan, char *path, size_t path_size,
                            FILE *errors)
{
    char(*names)[NAME], here[NAME];
    const int count = list(dir, &names);
    int first = 0;
    name_of(here, event);
    while (first < count && strcmp(names[first], here) >= 0)
        first++;
    const int status =
        load_newest(dir, names, first, count, run, plan, path, path_size, errors);
    free(names);
    return status;
}

int brink_checkpoint_resume(const char *dir, brink_run *run, brink_plan *plan,
                            char *path, size_t path_size, FILE *errors)
{
    char(*names)[NAME];
    const int count = list(dir, &names);
    const int status =
        load_newest(dir, names, 0, count, run, plan, path, path_size, errors);
    free(names);
    if (status)
        fprintf(errors,
                count < 0 ? "%s: it cannot be read: %s\n"
                : count > 0
                    ? "%s: none of its checkpoints is whole\n"
                    : "%s: it holds no checkpoint: start one with `brink run`\n",
                dir, strerror(errno));
    return status;
}
