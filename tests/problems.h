// SPDX-License-Identifier: MIT
#ifndef TESTS_PROBLEMS_H
#define TESTS_PROBLEMS_H
/**
 * What the kernels compute, as problems: families of inputs, the right answer,
 * and ways to an answer, the kernels' own and those of rivals.  What the ulp tool
 * and the bench have in common.
 */
#include "random.h"
#include <mpfr.h>

enum { PROBLEM_INPUTS = 14, PROBLEM_OUTPUTS = 7 };

/** n cases twice over: case by case, and as a structure of arrays for batches. */
typedef struct inputs {
    int n, width;
    double *rows;                    // width numbers a case
    double *columns[PROBLEM_INPUTS]; // n numbers each
} inputs;

typedef struct answers {
    double *x[PROBLEM_OUTPUTS];
    int *n; // how many roots, which sign, whether it crossed
} answers;

/** A kernel called on all inputs, directly, so that the loop can be timed. */
typedef void loop(const inputs *in, answers *out);

/** A real number to 128 bits, the double nearest to it, and the exponent of the
 * unit in the last place of its binade. */
typedef struct real {
    long double hi, lo;
    double nearest;
    int ulp;
} real;

typedef struct truth {
    int n;
    real x[PROBLEM_OUTPUTS];
} truth;

/** Ways to be wrong that no number of ulp describes. */
enum wrong {
    WRONG_NOT, // wrong by its error, if at all
    WRONG_MISSED,
    WRONG_INVENTED,
    WRONG_NOW, // now for later, or later for now
    WRONG_SIGN,
    WRONG_SIDE,     // crossed for reflected, or reflected for crossed
    WRONG_SPURIOUS, // 0, infinity or NaN for a number
    WRONG_KINDS
};

enum { MEASURES = 2 };

extern const char *const problem_wrong_names[WRONG_KINDS];

/** How good an answer is by each of the problem's measures: infinite where the
 * answer is wrong beyond measure, negative where there was nothing to measure,
 * such as the time at which a pair rightly never meets. */
typedef struct verdict {
    enum wrong wrong;
    double error[MEASURES];
} verdict;

/** What a way is, for how it is drawn and told. */
enum rank {
    RANK_FAST,
    RANK_PLAIN,
    RANK_CR,
    RANK_SIGN,       // answers with a sign alone
    RANK_NAIVE_SIGN, // here begin the rivals
    RANK_FORMULA,
    RANK_LIBRARY,
    RANK_WIDE,
    RANK_JUDGE // what all others are judged by
};

static inline int rank_is_sign(enum rank r)
{
    return r == RANK_SIGN || r == RANK_NAIVE_SIGN;
}

typedef verdict judge_of(const double *x, const truth *, int n, const double *y);

typedef struct method {
    const char *name;  // on the command line: a kernel's own, or problem/rival
    const char *label; // in a figure
    const char *about; // in a table
    enum rank rank;
    loop *loop;
    double bound;      // what a kernel promises, 0: nothing,
    int bound_measure; // by which measure
} method;

typedef struct problem {
    const char *name;  // of files
    const char *title; // of a section
    const char *about;
    int width, outputs;
    // Where among the inputs are the `pasted` numbers that make a line of
    // tests/*.wc, -1 for a 0; NULL: as they come
    const signed char *paste;
    int pasted;
    int families;
    const char *(*family)(int);
    void (*make)(int family, stream *, double *x);
    const char *usual; // the family over which costs are compared
    void (*solve)(const double *x, truth *);
    judge_of *judge, *judge_sign;
    const char *measure[MEASURES]; // what the errors are counted in
    const char *second;            // what the second of them is of, in a word
    int methods;
    const method *method; // the first is the baseline of costs
} problem;

enum { PROBLEMS = 14 };
extern const problem *const problems[PROBLEMS];

/** The family of this name, or -1. */
int problem_family(const problem *p, const char *name);

/** Looks a method up by its name; NULL, or its problem, and its place in *k. */
const problem *problem_of(const char *name, int *k);

/** The first n inputs of a family that follow from a seed; NULL: no memory. */
inputs *inputs_make(const problem *p, int family, int n, uint64_t seed);
void inputs_free(inputs *in);
answers *answers_make(int n);
void answers_free(answers *a);

void real_from(real *x, const mpfr_t exact);

/**
 * |x - exact| in ulp of the exact value's binade; an infinite x counts as 2^1024,
 * so rounding to infinity from the edge is an error like any other.  0 where x is
 * the infinity the exact value is or rounds to; +inf for NaN and for a missed
 * infinity.  As oracle_ulps, at once.
 */
double real_ulps(double x, const real *exact);

/** Whether 0, an infinity or NaN stands for something that is nothing of the
 * kind: by more than any rounding to a subnormal or at the edge of the range
 * explains. */
int real_is_spurious(double x, const real *exact);

/** Of an event's time t, by the first measure: is there one, and when? */
verdict problem_judge_time(const real *exact, double t);

/** The loop over a kernel: statements with *p, case i's inputs, into *out. */
#define LOOP(name, ...)                                                          \
    static void name(const inputs *in, answers *out)                             \
    {                                                                            \
        const int n = in->n, width = in->width;                                  \
        const double *p = in->rows;                                              \
        for (int i = 0; i < n; i++, p += width)                                  \
            __VA_ARGS__;                                                         \
    }
#endif
