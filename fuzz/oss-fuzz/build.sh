#!/bin/bash -eu
# SPDX-License-Identifier: MIT
# Called by OSS-Fuzz in the source, with CC, CFLAGS, LIB_FUZZING_ENGINE, WORK and OUT.
# Flags of the engine and the sanitizers are its own, so BRINK_SANITIZE stays off.
# shellcheck disable=SC2016 # $ORIGIN is the loader's
cmake -S . -B "$WORK/build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    -DBRINK_TESTS=ON -DBRINK_FUZZ="$LIB_FUZZING_ENGINE" \
    -DCMAKE_BUILD_RPATH='$ORIGIN/lib' -DCMAKE_BUILD_RPATH_USE_ORIGIN=ON
cmake --build "$WORK/build" --target fuzz_targets

mkdir -p "$OUT/lib"
cp fuzz/*_fuzz.options fuzz/*_fuzz.dict "$OUT/"
for program in "$WORK"/build/fuzz/*_fuzz; do
    room=$(basename "$program" _fuzz)
    cp "$program" "$OUT/"
    [ ! -d "fuzz/corpora/$room" ] ||
        zip -q -j "$OUT/${room}_fuzz_seed_corpus.zip" "fuzz/corpora/$room"/*
    # What the machine that runs it may lack; the C library it has.
    ldd "$program" | awk '/=> \// && !/lib(c|m|dl|rt|pthread)\.so/ { print $3 }' |
        xargs -r cp -n -t "$OUT/lib"
done
