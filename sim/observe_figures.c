// SPDX-License-Identifier: MIT
#include "observe_figures.h"
#include <inttypes.h>
#include <math.h>

void brink_figures_json_text(FILE *out, const char *text)
{
    for (const unsigned char *c = (const unsigned char *)text; *c; c++)
        if (*c == '"' || *c == '\\')
            fprintf(out, "\\%c", *c);
        else if (*c < 0x20)
            fprintf(out, "\\u%04x", *c);
        else
            putc(*c, out);
}

brink_figure brink_figures_of(const brink_series *series)
{
    return (brink_figure){brink_series_mean(series), brink_series_error(series)};
}

brink_figure brink_figures_free_time(const brink_record *record)
{
    const brink_figure rate = brink_figures_of(&record->rate);
    return (brink_figure){1 / rate.mean, rate.error / (rate.mean * rate.mean)};
}

brink_figure brink_figures_diffusion(const brink_record *record, int species)
{
    const brink_displacements *d = &record->displacements;
    return brink_displacements_trusted(d)
               ? brink_figures_of(&d->diffusion[species])
               : (brink_figure){(double)NAN, (double)NAN};
}

static void put_number(FILE *out, double value)
{
    if (isfinite(value))
        fprintf(out, "%.17g", value);
    else
        fputs("null", out);
}

static void put_figure(FILE *out, const char *key, brink_figure f)
{
    fputs("\"", out);
    brink_figures_json_text(out, key);
    fputs("\": {\"mean\": ", out);
    put_number(out, f.mean);
    fputs(", \"error\": ", out);
    put_number(out, f.error);
    fputs("}", out);
}

void brink_figures_json(FILE *out, const brink_record *record,
                        const brink_system *system)
{
    const brink_wish *w = &record->wish;
    fprintf(out,
            "  \"observed\": {\n    \"from\": %.17g, \"every\": %.17g, "
            "\"samples\": %" PRIu64 ",\n    ",
            w->from, w->every, record->samples);
    put_figure(out, "pressure", brink_figures_of(&record->pressure));
    fputs(",\n    ", out);
    put_figure(out, "temperature", brink_figures_of(&record->temperature));
    fputs(",\n    ", out);
    put_figure(out, "potential_energy_per_particle",
               brink_figures_of(&record->energy));
    fputs(",\n    ", out);
    put_figure(out, "mean_free_time", brink_figures_free_time(record));
    if (w->lags > 0) {
        fputs(",\n    \"diffusion\": {", out);
        for (int k = 0; k < system->species_count; k++) {
            fputs(k > 0 ? ", " : "", out);
            put_figure(out, system->species[k].name,
                       brink_figures_diffusion(record, k));
        }
        fprintf(out, "},\n    \"farthest_step\": %.17g",
                record->displacements.farthest);
    }
    fputs("\n  },\n", out);
}

static void put_columns(FILE *out, const brink_series *series)
{
    const brink_figure f = brink_figures_of(series);
    fprintf(out, " %.9g %.3g", f.mean, f.error);
}

void brink_figures_distances(FILE *out, const brink_record *record,
                             const brink_system *system)
{
    const brink_distances *d = &record->distances;
    fputs("# distance", out);
    for (int b = 0; b < d->species; b++)
        for (int a = 0; a <= b; a++)
            fprintf(out, ", g and error of %s-%s", system->species[a].name,
                    system->species[b].name);
    fputs("\n", out);
    for (int k = 0; k < d->bins; k++) {
        fprintf(out, "%.9g", d->most * (k + 0.5) / d->bins);
        for (int kind = 0; kind < brink_distances_kind(0, d->species); kind++)
            put_columns(out, &d->g[kind * d->bins + k]);
        fputs("\n", out);
    }
}

void brink_figures_displacements(FILE *out, const brink_record *record,
                                 const brink_system *system)
{
    const brink_displacements *d = &record->displacements;
    fputs("# time", out);
    for (int s = 0; s < d->species; s++)
        fprintf(out, ", mean squared displacement and error of %s",
                system->species[s].name);
    fputs("\n", out);
    for (int lag = 1; lag <= d->lags; lag++) {
        fprintf(out, "%.9g", d->span * lag / d->lags);
        for (int s = 0; s < d->species; s++)
            put_columns(out, &d->square[s * d->lags + lag - 1]);
        fputs("\n", out);
    }
}

void brink_figures_speeds(FILE *out, const brink_record *record)
{
    fputs("# speed / sqrt(kT/m), density and error\n", out);
    for (int k = 0; k < BRINK_RECORD_SPEEDS; k++) {
        fprintf(out, "%.9g", BRINK_RECORD_SPEED_STEP * (k + 0.5));
        put_columns(out, &record->speed[k]);
        fputs("\n", out);
    }
}
