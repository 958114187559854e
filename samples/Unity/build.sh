#!/usr/bin/env bash
# Builds the library for Unity, puts it into the package's Plugins and packs the package for the package manager.
#   samples/Unity/build.sh [DIR]     the .tgz in DIR (default out)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
out=${1:-out}
mkdir -p "$out"
out=$(cd "$out" && pwd)
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=false

package=samples/Unity/com.football.physics
version=$(sed -n 's/.*"version": "\(.*\)".*/\1/p' "$package/package.json")
dotnet build -c Release -f netstandard2.1 src/Football.Physics -v q >&2
cp src/Football.Physics/bin/Release/netstandard2.1/Football.Physics.{dll,xml} "$package/Plugins/"

# A tarball of the package manager has everything below "package/"; the same bytes for the same files.
tar --sort=name --mtime='2026-01-01 00:00Z' --owner=0 --group=0 --numeric-owner --mode=u+rw,go=rX --transform "s,^\./,package/," \
  -C "$package" -c . | gzip -n > "$out/com.football.physics-$version.tgz"
echo "$out/com.football.physics-$version.tgz"
