// SPDX-License-Identifier: MIT
// Every path tells the same stays, bit for bit: each is called by name, where the
// simulator has it and the processor can, for every particle of runs that have
// gone on for a while.
#include "paths.h"
#include "run.h"
#include "suite.h"
#include "systems.h"
#include <string.h>

typedef void stays(const brink_cells *c, const brink_system *system, uint32_t i,
                   double offset, brink_stay *stay);

PATHS_OF(stays, brink_cells_stay)

static void compare_paths(const brink_run *run, uint32_t i, double offset)
{
    stays *const paths[] = PATHS(brink_cells_stay);
    brink_stay first, other;
    paths[0](&run->cells, &run->system, i, offset, &first);
    for (int path = 1; path < PATHS_IN_ALL && can_try(path); path++) {
        paths[path](&run->cells, &run->system, i, offset, &other);
        ck_assert_msg(other.until == first.until && other.cells == first.cells &&
                          other.crossing.axis == first.crossing.axis &&
                          other.crossing.way == first.crossing.way &&
                          memcmp(other.near, first.near,
                                 (size_t)first.cells * sizeof *first.near) == 0,
                      "path %d, particle %u: until %a, not %a", path, i,
                      other.until, first.until);
    }
}

START_TEST(stays_are_the_same_on_every_path)
{
    static const char *const scenes[] = {hard_spheres, square_shoulder,
                                         discs_well, small_box, mixture};
    for (size_t k = 0; k < sizeof scenes / sizeof *scenes; k++) {
        brink_run run;
        make_run(&run, scenes[k]);
        for (uint64_t events = 1000; events <= 5000; events += 1000) {
            advance(&run, events);
            brink_particle *rests = &run.system.particle[events / 1000];
            memset(rests->v, 0, sizeof rests->v); // for good, as far as is asked
            for (uint32_t i = 0; i < run.system.count; i++)
                compare_paths(&run, i, run.now.offset);
        }
        brink_run_destroy(&run);
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE("cells_stay_path", 120, stays_are_the_same_on_every_path);
}
