#!/bin/sh
# SPDX-License-Identifier: MIT
# usage: golden.sh SOURCE FOLDER
# The same scene gives the same bits whoever compiles it and how: golden.c, built in
# FOLDER by gcc and clang, optimised and not, prints what golden.txt says.
set -eu
source=$1 folder=$2
status=0

golden() { # golden NAME COMPILER FLAGS
    name=$1 cc=$2 flags=$3
    if ! command -v "$cc" >/dev/null; then
        echo "$name: skipped, there is no $cc"
        return
    fi
    build=$folder/$name
    cmake -G Ninja -S "$source" -B "$build" -DCMAKE_C_COMPILER="$cc" \
        -DCMAKE_BUILD_TYPE=None -DCMAKE_C_FLAGS="$flags" -DBRINK_TESTS=OFF >/dev/null
    cmake --build "$build" --target brinksim >/dev/null
    # shellcheck disable=SC2046,SC2086 # lists of flags
    "$cc" $flags -std=c17 -D_POSIX_C_SOURCE=200809L -ffp-contract=off \
        -I"$build/include" -I"$source/sim" \
        "$source/tests/golden.c" "$source/tests/systems.c" -o "$build/golden" \
        "$build/sim/libbrinksim.a" "$build/kernels/libbrink.a" \
        $(pkg-config --cflags --libs check gsl yaml-0.1) -lm
    "$build/golden" >"$build/golden.txt"
    if diff "$source/tests/golden.txt" "$build/golden.txt"; then
        echo "$name: as committed"
    else
        echo "$name: differs from tests/golden.txt"
        status=1
    fi
}

golden gcc-O0 gcc -O0
golden gcc-O2 gcc -O2
golden gcc-O3-native gcc "-O3 -march=native"
golden clang-O0 clang-14 -O0
golden clang-O2 clang-14 -O2
exit $status
