// SPDX-License-Identifier: MIT
#include "bench_curves.h"
#include "bench_races.h"
#include <math.h>
#include <stdlib.h>

static const struct {
    const char *name, *style;
    int colour;
} looks[RACERS] = {{"brink", "lw 3.5 ps 0.8", 1}, {"plain", "lw 1.8 ps 0.8", 2}};

static void write_frame(FILE *out, const char *axis, double low, double high)
{
    fprintf(out,
            "set logscale xy\nunset key\nset lmargin 11\nset rmargin 9\n"
            "set yrange [%.6g:%.6g]\nset ylabel 'processor time an event' offset "
            "1,0\nset ytics scale 1,0 (",
            low, high);
    for (double decade = 100; decade < 1e6; decade *= 10)
        for (int k = 0; k < 3; k++) {
            const double ns = decade * (double[]){1, 2, 5}[k];
            fprintf(out, "%s'%g %s' %g", ns > 100 ? ", " : "",
                    ns < 1000 ? ns : ns / 1000, ns < 1000 ? "ns" : "µs", ns);
        }
    fprintf(out, ")\n%s", axis);
}

static void write_curve(FILE *out, enum racer who, int count, const double *x,
                        const race_result *const results[])
{
    fprintf(out, "$%s << E\n", looks[who].name);
    for (int k = 0; k < count; k++)
        fprintf(out, "%.9g %.6g\n", x[k], race_ns(results[k], who));
    fprintf(out, "E\nset label %d '%s' at %.9g, %.6g offset 1,0 tc lt %d\n",
            (int)who + 1, looks[who].name, x[count - 1],
            race_ns(results[count - 1], who), looks[who].colour);
}

char *bench_curves(const char *axis, int count, const double *x,
                   const race_result *const results[])
{
    char *script = NULL;
    size_t size = 0;
    double low = (double)INFINITY, high = 0;
    FILE *out = open_memstream(&script, &size);
    if (out == NULL)
        return NULL;
    for (int k = 0; k < count; k++)
        for (enum racer who = 0; who < RACERS; who++) {
            low = fmin(low, race_ns(results[k], who));
            high = fmax(high, race_ns(results[k], who));
        }
    write_frame(out, axis, low / 1.5, high * 1.5);
    for (enum racer who = 0; who < RACERS; who++)
        write_curve(out, who, count, x, results);
    for (int who = 0; who < RACERS; who++)
        fprintf(out, "%s $%s with linespoints lt %d %s", who == 0 ? "plot" : ",",
                looks[who].name, looks[who].colour, looks[who].style);
    fprintf(out, "\n");
    if (fclose(out) != 0) {
        free(script);
        return NULL;
    }
    return script;
}
