#!/usr/bin/env bash
# Fuzzes every input that another person may have made (docs/internals/threats.md), guided by the covered code: SharpFuzz instruments the assemblies, afl-fuzz changes the inputs.
#
#   tests/fuzz.sh [SECONDS [TARGET...]]   SECONDS per target, default 60; TARGET: a folder of tests/Fuzz/corpus, default all
#
# It first tries the stored inputs, then searches from them. It prints a line per target, and ends with exit code 1 after a crash or a hang. The findings are in artifacts/fuzz/TARGET, or in the folder OUT.
# KEEP=true adds the inputs that reach new code to the stored inputs, and removes the others (afl-cmin).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=false
# The runtime is not built for AFL, and the machine keeps its settings.
export AFL_SKIP_BIN_CHECK=1 AFL_SKIP_CPUFREQ=1 AFL_NO_AFFINITY=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_NO_UI=1 AFL_QUIET=1 AFL_FORKSRV_INIT_TMOUT=60000
# An input that takes longer, in ms, is a hang. The machine may be busy, and the first input also waits for the compiler.
hang=60000
export AFL_HANG_TMOUT=$hang
# More memory than this, in hexadecimal, throws: 512 MiB.
export DOTNET_GCHeapHardLimit=20000000
longest=8192

seconds=${1:-60}
shift || :
out=${OUT:-artifacts/fuzz}
built=tests/Fuzz/bin/Release/net10.0
[[ ${CI:-} == true && -e $built/football-fuzz.dll ]] || dotnet build -c Release tests/Fuzz -v q > /dev/null
(( $# > 0 )) || set -- $(dotnet "$built/football-fuzz.dll" list)

mkdir -p "$out"
rm -rf "$out/bin"
cp -r "$built" "$out/bin"
(cd tests/Fuzz && dotnet tool restore > /dev/null)
for part in Football.Physics Football.Scenarios Football.Physics.Tracks football football_physics; do
  (cd tests/Fuzz && dotnet sharpfuzz "../../$out/bin/$part.dll")
done

found=0
for target; do
  corpus=tests/Fuzz/corpus/$target
  dotnet "$built/football-fuzz.dll" try "$target" "$corpus"/* > "$out/$target.log" || { cat "$out/$target.log" >&2; exit 1; }
  rm -rf "${out:?}/$target"
  dictionary=tests/Fuzz/${target/bundles/scenarios}.dict
  words=()
  [[ -e $dictionary ]] && words=(-x "$dictionary")
  afl-fuzz "${words[@]}" -V "$seconds" -i "$corpus" -o "$out/$target" -t "$hang" -m none -G "$longest" -- dotnet "$out/bin/football-fuzz.dll" afl "$target" > "$out/$target.log" 2>&1 ||
    { tail -n 20 "$out/$target.log" >&2; exit 1; }
  stats=$out/$target/default
  value() { sed -nE "s/^$1 +: //p" "$stats/fuzzer_stats"; }
  printf '%-10s %8s executions, %5s inputs with new paths of %5s, %s of the map, %s crashes, %s hangs; stored: %s files, %s KiB\n' "$target" "$(value execs_done)" "$(value corpus_found)" \
    "$(value corpus_count)" "$(value bitmap_cvg)" "$(value saved_crashes)" "$(value saved_hangs)" "$(find "$corpus" -type f | wc -l)" "$(du -sk --apparent-size "$corpus" | cut -f 1)"
  for file in "$stats"/crashes/id* "$stats"/hangs/id*; do
    [[ -e $file ]] || continue
    found=1
    echo "$file" >&2
    timeout 60 dotnet "$built/football-fuzz.dll" try "$target" "$file" >&2 || :
  done

  if [[ ${KEEP:-} == true ]]; then
    # One input for each branch (-e), whatever its count. The script wants a path of the program, and a folder outside /tmp.
    rm -rf "$out/kept"
    afl-cmin -e -i "$stats/queue" -o "$out/kept" -t "$hang" -m none -- "$(readlink -f "$(command -v dotnet)")" "$out/bin/football-fuzz.dll" afl "$target" > "$out/$target.log" 2>&1 ||
      { tail -n 20 "$out/$target.log" >&2; exit 1; }
    rm -f "$corpus"/*
    for file in "$out/kept"/*; do cp "$file" "$corpus/$(sha256sum "$file" | cut -c 1-12)"; done
  fi
done

exit "$found"
