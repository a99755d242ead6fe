// SPDX-License-Identifier: MIT
#include "study_watch.h"
#include <time.h>
#include <unistd.h>

void brink_watch_begin(brink_watch *w)
{
    w->parent = 0;
    sigemptyset(&w->stops);
    sigaddset(&w->stops, SIGTERM);
    sigaddset(&w->stops, SIGINT);
    sigprocmask(SIG_BLOCK, &w->stops, &w->before);
}

void brink_watch_end(const brink_watch *w)
{
    sigprocmask(SIG_SETMASK, &w->before, NULL);
}

int brink_watch_stopped(const brink_watch *w)
{
    return brink_watch_wait(w, 0);
}

int brink_watch_wait(const brink_watch *w, double seconds)
{
    const time_t whole = (time_t)seconds;
    const struct timespec most = {whole, (long)((seconds - (double)whole) * 1e9)};
    return sigtimedwait(&w->stops, NULL, &most) > 0 ||
           (w->parent != 0 && getppid() != w->parent);
}
