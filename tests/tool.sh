#!/usr/bin/env bash
# Packs the command line as a .NET tool, installs it from a local feed as a stranger would, and runs it.
#   tests/tool.sh            one line a check; exit code 1 at the first that fails
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_CLI_UI_LANGUAGE=en
export MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=false

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
log=$work/log

fail() {
  echo "FAIL  $1" >&2
  [[ -s $log ]] && head -n 20 "$log" >&2
  exit 1
}

version=0.1.0-local.$(date -u +%Y%m%d%H%M%S)
dotnet build -c Release src/Football.Tool > "$log" 2>&1 || fail "dotnet build"
dotnet pack -c Release --no-build src/Football.Tool -o "$work/feed" "-p:Version=$version" > "$log" 2>&1 || fail "dotnet pack"
echo "ok    dotnet pack: Football.Physics.Tool.$version.nupkg"

export NUGET_PACKAGES=$work/cache   # empty: nothing but the feed can supply the package
cat > "$work/nuget.config" <<CONFIG
<configuration><packageSources><clear /><add key="local" value="$work/feed" /></packageSources></configuration>
CONFIG
dotnet tool install Football.Physics.Tool --version "$version" --tool-path "$work/tools" --configfile "$work/nuget.config" > "$log" 2>&1 \
  || fail "dotnet tool install"
"$work/tools/football" kick --speed 27 --elevation 12 --side-spin 60 > "$work/kick.json" 2> "$log" || fail "football kick"
grep -q '"state":"stopped"' "$work/kick.json" || fail "football kick: no result"
echo "ok    dotnet tool install; football kick: $(wc -c < "$work/kick.json") bytes of JSON"
