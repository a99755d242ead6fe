#!/bin/sh
# SPDX-License-Identifier: MIT
# bench_check.sh ULP BENCH: both do what they say, on samples too small to tell much.
# shellcheck source=tests/shell.sh
. "$(dirname "$0")/shell.sh"
ulp=$1
bench=$2

expect 0 "$ulp"
grep -q '^  quadratic_roots_cr ' out || fail "a kernel is not listed"
grep -q ' grazing ' out || fail "a family is not listed"

expect 0 "$ulp" quadratic_roots benign 1000 1
grep -q '^quadratic_roots, benign: 1000 cases of seed 1$' out || fail "what was measured"
grep -q 'promised 3 ' out || fail "the bound is not told"
grep -q '^  wrong 0$' out || fail "wrong answers are not told"
[ "$(grep -c '^-\{0,1\}0x.* .*0x.* .*0x' out)" -eq 5 ] || fail "five worst cases"

expect 0 "$ulp" quadratic/textbook
for family in $("$ulp" | sed -n '/quadratic_roots_cr/,/^$/s/^  on //p'); do
    grep -q "quadratic/textbook, $family: .* cases of seed" out ||
        fail "family $family was not measured"
done
grep -q 'invented' out || fail "the textbook invents no root"

expect 2 "$ulp" no_such_kernel
said "there is no kernel no_such_kernel"
expect 2 "$ulp" quadratic_roots nonsense
said "there is no family nonsense"
for count in 0 -1 12x 1e9 999999999999999999999; do
    expect 2 "$ulp" quadratic_roots benign "$count"
    said "this is no count: $count"
done
expect 2 "$ulp" quadratic_roots benign 10 one
said "this is no seed: one"
expect 2 "$ulp" quadratic_roots benign 10 1 more

expect 0 "$bench" --out page --cases 20 --seconds 0.01
[ "$(cat out)" = page/kernels.html ] || fail "the page's place is not told"
[ "$(grep -c '<svg' page/kernels.html)" -ge 15 ] || fail "figures are missing"
! grep -E 'src=|href="http|<script|<link|@import' page/kernels.html ||
    fail "the page would load something"
! grep -Eq '>-?(nan|inf)<' page/kernels.html || fail "there is no number somewhere"
grep -q 'lines of which something was asked' page/kernels.html || fail "the speeds asked are missing"
sed -n '/What was asked/,$p' page/kernels.html >speeds
for family in $("$ulp" | sed -n '/^  intersection_time_fast/,/^$/s/^  on //p'); do
    [ "$(grep -c ">$family<" speeds)" -ge 2 ] || fail "$family is not timed for both _fast"
done

! grep -q undescribed page/kernels.html || fail "a family is not described"

for options in --cases '--cases 0' '--cases x' '--nonsense 1' nonsense; do
    # shellcheck disable=SC2086
    expect 2 "$bench" $options
    said "usage: bench"
done
finish
