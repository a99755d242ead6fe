// SPDX-License-Identifier: MIT
#include "observe_record.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

int brink_record_create(brink_record *record, const brink_wish *wish,
                        const brink_run *run)
{
    const brink_system *s = &run->system;
    const double bodies = s->count > 1 ? s->count - 1 : 1;
    memset(record, 0, sizeof *record);
    record->wish = *wish;
    record->thermal = 2 * run->kinetic_begin / (s->dimensions * bodies);
    record->x = calloc(3 * (size_t)s->count, sizeof *record->x);
    record->speed = calloc(BRINK_RECORD_SPEEDS, sizeof *record->speed);
    if (!record->x || !record->speed ||
        (wish->distance_bins > 0 &&
         brink_distances_create(&record->distances, s, wish->distance_most,
                                wish->distance_bins)) ||
        (wish->lags > 0 && brink_displacements_create(&record->displacements, s,
                                                      wish->lags, wish->every))) {
        brink_record_destroy(record);
        return -1;
    }
    return 0;
}

void brink_record_destroy(brink_record *record)
{
    free(record->x);
    free(record->speed);
    brink_distances_destroy(&record->distances);
    brink_displacements_destroy(&record->displacements);
    memset(record, 0, sizeof *record);
}

brink_instant brink_record_due(const brink_record *record, const brink_run *run)
{
    const brink_wish *w = &record->wish;
    if (!(w->every > 0))
        return BRINK_NEVER;
    return brink_instant_at(run->system.year,
                            w->from + (double)record->samples * w->every);
}

// What has come together since the last sample.
static void sample_rates(brink_record *record, const brink_run *run, double kt)
{
    const brink_system *s = &run->system;
    const double n = s->count, every = record->wish.every;
    const brink_sum *now = &run->tally.virial, *then = &record->virial;
    const double virial = (now->sum - then->sum) + (now->carry - then->carry);
    const uint64_t events = brink_tally_events(&run->tally) - record->events;
    if (record->samples > 0) {
        brink_series_add(&record->pressure,
                         (n * kt + virial / (s->dimensions * every)) /
                             brink_system_volume(s));
        brink_series_add(&record->rate, 2 * (double)events / (n * every));
    }
    record->virial = *now;
    record->events += events;
}

static void sample_speeds(brink_record *record, const brink_system *s)
{
    double count[BRINK_RECORD_SPEEDS] = {0};
    for (uint32_t i = 0; i < s->count; i++) {
        const double *v = s->particle[i].v;
        const double m = s->species[s->particle[i].species].mass;
        const double u =
            sqrt(m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / record->thermal);
        const double at = u / BRINK_RECORD_SPEED_STEP;
        if (at < BRINK_RECORD_SPEEDS)
            count[(int)at]++;
    }
    for (int k = 0; k < BRINK_RECORD_SPEEDS; k++)
        brink_series_add(&record->speed[k],
                         count[k] / (s->count * BRINK_RECORD_SPEED_STEP));
}

void brink_record_sample(brink_record *record, const brink_run *run)
{
    const brink_system *s = &run->system;
    const brink_wish *w = &record->wish;
    const double kt = brink_system_temperature(s);
    sample_rates(record, run, kt);
    brink_series_add(&record->temperature, kt);
    brink_series_add(&record->energy,
                     brink_states_energy(&run->states, s) / s->count);
    if (w->speeds && record->thermal > 0)
        sample_speeds(record, s);
    if (w->distance_bins > 0 || w->lags > 0)
        for (uint32_t i = 0; i < s->count; i++)
            brink_run_position(run, i, &record->x[(size_t)i * 3]);
    if (w->distance_bins > 0)
        brink_distances_sample(&record->distances, s, record->x);
    if (w->lags > 0)
        brink_displacements_sample(&record->displacements, s, record->x);
    record->samples++;
}

static void code_record(brink_codec *c, brink_record *r)
{
    brink_code_u64(c, &r->samples);
    brink_code_u64(c, &r->events);
    brink_code_double(c, &r->virial.sum);
    brink_code_double(c, &r->virial.carry);
    brink_series_code(c, &r->pressure);
    brink_series_code(c, &r->temperature);
    brink_series_code(c, &r->energy);
    brink_series_code(c, &r->rate);
    if (r->wish.speeds)
        for (int k = 0; k < BRINK_RECORD_SPEEDS; k++)
            brink_series_code(c, &r->speed[k]);
    if (r->wish.distance_bins > 0)
        brink_distances_code(c, &r->distances);
    if (r->wish.lags > 0)
        brink_displacements_code(c, &r->displacements);
}

// The codec takes by pointer what it writes, and does not change it.
int brink_record_pack(const brink_record *record, char **bytes, uint64_t *size)
{
    size_t length = 0;
    *bytes = NULL;
    FILE *out = open_memstream(bytes, &length);
    if (!out)
        return -1;
    brink_codec c;
    brink_record r = *record;
    brink_codec_write_to(&c, out);
    code_record(&c, &r);
    brink_codec_seal(&c);
    const int failed = fclose(out) != 0 || c.fault;
    *size = length;
    return failed ? -1 : 0;
}

const char *brink_record_unpack(brink_record *record, char *bytes, uint64_t size)
{
    FILE *in = size > 0 ? fmemopen(bytes, size, "r") : NULL;
    if (!in)
        return "it holds no observations, which its scene asks for";
    brink_codec c;
    brink_codec_read_from(&c, in);
    code_record(&c, record);
    brink_codec_seal(&c);
    brink_codec_close(&c);
    fclose(in);
    return c.fault;
}
