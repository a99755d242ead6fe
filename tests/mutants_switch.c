// SPDX-License-Identifier: MIT
// In every program of a mutants' build (see mutants.py): which mutant it is, by
// the environment, what that may use up, and where it has been.  Its first
// failure is its end.
#define _XOPEN_SOURCE 700
#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

enum { MOST_FUNCTIONS = 4096 };

int brink_mutant; // 0: none
static unsigned char nowhere[MOST_FUNCTIONS];
unsigned char *brink_reached = nowhere; // per function of the mutated file

static void limit(int resource, rlim_t most)
{
    setrlimit(resource, &(struct rlimit){most, most});
}

__attribute__((constructor)) static void begin(void)
{
    const char *mutant = getenv("BRINK_MUTANT"),
               *seconds = getenv("BRINK_MUTANT_SECONDS"),
               *reached = getenv("BRINK_MUTANT_REACHED");
    if (mutant)
        brink_mutant = atoi(mutant);
    if (seconds) {
        limit(RLIMIT_CPU, (rlim_t)atoi(seconds));
#ifndef __SANITIZE_ADDRESS__ // it lays hands on far more than it uses
        limit(RLIMIT_AS, (rlim_t)2 << 30);
#endif
        limit(RLIMIT_CORE, 0);
    }
    if (!reached)
        return;
    // A file, so that processes that are forked or killed leave their part.
    const int file = open(reached, O_RDWR);
    void *map =
        mmap(NULL, MOST_FUNCTIONS, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (map != MAP_FAILED)
        brink_reached = map;
    close(file);
}

_Noreturn void __wrap__ck_assert_failed(const char *file, int line,
                                        const char *expression, ...);
_Noreturn void __wrap__ck_assert_failed(const char *file, int line,
                                        const char *expression, ...)
{
    (void)file, (void)line, (void)expression;
    _exit(1);
}
