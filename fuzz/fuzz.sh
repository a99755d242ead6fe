#!/bin/sh
# SPDX-License-Identifier: MIT
# usage: fuzz.sh libfuzzer|afl [MINUTES] [TARGET...]
#
# A campaign over the targets, all of them by default, of so many minutes in all, 10 by
# default, on every core.  What is found on the way is kept in build/corpora/TARGET, for
# the next campaign to start from, whichever the engine; a target's corpus in fuzz/corpora
# becomes the few files of both that run all they do.  A finding is printed, its input left
# in build/findings; status 1.
#
# BRINK_CORPORA names another folder for build/corpora: one that several machines share.
set -eu
cd "$(dirname "$0")/.."
engine=$1
shift
minutes=10
case ${1-} in
[0-9]*)
    minutes=$1
    shift
    ;;
esac
# shellcheck disable=SC2046 # a list of words
[ $# -gt 0 ] || set -- $(echo fuzz/*_fuzz.c | sed 's|fuzz/||g; s|_fuzz\.c||g')

case $engine in
libfuzzer) preset=fuzz ;;
afl) preset=afl ;;
*) sed -n '3,13s/^# \{0,1\}//p' "$0" >&2 && exit 2 ;;
esac
programs=build/$preset/fuzz
cores=$(nproc)
jobs=$((cores > $# ? cores / $# : 1)) # a target, where there are more cores than targets
seconds=$(echo "$minutes" $# "$cores" | awk '{
    at_once = $2 < $3 ? $2 : $3; printf "%d", $1 * 60 * at_once / $2 }')
[ "$seconds" -gt 0 ] || seconds=1

for target in "$@"; do
    [ -f "fuzz/${target}_fuzz.c" ] || {
        echo "fuzz: there is no fuzz/${target}_fuzz.c; the targets are" \
            "$(echo fuzz/*_fuzz.c | sed 's|fuzz/||g; s|_fuzz\.c||g')" >&2
        exit 2
    }
done
cmake --preset "$preset" -DBRINK_TESTS=ON >/dev/null
# shellcheck disable=SC2046 # a list of words
cmake --build "build/$preset" --target $(printf '%s_fuzz ' "$@")

echo "fuzz: $# targets by $engine, $seconds s each, $jobs of $cores cores"
printf '%s\n' "$@" | xargs -P "$cores" -I TARGET \
    sh fuzz/campaign.sh "$engine" "$programs" TARGET "$seconds" "$jobs" || true

found=0
for input in build/findings/*; do
    [ -f "$input" ] && found=$((found + 1)) && echo "fuzz: a finding: $input"
done
echo "fuzz: $# targets, $found findings"
[ "$found" -eq 0 ]
