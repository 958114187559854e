#!/usr/bin/env bash
# Opens the pages that the command line writes in a headless Chromium, looks at what they drew, and makes pictures of them:
# desktop and 390 pixels wide, light and dark.
#   tests/pages.sh [DIR]     pictures in DIR (default out/pages); one line a check; exit code 1 at the first that fails
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_CLI_UI_LANGUAGE=en
export MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=false

out=${1:-out/pages}
mkdir -p "$out"
out=$(cd "$out" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) \
  || { echo "FAIL  no Chromium: apt-get install chromium" >&2; exit 1; }

fail() {
  echo "FAIL  $1" >&2
  exit 1
}

# open SIZE THEME ARGUMENT… URL: what Chromium does with a page, in a profile of its own.
open() {
  local size=$1 dark=1
  [[ $2 == dark ]] && dark=0
  shift 2
  rm -rf "$work/profile"
  timeout 60 "$browser" --headless --no-sandbox --disable-gpu --hide-scrollbars --force-device-scale-factor=1 \
    --user-data-dir="$work/profile" --window-size="$size" --blink-settings=preferredColorScheme=$dark \
    --virtual-time-budget=2000 --host-resolver-rules="MAP * ~NOTFOUND" "$@" 2> "$work/log"
}

# pictures NAME URL: both sizes in both themes; a picture of nothing has a few thousand bytes.
pictures() {
  local size theme file
  for size in 1280,900 390,844; do
    for theme in light dark; do
      file=$out/$1-${size%,*}-$theme.png
      open "$size" "$theme" --screenshot="$file" "$2" || fail "$1: no picture"
      (( $(stat -c %s "$file") > 12000 )) || fail "$1: nothing in $file"
    done
  done
  cmp -s "$out/$1-1280-light.png" "$out/$1-1280-dark.png" && fail "$1: light and dark are the same"
  grep -qE 'Uncaught|SyntaxError' "$work/log" && fail "$1: $(grep -E 'Uncaught|SyntaxError' "$work/log" | head -n 1)"
  echo "ok    $1: 4 pictures in $out"
}

dotnet build -c Release samples/Football.Physics.Headless -v q > "$work/log" 2>&1 || { cat "$work/log" >&2; fail "dotnet build"; }
football() { dotnet samples/Football.Physics.Headless/bin/Release/net10.0/football.dll "$@"; }

cat > "$work/post.json" <<'JSON'
{"name": "Off the bar", "scenario": {"launch": {"position": [0, 0.11, 0], "velocity": [-2, 6.2, -24], "spin": [30, 20, 0]},
 "goals": [{"center": [0, 0, -22], "facing": [0, 0, 1]}], "stop": {"at": "rest"}}}
JSON
cat > "$work/wall.json" <<'JSON'
{"name": "Over the wall", "scenario": {"launch": {"position": [0, 0.11, 0], "velocity": [6.5, 8.4, -23], "spin": [-11, 60, -3]},
 "goals": [{"center": [0, 0, -22], "facing": [0, 0, 1]}], "stop": {"at": "rest"},
 "obstacles": [{"name": "wall", "shape": "box", "center": [1.5, 0.925, -9.35], "halfSize": [1.6, 0.925, 0.2]}]}}
JSON
football replay "$work/post.json" "$work/wall.json" -o "$work/replay.html" > /dev/null 2>&1 || fail "football replay"

# What the page says that it drew, and whether the pixels of the canvas say so too.
sed 's|</body>|<script>requestAnimationFrame(() => { const c = document.getElementById("stage"); const d = c.getContext("2d").getImageData(0, 0, c.width, c.height).data; const near = (r, g, b) => { let n = 0; for (let i = 0; i !== d.length; i += 4) if (Math.abs(d[i] - r) + Math.abs(d[i + 1] - g) + Math.abs(d[i + 2] - b) < 24) n++; return n; }; document.body.dataset.pixels = [near(0, 114, 178), near(224, 123, 0), near(255, 255, 255)].join(" "); });</script></body>|' \
  "$work/replay.html" > "$work/probe.html"
open 1280,900 light --dump-dom "file://$work/probe.html#time=0.9" > "$work/dom"
drawn=$(grep -o 'data-drawn="[^"]*"' "$work/dom" | sed 's/&quot;/"/g') || fail "replay: nothing was drawn"
for part in '"time":0.9' '"shots":2' '"balls":2' '"faces":[1-9]' '"ground":[1-9]' '"marks":[1-9]' '"pieces":[1-9][0-9][0-9]' '"lines":[1-9][0-9]'; do
  grep -qE "$part" <<< "$drawn" || fail "replay: $part is not in $drawn"
done
read -r blue orange white < <(grep -o 'data-pixels="[^"]*"' "$work/dom" | tr -dc '0-9 \n')
(( blue > 300 && orange > 300 && white > 500 )) || fail "replay: too few pixels of the paths and of the goal ($blue, $orange, $white)"
echo "ok    replay: drew $(sed 's/data-drawn=//; s/["{}]//g' <<< "$drawn"); pixels of both paths and of the goal: $blue, $orange, $white"
later=$(open 1280,900 light --dump-dom "file://$work/probe.html#time=2.5" | grep -o 'data-drawn="[^"]*"')
grep -q 'time&quot;:2.5' <<< "$later" || fail "replay: the time in the address is not shown"
playing=$(open 1280,900 light --dump-dom "file://$work/replay.html" | grep -o 'data-drawn="[^"]*"')
grep -q 'time&quot;:0,' <<< "$playing" && fail "replay: it does not play"
echo "ok    replay: plays, and shows the time that the address names"
pictures replay "file://$work/replay.html#time=0.9"

dotnet run -c Release --project docs/Site -- "$work/site" > "$work/log" 2>&1 || { cat "$work/log" >&2; fail "docs/Site"; }
sed 's|</body>|<script>document.getElementById("search").value = "roll back"; show();</script></body>|' "$work/site/index.html" > "$work/site/probe.html"
open 1280,900 light --dump-dom "file://$work/site/probe.html" > "$work/dom"
grep -q '<li><a href="determinism.html#rollback"' "$work/dom" || fail "site: the search does not find what is there"
rm "$work/site/probe.html"
echo "ok    site: $(ls "$work/site"/*.html | wc -l) pages; the search answers"
pictures site "file://$work/site/index.html"

football gallery --out "$work/gallery" > /dev/null 2>&1 || fail "football gallery"
pictures gallery "file://$work/gallery/index.html"
