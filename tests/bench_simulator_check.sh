#!/bin/sh
# SPDX-License-Identifier: MIT
# bench_simulator_check.sh BENCH COUNTER: the page is made, from systems too small to
# tell much.
# shellcheck source=tests/shell.sh
. "$(dirname "$0")/shell.sh"
bench=$1
counter=$2

# Pairs are counted without callgrind too.
expect 0 "$counter" 500
[ "$(grep -cE '^[a-z0-9.-]+ (brink|plain) pairs [0-9.]+$' out)" -eq 10 ] ||
    fail "pairs of both in five systems"
! grep -q ' pairs 0\.00$' out || fail "no pair was counted somewhere"
cp out counts
cat >>counts <<'END'
well-3 brink instructions 16538.4
well-3 plain instructions 22617.7
well-3 brink 17.14 <brink_predict> sim/run_predict.c
well-3 brink 9.5 meet -
END

page=page/simulator.html
expect 0 "$bench" simulator --out page --particles 500 --seconds 0.001 \
    --instructions counts
[ "$(cat out)" = "$page" ] || fail "the page's place is not told"
[ "$(grep -c '<svg' $page)" -eq 2 ] || fail "figures are missing"
# By name, by size, and where memory is told.
[ "$(grep -c '>500</t[dh]>' $page)" -eq 17 ] || fail "systems are missing"
grep -q '&lt;brink_predict&gt;' $page || fail "the functions are missing"
grep -q '>16[^<]*500</td>' $page || fail "the instructions are missing"
grep -q 'times as many events' $page || fail "what came of it is not said"
[ "$(grep -c '>32[^<]*000</td>.*>650[^<]*000</td>' $page)" -eq 2 ] ||
    fail "what was asked is missing"
! grep -E 'src=|href="http|<script|<link|@import' $page ||
    fail "the page would load something"
! grep -Eq '>-?(nan|inf)' $page || fail "there is no number somewhere"

expect 0 "$bench" simulator --out page --particles 500 --seconds 0.001
! grep -Eq '>-?(nan|inf)' $page || fail "what was not counted is no number"

for options in --particles '--particles 0' '--seconds x' '--cases 5' nonsense; do
    # shellcheck disable=SC2086
    expect 2 "$bench" simulator $options
    said "usage: bench"
done
finish
