#!/bin/sh
# SPDX-License-Identifier: MIT
# usage: consumer.sh SOURCE FOLDER CC ON|OFF
# Installs the library alone, shared or static, to a fresh prefix in FOLDER; looks at what
# it exports, needs and keeps; builds tests/consumer against it, by find_package and by
# pkg-config; then the README's example, which must print what the README says, and every
# installed header by itself.
set -eu
source=$1 folder=$2 cc=$3 shared=$4
fail() {
    echo "$*" >&2
    exit 1
}
rm -rf "$folder"
mkdir -p "$folder"
prefix=$folder/prefix

cmake -G Ninja -S "$source" -B "$folder/library" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_C_COMPILER="$cc" -DCMAKE_INSTALL_PREFIX="$prefix" \
    -DBUILD_SHARED_LIBS="$shared" -DBRINK_SIMULATOR=OFF -DBRINK_TESTS=OFF >/dev/null
cmake --build "$folder/library" >/dev/null
cmake --install "$folder/library" >/dev/null

echo "the library's symbols:"
built=$(find "$folder/library/kernels" -name 'libbrink.a' -o -name 'libbrink.so.*.*')
[ "$shared" = ON ] && dynamic=-D || dynamic=
# shellcheck disable=SC2086 # a flag or nothing
foreign=$(nm $dynamic --defined-only "$built" |
    awk 'NF == 3 && $2 ~ /[A-Z]/ && $3 !~ /^brink_/')
[ -z "$foreign" ] || fail "exported without brink_: $foreign"
allocating=$(nm -u "$built" | grep -wE '(m|c|re|aligned_)alloc|free|mmap|s?brk' || true)
[ -z "$allocating" ] || fail "allocates: $allocating"
state=$(objdump -t "$built" |
    awk 'NF > 3 && $(NF - 2) ~ /^(\.data|\.bss|\*COM\*)$/ && $NF !~ /^(\.|_|completed)/')
[ -z "$state" ] || fail "global state: $state"
echo 'int main(void) { return 0; }' >"$folder/main.c"
"$cc" "$folder/main.c" -o "$folder/whole" \
    -Wl,--no-undefined -Wl,--whole-archive "$built" -Wl,--no-whole-archive -lm ||
    fail "needs more than libm"

echo "by find_package:"
cmake -G Ninja -S "$source/tests/consumer" -B "$folder/consumer" \
    -DCMAKE_C_COMPILER="$cc" -DCMAKE_PREFIX_PATH="$prefix" >/dev/null
cmake --build "$folder/consumer" >/dev/null
"$folder/consumer/consumer"

echo "by pkg-config:"
pc=$(find "$prefix" -name brink.pc)
library=$(dirname "$(dirname "$pc")")
PKG_CONFIG_PATH=$(dirname "$pc")
export PKG_CONFIG_PATH
[ "$shared" = ON ] && static='' || static=--static
# shellcheck disable=SC2046,SC2086 # lists of flags, and a flag or nothing
"$cc" -std=c17 "$source/tests/consumer/consumer.c" -o "$folder/by-pkg-config" \
    $(pkg-config $static --cflags --libs brink)
LD_LIBRARY_PATH=$library "$folder/by-pkg-config"

echo "the README's example:"
block() { # block KIND: the README's lines between ```KIND and ```
    awk -v kind="$1" 'index($0, "```") == 1 { on = $0 == "```" kind; next } on' \
        "$source/README.md"
}
block c >"$folder/example.c"
block text >"$folder/expected"
# shellcheck disable=SC2046,SC2086
"$cc" -std=c17 "$folder/example.c" -o "$folder/example" \
    $(pkg-config $static --cflags --libs brink)
LD_LIBRARY_PATH=$library "$folder/example" >"$folder/printed"
diff "$folder/expected" "$folder/printed"

echo "every header by itself, as C and as C++:"
for header in "$prefix"/include/brink/*.h; do
    # shellcheck disable=SC2046
    for compiler in "$cc -std=c17 -x c" "c++ -x c++"; do
        echo "#include <brink/$(basename "$header")>" |
            $compiler -Wall -Werror -fsyntax-only $(pkg-config --cflags brink) -
    done
done
