#!/usr/bin/env bash
# ARM64: the golden file and the live filter, by the program that prints them, published for linux-arm64, and kicks, a match and the filter through the C library, which is built across; all run by qemu-user over Debian's C library for that machine.
#   tests/arm64.sh [golden]        golden: the golden file and the live filter alone, as CI does
# Needs qemu-aarch64-static (Debian: qemu-user-static), aarch64-linux-gnu-gcc (gcc-aarch64-linux-gnu, libc6-dev-arm64-cross) and dpkg-deb, and asks apt for six packages of arm64, which are unpacked into a folder and not installed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=${UseSharedCompilation:-false}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
log=$work/log

fail() {
  echo "FAIL  $1" >&2
  [[ -s $log ]] && tail -n 20 "$log" >&2
  exit 1
}

# Lists and archives of arm64 stay in a folder of their own: the machine's own apt does not learn of another architecture.
mkdir -p "$work"/apt/{lists/partial,archives/partial} "$work/root"
arm() {
  apt-get -qq -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State::lists="$work/apt/lists" -o Dir::Cache="$work/apt" -o APT::Sandbox::User=root "$@"
}
arm update > "$log" 2>&1 || fail "apt-get update for arm64"
(cd "$work" && arm download libc6 libgcc-s1 libstdc++6 zlib1g libssl3 gcc-12-base) > "$log" 2>&1 || fail "apt-get download for arm64"
for package in "$work"/*.deb; do dpkg-deb -x "$package" "$work/root"; done

# run PROGRAM…: on the other machine. Its code may not be written and run at two addresses at once there.
run() { DOTNET_EnableWriteXorExecute=0 QEMU_LD_PREFIX=$work/root qemu-aarch64-static "$@"; }

# Under qemu, compiling at run time takes longer than running, so the code is compiled ahead of time; in .ci/run --full, at run time.
ready=(-p:PublishReadyToRun=true)
[[ ${FOOTBALL_FULL:-} != 1 ]] || ready=()
# .ci/run plays every fifth golden line there, unless it runs in full.
some=()
[[ ${1:-} != golden || ${FOOTBALL_FULL:-} == 1 ]] || some=(--some)
start=$SECONDS
dotnet publish -c Release -m:1 -r linux-arm64 --self-contained "${ready[@]}" tests/Package.Consumer -p:RunAnalyzers=false -p:LibraryProject=true -p:TargetFrameworks=net10.0 --artifacts-path "$work/build" -o "$work/golden" > "$log" 2>&1 || fail "publish for linux-arm64"
published=$(( SECONDS - start ))
start=$SECONDS
run "$work/golden/consumer" "${some[@]}" > "$work/hashes" 2> "$log" || fail "the golden program on ARM64"
cp tests/Golden/golden.txt "$work/expected"
if (( ${#some[@]} > 0 )); then
  grep -Fxf "$work/hashes" tests/Golden/golden.txt > "$work/expected" || :
  (( $(wc -l < "$work/hashes") * 5 >= $(wc -l < tests/Golden/golden.txt) )) || fail "only $(wc -l < "$work/hashes") lines"
fi
diff "$work/expected" "$work/hashes" > "$log" || fail "other hashes than tests/Golden/golden.txt ($(grep -c '^>' "$log") of $(wc -l < "$work/hashes") lines differ)"
echo "ok    ARM64 under qemu-user: $(wc -l < "$work/hashes") lines as in golden.txt, published in $published s, run in $(( SECONDS - start )) s"

start=$SECONDS
run "$work/golden/consumer" --follow > "$work/hashes" 2> "$log" || fail "the live filter on ARM64"
diff tests/Native/follow.txt "$work/hashes" > "$log" || fail "the live filter: other hashes than tests/Native/follow.txt"
echo "ok    ARM64 under qemu-user: the live filter, $(wc -l < "$work/hashes") lines as in follow.txt, run in $(( SECONDS - start )) s"

[[ ${1:-} != golden ]] || exit 0

# --- the C library there: built across, and kicks.c and match.c against it

start=$SECONDS
src/Football.Physics.Native/build.sh "$work/native" linux-arm64 > "$log" 2>&1 || fail "build.sh for linux-arm64"
for program in kicks match follow; do
  aarch64-linux-gnu-gcc -O2 -std=c99 -I"$work/native/include" "tests/Native/$program.c" -o "$work/$program" -L"$work/native/lib" -lfootball_physics -lm > "$log" 2>&1 || fail "$program.c for ARM64"
done
newest=$(readelf -W --dyn-syms "$work/native/lib/libfootball_physics.so" | grep -oE '@GLIBC_[0-9.]+' | sort -uV | tail -n 1)
printf '%s\n' "$newest" @GLIBC_2.31 | sort -CV || fail "the library for ARM64 needs glibc ${newest#@GLIBC_}; allowed: 2.31"
built=$(( SECONDS - start ))
start=$SECONDS
run -E LD_LIBRARY_PATH="$work/native/lib" "$work/kicks" 300 > "$work/hashes" 2> "$log" || fail "kicks.c on ARM64"
diff <(awk '$2 <= 300' tests/Native/kicks.txt) "$work/hashes" > "$log" || fail "kicks on ARM64: other hashes than C# has on x64"
echo "ok    ARM64 under qemu-user: 900 kicks to rest through the C library, the hashes of C# on x64, built in $built s, run in $(( SECONDS - start )) s"
start=$SECONDS
run -E LD_LIBRARY_PATH="$work/native/lib" "$work/match" 2 > "$work/hashes" 2> "$log" || fail "match.c on ARM64"
diff <(head -n 2 tests/Native/match.txt) "$work/hashes" > "$log" || fail "a match on ARM64: other hashes than C# has on x64"
echo "ok    ARM64 under qemu-user: two minutes of a match with 22 moving players, the hashes of C# on x64, in $(( SECONDS - start )) s; glibc ${newest#@GLIBC_} or later"
start=$SECONDS
run -E LD_LIBRARY_PATH="$work/native/lib" "$work/follow" > "$work/hashes" 2> "$log" || fail "follow.c on ARM64"
diff tests/Native/follow.txt "$work/hashes" > "$log" || fail "the live filter on ARM64: other hashes than C# has on x64"
echo "ok    ARM64 under qemu-user: the live filter through the C library, the hashes of C# on x64, in $(( SECONDS - start )) s"
