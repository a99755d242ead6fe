#!/bin/sh
# SPDX-License-Identifier: MIT
# instructions.sh BENCH: the instructions a call of every kernel and rival takes, one a
# line behind its name.  BENCH has each of them dump its count under "name calls".
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
valgrind --tool=callgrind --collect-atstart=no --callgrind-out-file="$folder/count" \
    "$1" count >"$folder/said" 2>&1 || {
    cat "$folder/said" >&2
    exit 1
}
for dump in "$folder"/count.*; do
    sed -n -e 's/^desc: Trigger: Client Request: //p' -e 's/^summary: //p' "$dump" |
        tr '\n' ' '
    echo
done | awk 'NF == 3 { printf "%s %.1f\n", $1, $3 / $2 }'
