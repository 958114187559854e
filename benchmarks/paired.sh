#!/usr/bin/env bash
# Times the rows of `quick` with the library of the work tree and with that of another commit, which alternate in one process. Exit code 1 if a row is above its bound.
#   benchmarks/paired.sh [COMMIT] [--only TEXT] [--bound RATIO] [--runs N] [--seconds S]
# COMMIT: default that of the last line of benchmarks/history.csv. TEXT: a part of "TABLE: ROW", such as "contact:" or "RK4". RATIO: default 1.03; benchmarks/bounds.tsv lists the rows with another bound.
# N runs, default 3. S seconds for each row and run, default 0.2. All rows take about fourteen minutes.
# The position of code in memory changes a time by some percent, so each run compiles both libraries again. A row that is above its bound in all runs is timed in N more; it fails if their median is above the bound, too.
# Both libraries run the benchmarks of the work tree. A row that uses a member which the other library lacks is not compared, and says so. Rows of other code (plain, thesis, MathNet) show the noise.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=false
# The columns before that of the commit need no quotes.
[[ ${1:---} == --* ]] || { commit=$1; shift; }
commit=${commit:-$(tail -n 1 benchmarks/history.csv | cut -d, -f3)}
commit=$(git rev-parse --verify "$commit^{commit}")
project=benchmarks/Football.Physics.Benchmarks
output=$project/bin/Release/net10.0

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
build() { dotnet build -c Release "$@" -v q -p:RunAnalyzers=false > "$work/log" 2>&1 || { tail -n 20 "$work/log" >&2; exit 2; }; }
build $project

# The other folder differs only in the library. An empty project builds all its parts.
mkdir -p "$work/tree/all"
git archive "$commit" | tar -x -C "$work/tree"
# In an older commit, Batch and Engines are assemblies of their own. They belong to the library for the benchmarks of the work tree.
if [[ -e $work/tree/src/Football.Physics.Batch/Football.Physics.Batch.csproj ]]; then cp src/Football.Physics/Football.Physics.csproj "$work/tree/src/Football.Physics/"; fi
cp -R "$output" "$work/then"
{
  echo '<Project Sdk="Microsoft.NET.Sdk"><PropertyGroup><TargetFramework>net10.0</TargetFramework></PropertyGroup><ItemGroup>'
  for part in "$output"/Football.Physics*.dll; do
    name=$(basename "$part" .dll)
    [[ -d src/$name ]] || continue
    rm "$work/then/$name.dll"
    [[ ! -d $work/tree/src/$name ]] || echo "<ProjectReference Include=\"../src/$name/$name.csproj\" />"
  done
  echo '</ItemGroup></Project>'
} > "$work/tree/all/all.csproj"
build "$work/tree/all" -o "$work/library"
cp "$work"/library/Football.*.dll "$work/then"

echo "Against $(git log -1 --format='%h %s' "$commit"):"
dotnet "$output/Football.Physics.Benchmarks.dll" paired "$work/then" "$@"
