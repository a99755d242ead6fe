// SPDX-License-Identifier: MIT
#include "contract.h"

enum { MOST_NUDGES = 3, NUDGE_ULP = 4 };

static int is_finite(const double *x, int n)
{
    for (int k = 0; k < n; k++)
        if (!isfinite(x[k]))
            return 0;
    return 1;
}

void contract_case(const problem *p, stream *s, int movable,
                   double x[PROBLEM_INPUTS])
{
    do // some families reach beyond the range now and then
        p->make(stream_int(s, 0, p->families - 1), s, x);
    while (!is_finite(x, p->width));
    for (int n = stream_int(s, 0, MOST_NUDGES); n > 0; n--) {
        double *moved = &x[stream_int(s, 0, movable - 1)];
        const double to = stream_near(s, *moved, NUDGE_ULP);
        // A radius, a mass is not to become negative, and nothing infinite.
        if (isfinite(to) && signbit(to) == signbit(*moved))
            *moved = to;
    }
}

int contract_answer(const problem *p, int k, const double x[PROBLEM_INPUTS],
                    double y[PROBLEM_OUTPUTS])
{
    double row[PROBLEM_INPUTS];
    int n = 0;
    inputs in = {.n = 1, .width = p->width, .rows = row};
    answers out = {.n = &n};
    for (int i = 0; i < p->width; i++) {
        row[i] = x[i];
        in.columns[i] = &row[i];
    }
    for (int i = 0; i < p->outputs; i++) {
        y[i] = 0;
        out.x[i] = &y[i];
    }
    p->method[k].loop(&in, &out);
    return n;
}

/** The nearest double itself, where a kernel promises that: half an ulp leaves a
 * tie open. */
static int is_nearest(const problem *p, const truth *right, const double *y)
{
    for (int i = 0; i < right->n && i < p->outputs; i++)
        if (y[i] != right->x[i].nearest)
            return 0;
    return 1;
}

int contract_kernel(const problem *p, enum rank rank)
{
    int k = 0;
    while (p->method[k].rank != rank)
        k++;
    return k;
}

void contract_check(const problem *p, enum rank rank,
                    const double x[PROBLEM_INPUTS], const truth *right)
{
    for (int k = 0; k < p->methods; k++) {
        const method *m = &p->method[k];
        if (m->rank != rank)
            continue;
        double y[PROBLEM_OUTPUTS];
        const int n = contract_answer(p, k, x, y);
        judge_of *const judge = rank_is_sign(rank) ? p->judge_sign : p->judge;
        const verdict v = judge(x, right, n, y);
        const int by = m->bound_measure, exact = rank_is_sign(rank);
        const int decided = by == 0 ? v.wrong == WRONG_NOT : 1;
        const int close = exact || v.error[by] <= m->bound;
        const int rounded = exact || m->bound > 0.5 || is_nearest(p, right, y);
        if (decided && close && rounded)
            continue;
        FINDING("%s is %s, off by %g %s, promised %g", m->name,
                problem_wrong_names[v.wrong], v.error[by], p->measure[by],
                m->bound);
        finding_numbers("x", p->width, x);
        finding_numbers("got", p->outputs, y);
        fprintf(stderr, "  got %d, right is %d: %a, %a\n", n, right->n,
                right->x[0].nearest, right->x[1].nearest);
        finding_end();
    }
}
