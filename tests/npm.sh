#!/usr/bin/env bash
# The npm package as a stranger uses it: packed, its size, its types, bad input, the programs of docs/web.md, and the three.js sample in a browser.
#   tests/npm.sh [DIR]     the picture of the sample in DIR (default out/npm)
# Needs Node, npm and a Chromium; the solution must be built. Web.Tests compares the bits with C#.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
most_bytes=2000000

out=${1:-out/npm}
mkdir -p "$out"
out=$(cd "$out" && pwd)
log=$(mktemp)
trap 'rm -f "$log"' EXIT

fail() {
  echo "FAIL  $1" >&2
  tail -n 20 "$log" >&2
  exit 1
}

package=$root/src/Football.Physics.Web/bin/package
[[ -e $package/index.js ]] || fail "no package: dotnet publish -c Release src/Football.Physics.Web"
(cd "$out" && npm pack --silent "$package") > "$log" 2>&1 || fail "npm pack"
tgz=$out/$(tail -n 1 "$log")
bytes=$(node tests/Npm/compressed.mjs "$package")
(( bytes <= most_bytes )) || fail "the package has $bytes bytes with brotli; allowed: $most_bytes"
echo "ok    $(basename "$tgz"): $(stat -c %s "$tgz") bytes, $bytes with brotli, of at most $most_bytes"

for folder in tests/Npm samples/Three; do
  (cd "$folder" && npm ci --no-audit --no-fund --prefer-offline) > "$log" 2>&1 || fail "npm ci in $folder"
done
node tests/Npm/node_modules/typescript/bin/tsc -p tests/Npm > "$log" 2>&1 || { cat "$log" >&2; fail "tsc"; }
echo "ok    the types compile, and reject what they should"

node tests/Npm/refusals.mjs > "$log" 2>&1 || fail "refusals.mjs"
echo "ok    $(tail -n 1 "$log")"
node tests/Npm/docs.mjs docs/web.md > "$log" 2>&1 || fail "docs/web.md"
echo "ok    $(tail -n 1 "$log")"

start=$SECONDS
(cd samples/Three && npm run --silent shot -- "$out/three.png") > "$log" 2>&1 || fail "samples/Three"
echo "ok    samples/Three in a browser: $(tail -n 1 "$log"); $(grep -c '^hash' "$log") hashes as in C#, in $(( SECONDS - start )) s"
