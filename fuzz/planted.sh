#!/bin/sh
# SPDX-License-Identifier: MIT
# usage: planted.sh [NN...]
#
# Plants the faults of fuzz/planted, all or those so numbered, one at a time in a copy of
# the tree, and lets the target that each names look for it, from nothing, on one core.
# A line a fault: the seconds it took, or that it survived 60 of them; status 1 if one did.
set -eu
cd "$(dirname "$0")/.."
most=60
seed=1
tree=build/planted/tree
build=build/planted/build
log=build/planted/log
mkdir -p "$log"
# shellcheck disable=SC2046 # a list of words
[ $# -gt 0 ] || set -- $(echo fuzz/planted/*.patch | sed 's|fuzz/planted/\([0-9]*\)-[^ ]*|\1|g')

# A copy that keeps the times of what has not changed: ninja builds what a fault touches.
mkdir -p "$tree"
git ls-files | while read -r file; do
    cmp -s "$file" "$tree/$file" || {
        mkdir -p "$tree/$(dirname "$file")"
        cp "$file" "$tree/$file"
    }
done
cmake -S "$tree" --preset fuzz -B "$build" -DBRINK_TESTS=ON >/dev/null

plant() { patch -s -d "$tree" -p1 "$@" <"$fault"; }

survived=0
for number in "$@"; do
    fault=$(echo fuzz/planted/"$number"-*.patch)
    name=$(basename "$fault" .patch)
    target=$(sed -n 's/^target: //p' "$fault")
    plant
    cmake --build "$build" --target "$target" >"$log/$name" 2>&1 || {
        plant -R
        echo "$name: does not build: see $log/$name"
        exit 1
    }
    options=$(sh fuzz/options.sh libfuzzer "${target%_fuzz}")
    begun=$(date +%s.%N)
    # shellcheck disable=SC2086 # words, to be split
    if "$build/fuzz/$target" $options -seed=$seed -max_total_time=$most \
        -artifact_prefix="$log/$name-" >>"$log/$name" 2>&1; then
        survived=$((survived + 1))
        echo "$name: SURVIVED $most s of $target"
    else
        echo "$begun $(date +%s.%N) $name $target" |
            awk '{ printf "%s: found in %.1f s by %s\n", $3, $2 - $1, $4 }'
    fi
    plant -R
done
echo "planted: $survived survived"
[ "$survived" -eq 0 ]
