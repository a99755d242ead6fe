#!/bin/sh
# SPDX-License-Identifier: MIT
# simulator_counts.sh COUNTER SOURCE [PARTICLES]: what an event takes of either simulator,
# one fact a line: "SYSTEM WHO pairs NUMBER" and "SYSTEM WHO instructions NUMBER", and of
# brink's functions the five with most instructions of their own, "SYSTEM brink PERCENT
# NAME FILE", FILE "-" where the tree has none or several of that name.
set -eu
counter=$1
source=$2
shift 2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Compilers add to the name of a function they have cut or copied, and the build adds the
# path to one compiled for several.
file_of() {
    bare=$(echo "${1%%.*}" | sed -E 's/_(any|fma|avx512)$//')
    found=$(cd "$source" && grep -lE "^(static |const )*[a-z_0-9]+( [a-z_0-9]+)* \*?(${1%%.*}|$bare)\(" \
        sim/*.c kernels/*.c kernels/*.h) || found=
    if [ "$(echo "$found" | wc -w)" -eq 1 ]; then echo "$found"; else echo -; fi
}

valgrind --tool=callgrind --instr-atstart=no --callgrind-out-file="$folder/count" \
    "$counter" "$@" 2>"$folder/said" || {
    cat "$folder/said" >&2
    exit 1
}
for dump in "$folder"/count.*; do
    # shellcheck disable=SC2046 # three words
    set -- $(sed -n 's/^desc: Trigger: Client Request: //p' "$dump")
    [ $# -eq 3 ] || continue
    awk -v is="$1 $2 instructions" -v events="$3" \
        '/^totals:/ { printf "%s %.1f\n", is, $2 / events }' "$dump"
    [ "$2" = brink ] || continue
    callgrind_annotate "$dump" | sed -nE \
        's/^ *[0-9,]+ \( *([0-9.]+)%\) +[^:]*:([^ ]+).*/\1 \2/p' | sed 5q |
        while read -r percent function; do
            echo "$1 $2 $percent $function $(file_of "$function")"
        done
done
