#!/usr/bin/env bash
# The C library of a release as a stranger uses it, unpacked into an empty folder: the sample found by CMake, ten thousand kicks and a match with the bits of C#, hostile calls, the header in C++, what is exported,
# the wheel for Python, installed into a fresh environment, the kick in Rust, the extension for Godot in a stand-in for the engine, and the games in LÖVE and pygame, each with a picture.
#   tests/native.sh [CALLS]       hostile calls; default 1 000 000
# Needs clang or gcc, g++, CMake, Rust, and Debian's bindgen, python3-numpy, python3-venv, python3-pygame, love, xvfb and xauth.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
calls=${1:-1000000}
# 320 KiB above 5 MiB: the order-8 pieces of custom forces, the live filter, and the outputs of impacts.
most_kib=5440

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
log=$work/log

fail() {
  echo "FAIL  $1" >&2
  [[ -s $log ]] && tail -n 20 "$log" >&2
  exit 1
}

ok() { echo "ok    $1"; : > "$log"; }

quietly() {
  local what=$1
  shift
  "$@" > "$log" 2>&1 || fail "$what"
}

# page SECTION: runs the blocks of a section of a page exactly as printed, in that folder.
# shellcheck source=artefacts.sh
source tests/artefacts.sh
# Only the samples are there, and the artefacts: no sources of the library.
mkdir -p "$work/clone/out/wheel"
git ls-files -z -co --exclude-standard -- samples | while IFS= read -r -d '' file; do [[ ! -e $file ]] || printf '%s\0' "$file"; done | xargs -0 cp --parents -t "$work/clone"
page() { (cd "$work/clone" && "$root/tests/blocks.py" run "$1") > "$log" 2>&1 || fail "$1"; }

# --- the library and the sample

# Beside other work, a second process of MSBuild costs more than it saves.
DOTNET_PROCESSOR_COUNT=1 artefacts native 'football-physics-c-*.tar.gz' "$root"
case $(uname -m) in aarch64) system=linux-arm64 ;; *) system=linux-x64 ;; esac
prefix=$work/clone/out/native
mkdir "$prefix"
tar -xzf "$release/football-physics-c-$version-$system.tar.gz" -C "$prefix"
CFLAGS="-Wall -Wextra -Werror -pedantic" page docs/c.md#c-c-and-unreal
library=$prefix/lib/libfootball_physics.so
kib=$(( $(stat -c %s "$library") / 1024 ))
(( kib <= most_kib )) || fail "the library has $kib KiB; allowed: $most_kib"
ok "libfootball_physics.so, $kib KiB of at most $most_kib, from football-physics-c-$version-$system.tar.gz"

diff <(nm -D --defined-only "$library" | awk '{ sub(/@.*/, "", $3) } $3 ~ /^fp_/ { print $3 }' | sort) \
  <(grep -oE '\bfp_[a-z_]+\(' "$prefix/include/football_physics.h" | grep -v '^fp_.*_ABI' | tr -d '(' | sort -u) > "$log" || fail "exports and header differ"
ok "exports: the $(nm -D --defined-only "$library" | grep -c ' fp_') functions of the header, no more and no fewer"

newest=$(readelf -W --dyn-syms "$library" | grep -oE '@GLIBC_[0-9.]+' | sort -uV | tail -n 1)
printf '%s\n' "$newest" @GLIBC_2.31 | sort -CV || fail "the library needs glibc ${newest#@GLIBC_}; allowed: 2.31. Add the function to src/Football.Physics.Native/glibc.sh: $(readelf -W --dyn-syms "$library" | grep -- "$newest" | head -n 1)"
ok "the newest version of a function of glibc is ${newest#@GLIBC_}; Debian 11 has 2.31"

strict=(-Wall -Wextra -Werror -I"$prefix/include")
link=(-L"$prefix/lib" -lfootball_physics "-Wl,-rpath,$prefix/lib" -lm)
printf '#include <math.h>\n#include <football_physics.h>\nint main(void) { int32_t sizes[] = { (int32_t)sizeof(fp_state), (int32_t)sizeof(fp_ball) }; return fp_hash(0) != 0 || fp_check_sizes(FOOTBALL_ABI_VERSION, sizes, 2) != FP_OK || FOOTBALL_CHECK_ABI() != FP_OK; }\n' > "$work/header.c"
cp "$work/header.c" "$work/header.cpp"
# The headers of Apple's machines with Intel define FP_STATE_BYTES, before or after this one.
{ echo '#define FP_STATE_BYTES 512'; cat "$work/header.c"; } > "$work/before.c"
{ sed '/math.h/d' "$work/header.c" | sed 's/^int main/#define FP_STATE_BYTES 512\n&/'; } > "$work/after.c"
for standard in c99 c11; do
  for source in header before after; do
    quietly "the header in $standard, $source" gcc -std=$standard -Wpedantic "${strict[@]}" "$work/$source.c" -o "$work/header" "${link[@]}"
    quietly "the C program, $source" "$work/header"
  done
done
quietly "the header in C++20" g++ -std=c++20 -Wpedantic "${strict[@]}" "$work/header.cpp" -o "$work/header" "${link[@]}"
quietly "the C++ program" "$work/header"
ok "the header compiles as C99, C11 and C++20 with -Wall -Wextra -Wpedantic -Werror, and beside Apple's FP_STATE_BYTES"

quietly "ctest" ctest --test-dir "$work/clone/out/c" --output-on-failure
"$work/clone/out/c/free_kick" > "$work/said"
ok "samples/C, $(grep -c . samples/C/free_kick.c) lines, found by CMake: $(head -n 1 "$work/said"), $(tail -n 1 "$work/said")"

# --- bits and hostile calls

# The runtime has a handler of its own for a null pointer, and keeps its heap to the end.
sanitizers=handle_segv=0:allow_user_segv_handler=1:detect_leaks=0

quietly "kicks.c" gcc -O2 -std=c99 -pedantic "${strict[@]}" tests/Native/kicks.c -o "$work/kicks" "${link[@]}"
start=$SECONDS
"$work/kicks" > "$work/kicks.txt" 2> "$log" || fail "kicks.c"
diff tests/Native/kicks.txt "$work/kicks.txt" > "$log" || fail "kicks: other hashes than C# has"
ok "10 000 kicks to rest in three scenes, every tick and event, saved and restored: the hashes of C#, in $(( SECONDS - start )) s"

quietly "match.c" gcc -O1 -g -std=c99 -pedantic -fsanitize=address,undefined -fno-sanitize-recover=undefined "${strict[@]}" tests/Native/match.c -o "$work/match" "${link[@]}"
start=$SECONDS
ASAN_OPTIONS=$sanitizers "$work/match" > "$work/match.txt" 2> "$log" || fail "match.c"
diff tests/Native/match.txt "$work/match.txt" > "$log" || fail "match: other hashes than C# has"
ok "a match of ten minutes with 22 moving players, restored and replayed on the way: the hashes of C#, under sanitizers, in $(( SECONDS - start )) s"

quietly "follow.c" gcc -O2 -std=c99 -pedantic "${strict[@]}" tests/Native/follow.c -o "$work/follow" "${link[@]}"
start=$SECONDS
"$work/follow" > "$work/follow.txt" 2> "$log" || fail "follow.c"
diff tests/Native/follow.txt "$work/follow.txt" > "$log" || fail "the live filter: other hashes than C# has"
ok "three streams of the live filter, with late, wrong and missing points: the hashes of C#, in $(( SECONDS - start )) s"

quietly "one_default.c" gcc -O2 -std=c99 -pedantic "${strict[@]}" tests/Native/one_default.c -o "$work/one_default" "${link[@]}"
"$work/one_default" tests/Golden/one-default.csv > "$work/said" 2> "$log" || fail "one_default.c"
ok "$(cat "$work/said")"

quietly "refusals.c" gcc -O2 -std=c99 -pedantic "${strict[@]}" tests/Native/refusals.c -o "$work/refusals" "${link[@]}"
"$work/refusals" > "$work/said" 2> "$log" || fail "refusals.c: $(tail -n 1 "$work/said")"
ok "$(tail -n 1 "$work/said")"

quietly "cancel.c" gcc -O1 -g -std=c99 -D_DEFAULT_SOURCE -pthread -fsanitize=address,undefined -fno-sanitize-recover=undefined "${strict[@]}" tests/Native/cancel.c -o "$work/cancel" "${link[@]}"
ASAN_OPTIONS=$sanitizers "$work/cancel" > "$work/said" 2> "$log" || fail "cancel.c: $(tail -n 1 "$work/said")"
ok "$(tail -n 1 "$work/said"), under sanitizers"

quietly "unload.c" gcc -O2 -std=c99 -D_GNU_SOURCE -Wall -Wextra -Werror tests/Native/unload.c -o "$work/unload" -ldl
"$work/unload" "$library" > "$work/said" 2> "$log" || fail "unload.c: $(tail -n 1 "$work/said")"
ok "$(tail -n 1 "$work/said")"

quietly "hostile.c" gcc -O1 -g -std=c99 -pthread -fsanitize=address,undefined -fno-sanitize-recover=undefined "${strict[@]}" tests/Native/hostile.c -o "$work/hostile" "${link[@]}"
start=$SECONDS
ASAN_OPTIONS=$sanitizers "$work/hostile" "$calls" > "$work/said" 2> "$log" || fail "hostile.c: $(tail -n 1 "$work/said")"
ok "$(tail -n 1 "$work/said"), under the address and undefined-behaviour sanitizers, in $(( SECONDS - start )) s"

# --- Rust, and Godot without C#

start=$SECONDS
page docs/c.md#rust
ok "samples/Rust, $(grep -c . samples/Rust/kick.rs) lines, with the declarations of $(bindgen --version): $("$work/clone/out/kick" | tail -n 1), in $(( SECONDS - start )) s"

# godot NAME FLAGS...: builds the extension and the stand-in for Godot with these flags.
godot() {
  local name=$1
  shift
  quietly "the extension for Godot, $name" env FOOTBALL_BIN="$work/$name" samples/GDExtension/build.sh "$prefix" -Werror "$@"
  quietly "godot_host.c, $name" gcc -std=c99 -pedantic -D_GNU_SOURCE -Wall -Wextra -Werror "$@" -I"$prefix/include" tests/Native/godot_host.c -rdynamic -o "$work/$name/host" -ldl -lm
}
# plays HOST EXTENSION: the names of two builds.
plays() { "$work/$1/host" "$work/$2/libfootball_godot.so" tests/Native/godot-methods.tsv; }
start=$SECONDS
sanitized=(-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=undefined)
echo leak:libfootball_physics.so > "$work/suppressed"
unzip -q "$release/football-physics-gdextension-$version-$system.zip" -d "$work/addon"
mv "$work/addon/addons/football/bin/$system" "$work/plain"
quietly "godot_host.c" gcc -std=c99 -D_GNU_SOURCE -O2 -I"$prefix/include" tests/Native/godot_host.c -rdynamic -o "$work/plain/host" -ldl -lm
godot single "${sanitized[@]}"
godot double "${sanitized[@]}" -DFOOTBALL_GODOT_DOUBLE
plays plain plain > "$work/godot.txt" 2> "$log" || fail "the extension for Godot"
diff tests/Native/godot.txt "$work/godot.txt" > "$log" || fail "the extension for Godot: other results than C# has"
for name in single double; do
  # The leaks of the extension itself count; the .NET runtime keeps its heap to the end.
  ASAN_OPTIONS=$sanitizers:detect_leaks=1 LSAN_OPTIONS=suppressions=$work/suppressed:print_suppressions=0 plays $name $name > "$work/godot.txt" 2> "$log" || fail "the extension for Godot under sanitizers, $name"
  diff tests/Native/godot.txt "$work/godot.txt" > "$log" || fail "the extension for Godot, $name: other results than C# has"
done
if ASAN_OPTIONS=$sanitizers plays double single > "$log" 2>&1; then fail "an extension of single precision loads into an engine of double precision"; fi
grep -q 'another precision' "$log" || fail "an extension of another precision"
ok "samples/GDExtension in a stand-in for Godot: $(grep -c . tests/Native/godot.txt) lines with the hashes of C#, in both precisions under the address sanitizer, no leak; $(grep -c '^[A-Z]' tests/Native/godot-methods.tsv) hashes of methods, in $(( SECONDS - start )) s"

# --- Python

# The system's Python has numpy.
cp "$release"/football_physics-*_"$(uname -m)".whl "$work/clone/out/wheel/"
PATH=/usr/bin:$PATH page docs/data-sets.md#python
wheel=$(echo "$work"/clone/out/wheel/*.whl)
[[ $wheel == *-manylinux_2_31_* ]] || fail "the wheel has the tag of $(basename "$wheel"); PyPI accepts manylinux_2_31"
python=$work/clone/out/python/bin/python
# The wheel names the version and the address of the release.
address=$(unzip -p "$wheel" '*/METADATA' | sed -n 's/^Project-URL: Homepage, //p')
quietly "wheel again" env MinVerVersionOverride="$version" ProjectUrl="$address" /usr/bin/python3 src/Football.Physics.Python/build_wheel.py "$library" "$work/again"
cmp "$wheel" "$work"/again/*.whl > "$log" || fail "the wheel built twice differs"
ok "$(basename "$wheel"), $(( $(stat -c %s "$wheel") / 1024 )) KiB, of the release, the same bytes built again, installed by pip into a fresh environment as docs/data-sets.md says"
cd "$work"
"$python" -m unittest discover -s "$root/tests/Python" > "$log" 2>&1 || fail "tests/Python"
ok "tests/Python: $(grep -E '^Ran ' "$log")"
while read -r guide; do
  "$python" "$root/tests/Python/pages.py" "$guide" > "$work/said" 2> "$log" || fail "$guide, Python"
  ok "$(tail -n 1 "$work/said")"
done <<< "$("$root/tests/blocks.py" python)"
"$python" "$root/src/Football.Physics.Python/examples/free_kick.py" 150 > "$work/said" 2> "$log" || fail "examples/free_kick.py"
[[ -s free_kick.svg ]] || fail "examples/free_kick.py draws nothing"
goals=$(awk '/goals of 100/ { print $1 }' "$work/said")
(( goals >= 90 )) || fail "examples/free_kick.py: $goals goals of 100"
ok "examples/free_kick.py: $(tail -n 1 "$work/said")"
"$python" "$root/src/Football.Physics.Python/examples/track.py" > "$work/said" 2> "$log" || fail "examples/track.py"
(( $(grep -c '<polyline' track.svg) >= 3 )) || fail "examples/track.py draws too few flights"
(( $(grep -c '^kick' "$work/said") == 3 )) || fail "examples/track.py finds other kicks than its three"
awk '$1 == "wind_z" { found = ($2 - 3)^2 < ($4 * 4 + 0.1)^2 } END { exit !found }' "$work/said" || fail "examples/track.py: $(grep wind_z "$work/said"); it blows with 3 m/s"
ok "examples/track.py: $(head -n 1 "$work/said")"
for page in docs/c.md docs/getting-started.md; do
  "$python" "$root/tests/Python/pages.py" --c "$page" "$prefix" > "$work/said" 2> "$log" || fail "$page"
  ok "$(tail -n 1 "$work/said")"
done

# --- LÖVE and pygame: a kick without a person, and its picture

start=$SECONDS
"$python" "$root/tests/Python/pages.py" --lua docs/lua.md "$prefix" > "$work/said" 2> "$log" || fail "docs/lua.md"
ok "$(tail -n 1 "$work/said")"
FOOTBALL_PHYSICS=$prefix page "docs/lua.md#a-game"
page docs/data-sets.md#pygame
/usr/bin/python3 "$root/tests/Python/picture.py" "$work/clone/out/love.png" "$work/clone/out/pygame.png" > "$work/said" 2> "$log" || fail "picture.py"
ok "samples/Love and samples/Pygame print the hash of C# as the pages say; each picture contains $(head -n 1 "$work/said" | cut -d ' ' -f 2-), in $(( SECONDS - start )) s"
