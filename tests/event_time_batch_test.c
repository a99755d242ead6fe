// SPDX-License-Identifier: MIT
// Batches are the scalar kernel bit for bit: as they are called, and on each
// instruction set path by its name.
#include "batches.h"
#include "cases.h"
#include "pairs.h"
#include "suite.h"

enum { MOST = 300, SEED = 1, UNTOUCHED = -12345 };

static const char *const way_names[WAYS] = {"as called", "any", "fma", "avx512"};

/** Pairs as a structure of arrays, with room to start at any alignment. */
typedef struct arrays {
    double x[7][MOST + 8], t[MOST + 8];
} arrays;

static void set_pair(arrays *a, int i, const pair_case *p)
{
    for (int k = 0; k < 3; k++) {
        a->x[k][i] = p->r[k];
        a->x[3 + k][i] = p->v[k];
    }
    a->x[6][i] = p->sigma;
}

static void fill(arrays *a, stream *s, const pair_family *family)
{
    for (int i = 0; i < MOST + 8; i++) {
        pair_case p;
        family->make(s, &p);
        const int outside = stream_int(s, 0, 99); // the domain, if at most 2
        if (outside <= 1)
            *(outside ? &p.r[1] : &p.sigma) = (double)NAN;
        if (outside == 2)
            p.sigma = -p.sigma;
        set_pair(a, i, &p);
    }
}

static void call(batch *many, const arrays *a, int from, int n, double *t)
{
    many((size_t)n, a->x[0] + from, a->x[1] + from, a->x[2] + from,
         a->x[3] + from, a->x[4] + from, a->x[5] + from, a->x[6] + from, t);
}

static double one_by_one(const struct tier *tier, const arrays *a, int i)
{
    const double r[3] = {a->x[0][i], a->x[1][i], a->x[2][i]};
    const double v[3] = {a->x[3][i], a->x[4][i], a->x[5][i]};
    return tier->one(r, v, a->x[6][i]);
}

/** t[i] must be right[i], i < n; pair i is in place from + i. */
static void expect(const struct tier *tier, int way, const char *family,
                   const arrays *a, int from, int n, const double *t,
                   const double *right)
{
    for (int i = 0; i < n; i++)
        if (!same(t[i], right[i])) {
            const int k = from + i;
            ck_abort_msg("%s, %s, %s, %d of %d from %d (seed %d):\n"
                         "%a %a %a  %a %a %a  %a\nin a batch %a, alone %a",
                         tier->name, way_names[way], family, i, n, from, SEED,
                         a->x[0][k], a->x[1][k], a->x[2][k], a->x[3][k],
                         a->x[4][k], a->x[5][k], a->x[6][k], t[i], right[i]);
        }
}

/** What a tier's scalar kernel says of every pair. */
static void one_by_one_all(const struct tier *tier, const arrays *a,
                           double right[MOST + 8])
{
    for (int i = 0; i < MOST + 8; i++)
        right[i] = one_by_one(tier, a, i);
}

START_TEST(batches_of_any_size_and_alignment_are_the_scalar_kernel)
{
    static arrays a;
    static double right[TIERS][MOST + 8];
    stream s = stream_of_seed(SEED);
    fill(&a, &s, &pair_families[_i]);
    for (int k = 0; k < TIERS; k++)
        one_by_one_all(&tiers[k], &a, right[k]);
    for (int n = 0; n <= MOST; n++)
        for (int k = 0; k < TIERS; k++)
            for (int way = 0; way < WAYS && has_way(way); way++) {
                const int from = stream_int(&s, 0, 7), to = stream_int(&s, 0, 7);
                for (int i = 0; i < MOST + 8; i++)
                    a.t[i] = UNTOUCHED;
                call(batch_of(&tiers[k], way), &a, from, n, a.t + to);
                expect(&tiers[k], way, pair_families[_i].name, &a, from, n,
                       a.t + to, right[k] + from);
                for (int i = 0; i < MOST + 8; i++) // nothing else is written
                    if ((i < to || i >= to + n) && a.t[i] != UNTOUCHED)
                        ck_abort_msg("%s, %s, %d to %d: %d is written",
                                     tiers[k].name, way_names[way], n, to, i);
            }
}
END_TEST

START_TEST(hard_cases_are_the_scalar_kernel_in_a_batch_of_their_like)
{
    static arrays a;
    static double right[MOST + 8];
    FILE *in = cases_open("event_time");
    double x[7];
    while (cases_next(in, 7, x)) {
        const pair_case p = {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, x[6]};
        for (int i = 0; i < MOST + 8; i++)
            set_pair(&a, i, &p);
        for (int k = 0; k < TIERS; k++)
            for (int way = 0; way < WAYS && has_way(way); way++) {
                one_by_one_all(&tiers[k], &a, right);
                call(batch_of(&tiers[k], way), &a, 0, MOST, a.t);
                expect(&tiers[k], way, "event_time.wc", &a, 0, MOST, a.t, right);
            }
    }
    fclose(in);
}
END_TEST

START_TEST(the_times_may_be_written_over_any_of_the_inputs)
{
    static arrays a, before;
    static double right[MOST + 8];
    stream s = stream_of_seed(SEED);
    for (int k = 0; k < TIERS; k++) {
        fill(&before, &s, &pair_families[_i]);
        one_by_one_all(&tiers[k], &before, right);
        for (int way = 0; way < WAYS && has_way(way); way++)
            for (int over = 0; over < 7; over++) {
                a = before;
                call(batch_of(&tiers[k], way), &a, 0, MOST, a.x[over]);
                expect(&tiers[k], way, pair_families[_i].name, &before, 0, MOST,
                       a.x[over], right);
            }
    }
}
END_TEST

START_TEST(inputs_may_be_one_array)
{
    // r = v = (x, x, x): going straight outward
    double x[20], t[20];
    for (int i = 0; i < 20; i++)
        x[i] = i - 10;
    for (int k = 0; k < TIERS; k++)
        for (int way = 0; way < WAYS && has_way(way); way++) {
            batch_of(&tiers[k], way)(20, x, x, x, x, x, x, x, t);
            for (int i = 0; i < 20; i++) {
                const double r[3] = {x[i], x[i], x[i]};
                ck_assert(same(t[i], tiers[k].one(r, r, x[i])));
            }
        }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("event_time_batch");
    TCase *all = tcase_create("all");
    tcase_set_timeout(all, 600);
    tcase_add_loop_test(all,
                        batches_of_any_size_and_alignment_are_the_scalar_kernel,
                        0, PAIR_FAMILIES);
    tcase_add_loop_test(all, the_times_may_be_written_over_any_of_the_inputs, 0,
                        PAIR_FAMILIES);
    tcase_add_test(all,
                   hard_cases_are_the_scalar_kernel_in_a_batch_of_their_like);
    tcase_add_test(all, inputs_may_be_one_array);
    suite_add_tcase(suite, all);
    return run_whole_suite(suite);
}
