# SPDX-License-Identifier: MIT
# What the tests of the program in shell share:  . shell.sh PROGRAM SCENES
# shellcheck shell=sh disable=SC2034
brink=$1
scenes=$2
failures=0
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1

fail() {
    echo "FAILED: $*" >&2
    failures=$((failures + 1))
}

# expect CODE COMMAND...: runs it, standard error to ./err, standard output to ./out.
expect() {
    code=$1
    shift
    "$@" >out 2>err
    got=$?
    [ "$got" -eq "$code" ] || {
        fail "exit $got, not $code: $*"
        cat err >&2
    }
}

# said TEXT: the last command's standard error has it.
said() {
    grep -qF -- "$1" err || {
        fail "'$1' was not said, but:"
        cat err >&2
    }
}

finish() {
    echo "$failures failures"
    [ "$failures" -eq 0 ]
}
