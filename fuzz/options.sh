#!/bin/sh
# SPDX-License-Identifier: MIT
# usage: options.sh libfuzzer|afl TARGET
#
# What an engine is told of a target, as words of its command line: how long a case may
# be, which TARGET_fuzz.options says in OSS-Fuzz's form, or else 256 bytes; and its
# dictionary, if it has one.
set -eu
options=fuzz/$2_fuzz.options
dictionary=fuzz/$2_fuzz.dict
longest=256
[ ! -f "$options" ] || longest=$(sed -n 's/^max_len = //p' "$options")
case $1 in
libfuzzer)
    # Of any length from the beginning: the first bytes choose what the rest is for.  A
    # minute is a hang; ten seconds, libFuzzer's "slow", were a run of a tenth of one on a
    # busy machine.
    echo "-max_len=$longest -len_control=0 -timeout=60 -report_slow_units=60" \
        -rss_limit_mb=2048
    [ ! -f "$dictionary" ] || echo "-dict=$dictionary"
    ;;
afl)
    # Its second is as little of a processor, and one such seed would end the campaign: +
    # leaves it out.
    echo "-G $longest -t 10000+"
    [ ! -f "$dictionary" ] || echo "-x $dictionary"
    ;;
esac
