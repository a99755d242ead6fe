// SPDX-License-Identifier: MIT
#include "observe_series.h"
#include <math.h>

void brink_series_add(brink_series *s, double sample)
{
    s->count++;
    for (int l = 0; l < BRINK_SERIES_LEVELS; l++) {
        brink_series_level *level = &s->level[l];
        const uint64_t blocks = s->count >> l;
        const double off = sample - level->mean;
        level->mean += off / (double)blocks;
        level->scatter += off * (sample - level->mean);
        if (blocks % 2 == 1) {
            level->pending = sample;
            return;
        }
        sample = 0.5 * (level->pending + sample);
    }
}

double brink_series_mean(const brink_series *s)
{
    return s->count > 0 ? s->level[0].mean : (double)NAN;
}

double brink_series_error(const brink_series *s)
{
    double most = (double)NAN;
    for (int l = 0; l < BRINK_SERIES_LEVELS; l++) {
        const double blocks = (double)(s->count >> l);
        if (blocks < BRINK_SERIES_BLOCKS)
            break;
        most = fmax(most, // of NaN and a number the number
                    sqrt(s->level[l].scatter / (blocks * (blocks - 1))));
    }
    return most;
}

void brink_series_code(brink_codec *c, brink_series *s)
{
    brink_code_u64(c, &s->count);
    for (int l = 0; l < BRINK_SERIES_LEVELS && s->count >> l > 0; l++) {
        brink_code_double(c, &s->level[l].mean);
        brink_code_double(c, &s->level[l].scatter);
        brink_code_double(c, &s->level[l].pending);
    }
}
