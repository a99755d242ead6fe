// SPDX-License-Identifier: MIT
#ifndef FOLDER_H
#define FOLDER_H
/**
 * A folder for a test's files, and what is in one of them.
 */
#include <check.h>
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static inline void remove_all(const char *path)
{
    DIR *folder = opendir(path);
    for (struct dirent *e; folder != NULL && (e = readdir(folder)) != NULL;) {
        char inside[4096];
        if (strcmp(e->d_name, ".") == 0 || strcmp(e->d_name, "..") == 0)
            continue;
        if (snprintf(inside, sizeof inside, "%s/%s", path, e->d_name) <
            (int)sizeof inside)
            remove_all(inside);
    }
    if (folder != NULL)
        closedir(folder);
    remove(path);
}

static char the_folder[64];

static inline void remove_the_folder(void)
{
    remove_all(the_folder);
}

/** A new folder under `place`, one a test; it goes when the test's process ends,
 *  unless it failed. */
static inline const char *new_folder_in(const char *place)
{
    snprintf(the_folder, sizeof the_folder, "%s/brink-test-XXXXXX", place);
    ck_assert_ptr_nonnull(mkdtemp(the_folder));
    atexit(remove_the_folder);
    return the_folder;
}

static inline const char *new_folder(void)
{
    return new_folder_in("/tmp");
}

/** The same in memory, where the system has such a place: syncing takes no
 *  time. */
static inline const char *new_quick_folder(void)
{
    struct stat about;
    const char *memory = "/dev/shm";
    return new_folder_in(stat(memory, &about) == 0 ? memory : "/tmp");
}

/** FOLDER/NAME, valid until the next call. */
static inline const char *in_folder(const char *folder, const char *name)
{
    static char path[4096];
    const int length = snprintf(path, sizeof path, "%s/%s", folder, name);
    ck_assert_int_lt(length, (int)sizeof path);
    return path;
}

/** The whole of FOLDER/NAME, to be freed; the test fails where there is none. */
static inline char *whole_file(const char *folder, const char *name)
{
    FILE *in = fopen(in_folder(folder, name), "r");
    ck_assert_msg(in != NULL, "there is no %s in %s", name, folder);
    struct stat about;
    ck_assert_int_eq(fstat(fileno(in), &about), 0);
    char *text = calloc(1, (size_t)about.st_size + 1);
    ck_assert_ptr_nonnull(text);
    const size_t size = (size_t)about.st_size;
    ck_assert_uint_eq(fread(text, 1, size, in), size);
    fclose(in);
    return text;
}

static inline void write_file(const char *folder, const char *name,
                              const char *text)
{
    FILE *out = fopen(in_folder(folder, name), "w");
    ck_assert_ptr_nonnull(out);
    ck_assert_int_ge(fputs(text, out), 0);
    ck_assert_int_eq(fclose(out), 0);
}
#endif
