// SPDX-License-Identifier: MIT
#include "study_words.h"
#include "suite.h"
#include <math.h>

#define NARROW "\u202f"

START_TEST(digits_are_grouped_by_threes_from_the_right)
{
    ck_assert_str_eq(brink_words_grouped(0).text, "0");
    ck_assert_str_eq(brink_words_grouped(999).text, "999");
    ck_assert_str_eq(brink_words_grouped(1000).text, "1" NARROW "000");
    ck_assert_str_eq(brink_words_grouped(686000).text, "686" NARROW "000");
    ck_assert_str_eq(brink_words_grouped(UINT64_MAX).text,
                     "18" NARROW "446" NARROW "744" NARROW "073" NARROW
                     "709" NARROW "551" NARROW "615");
}
END_TEST

START_TEST(powers_of_ten_are_raised)
{
    ck_assert_str_eq(brink_words_scientific(1.4e-7).text, "1.4\u00a0×\u00a010⁻⁷");
    ck_assert_str_eq(brink_words_scientific(-2.5e120).text,
                     "-2.5\u00a0×\u00a010¹²⁰");
    ck_assert_str_eq(brink_words_scientific(3).text, "3.0\u00a0×\u00a010⁰");
    ck_assert_str_eq(brink_words_scientific(0x1p-1074).text,
                     "4.9\u00a0×\u00a010⁻³²⁴");
}
END_TEST

START_TEST(a_mantissa_that_rounds_to_ten_is_carried)
{
    ck_assert_str_eq(brink_words_scientific(9.96e-8).text,
                     "1.0\u00a0×\u00a010⁻⁷");
    ck_assert_str_eq(brink_words_scientific(9.94e-8).text,
                     "9.9\u00a0×\u00a010⁻⁸");
    ck_assert_str_eq(brink_words_scientific(1e-10).text, "1.0\u00a0×\u00a010⁻¹⁰");
}
END_TEST

START_TEST(what_has_no_exponent_is_left_as_it_is)
{
    ck_assert_str_eq(brink_words_scientific(0).text, "0");
    ck_assert_str_eq(brink_words_scientific((double)INFINITY).text, "inf");
}
END_TEST

START_TEST(a_frequency_has_its_counting_error_or_a_bound)
{
    ck_assert_str_eq(brink_words_frequency(400, 1000).text, "0.4000 ± 0.0200");
    // -ln 0.05 / 1000 = 0.0029957
    ck_assert_str_eq(brink_words_frequency(0, 1000).text,
                     "< 3.0\u00a0×\u00a010⁻³");
    ck_assert_str_eq(brink_words_frequency(0, 0).text, "–");
    ck_assert_str_eq(brink_words_frequency(45, 320000000).text,
                     "(1.41 ± 0.21)\u00a0×\u00a010⁻⁷");
}
END_TEST

START_TEST(a_slug_has_nothing_that_a_shell_or_gnuplot_minds)
{
    ck_assert_str_eq(brink_words_slug("algorithm 2").text, "algorithm-2");
    ck_assert_str_eq(brink_words_slug("a'b\"c/../$d").text, "a-b-c-----d");
    ck_assert_str_eq(brink_words_slug("σ").text, "--");
}
END_TEST

START_TEST(a_slug_of_a_long_text_is_its_beginning)
{
    char text[200] = "";
    for (int k = 0; k < 199; k++)
        text[k] = 'a';
    const brink_words slug = brink_words_slug(text);
    ck_assert_uint_eq(strlen(slug.text), sizeof slug.text - 1);
}
END_TEST

int main(void)
{
    return RUN_SUITE("words", 60, digits_are_grouped_by_threes_from_the_right,
                     powers_of_ten_are_raised,
                     a_mantissa_that_rounds_to_ten_is_carried,
                     what_has_no_exponent_is_left_as_it_is,
                     a_frequency_has_its_counting_error_or_a_bound,
                     a_slug_has_nothing_that_a_shell_or_gnuplot_minds,
                     a_slug_of_a_long_text_is_its_beginning);
}
