// SPDX-License-Identifier: MIT
// What Coq is told quadratic.c does is what it does.
#include "transcribed/quadratic_rescued_v.h"
#include "transcribed/quadratic_roots_v.h"
#include "transcribed/quadratic_told_sum_v.h"
#include "transcribed/quadratic_told_v.h"
#include "transcribed/quadratic_v.h"

#define BRINK_PATH transcribed // its functions beside the library's
// NOLINTNEXTLINE(bugprone-suspicious-include): for what is static there
#include "../kernels/quadratic.c"

/** Of a, c, h: a c as large as h^2, exactly or all but that, or of any size. */
static void any_coefficients(stream *s, double *a, double *c, double *h)
{
    *a = stream_scaled(s, -250, 250);
    *c = stream_scaled(s, -250, 250);
    *h = stream_scaled(s, -250, 250);
    switch (stream_int(s, 0, 3)) {
    case 0:
        *a = *c = *h;
        break;
    case 1:
        *h = stream_near(s, copysign(sqrt(fabs(*a * *c)), *h), 3);
        break;
    default:
        break;
    }
}

START_TEST(the_discriminant_of_one_sign_is_that_of_the_proof)
{
    EACH_INPUT(s)
    {
        double a, c, h;
        any_coefficients(&s, &a, &c, &h);
        c = copysign(c, a);
        const dd q = two_prod(a, c);
        SAME_DD(quadratic_v_q(a, c), q, a, c);
        SAME(quadratic_v_f(h, a, c) < quadratic_v_q(a, c).lo, is_rootless(h, q),
             a, c, h);
        SAME(quadratic_v_discriminant(h, a, c), discriminant_of(h, q), a, c, h);
    }
}
END_TEST

START_TEST(any_discriminant_is_that_of_the_proof)
{
    EACH_INPUT(s)
    {
        double a, c, h;
        any_coefficients(&s, &a, &c, &h);
        const dd q = two_prod(a, c);
        SAME(quadratic_roots_v_discriminant_of(h, q), discriminant_of(h, q), a, c,
             h);
        SAME(quadratic_v_f(h, a, c) < quadratic_v_q(a, c).lo, is_rootless(h, q),
             a, c, h);
    }
}
END_TEST

/** Of any exponents, b^2 not far from a c, or not. */
static void any_at_all(stream *s, double *a, double *b, double *c)
{
    *a = stream_scaled(s, -1070, 1020);
    *c = stream_scaled(s, -1070, 1020);
    *b = stream_int(s, 0, 3) == 0
             ? stream_scaled(s, -1070, 1020)
             : sqrt(fabs(*a)) * sqrt(fabs(*c)) * stream_scaled(s, -20, 20);
}

START_TEST(what_is_rootless_is_what_the_proof_calls_so)
{
    EACH_INPUT(s)
    {
        double a, b, c;
        any_at_all(&s, &a, &b, &c);
        const double h = -0.5 * b;
        SAME(quadratic_rescued_v_half(b), h, b);
        SAME(quadratic_rescued_v_is_rootless(h, a, c),
             is_rootless(h, two_prod(a, c)), a, b, c);
    }
}
END_TEST

/** Of numbers near 1 ldexp is exact, and of a root it rounds once. */
START_TEST(what_is_rescued_is_as_the_proof_has_it)
{
    EACH_INPUT(s)
    {
        double a, b, c, x0 = 0, x1 = 0;
        any_at_all(&s, &a, &b, &c);
        if (a == 0 || c == 0 || isinf(b))
            continue;
        const int unit = (ilogb(c) - ilogb(a)) / 2;
        const balanced e = balance(a, b, c);
        SAME(unit, e.unit, a, b, c);
        SAME(ldexp(a, 2 * unit - ilogb(c)), e.a, a, b, c);
        SAME(ldexp(c, -ilogb(c)), e.c, a, b, c);
        ck_assert(0.5 <= fabs(e.a) && fabs(e.a) < 4);
        if (b == 0 || abs(e.b_exponent) >= 200)
            continue;
        SAME(ldexp(b, unit - ilogb(c)), e.b, a, b, c);
        const double h = -0.5 * e.b;
        const double d = quadratic_roots_v_discriminant_of(h, two_prod(e.a, e.c));
        const int count = roots_rescued(a, b, c, &x0, &x1);
        SAME(d < 0 ? 0 : 2, count, a, b, c);
        if (count == 2) {
            const double sum = quadratic_roots_v_sum_of(h, copysign(1, h), d);
            const double y0 = ldexp(sum / e.a, unit), y1 = ldexp(e.c / sum, unit);
            SAME(fmin(y0, y1), x0, a, b, c);
            SAME(fmax(y0, y1), x1, a, b, c);
        }
    }
}
END_TEST

/** The roots are s / a and c / s, in order. */
START_TEST(the_roots_are_those_of_the_proof)
{
    EACH_INPUT(s)
    {
        double a, c, h, x0 = 0, x1 = 0;
        any_coefficients(&s, &a, &c, &h);
        const double d = fabs(stream_scaled(&s, -500, 500));
        const double sum = quadratic_roots_v_sum_of(h, copysign(1, h), d);
        const double first = sum / a, second = c / sum;
        roots_of(a, c, h, d, &x0, &x1);
        SAME(fmin(first, second), x0, a, c, h, d);
        SAME(fmax(first, second), x1, a, c, h, d);
    }
}
END_TEST

/** What is told and what is not, and the roots; of h < 0 the mirror. */
START_TEST(the_told_roots_are_those_of_the_proof)
{
    EACH_INPUT(s)
    {
        double a, c, any, x0 = 0, x1 = 0;
        any_coefficients(&s, &a, &c, &any);
        const double h = fabs(any);
        const double d = quadratic_told_v_discriminant(h, a, c);
        if (!(d > 0))
            continue;
        const double sum = quadratic_told_sum_v_s_hi(h, d);
        const double more = quadratic_told_sum_v_s_lo(h, a, c, d);
        const two_lanes x = {quadratic_told_v_lower(c, sum),
                             quadratic_told_v_upper(a, sum)};
        const two_lanes y = {quadratic_told_v_lower_more(c, sum, more),
                             quadratic_told_v_upper_more(a, sum, more)};
        two_lanes root;
        const int count = lanes_are_told(x, y, &root) ? 2 : -1;
        SAME(count, roots_told(a, -2 * any, c, &x0, &x1), a, c, any);
        if (count == 2) {
            root *= (two_lanes){copysign(1, any), copysign(1, any)};
            SAME(fmin(root[0], root[1]), x0, a, c, any);
            SAME(fmax(root[0], root[1]), x1, a, c, any);
        }
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE("quadratic, transcribed", 120,
                     the_discriminant_of_one_sign_is_that_of_the_proof,
                     any_discriminant_is_that_of_the_proof,
                     what_is_rootless_is_what_the_proof_calls_so,
                     what_is_rescued_is_as_the_proof_has_it,
                     the_roots_are_those_of_the_proof,
                     the_told_roots_are_those_of_the_proof);
}
