// SPDX-License-Identifier: MIT
#include "codec.h"
#include "snapshot.h"
#include "suite.h"
#include "systems.h"
#include <stdlib.h>
#include <string.h>

static const char *const scenes[] = {
    hard_spheres, square_well, square_shoulder, three_steps,    mixture,
    discs_well,   small_box,   crowded_spheres, crowded_mixture};
enum { ALL = sizeof scenes / sizeof *scenes };

static brink_plan plan = {.events = 12345,
                          .until = 2.5,
                          .seed = 99,
                          .frames = 3,
                          .frame_end = 1000,
                          .wall_seconds = 1.5,
                          .scene = (char[]){"a scene"},
                          .scene_size = 7};

static FILE *write_run(const brink_run *run)
{
    FILE *file = tmpfile();
    const char *fault = brink_snapshot_write(file, run, &plan);
    ck_assert_msg(!fault, "%s", fault);
    rewind(file);
    return file;
}

static void read_run(FILE *file, brink_run *run)
{
    brink_plan p;
    const char *fault = brink_snapshot_read(file, run, &p);
    ck_assert_msg(!fault, "%s", fault);
    ck_assert(p.events == plan.events && p.until == plan.until &&
              p.seed == plan.seed && p.frames == plan.frames &&
              p.frame_end == plan.frame_end &&
              p.wall_seconds == plan.wall_seconds);
    ck_assert_str_eq(p.scene, "a scene");
    brink_plan_destroy(&p);
}

START_TEST(saved_and_loaded_half_way_a_run_ends_the_same)
{
    for (int k = 0; k < ALL; k++) {
        brink_run whole, half, loaded;
        make_run(&whole, scenes[k]);
        make_run(&half, scenes[k]);
        advance(&whole, 20000);
        advance(&half, 10000);
        half.idle = 3; // as in the middle of simultaneous events
        FILE *file = write_run(&half);
        read_run(file, &loaded);
        fclose(file);
        ck_assert_msg(same_state(&half, &loaded), "scene %d, loaded", k);
        advance(&loaded, 20000);
        ck_assert_msg(same_state(&whole, &loaded), "scene %d, at the end", k);
        ck_assert(whole.energy_begin == loaded.energy_begin);
        brink_run_destroy(&whole);
        brink_run_destroy(&half);
        brink_run_destroy(&loaded);
    }
}
END_TEST

// FACTS: in 10 of 25 saves of an existing simulator the stored state contradicts
// the stored positions by a rounding.  The state wins.
START_TEST(where_state_and_position_disagree_the_state_wins)
{
    brink_run run, loaded;
    make_run(&run, square_well);
    int contradictions = 0;
    for (uint64_t events = 1; events <= 200; events++) {
        double r[3];
        advance(&run, events);
        const brink_happening *e = &run.last;
        brink_system_separation(&run.system, e->i, e->j, run.now.offset, r);
        const brink_potential *p =
            brink_system_potential(&run.system, e->i, e->j);
        const int seen = brink_step_level_at(p, r);
        if (seen == e->level_after || seen == p->count)
            continue;
        contradictions++;
        FILE *file = write_run(&run);
        read_run(file, &loaded);
        fclose(file);
        ck_assert_int_eq(brink_states_level(&loaded.states, e->i, e->j),
                         e->level_after);
        ck_assert(brink_run_energy(&loaded) == brink_run_energy(&run));
        brink_run_destroy(&loaded);
    }
    ck_assert_msg(contradictions > 0, "nothing was tested");
    brink_run_destroy(&run);
}
END_TEST

static char *bytes_of(FILE *file, size_t *size)
{
    fseek(file, 0, SEEK_END);
    *size = (size_t)ftell(file);
    char *bytes = malloc(*size);
    rewind(file);
    ck_assert_uint_eq(fread(bytes, 1, *size, file), *size);
    return bytes;
}

static const char *read_bytes(const char *bytes, size_t size)
{
    FILE *file = tmpfile();
    brink_run run;
    brink_plan p;
    ck_assert_uint_eq(fwrite(bytes, 1, size, file), size);
    rewind(file);
    const char *fault = brink_snapshot_read(file, &run, &p);
    fclose(file);
    if (!fault) {
        brink_run_destroy(&run);
        brink_plan_destroy(&p);
    }
    return fault;
}

// Of every bit: a checksum of 64 bits finds all errors so short, and whether this
// is the one that is used, and over the whole of the file, is seen here.
START_TEST(a_file_with_any_one_bit_flipped_is_refused)
{
    brink_run run, taken;
    brink_plan p;
    size_t size;
    make_run(&run, small_box);
    advance(&run, 500);
    FILE *file = write_run(&run);
    char *bytes = bytes_of(file, &size);
    fclose(file);
    file = fmemopen(bytes, size, "r");
    setvbuf(file, NULL, _IONBF, 0); // the bytes as they are now
    ck_assert_ptr_null(brink_snapshot_read(file, &taken, &p));
    brink_run_destroy(&taken);
    brink_plan_destroy(&p);
    for (size_t bit = 0; bit < 8 * size; bit++) {
        const char mask = (char)(1 << bit % 8);
        bytes[bit / 8] ^= mask;
        rewind(file);
        const char *fault = brink_snapshot_read(file, &taken, &p);
        ck_assert_msg(fault != NULL, "bit %zu of %zu", bit, 8 * size);
        ck_assert_ptr_nonnull(strstr(fault, "checksum"));
        bytes[bit / 8] ^= mask;
    }
    fclose(file);
    free(bytes);
    brink_run_destroy(&run);
}
END_TEST

// Damage whose checksum was made to fit, as an adversary would: no crash, and
// where it is taken for a run, a valid one.
START_TEST(a_forged_file_is_refused_or_a_valid_run)
{
    brink_run run;
    size_t size;
    make_run(&run, small_box);
    advance(&run, 500);
    FILE *file = write_run(&run);
    char *bytes = bytes_of(file, &size);
    fclose(file);
    ck_assert_ptr_null(read_bytes(bytes, size));
    int refused = 0, all = 0;
    for (size_t at = 0; at + 8 < size; at += 7) {
        FILE *forged = tmpfile();
        brink_codec c;
        const char kept = bytes[at];
        bytes[at] = (char)(kept ^ (1 << at % 8));
        brink_codec_write_to(&c, forged);
        brink_code_bytes(&c, bytes, size - 8);
        brink_codec_seal(&c);
        rewind(forged);
        brink_run taken;
        brink_plan p;
        const char *fault = brink_snapshot_read(forged, &taken, &p);
        if (!fault) {
            ck_assert_ptr_null(brink_run_is_valid(&taken));
            brink_run_destroy(&taken);
            brink_plan_destroy(&p);
        }
        refused += fault != NULL;
        all++;
        fclose(forged);
        bytes[at] = kept;
    }
    ck_assert_msg(refused > all / 10, "%d of %d refused", refused, all);
    free(bytes);
    brink_run_destroy(&run);
}
END_TEST

START_TEST(what_is_wrong_is_said)
{
    brink_run run;
    size_t size;
    make_run(&run, small_box);
    FILE *file = write_run(&run);
    char *bytes = bytes_of(file, &size);
    fclose(file);
    ck_assert_ptr_nonnull(strstr(read_bytes(bytes, 3), "too short"));
    ck_assert_ptr_nonnull(strstr(read_bytes(bytes, size - 1), "checksum"));
    bytes[0] = 'B';
    ck_assert_ptr_nonnull(strstr(read_bytes(bytes, size), "checksum"));
    free(bytes);
    brink_run_destroy(&run);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "snapshot", 300, saved_and_loaded_half_way_a_run_ends_the_same,
        where_state_and_position_disagree_the_state_wins,
        a_file_with_any_one_bit_flipped_is_refused,
        a_forged_file_is_refused_or_a_valid_run, what_is_wrong_is_said);
}
