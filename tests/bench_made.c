// SPDX-License-Identifier: MIT
#include "bench_made.h"
#include <stdio.h>
#include <string.h>
#include <sys/utsname.h>

/** The processor's name, if the system tells it. */
static void find_processor(char *name, size_t size)
{
    char line[300];
    FILE *in = fopen("/proc/cpuinfo", "r");
    snprintf(name, size, "unknown processor");
    while (in != NULL && fgets(line, sizeof line, in) != NULL)
        if (strncmp(line, "model name", 10) == 0 && strchr(line, ':') != NULL) {
            line[strcspn(line, "\n")] = '\0';
            snprintf(name, size, "%s", strchr(line, ':') + 2);
            break;
        }
    if (in != NULL)
        fclose(in);
}

void bench_write_made(brink_report *r, const char *command)
{
    char processor[300];
    struct utsname u;
    find_processor(processor, sizeof processor);
    if (uname(&u) != 0)
        strcpy(u.machine, "");
    brink_report_heading(r, 2, "How this page was made");
    brink_report_verbatim(r, "%s\n\nbrink %s, compiled by %s\n%s, %s", command,
                          BRINK_VERSION, BRINK_COMPILER, processor, u.machine);
}
