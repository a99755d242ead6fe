#!/bin/sh
# SPDX-License-Identifier: MIT
# What the tests run of kernels/ and sim/, and what they do not; the fuzzers' corpora
# with them, where there are any.  `./run coverage` installs what this needs and calls
# it.  Status 1 where it is less than tests/coverage.py asks for.
set -eu
cd "$(dirname "$0")/.."
build=build/coverage
here=$PWD/$build/profile

cmake --preset coverage -DBRINK_TESTS=ON >/dev/null
cmake --build --preset coverage
rm -rf "$here"
mkdir -p "$here"

# %c: counters are in the file itself, all the time, so that those of a process that is
# killed are there as well.  %p: a file a process, shared by those that it forks.  These
# count all on one processor, where adding one, an instruction, has nothing in between:
# counting that is safe on two takes ten times as long.
export LLVM_PROFILE_FILE="$here/%c%p.profraw"
processor=$(taskset -cp $$ | sed 's/.*: //; s/[-,].*//')
export BRINK_TEST_SHARE="${BRINK_TEST_SHARE-0.1}"
failed=0
# Not those that build for themselves, or measure.
taskset -c "$processor" ctest --test-dir $build --output-on-failure \
    -E '^(golden|consumer.*|bench_.*|house_check|trajectory_check)$' || failed=1
for fuzz in "$build"/fuzz/*_fuzz; do
    name=$(basename "$fuzz" _fuzz)
    if [ -x "$fuzz" ] && [ -d "fuzz/corpora/$name" ]; then
        find "fuzz/corpora/$name" -type f -exec "$fuzz" {} + >/dev/null || failed=1
    fi
done

llvm-profdata-14 merge -sparse "$here"/*.profraw -o $build/all.profdata
set -- $build/sim/brink
for program in "$build"/tests/*_test "$build"/fuzz/*_fuzz; do
    [ ! -x "$program" ] || set -- "$@" -object "$program"
done
llvm-cov-14 export -format=text -instr-profile $build/all.profdata "$@" \
    -ignore-filename-regex='/(tests|fuzz)/' >$build/export.json
llvm-cov-14 show -format=html -output-dir $build/html -show-branches=count \
    -instr-profile $build/all.profdata "$@" -ignore-filename-regex='/(tests|fuzz)/'
python3 tests/coverage.py . $build/export.json || failed=1
echo "$build/html/index.html"
exit $failed
