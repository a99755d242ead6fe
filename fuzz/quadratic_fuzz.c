// SPDX-License-Identifier: MIT
#include <brink/quadratic.h>

#include "contract.h"
#include <string.h>

typedef int roots_kernel(double a, double b, double c, double *x0, double *x1);
typedef struct roots {
    int n;
    double x[2];
} roots;

static roots solve(roots_kernel *kernel, const double q[3])
{
    roots r = {0, {-12345, -12345}}; // what an output without a root must keep
    r.n = kernel(q[0], q[1], q[2], &r.x[0], &r.x[1]);
    return r;
}

static void keep(const char *law, const double q[3], const roots *a,
                 const double q2[3], const roots *b)
{
    const int same = a->n == b->n && a->x[0] == b->x[0] && a->x[1] == b->x[1];
    if (same)
        return;
    FINDING("quadratic: %s", law);
    finding_numbers("q", 3, q);
    finding_numbers("x", 2, a->x);
    finding_numbers("its_q", 3, q2);
    finding_numbers("its_x", 2, b->x);
    finding_end();
}

/** Laws that hold bit for bit for the nearest doubles; of the plain roots, whose
 * last bits may go either way, the contract says it all. */
static void laws(const double q[3])
{
    const roots of_q = solve(brink_quadratic_roots_cr, q);

    const double minus[3] = {-q[0], -q[1], -q[2]};
    const roots of_minus = solve(brink_quadratic_roots_cr, minus);
    keep("-q has the roots of q", q, &of_q, minus, &of_minus);

    const double mirror[3] = {q[0], -q[1], q[2]};
    roots of_mirror = solve(brink_quadratic_roots_cr, mirror);
    if (of_mirror.n == 2)
        of_mirror = (roots){2, {-of_mirror.x[1], -of_mirror.x[0]}};
    if (of_mirror.n == 1)
        of_mirror.x[0] = -of_mirror.x[0];
    keep("x -> -x mirrors the roots", q, &of_q, mirror, &of_mirror);
}

/** x 2^e in *to; whether that is exact and both are normal, and x not the least
 *  number that is: what is rounded to that may be below it, in fewer bits. */
static int times_power(double *to, double x, int e)
{
    *to = ldexp(x, e);
    return fabs(x) > 0x1p-1022 && isnormal(*to) && ldexp(*to, -e) == x;
}

/** Coefficients times powers of two: exact, so the roots are, too, as long as
 *  nothing leaves the normal range. */
static void scaling(const double q[3], stream *s)
{
    const int all = stream_int(s, -400, 400), unit = stream_int(s, -200, 200);
    double scaled[3];
    for (int k = 0; k < 3; k++)
        if (!times_power(&scaled[k], q[k], all + (k - 1) * unit))
            return;
    roots of_q = solve(brink_quadratic_roots_cr, q);
    for (int k = 0; k < of_q.n; k++) {
        const double x = of_q.x[k];
        if (!times_power(&of_q.x[k], x, unit))
            return;
    }
    const roots of_scaled = solve(brink_quadratic_roots_cr, scaled);
    keep("powers of two change nothing else", q, &of_q, scaled, &of_scaled);
}

static void outside(roots_kernel *kernel, const double q[3], stream *s)
{
    static const double bad[] = {(double)INFINITY, -(double)INFINITY,
                                 (double)NAN};
    double broken[3] = {q[0], q[1], q[2]};
    broken[stream_int(s, 0, 2)] = bad[stream_int(s, 0, 2)];
    const roots of_broken = solve(kernel, broken);
    const roots refused = {-1, {-12345, -12345}};
    keep("what is not finite is refused", broken, &of_broken, broken, &refused);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static roots_kernel *const tiers[] = {brink_quadratic_roots,
                                          brink_quadratic_roots_cr};
    stream s = stream_of_bytes(data, size);
    double x[PROBLEM_INPUTS];
    contract_case(&problem_quadratic, &s, 3, x);
    truth right = {0};
    problem_quadratic.solve(x, &right);
    contract_check(&problem_quadratic, RANK_PLAIN, x, &right);
    contract_check(&problem_quadratic, RANK_CR, x, &right);
    laws(x);
    scaling(x, &s);
    for (int k = 0; k < 2; k++)
        outside(tiers[k], x, &s);
    return 0;
}
