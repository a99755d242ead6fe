// SPDX-License-Identifier: MIT
// Lattices laid into boxes, against the promise of their header.
#include "start_lattice.h"
#include "suite.h"
#include <gsl/gsl_rng.h>
#include <math.h>

// A cell's proper shape, the sites in it, and how far the nearest two are apart.
static const struct {
    double proper[3];
    unsigned sites;
    double apart;
    int dimensions;
} lattices[] = {[BRINK_START_FCC] = {{1, 1, 1}, 4, 0.7071067811865476, 3},
                [BRINK_START_SC] = {{1, 1, 1}, 1, 1, 3},
                [BRINK_START_SQUARE] = {{1, 1, 1}, 1, 1, 2},
                [BRINK_START_HEXAGONAL] = {{1, 1.7320508075688772, 1}, 2, 1, 2}};

static double nearest(const brink_sites *s)
{
    double least = (double)INFINITY;
    for (uint64_t i = 0; i < s->count; i++)
        for (uint64_t j = 0; j <= i; j++) {
            double x[3], y[3], sum = 0;
            brink_lattice_site(s, i, x);
            brink_lattice_site(s, j, y);
            for (int a = 0; a < 3; a++) {
                const double d = x[a] - y[a], l = s->length[a];
                sum += pow(d - l * rint(d / l), 2);
            }
            if (i != j)
                least = fmin(least, sqrt(sum));
        }
    return least;
}

// The largest cell of proper shape of which enough go whole into the box: one of
// those that just fit k times along an axis.
static double largest_cell(enum brink_lattice lattice, const double length[3],
                           uint64_t least)
{
    double best = 0;
    for (int a = 0; a < lattices[lattice].dimensions; a++)
        for (int k = 1; k <= 200; k++) {
            const double size = length[a] / (k * lattices[lattice].proper[a]);
            double sites = lattices[lattice].sites;
            for (int b = 0; b < lattices[lattice].dimensions; b++)
                sites *= fmax(
                    // NOLINTNEXTLINE(clang-analyzer-core.*): b < 3
                    1, floor(length[b] / (size * lattices[lattice].proper[b]) *
                             (1 + 0x1p-50))); // k itself goes k times
            if (sites >= (double)least)
                best = fmax(best, size);
        }
    return best;
}

START_TEST(sites_are_no_closer_than_in_the_largest_proper_lattice_that_fits)
{
    gsl_rng *random = gsl_rng_alloc(gsl_rng_mt19937);
    for (unsigned seed = 0; seed < 400; seed++) {
        gsl_rng_set(random, seed);
        const enum brink_lattice lattice = (enum brink_lattice)(seed % 4);
        const int dimensions = lattices[lattice].dimensions;
        double length[3] = {1, 1, 1};
        for (int a = 0; a < dimensions; a++)
            length[a] = seed % 3 ? 10 : 3 + 20 * gsl_rng_uniform(random);
        const uint64_t least = 8 + gsl_rng_uniform_int(random, 120);
        const brink_sites s = brink_lattice_lay(lattice, length, least);
        const double size = largest_cell(lattice, length, least);
        ck_assert_uint_ge(s.count, least);
        // A box thinner than a cell brings images nearer, which no lattice helps.
        int is_thin = 0;
        for (int a = 0; a < dimensions; a++)
            is_thin |= length[a] < size * lattices[lattice].proper[a];
        // A coordinate is off by 3 roundings of less than 23 2^-53.
        if (!is_thin)
            ck_assert_msg(nearest(&s) >=
                              lattices[lattice].apart * size - 300 * 0x1p-53,
                          "seed %u: %a, and %a", seed, nearest(&s),
                          lattices[lattice].apart * size);
    }
    gsl_rng_free(random);
}
END_TEST

START_TEST(a_magic_number_makes_a_perfect_lattice)
{
    static const double cube[3] = {7, 7, 7}, plane[3] = {10, 10, 1};
    brink_sites s = brink_lattice_lay(BRINK_START_FCC, cube, 4 * 7 * 7 * 7);
    ck_assert_uint_eq(s.count, 4 * 7 * 7 * 7);
    ck_assert(s.cells[0] == 7 && s.cells[1] == 7 && s.cells[2] == 7);
    s = brink_lattice_lay(BRINK_START_SQUARE, plane, 100);
    ck_assert_uint_eq(s.count, 100);
    ck_assert(s.cells[0] == 10 && s.cells[1] == 10 && s.cells[2] == 1);
}
END_TEST

START_TEST(sites_lie_within_the_box_and_off_its_faces)
{
    static const double box[3] = {5, 6, 7};
    const brink_sites s = brink_lattice_lay(BRINK_START_FCC, box, 300);
    for (uint64_t i = 0; i < s.count; i++) {
        double x[3];
        brink_lattice_site(&s, i, x);
        for (int a = 0; a < 3; a++)
            ck_assert(x[a] > 0 && x[a] < box[a]);
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "lattice", 60,
        sites_are_no_closer_than_in_the_largest_proper_lattice_that_fits,
        a_magic_number_makes_a_perfect_lattice,
        sites_lie_within_the_box_and_off_its_faces);
}
