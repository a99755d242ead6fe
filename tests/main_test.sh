#!/bin/sh
# SPDX-License-Identifier: MIT
# The command line: what it takes, what it refuses, and its exit codes.
# shellcheck source=tests/shell.sh
. "$(dirname "$0")/shell.sh"

expect 0 "$brink" --version
grep -q '^brink [0-9]' out || fail "--version does not name the version"
expect 0 "$brink" --help
for word in run resume check study --events-per-particle --events --time --seed --tier \
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

for scene in "$scenes"/*.yaml; do
    expect 0 "$brink" check "$scene"
    grep -q 'a good scene' out || fail "$scene is not called good"
done
finish
