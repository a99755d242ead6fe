#!/bin/sh
# SPDX-License-Identifier: MIT
# The command line: what it takes, what it refuses, and its exit codes.
# shellcheck source=tests/shell.sh
. "$(dirname "$0")/shell.sh"

expect 0 "$brink" --version
grep -q '^brink [0-9]' out || fail "--version does not name the version"
expect 0 "$brink" --help
for word in run resume check study explain --event --pair --events-per-particle --events --time --seed --tier \
    --max-wall --out 'exit codes'; do
    grep -qF -- "$word" out || fail "--help does not tell of $word"
done

expect 2 "$brink"
said 'a command is needed'
expect 2 "$brink" rum
said 'there is no command rum'
expect 2 "$brink" run
said 'takes one scene'
expect 2 "$brink" run a.yaml b.yaml
said 'takes one scene'
expect 2 "$brink" run --event 5 a.yaml
said 'has no option --event'
expect 2 "$brink" run a.yaml --events
said '--events needs a value'
expect 2 "$brink" run a.yaml --events 1e3
said '--events takes a whole number'
expect 2 "$brink" run a.yaml --events 5 --time 3
said 'one target'
expect 2 "$brink" run a.yaml --time nan
said '--time takes a positive number'
expect 2 "$brink" run a.yaml --tier slow
said '--tier is fast, plain or cr, not slow'
expect 2 "$brink" run a.yaml --seed 4294967296
said '--seed is below 2^32'
expect 2 "$brink" resume a --seed 3
said 'has no option --seed'
expect 2 "$brink" check nowhere.yaml
said 'nowhere.yaml'

expect 2 "$brink" explain a.yaml
said 'explain needs --event N'
expect 2 "$brink" explain a.yaml --event 0
said '--event counts from 1, not 0'
expect 2 "$brink" explain a.yaml --event 1e3
said '--event takes a whole number'
for pair in 3 3,3 3,4294967296 111111111111111111111111,3; do
    expect 2 "$brink" explain a.yaml --event 1 --pair "$pair"
    said "--pair takes two particles, as 3,14, not $pair"
done
expect 2 "$brink" explain a.yaml --event 1 --pair 3,b
said '--pair takes a whole number'
expect 2 "$brink" explain a.yaml --event 1 --time 3
said 'has no option --time'
expect 2 "$brink" explain nowhere.yaml --event 1
said 'nowhere.yaml'

# An event of a scene, and the same one of a run of it; and a pair.
expect 0 "$brink" run "$scenes/discs-well.yaml" --events 300 --seed 5 --out well
expect 0 "$brink" explain well --event 300
grep -q 'the run did the same  *yes, to the bit' out || fail "the run did otherwise"
sed -n '/^the pair/,$p' out >one.txt
expect 0 "$brink" explain "$scenes/discs-well.yaml" --event 300 --seed 5
sed -n '/^the pair/,$p' out >other.txt
cmp one.txt other.txt || fail "a folder and its scene have different events"
expect 0 "$brink" explain well --event 300 --pair 3,14
grep -q '1: 3, of species A' out || fail "no pair 3, 14"
expect 2 "$brink" explain well --event 301
said 'beyond the end of the run, whose target is 300 events'
expect 2 "$brink" explain well --event 300 --tier cr
said 'this run has its seed and its tier'

for scene in "$scenes"/*.yaml; do
    expect 0 "$brink" check "$scene"
    grep -q 'a good scene' out || fail "$scene is not called good"
done
finish
