#!/usr/bin/env bash
# Builds the library and its part for engines for Unity, puts them into the package's Plugins and packs the package for the package manager.
#   samples/Unity/build.sh [DIR]     the .tgz in DIR (default out)
# FOOTBALL_ADDRESS=https://… is where the repository's pages are, for the links of the package manager; default the address of "origin".
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
out=${1:-out}
mkdir -p "$out"
out=$(cd "$out" && pwd)
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=false

package=samples/Unity/com.football.physics
version=$(sed -n 's/.*"version": "\(.*\)".*/\1/p' "$package/package.json")
for part in Football.Physics{,.Engines}; do
  dotnet build -c Release -f netstandard2.1 "src/$part" -v q >&2
  cp "src/$part/bin/Release/netstandard2.1/$part".{dll,xml} "$package/Plugins/"
done

# Links need an address; where the repository has none, the package manager opens the files in the package.
staged=$(mktemp -d)
trap 'rm -rf "$staged"' EXIT
cp -R "$package" "$staged/package"
address=${FOOTBALL_ADDRESS:-$(git config --get remote.origin.url || true)}
if [[ $address =~ ^(ssh://)?git@([^:/]+)[:/](.+)$ ]]; then address=https://${BASH_REMATCH[2]}/${BASH_REMATCH[3]}; fi
address=${address%/}
address=${address%.git}
if [[ $address == http*://* ]]; then
  host=${address#*://}
  address=${address%%://*}://${host#*@}   # without a name and password that a clone may have in it
  pages=$address/blob/HEAD/$package
  sed -i "s|^  \"license\":|  \"documentationUrl\": \"$pages/Documentation~/index.md\",\n  \"changelogUrl\": \"$pages/CHANGELOG.md\",\n  \"licensesUrl\": \"$pages/LICENSE.md\",\n&|" \
    "$staged/package/package.json"
fi

# A tarball of the package manager has everything below "package/"; the same bytes for the same files.
tar --sort=name --mtime='2026-01-01 00:00Z' --owner=0 --group=0 --numeric-owner --mode=u+rw,go=rX -C "$staged" -c package \
  | gzip -n > "$out/com.football.physics-$version.tgz"
echo "$out/com.football.physics-$version.tgz"
