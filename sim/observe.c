// SPDX-License-Identifier: MIT
#include "observe.h"
#include "observe_figures.h"
#include <inttypes.h>
#include <math.h>

static void put_text(FILE *out, const char *key, const char *text)
{
    fprintf(out, "  \"%s\": \"", key);
    brink_figures_json_text(out, text);
    fputs("\",\n", out);
}

static void put_count(FILE *out, const char *key, uint64_t count)
{
    fprintf(out, "  \"%s\": %" PRIu64 ",\n", key, count);
}

static void put_number(FILE *out, const char *key, double value)
{
    if (isfinite(value))
        fprintf(out, "  \"%s\": %.17g,\n", key, value);
    else
        fprintf(out, "  \"%s\": null,\n", key);
}

static double energy_drift(const brink_run *run)
{
    return (brink_run_energy(run) - run->energy_begin) / run->kinetic_begin;
}

static double momentum_drift(const brink_run *run)
{
    const brink_system *s = &run->system;
    double p[3], all = 0.0, most = 0.0;
    brink_system_momentum(s, p);
    for (uint32_t i = 0; i < s->count; i++) {
        const double *v = s->particle[i].v;
        all += s->species[s->particle[i].species].mass *
               sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    for (int a = 0; a < 3; a++)
        most = fmax(most, fabs(p[a] - run->momentum_begin[a]));
    return all > 0 ? most / all : 0.0;
}

int brink_observe_summary(FILE *out, const brink_run *run, const brink_plan *plan,
                          const char *title, const char *stopped,
                          const brink_record *record)
{
    static const char *const tiers[] = {"fast", "plain", "cr"};
    const brink_tally *t = &run->tally;
    const uint64_t events = brink_tally_events(t);
    fputs("{\n", out);
    put_text(out, "title", title);
    put_text(out, "version", BRINK_VERSION);
    put_count(out, "seed", plan->seed);
    put_text(out, "tier", tiers[run->tier]);
    put_text(out, "stopped", stopped);
    put_count(out, "particles", run->system.count);
    put_count(out, "events", events);
    fprintf(out,
            "  \"events_by_kind\": {\"core\": %" PRIu64 ", \"capture\": %" PRIu64
            ", \"release\": %" PRIu64 ", \"bounce\": %" PRIu64
            ", \"wall\": %" PRIu64 ", \"cell\": %" PRIu64 "},\n",
            t->core, t->capture, t->release, t->bounce, t->wall, t->cell);
    put_number(out, "time", brink_run_time(run));
    put_number(out, "wall_seconds", plan->wall_seconds);
    put_number(out, "events_per_second", (double)events / plan->wall_seconds);
    put_number(out, "energy_initial", run->energy_begin);
    put_number(out, "energy_final", brink_run_energy(run));
    put_number(out, "energy_drift_relative", energy_drift(run));
    put_number(out, "momentum_drift", momentum_drift(run));
    put_number(out, "temperature", brink_system_temperature(&run->system));
    put_number(out, "potential_energy_per_particle",
               brink_states_energy(&run->states, &run->system) /
                   run->system.count);
    put_number(out, "pressure", brink_run_pressure(run));
    put_number(out, "compressibility_factor", brink_run_compressibility(run));
    put_number(out, "mean_free_time", brink_run_mean_free_time(run));
    put_number(out, "contact_error_max", t->contact_error_max);
    if (record)
        brink_figures_json(out, record, &run->system);
    const char *const names[] = {"cells", "lists"};
    const brink_neighbours *n = &run->neighbours;
    fprintf(out, "  \"neighbourhood\": \"%s\",\n", names[n->radius > 0]);
    fprintf(out, "  \"cells\": [%d, %d, %d],\n", run->cells.count[0],
            run->cells.count[1], run->cells.count[2]);
    if (n->radius > 0)
        put_number(out, "neighbours_per_particle",
                   (double)n->who.used / run->system.count);
    fprintf(out,
            "  \"anomalies\": {\"clamped\": %" PRIu64 ", \"zero_time\": %" PRIu64
            ", \"repeated\": %" PRIu64 ", \"rim\": %" PRIu64
            ", \"refused\": %" PRIu64 "}\n}\n",
            t->clamped, t->zero_time, t->repeated, t->rim, t->refused);
    return ferror(out) || fflush(out) ? -1 : 0;
}

double brink_observe_done(const brink_run *run, const brink_plan *plan)
{
    const double events =
        (double)brink_tally_events(&run->tally) / (double)plan->events;
    return fmin(1.0, fmax(events, brink_run_time(run) / plan->until));
}

void brink_observe_progress(char *line, size_t size, const brink_run *run,
                            const brink_plan *plan, double rate)
{
    const uint64_t events = brink_tally_events(&run->tally);
    const double done = brink_observe_done(run, plan);
    const double left = (double)events * (1.0 - done) / (done * rate);
    snprintf(line, size,
             "%" PRIu64 " events, %.1f %%, %.0f events/s, %.0f s left, "
             "energy error %.1e",
             events, 100 * done, rate, isfinite(left) ? left : 0.0,
             energy_drift(run));
}
