// SPDX-License-Identifier: MIT
#include "session_files.h"
#include "checkpoint.h"
#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define NAME_ROOM 64
#define PATH_ROOM 4200 // a session's folder is shorter than 4096 bytes

int brink_files_complain(const char *dir, const char *name)
{
    const int error = errno;
    fprintf(stderr,
            "%s/%s: it cannot be written: %s\n"
            "  %s, then `brink resume %s` goes on from the last checkpoint\n",
            dir, name, strerror(error), brink_checkpoint_remedy(error), dir);
    return -1;
}

FILE *brink_files_open(const char *dir, const char *name, const char *mode)
{
    char path[PATH_ROOM];
    snprintf(path, sizeof path, "%s/%s", dir, name);
    FILE *file = fopen(path, mode);
    if (!file)
        brink_files_complain(dir, name);
    return file;
}

static void part_of(char part[NAME_ROOM], const char *name)
{
    snprintf(part, NAME_ROOM, "%s.part", name);
}

FILE *brink_files_begin(const char *dir, const char *name)
{
    char part[NAME_ROOM];
    part_of(part, name);
    return brink_files_open(dir, part, "w");
}

int brink_files_end(FILE *file, const char *dir, const char *name, int failed)
{
    char part[NAME_ROOM], from[PATH_ROOM], to[PATH_ROOM];
    part_of(part, name);
    snprintf(from, sizeof from, "%s/%s", dir, part);
    snprintf(to, sizeof to, "%s/%s", dir, name);
    const int error = errno; // of the write that failed first
    if (fclose(file) == 0 && !failed && rename(from, to) == 0)
        return 0;
    if (failed)
        errno = error;
    brink_files_complain(dir, name);
    unlink(from);
    return -1;
}

int brink_files_choose(char *dir, size_t size, const char *scene, const char *out)
{
    const char *slash = strrchr(scene, '/');
    const char *stem = slash ? slash + 1 : scene;
    const char *dot = strrchr(stem, '.');
    const int length =
        out ? (int)strlen(out) : (int)(dot ? (size_t)(dot - stem) : strlen(stem));
    if (length == 0 || (size_t)length + 64 > size) {
        fprintf(stderr,
                "%s: no folder can be named after it; give one with --out DIR\n",
                scene);
        return -1;
    }
    snprintf(dir, size, "%.*s", length, out ? out : stem);
    if (mkdir(dir, 0777) && errno != EEXIST) {
        fprintf(stderr,
                "%s: the folder cannot be made: %s\n  --out DIR takes another\n",
                dir, strerror(errno));
        return -1;
    }
    if (brink_checkpoint_count(dir) > 0) {
        fprintf(stderr,
                "%s: it holds a run already, which is not overwritten\n"
                "  `brink resume %s` goes on with it; --out DIR takes another "
                "folder\n",
                dir, dir);
        return -1;
    }
    return 0;
}
