#!/usr/bin/env bash
# The npm package of a release as a stranger uses it: installed into an empty folder, its size, its types, bad input, the programs of docs/, and the three.js sample in a browser.
#   tests/npm.sh [DIR]     the picture of the sample in DIR (default out/npm)
# Needs Node, npm and a Chromium. Web.Tests compares the bits with C#.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
most_bytes=2000000

out=${1:-out/npm}
mkdir -p "$out"
out=$(cd "$out" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
log=$work/log
# shellcheck source=artefacts.sh
source tests/artefacts.sh

fail() {
  echo "FAIL  $1" >&2
  tail -n 20 "$log" >&2
  exit 1
}

# Beside other work, a second process of MSBuild costs more than it saves.
DOTNET_PROCESSOR_COUNT=1 artefacts npm 'football-physics-[0-9]*.tgz' "$root"
tgz=$release/football-physics-$version.tgz
mkdir "$work/user"
cp tests/Npm/*.mjs tests/Npm/*.ts tests/Npm/tsconfig.json "$work/user/"
cd "$work/user"
echo '{ "private": true, "type": "module" }' > package.json
npm install --no-audit --no-fund --ignore-scripts --cache "$work/cache" "$tgz" > "$log" 2>&1 || fail "npm install of the package"
package=$work/user/node_modules/football-physics
bytes=$(node compressed.mjs "$package")
(( bytes <= most_bytes )) || fail "the package has $bytes bytes with brotli; allowed: $most_bytes"
echo "ok    $(basename "$tgz"): $(stat -c %s "$tgz") bytes, $bytes with brotli, of at most $most_bytes, installed into an empty folder with an empty cache"

typescript=$(node -p 'JSON.parse(require("fs").readFileSync(process.argv[1])).devDependencies.typescript' "$root/tests/Npm/package.json")
npm install --no-audit --no-fund --prefer-offline "typescript@$typescript" > "$log" 2>&1 || fail "npm install of typescript"
node node_modules/typescript/bin/tsc -p . > "$log" 2>&1 || { cat "$log" >&2; fail "tsc"; }
echo "ok    the types compile, and reject what they should"

node refusals.mjs > "$log" 2>&1 || fail "refusals.mjs"
echo "ok    $(tail -n 1 "$log")"
for page in docs/javascript.md docs/getting-started.md; do
  node docs.mjs "$root/$page" > "$log" 2>&1 || fail "$page"
  echo "ok    $(tail -n 1 "$log")"
done

# The sample takes the package from the folder that `dotnet publish` writes. Here that folder has the files of the release, and no sources are beside it.
start=$SECONDS
mkdir -p "$work/clone/samples/Three" "$work/clone/src/Football.Physics.Web/bin"
(cd "$root" && git ls-files -z -- samples/Three | xargs -0 cp --parents -t "$work/clone")
cp -R "$package" "$work/clone/src/Football.Physics.Web/bin/package"
cd "$work/clone"
"$root/tests/blocks.py" run docs/javascript.md#threejs > "$log" 2>&1 || fail "docs/javascript.md, three.js"
mv samples/Three/shot.png "$out/three.png"
echo "ok    samples/Three in a browser: $(grep -c '^hash' "$log") hashes as in C#, in $(( SECONDS - start )) s"
