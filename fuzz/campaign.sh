#!/bin/sh
# SPDX-License-Identifier: MIT
# usage: campaign.sh libfuzzer|afl PROGRAMS TARGET SECONDS JOBS
#
# One target for so long, by so many processes at once; see fuzz.sh.
set -eu
engine=$1 programs=$2 target=$3 seconds=$4 jobs=$5
program=$programs/${target}_fuzz
kept=fuzz/corpora/$target
pool=${BRINK_CORPORA:-build/corpora}/$target
findings=build/findings
log=build/findings/log/$target.$engine
mkdir -p "$kept" "$pool" "$findings/log"

room=65536 # bytes of fuzz/corpora that one target may have
options=$(sh fuzz/options.sh "$engine" "$target") # words, to be split

by_libfuzzer() {
    set -- -print_final_stats=1 -artifact_prefix="$findings/$target-" "$pool" "$kept"
    [ "$jobs" -le 1 ] || set -- -fork="$jobs" "$@"
    # shellcheck disable=SC2086
    "$program" $options -max_total_time="$seconds" "$@" >"$log" 2>&1 || say_finding
}

# One main, the rest secondaries, all in one folder; pool and seeds as in libFuzzer.
by_afl() {
    queues=build/afl-queues/$target
    mkdir -p "$queues/seeds"
    find "$kept" "$pool" -type f -exec cp {} "$queues/seeds" \;
    [ -n "$(ls "$queues/seeds")" ] || echo brink >"$queues/seeds/brink"
    export AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_NO_UI=1 \
        AFL_NO_AFFINITY=1 AFL_AUTORESUME=1
    # shellcheck disable=SC2086
    set -- -i "$queues/seeds" -o "$queues" -V "$seconds" $options
    job=1
    while [ "$job" -lt "$jobs" ]; do
        afl-fuzz -S "secondary$job" "$@" -- "$program" >"$log.$job" 2>&1 &
        job=$((job + 1))
    done
    afl-fuzz -M main "$@" -- "$program" >"$log" 2>&1 || true
    wait
    for input in "$queues"/*/queue/id:*; do
        [ -f "$input" ] && cp "$input" "$pool/$(sha1sum <"$input" | cut -c1-40)"
    done
    for input in "$queues"/*/crashes/id:* "$queues"/*/hangs/id:*; do
        [ -f "$input" ] || continue
        cp "$input" "$findings/$target-$(sha1sum <"$input" | cut -c1-40)"
        "$program" "$input" >>"$log" 2>&1 || say_finding
    done
}

say_finding() {
    echo "fuzz: $target, see $log" >&2
    grep -A12 -E '^finding:|ERROR:|runtime error' "$log" | head -n 40 >&2 || true
}

# The corpus becomes as few files as run everything that it and the pool do; where that is
# more than there is room for, the smallest.  Findings of the past stay.
keep_best() {
    cover=$(mktemp -d)
    # shellcheck disable=SC2086
    if "$program" $options -set_cover_merge=1 -use_counters=0 "$cover" "$kept" "$pool" \
        >>"$log" 2>&1; then
        find "$kept" -type f ! -name 'found-*' -delete
        find "$cover" -type f -printf '%s %p\n' | sort -n |
            awk -v room="$room" '{ n += $1; if (n <= room) print $2 }' | xargs -r cp -t "$kept"
    fi
    rm -r "$cover"
}

# How many cases were tried, as the engines' own notes have it.
cases() {
    case $engine in
    libfuzzer) grep -oE '^#[0-9]+' "$log" | tr -d '#' | sort -n | tail -n 1 ;;
    afl) sed -n 's/^execs_done *: //p' "build/afl-queues/$target"/*/fuzzer_stats |
        awk '{ n += $1 } END { print n }' ;;
    esac
}

"by_$engine"
tried=$(cases)
[ "$engine" != libfuzzer ] || keep_best
echo "fuzz: $target: $tried cases"
