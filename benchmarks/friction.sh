#!/usr/bin/env bash
# Proves that the law of friction exists once: changes it to μ(v) = μ₀ (1 + a e^(−v/b)) by benchmarks/Friction/slip-speed.patch, in at most four files of a copy of the library, builds the copy,
# and compares slides along a line with their closed form: on level ground (the fast form), on an obstacle, on two contacts. Impulses keep the limit at rest, μ₀ (1 + a). Then it does the same without the patch, which must fail. Exit code 0 if both are so.
#   benchmarks/friction.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1
patch=$PWD/benchmarks/Friction/slip-speed.patch
gain=$(sed -n 's/.*SlowGain = \([0-9.]*\);/\1/p' "$patch")
speed=$(sed -n 's/.*SlowSpeed = \([0-9.]*\);/\1/p' "$patch")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The files of the work tree that git tracks or would track, without the rest.
git ls-files -z --cached --others --exclude-standard -- src/Football.Physics src/Football.Physics.Batch src/Football.Physics.Engines src/Packaging benchmarks/Friction 'Directory.*' global.json BannedSymbols.txt .editorconfig | while IFS= read -r -d '' file; do
  [[ ! -e $file ]] || printf '%s\0' "$file"
done | tar -c --null -T - | tar -x -C "$work"
build() { dotnet build -c Release "$work/benchmarks/Friction" -o "$work/$1" -v q -p:RunAnalyzers=false -p:TargetFrameworks=net10.0 > "$work/log" 2>&1 || { tail -n 20 "$work/log" >&2; exit 1; }; }
build plain
(cd "$work" && git apply "$patch")
files=$(grep -c '^diff ' "$patch")
build patched

echo "μ(v) = μ₀ (1 + $gain e^(−v/$speed m/s)); the patch changes $files files of the library."
echo
dotnet "$work/patched/Friction.dll" "$gain" "$speed"
if dotnet "$work/plain/Friction.dll" "$gain" "$speed" > /dev/null; then
  echo "the library without the patch agrees with the law too: the comparison cannot fail" >&2
  exit 1
fi
(( files <= 4 )) || { echo "the patch changes more than four files" >&2; exit 1; }
