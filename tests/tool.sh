#!/usr/bin/env bash
# Installs the command line of a release as a new user would, in an empty folder with empty caches, and runs the commands of the pages exactly as printed.
#   tests/tool.sh            one line a check; exit code 1 at the first that fails
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD

export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_CLI_UI_LANGUAGE=en
# shellcheck source=artefacts.sh
source tests/artefacts.sh
export MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=${UseSharedCompilation:-false}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
log=$work/log

fail() {
  echo "FAIL  $1" >&2
  [[ -s $log ]] && head -n 20 "$log" >&2
  exit 1
}

# page FOLDER SECTION [N…]: runs the blocks of a section in the folder.
page() { (cd "$1" && "$root/tests/blocks.py" run "${@:2}") > "$log" 2>&1 || fail "${*:2}"; }

# Beside other work, a second process of MSBuild costs more than it saves.
DOTNET_PROCESSOR_COUNT=1 artefacts tool 'Football.Physics.Tool.*.nupkg' "$root"
# The tool is installed for a user whose home and whose caches are empty, from a folder with nothing but the package.
mkdir -p "$work/home" "$work/bare/out/feed"
cp "$release/Football.Physics.Tool.$version.nupkg" "$work/bare/out/feed/"
if [[ $version == *-* ]]; then
  # The page installs a version that is released.
  (cd "$work/bare" && DOTNET_CLI_HOME=$work/home NUGET_PACKAGES=$work/cache dotnet tool install --global Football.Physics.Tool --source out/feed --version "$version") > "$log" 2>&1 || fail "dotnet tool install"
else
  DOTNET_CLI_HOME=$work/home NUGET_PACKAGES=$work/cache page "$work/bare" docs/command-line.md#install 2
fi
export PATH=$work/home/.dotnet/tools:$PATH
[[ $(type -P football) == "$work"/* ]] || fail "dotnet tool install: football is not in the home of this test"
echo "ok    docs/command-line.md, Install: Football.Physics.Tool.$version.nupkg of the release, installed from an empty folder with empty caches"
DOTNET_PROCESSOR_COUNT=1 page . docs/command-line.md#install 3
grep -q '^  kick ' "$log" || fail "football help does not list kick"
echo "ok    docs/command-line.md, Install: without installing, it lists $(grep -c '^  [a-z]' "$log") commands"

mkdir "$work/user"
page "$work/user" docs/command-line.md#a-kick
grep -q '"state":"stopped"' "$log" || fail "football kick: no result"
echo "ok    docs/command-line.md, A kick: $(wc -c < "$log") bytes of JSON"
page "$work/user" docs/command-line.md#a-replay
page "$work/user" docs/command-line.md#a-page-to-play-with
page "$work/user" docs/cookbook.md#see-what-it-does
for written in shots.html toy.html shot.html; do
  grep -q '</html>' "$work/user/$written" || fail "$written is not a page"
done
echo "ok    docs/command-line.md and docs/cookbook.md: pages of $(cd "$work/user" && du -kc shots.html toy.html shot.html | awk 'END { print $1 }') KiB"

tests/blocks.py show docs/data-sets.md#ranges "json sweep" > "$work/user/shots.json"
page "$work/user" docs/data-sets.md#data-sets-tracks-and-python
tests/blocks.py show docs/data-sets.md#files python > "$work/user/read.py"
echo 'assert speed.shape == (10000,) and landing.shape == (10000, 3)' >> "$work/user/read.py"
(cd "$work/user" && /usr/bin/python3 read.py) > "$log" 2>&1 || fail "docs/data-sets.md, Files: the program that reads the rows"
page "$work/user" docs/data-sets.md#many-machines
diff -rq -x 'shard-*' "$work/user/rows" "$work/user/parts" > "$log" || fail "docs/data-sets.md: the merged shards are not the sweep"
echo "ok    docs/data-sets.md: a sweep, and the same bytes from two shards"
