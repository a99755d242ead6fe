// SPDX-License-Identifier: MIT
// What Coq is told quadratic.c does is what it does.
#include "transcribed/quadratic_roots_v.h"
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

int main(void)
{
    return RUN_SUITE("quadratic, transcribed", 120,
                     the_discriminant_of_one_sign_is_that_of_the_proof,
                     any_discriminant_is_that_of_the_proof,
                     the_roots_are_those_of_the_proof);
}
