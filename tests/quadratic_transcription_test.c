// SPDX-License-Identifier: MIT
// What Coq and Gappa are told quadratic.c does is what it does.
#include "transcribed/quadratic_one_sign_g.h"
#include "transcribed/quadratic_two_signs_g.h"
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

START_TEST(the_discriminant_of_two_signs_is_that_of_the_script)
{
    EACH_INPUT(s)
    {
        const double h = within(&s, quadratic_two_signs_g_h_range);
        const double a = stream_scaled(&s, -250, 250);
        const double c = copysign(stream_scaled(&s, -250, 250), -a);
        const dd q = two_prod(a, c);
        SAME(quadratic_two_signs_g_dr(h, (product){-a, c}), discriminant_of(h, q),
             a, c, h);
        SAME(quadratic_v_f(h, a, c) < quadratic_v_q(a, c).lo, is_rootless(h, q),
             a, c, h);
    }
}
END_TEST

/** The roots are s / a and c / s, in order, and with h < 0 their signs change. */
static void keep_roots(double a, double c, double h, double d, double s)
{
    double x0 = 0, x1 = 0;
    roots_of(a, c, h, d, &x0, &x1);
    const double larger_h = copysign(s, h), first = larger_h / a;
    const double second = c / larger_h;
    SAME(fmin(first, second), x0, a, c, h, d);
    SAME(fmax(first, second), x1, a, c, h, d);
}

START_TEST(the_roots_are_those_of_the_scripts)
{
    EACH_INPUT(s)
    {
        const double h =
            within(&s, quadratic_one_sign_g_h_range) * stream_sign(&s);
        const double d = within(&s, quadratic_one_sign_g_dr_range);
        const double a =
            within(&s, quadratic_one_sign_g_a_range) * stream_sign(&s);
        const double c = copysign(within(&s, quadratic_one_sign_g_c_range), a);
        keep_roots(a, c, h, d, quadratic_one_sign_g_s(fabs(h), d));
        keep_roots(-a, c, h, discriminant_of(h, two_prod(-a, c)),
                   quadratic_two_signs_g_s(fabs(h), (product){a, c}));
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE("quadratic, transcribed", 120,
                     the_discriminant_of_one_sign_is_that_of_the_proof,
                     the_discriminant_of_two_signs_is_that_of_the_script,
                     the_roots_are_those_of_the_scripts);
}
