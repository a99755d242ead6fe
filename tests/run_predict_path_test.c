// SPDX-License-Identifier: MIT
// Every path predicts the same events, bit for bit: each is called by name, where
// the simulator has it and the processor can, for every particle of runs that
// have gone on for a while.
#include "paths.h"
#include "run_predict.h"
#include "suite.h"
#include "systems.h"
#include <string.h>

typedef void predict(brink_run *run, uint32_t i, double offset);

PATHS_OF(predict, brink_predict)

// What particle i waits for, as the path has it.
static brink_entry waits_for(brink_run *run, uint32_t i, int path)
{
    predict *const paths[] = PATHS(brink_predict);
    paths[path](run, i, run->now.offset);
    return run->calendar.entry[i];
}

static void compare_paths(brink_run *run)
{
    for (int path = 1; path < PATHS_IN_ALL && can_try(path); path++)
        for (uint32_t i = 0; i < run->system.count; i++) {
            const brink_entry a = waits_for(run, i, 0);
            const brink_entry b = waits_for(run, i, path);
            ck_assert_msg(memcmp(&a, &b, sizeof a) == 0,
                          "path %d, particle %u: at %a, not %a", path, i,
                          b.when.offset, a.when.offset);
        }
}

START_TEST(predictions_are_the_same_on_every_path)
{
    static const char *const scenes[] = {
        hard_spheres, square_well, three_steps,     mixture,
        discs_well,   small_box,   crowded_spheres, crowded_mixture};
    for (size_t k = 0; k < sizeof scenes / sizeof *scenes; k++) {
        brink_run run;
        make_run(&run, scenes[k]);
        for (uint64_t events = 1000; events <= 5000; events += 1000) {
            advance(&run, events);
            compare_paths(&run);
        }
        brink_run_destroy(&run);
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE("predict_path", 120, predictions_are_the_same_on_every_path);
}
