#!/usr/bin/env bash
# Times the kicks of the work tree and of another commit, which alternate in one process. Exit code 1 if a kick is more than 5 % slower than before.
#   benchmarks/paired.sh [COMMIT] [SECONDS]     COMMIT: default that of the last line of benchmarks/history.csv; SECONDS for each run: default 30
# The position of code in memory changes a time by some percent, and differs between processes: a kick counts as slower only if it is slower in three runs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=false
# The columns before that of the commit need no quotes.
commit=${1:-$(tail -n 1 benchmarks/history.csv | cut -d, -f3)}
commit=$(git rev-parse --verify "$commit^{commit}")
seconds=${2:-30}
project=benchmarks/Football.Physics.Benchmarks
output=$project/bin/Release/net10.0

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/then"
git archive "$commit" | tar -x -C "$work/then"
for tree in . "$work/then"; do
  dotnet build -c Release "$tree/$project" -v q -p:RunAnalyzers=false > "$work/log" 2>&1 || { tail -n 20 "$work/log" >&2; exit 2; }
done

echo "Against $(git log -1 --format='%h %s' "$commit"):"
: > "$work/slower"
for run in 1 2 3; do
  said=0
  dotnet "$output/Football.Physics.Benchmarks.dll" quick --seconds "$seconds" --against "$work/then/$output" > "$work/table" || said=$?
  (( said < 2 )) || exit 2
  cat "$work/table"
  grep -F '**slower**' "$work/table" | cut -d'|' -f2 | sort > "$work/these" || :
  if (( run == 1 )); then mv "$work/these" "$work/slower"; else comm -12 "$work/slower" "$work/these" > "$work/both" && mv "$work/both" "$work/slower"; fi
  [[ -s $work/slower ]] || { echo "No kick is slower."; exit 0; }
done
echo "Slower in three runs:"
cat "$work/slower"
exit 1
