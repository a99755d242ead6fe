// SPDX-License-Identifier: MIT
#include "study_tiers.h"
#include "start.h"
#include "study_words.h"
#include <brink/overlap.h>
#include <math.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { TURNS = 100, EVENTS_A_LOOK = 100 };

typedef struct subject { // one tier's run
    brink_run run;
    double squares; // sum of squared contact errors
    uint64_t looks;
    double seconds;
    enum brink_run_status status;
} subject;

/** (|r| - distance) / distance of the last event's pair: the overlap function is
 *  the difference of the squares. */
static double contact_error(const brink_run *run)
{
    const brink_happening *e = &run->last;
    double r[3];
    brink_system_separation(&run->system, e->i, e->j, e->when.offset, r);
    return brink_ball_overlap(r, e->distance) / (2 * e->distance * e->distance);
}

static void take_turn(subject *s, uint64_t events)
{
    uint64_t done = brink_tally_events(&s->run.tally);
    while (s->status == BRINK_RUN_REACHED && done < events) {
        const uint64_t next = done + EVENTS_A_LOOK;
        const clock_t begin = clock();
        s->status = brink_run_advance(&s->run, next < events ? next : events,
                                      BRINK_NEVER);
        s->seconds += (double)(clock() - begin) / CLOCKS_PER_SEC;
        done = brink_tally_events(&s->run.tally);
        if (s->status != BRINK_RUN_REACHED)
            return;
        const double error = contact_error(&s->run);
        s->squares += error * error;
        s->looks++;
    }
}

static int create(subject s[BRINK_TIERS], const brink_scene *scene,
                  const char *path)
{
    for (int k = 0; k < BRINK_TIERS; k++) {
        brink_system start;
        if (brink_start_make(scene, path, &start, stderr) != 0)
            return -1;
        if (brink_run_create(&s[k].run, &start, (enum brink_tier)k) != 0) {
            brink_system_destroy(&start);
            fprintf(stderr, "%s: memory is out\n", path);
            return -1;
        }
    }
    return 0;
}

static void sum_up(const subject *s, brink_tier_trial *t)
{
    const double begin = s->run.energy_begin, size = fabs(begin);
    t->status = s->status;
    t->seconds = s->seconds;
    t->contact_rms = sqrt(s->squares / (double)s->looks);
    t->energy_error =
        fabs(brink_run_energy(&s->run) - begin) / (size > 0 ? size : 1);
    t->tally = s->run.tally;
}

static int run_all(const brink_scene *scene, const char *path, uint64_t events,
                   brink_tier_trial trial[BRINK_TIERS])
{
    subject s[BRINK_TIERS] = {0};
    const int status = create(s, scene, path);
    for (uint64_t turn = 1; turn <= TURNS && status == 0; turn++)
        for (int k = 0; k < BRINK_TIERS; k++)
            take_turn(&s[k],
                      events / TURNS * turn + events % TURNS * turn / TURNS);
    for (int k = 0; k < BRINK_TIERS; k++) {
        if (status == 0)
            sum_up(&s[k], &trial[k]);
        brink_run_destroy(&s[k].run);
    }
    return status;
}

int brink_tiers_try(const brink_scene *scene, const char *path, uint64_t events,
                    brink_tier_trial trial[BRINK_TIERS])
{
    int ends[2]; // what goes through is smaller than what a pipe holds
    if (pipe(ends) != 0)
        return -1;
    const ssize_t size = BRINK_TIERS * (ssize_t)sizeof *trial;
    const pid_t worker = fork();
    if (worker == 0)
        _exit(run_all(scene, path, events, trial) != 0 ||
              write(ends[1], trial, (size_t)size) != size);
    close(ends[1]);
    int status = worker < 0 || read(ends[0], trial, (size_t)size) != size;
    close(ends[0]);
    if (worker > 0)
        waitpid(worker, NULL, 0);
    return status ? -1 : 0;
}

static const char tiers[] = "The event times of all of the above are those of "
                            "the tier “plain”: whether and "
                            "on which side exact, the time within 8 ulp. “fast” "
                            "promises no more than that "
                            "the pair is at the surface at that time to a few "
                            "rounding errors, and may be "
                            "wrong about whether where it all but grazes; “cr” "
                            "rounds the time correctly. "
                            "Here the same scene has been run in each, side by "
                            "side, for %s events, at most. "
                            "The contact error is how far from the step a pair "
                            "is when its event is executed, "
                            "relative to the distance of the step; the root of "
                            "the mean square is that of "
                            "every hundredth event.";

void brink_tiers_tell(brink_report *r, const brink_tier_trial trial[BRINK_TIERS])
{
    static const char *const names[BRINK_TIERS] = {"fast", "plain", "cr"};
    static const char *const head[] = {
        "tier",    "contact error, rms", "largest of all", "energy error",
        "clamped", "at one instant",     "seconds",        "to fast"};
    uint64_t most = 0;
    for (int k = 0; k < BRINK_TIERS; k++) {
        const uint64_t events = brink_tally_events(&trial[k].tally);
        most = events > most ? events : most;
    }
    brink_report_heading(r, 3, "What more exact times cost and buy");
    brink_report_paragraph(r, tiers, brink_words_grouped(most).text);
    brink_report_table(r,
                       "Clamped: due when predicted, the pair already beyond "
                       "the step by a rounding.",
                       8, "lrrrrrrr", head);
    for (int k = 0; k < BRINK_TIERS; k++) {
        const brink_tier_trial *t = &trial[k];
        brink_report_cell(r, "%s%s", names[k],
                          t->status == BRINK_RUN_REACHED ? "" : " (stopped)");
        brink_report_cell(r, "%s", brink_words_scientific(t->contact_rms).text);
        brink_report_cell(
            r, "%s", brink_words_scientific(t->tally.contact_error_max).text);
        brink_report_cell(r, "%s", brink_words_scientific(t->energy_error).text);
        brink_report_cell(r, "%s", brink_words_grouped(t->tally.clamped).text);
        brink_report_cell(r, "%s", brink_words_grouped(t->tally.zero_time).text);
        brink_report_cell(r, "%.3g", t->seconds);
        brink_report_cell(r, "%.2f", t->seconds / trial[0].seconds);
    }
    brink_report_table_end(r);
}
