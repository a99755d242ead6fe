// SPDX-License-Identifier: MIT
// A target without a fuzzer: replays what one has found, or throws dice.
#include "fuzz.h"
#include <dirent.h>
#include <errno.h>
#include <inttypes.h>
#include <signal.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { LONGEST = 1 << 20, LONGEST_DICE = 4096 };

static void usage(const char *program)
{
    fprintf(stderr,
            "usage: %s FILE|FOLDER...       each file one case, once\n"
            "       %s --dice COUNT [SEED]  so many cases of random bytes\n",
            program, program);
    exit(2);
}

static void replay_file(const char *path)
{
    static unsigned char bytes[LONGEST];
    FILE *in = fopen(path, "rb");
    if (in == NULL) {
        fprintf(stderr, "%s: %s\n", path, strerror(errno));
        exit(2);
    }
    const size_t size = fread(bytes, 1, sizeof bytes, in);
    fclose(in);
    // From the heap, to its size: a sanitizer sees what is read beyond it.
    unsigned char *exact = malloc(size + 1);
    if (exact == NULL)
        abort();
    memcpy(exact, bytes, size);
    LLVMFuzzerTestOneInput(exact, size);
    free(exact);
}

static int replay(const char *path)
{
    struct stat about;
    if (stat(path, &about) != 0 || !S_ISDIR(about.st_mode)) {
        replay_file(path);
        return 1;
    }
    struct dirent **entries;
    const int count = scandir(path, &entries, NULL, alphasort);
    int files = 0;
    for (int k = 0; k < count; k++) {
        char inside[4096];
        snprintf(inside, sizeof inside, "%s/%s", path, entries[k]->d_name);
        if (entries[k]->d_name[0] != '.')
            files += replay(inside);
        free(entries[k]);
    }
    if (count >= 0)
        free(entries);
    return files;
}

static char again[60]; // how to have the case again that is being tried

static void say_again(int signal)
{
    (void)signal;
    (void)!write(STDERR_FILENO, again, strlen(again));
}

static void throw_dice(uint64_t count, uint64_t seed)
{
    unsigned char bytes[LONGEST_DICE];
    for (uint64_t k = 0; k < count; k++) {
        snprintf(again, sizeof again, "  --dice 1 %" PRIu64 "\n", seed + k);
        stream s = stream_of_seed(seed + k);
        const int size = stream_int(&s, 0, LONGEST_DICE);
        for (int i = 0; i < size; i++)
            bytes[i] = (unsigned char)stream_bits(&s);
        LLVMFuzzerTestOneInput(bytes, (size_t)size);
    }
}

int main(int argc, char **argv)
{
    if (argc < 2)
        usage(argv[0]);
    if (strcmp(argv[1], "--dice") == 0) {
        if (argc < 3 || argc > 4)
            usage(argv[0]);
        signal(SIGABRT, say_again);
        throw_dice(strtoull(argv[2], NULL, 10),
                   argc == 4 ? strtoull(argv[3], NULL, 10) : 1);
        puts("no finding");
        return 0;
    }
    int files = 0;
    for (int k = 1; k < argc; k++)
        files += replay(argv[k]);
    printf("%d files, no finding\n", files);
    return 0;
}
