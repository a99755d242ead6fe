#!/bin/sh
# SPDX-License-Identifier: MIT
# Everything that is checked, one step after the other; a step that fails does not keep
# the rest from running.  `./run test` installs what this needs and calls it.
# Last line: N passed, N failed, counting steps here and tests of every suite.
set -u
cd "$(dirname "$0")/.." || exit 1
passed=0
failed=0

step() { # step NAME COMMAND...
    echo "== $1"
    shift
    if "$@"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "** failed: $*"
    fi
}

build() { # build PRESET [FOLDER CONFIGURE-OPTION...]
    preset=$1
    folder=build/${2:-$preset}
    shift $(($# > 1 ? 2 : 1))
    cmake --preset "$preset" -B "$folder" -DBRINK_TESTS=ON "$@" >/dev/null &&
        cmake --build "$folder"
}

suite() { # suite PRESET: its tests, counted one by one
    echo "== suite, $1"
    log=build/$1/suite.txt
    ctest --preset "$1" -j "$(nproc)" --output-log "$log"
    counts=$(sed -n 's/.*, \([0-9]*\) tests failed out of \([0-9]*\)$/\1 \2/p' "$log")
    bad=${counts%% *}
    all=${counts##* }
    failed=$((failed + ${bad:-1}))
    passed=$((passed + ${all:-0} - ${bad:-0}))
}

formatted() {
    git ls-files '*.[ch]' | xargs clang-format-14 --dry-run -Werror
}

linted() { # the checks and their exceptions: .clang-tidy
    run-clang-tidy-14 -quiet -p build/dev-clang "$PWD/(kernels|sim|tests|fuzz)/" \
        >build/tidy.txt 2>/dev/null || {
        grep -A4 -E '(warning|error):' build/tidy.txt
        return 1
    }
}

step "build, release" build release
step "build, gcc, warnings are errors" build dev
step "build, clang, warnings are errors" build dev dev-clang -DCMAKE_C_COMPILER=clang-14
step "build, sanitizers" build asan
suite release
suite asan
step "clang-format" formatted
step "clang-tidy" linted
step "shellcheck" sh -c "git ls-files run .ci/run '*.sh' | xargs shellcheck"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
