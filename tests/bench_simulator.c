// SPDX-License-Identifier: MIT
#include "bench_simulator.h"
#include "bench_made.h"
#include "bench_simulator_parts.h"
#include <math.h>

static void write_findings(brink_report *r, const bench_races *races)
{
    double least = (double)INFINITY, most = 0;
    for (int k = 0; k < COURSES; k++) {
        const double ratio =
            bench_race_over(races, bench_courses[k].course)->ratio;
        least = fmin(least, ratio);
        most = fmax(most, ratio);
    }
    brink_report_finding(
        r,
        "In a second of processor time brink executes %s to %s times as many "
        "events as the plain simulator.",
        bench_ratio(least).text, bench_ratio(most).text);
    const race_result *first = bench_race_over(races, bench_size(0)),
                      *last = bench_race_over(races, bench_size(SIZES - 1));
    brink_report_finding(
        r,
        "From %s to %s particles, what an event costs differs by a factor of "
        "%s; asked was less than 2.5. The plain simulator's differs by %s.",
        bench_particles(first).text, bench_particles(last).text,
        bench_ratio(bench_size_spread(races, RACE_BRINK)).text,
        bench_ratio(bench_size_spread(races, RACE_PLAIN)).text);
    const race_result *well = bench_race_over(races, bench_well_12);
    if (last->bytes[RACE_BRINK] > 0)
        brink_report_finding(
            r,
            "A hard sphere takes %.0f bytes of memory, a particle in a well "
            "with %.1f partners %.0f; asked were at most 300 and 600.",
            last->bytes[RACE_BRINK], well->captured, well->bytes[RACE_BRINK]);
}

static void write_beginning(brink_report *r, const bench_races *races)
{
    brink_report_heading(r, 1, "The simulator beside a plain one");
    brink_report_paragraph(
        r,
        "How fast is brink's simulator? A number of events a second says little "
        "on another machine. So a second simulator runs here beside it: what a "
        "competent person writes in an afternoon. One binary heap holds every "
        "collision ahead, and what has become stale is dropped when it comes "
        "up; there is one list of cells; pairs are predicted one by one, by the "
        "formulas as they stand in print. Both run the same systems from the "
        "same start, in one process, taking turns, and until rounding parts "
        "them they execute the same events, which is tested.");
    write_findings(r, races);
}

static void write_end(brink_report *r, const bench_simulator_settings *s)
{
    bench_write_made(r, s->command);
    brink_report_paragraph(
        r,
        "Systems begin on a lattice and settle for %d events a particle before "
        "anything is measured. A piece is so many events as brink executes in "
        "%g s, but at least as many as give every particle one. An event is a "
        "pair's: what happens at a core or at a step; crossings of cells are "
        "none. brink's times are the certified ones, as in any run. The plain "
        "simulator, tests/plain_simulator.c, keeps what pairs are captured in a "
        "list with each particle. Both are compiled alike, but brink has some "
        "functions twice over and takes those that suit the processor.",
        RACE_SETTLING, s->seconds);
}

int bench_simulator(const bench_simulator_settings *s)
{
    bench_races races = {.seconds = s->seconds, .most = s->particles};
    brink_report r;
    if (bench_hold_races(&races) != 0)
        return -1;
    brink_report_open_page(&r, s->out, "simulator",
                           "The simulator beside a plain one");
    write_beginning(&r, &races);
    bench_write_systems(&r, &races, s->counts);
    bench_write_sizes(&r, &races);
    bench_write_memory(&r, &races);
    bench_write_densities(&r, &races);
    write_end(&r, s);
    return brink_report_close(&r, stderr);
}
