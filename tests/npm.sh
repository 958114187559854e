#!/usr/bin/env bash
# The npm package as a stranger uses it: packed, its size, its types, bad input, the programs of docs/c.md, and the three.js sample in a browser.
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
# The blocks of docs/c.md, exactly as printed.
# Beside other work, a second process of MSBuild costs more than it saves.
DOTNET_PROCESSOR_COUNT=1 tests/blocks.py run docs/c.md#javascript-npm-web-pages-and-threejs > "$log" 2>&1 || fail "docs/c.md, npm"
mv football-physics-*.tgz "$out"
tgz=$(echo "$out"/football-physics-*.tgz)
bytes=$(node tests/Npm/compressed.mjs "$package")
(( bytes <= most_bytes )) || fail "the package has $bytes bytes with brotli; allowed: $most_bytes"
echo "ok    $(basename "$tgz"): $(stat -c %s "$tgz") bytes, $bytes with brotli, of at most $most_bytes"

npm ci --no-audit --no-fund --prefer-offline --prefix tests/Npm > "$log" 2>&1 || fail "npm ci in tests/Npm"
node tests/Npm/node_modules/typescript/bin/tsc -p tests/Npm > "$log" 2>&1 || { cat "$log" >&2; fail "tsc"; }
echo "ok    the types compile, and reject what they should"

node tests/Npm/refusals.mjs > "$log" 2>&1 || fail "refusals.mjs"
echo "ok    $(tail -n 1 "$log")"
node tests/Npm/docs.mjs docs/c.md > "$log" 2>&1 || fail "docs/c.md"
echo "ok    $(tail -n 1 "$log")"

start=$SECONDS
tests/blocks.py run docs/c.md#threejs > "$log" 2>&1 || fail "docs/c.md, three.js"
mv samples/Three/shot.png "$out/three.png"
echo "ok    samples/Three in a browser: $(grep -c '^hash' "$log") hashes as in C#, in $(( SECONDS - start )) s"
