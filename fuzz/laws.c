// SPDX-License-Identifier: MIT
#include "laws.h"
#include "../tests/paths.h"

/** A kernel and what is asked of it. */
typedef struct trial {
    const lawful *law;
    const method *kernel;
    int k, exact; // its number; whether it is right to the bit
    const double *x;
    double y; // what it answers to x: a value,
    int n;    // or a sign
} trial;

static _Noreturn void broken(const trial *t, const char *law,
                             const double *other_x, double y, int n)
{
    const int width = t->law->problem->width;
    FINDING("%s: %s", t->kernel->name, law);
    finding_numbers("x", width, t->x);
    finding_numbers("other_x", width, other_x);
    fprintf(stderr, "  %a, %d and %a, %d\n", t->y, t->n, y, n);
    finding_end();
}

/** What the kernel answers to other inputs. */
static double ask(const trial *t, const double *x, int *n)
{
    double y[PROBLEM_OUTPUTS];
    *n = contract_answer(t->law->problem, t->k, x, y);
    return y[0];
}

static double ulp_of(double x)
{
    return nextafter(fabs(x), (double)INFINITY) - fabs(x);
}

/** Whether two answers to one question may be: each is within the bound, and of
 *  the larger one's ulp.  Beside an infinity there is what rounds to it. */
static int may_both_be(const trial *t, double x, double y)
{
    if (x == y || (isnan(x) && isnan(y)))
        return 1;
    if (t->exact)
        return 0;
    if (isinf(x) || isinf(y))
        return fabs(x) >= 0x1p1023 && fabs(y) >= 0x1p1023 && x * y > 0;
    const double ulp = fmax(ulp_of(x), ulp_of(y));
    return fabs(x - y) <= 2 * t->kernel->bound * ulp;
}

static void expect(const trial *t, const char *law, const double *x)
{
    int n;
    const double y = ask(t, x, &n);
    if (n != t->n || !may_both_be(t, t->y, y))
        broken(t, law, x, y, n);
}

/** Vectors come first: how many numbers they are. */
static int vector_numbers(const trial *t)
{
    return t->law->problem->width / 3 * 3;
}

/** Products of what is mirrored are the same, or have the other sign: so is every
 *  rounding. */
static void mirror(trial t, stream *s)
{
    double x[PROBLEM_INPUTS];
    const int axes = stream_int(s, 1, 7);
    memcpy(x, t.x, sizeof x);
    for (int i = 0; i < vector_numbers(&t); i++)
        if (axes >> i % 3 & 1)
            x[i] = -x[i];
    t.exact = 1;
    expect(&t, axes == 7 ? "seen from the partner" : "mirrored", x);
}

static void exchange(const trial *t, stream *s)
{
    double x[PROBLEM_INPUTS];
    const int turn = stream_int(s, 0, 2), swap = stream_int(s, 0, 1);
    memcpy(x, t->x, sizeof x);
    for (int i = 0; i < vector_numbers(t); i++) {
        const int axis = swap ? 2 - i % 3 : i % 3;
        x[i] = t->x[i / 3 * 3 + (axis + turn) % 3];
    }
    expect(t, "axes exchanged", x);
}

static void change_zeros(const trial *t)
{
    double x[PROBLEM_INPUTS];
    memcpy(x, t->x, sizeof x);
    for (int i = 0; i < t->law->problem->width; i++)
        if (x[i] == 0)
            x[i] = -x[i];
    expect(t, "zeros of the other sign", x);
}

// --- Units ---------------------------------------------------------------------

/** Powers of two by which units are changed. */
typedef struct units {
    int length, velocity, normal;
} units;

static int exponent_of(const units *u, char letter)
{
    switch (letter) {
    case 'L':
    case 'R':
        return u->length;
    case 'V':
        return u->velocity;
    case 'N':
        return u->normal;
    case 'T':
        return u->length - u->velocity;
    default:
        return 0;
    }
}

/** x 2^e in *to; whether that is exact. */
static int times_power(double *to, double x, int e)
{
    *to = ldexp(x, e);
    return isfinite(*to) && ldexp(*to, -e) == x;
}

/** Little for most, else up to where doubles end. */
static int some_exponent(stream *s)
{
    const int limit = stream_int(s, 0, 3) ? 64 : 1100;
    return stream_int(s, -limit, limit);
}

/** Whether y, for the answer t->y times 2^e, may be.  A 0 may stand for what is
 *  too small there, an infinity for what is too large; what is subnormal has lost
 *  digits. */
static int is_scaled(const trial *t, double y, int e)
{
    double want;
    if (t->y == 0)
        return fabs(y) <= ldexp(1, e - 1074);
    if (isinf(t->y))
        return fabs(y) >= ldexp(1, e + 1023) && (y == 0 || y * t->y > 0);
    if (!times_power(&want, t->y, e) || !isnormal(want) || !isnormal(t->y))
        return 1;
    return may_both_be(t, want, y);
}

static void scale(const trial *t, stream *s)
{
    const units u = {some_exponent(s), some_exponent(s), some_exponent(s)};
    double x[PROBLEM_INPUTS];
    for (int i = 0; i < t->law->problem->width; i++)
        if (!times_power(&x[i], t->x[i], exponent_of(&u, t->law->units[i])))
            return;
    int n, e = 0;
    const double y = ask(t, x, &n);
    for (const char *unit = t->law->answer; *unit; unit++)
        e += exponent_of(&u, *unit);
    if (n != t->n || !is_scaled(t, y, e))
        broken(t, "in other units", x, y, n);
}

// --- The domain ----------------------------------------------------------------

static void leave_domain(const trial *t, stream *s)
{
    static const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY,
                                 -1};
    double x[PROBLEM_INPUTS];
    memcpy(x, t->x, sizeof x);
    const int i = stream_int(s, 0, t->law->problem->width - 1);
    const int kind = stream_int(s, 0, t->law->units[i] == 'R' ? 3 : 2);
    if (t->law->units[i] == '-')
        return;
    x[i] = bad[kind];
    int n;
    const double y = ask(t, x, &n);
    if (t->kernel->rank == RANK_SIGN ? n != 0 : !isnan(y))
        broken(t, "outside the domain", x, y, n);
}

void laws_check(const lawful *l, enum rank rank, const double x[PROBLEM_INPUTS],
                stream *s)
{
    trial t = {.law = l, .k = contract_kernel(l->problem, rank), .x = x};
    t.kernel = &l->problem->method[t.k];
    t.exact = rank_is_sign(rank) || t.kernel->bound <= 0.5;
    t.y = ask(&t, x, &t.n);
    if (*l->answer == 'T' && signbit(t.y))
        broken(&t, "a negative time", x, t.y, t.n);
    mirror(t, s);
    if (rank != RANK_FAST) {
        exchange(&t, s);
        scale(&t, s);
        change_zeros(&t);
    }
    leave_domain(&t, s);
}
