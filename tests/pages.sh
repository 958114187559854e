#!/usr/bin/env bash
# Opens the pages that the command line and docs/Site write in a headless Chromium, asks them what they drew, and makes pictures
# of them: desktop and 390 pixels wide, light and dark. Kicks 200 balls on the page to play with, at 10 per second.
#   tests/pages.sh [DIR]     pictures in DIR (default out/pages); one line a check; exit code 1 at the first that fails
# Needs a Chromium and Python; run by root on Debian it installs the smallest there is.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_CLI_UI_LANGUAGE=en
export MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=${UseSharedCompilation:-false}

out=${1:-out/pages}
mkdir -p "$out"
out=$(cd "$out" && pwd)
work=$(mktemp -d)
player=
trap '[[ -z $player ]] || kill "$player" 2> /dev/null || :; rm -rf "$work"' EXIT

fail() {
  echo "FAIL  $1" >&2
  exit 1
}

find_browser() { type -P chromium-headless-shell || type -P chromium || type -P chromium-browser || type -P google-chrome; }
browser=$(find_browser) || {
  (( EUID == 0 )) || fail "no Chromium: apt-get install chromium-headless-shell"
  { apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends chromium-headless-shell; } > "$work/log" 2>&1 \
    || { tail -n 5 "$work/log" >&2; fail "apt-get install chromium-headless-shell"; }
  browser=$(find_browser) || fail "no Chromium"
  echo "ok    installed $(basename "$browser")"
}

# What a page says of itself: the size of the window, how wide the page is, and what it drew on a canvas if it has one.
# The attributes stand in the element <body> of the dump.
report='<script>(function () {
  const said = document.body.dataset, root = document.documentElement, stage = document.getElementById("stage");
  said.window = innerWidth; said.wide = root.scrollWidth; said.dark = matchMedia("(prefers-color-scheme: dark)").matches;
  if (!stage) return;
  const d = stage.getContext("2d").getImageData(0, 0, stage.width, stage.height).data;
  const near = function (r, g, b) { let n = 0; for (let i = 0; i !== d.length; i += 4) if (24 > Math.abs(d[i] - r) + Math.abs(d[i + 1] - g) + Math.abs(d[i + 2] - b)) n++; return n; };
  said.pixels = [near(0, 114, 178), near(224, 123, 0), near(255, 255, 255)].join(" ");
})();</script>'

# probe PAGE [SCRIPT]: the page with the report, and with a script before it, beside it; says where.
probe() {
  local to=${1%.html}-probe${2:+-acts}.html
  SCRIPT=${2:+<script>$2</script>} REPORT=$report awk '{ at = index($0, "</body>"); if (at) print substr($0, 1, at - 1) ENVIRON["SCRIPT"] ENVIRON["REPORT"] substr($0, at); else print }' "$1" > "$to"
  echo "$to"
}

# open NAME SIZE THEME URL [ARGUMENT…]: what Chromium makes of a page, in a profile of its own; its dump in $work/NAME.dom.
open() {
  local name=$1 size=$2 dark=1 url=$4
  [[ $3 == dark ]] && dark=0
  shift 4
  timeout 180 "$browser" --headless --no-sandbox --disable-gpu --hide-scrollbars --force-device-scale-factor=1 --enable-logging=stderr \
    --user-data-dir="$work/profile-$name" --window-size="$size" --blink-settings=preferredColorScheme=$dark \
    --virtual-time-budget=500 --host-resolver-rules="MAP * ~NOTFOUND" --dump-dom "$@" "$url" > "$work/$name.dom" 2> "$work/$name.log" \
    || { tail -n 3 "$work/$name.log" >&2; fail "$name: Chromium"; }
  ! grep -E 'CONSOLE.*(Uncaught|Error)' "$work/$name.log" >&2 || fail "$name: the page's program has an error"
}

# said NAME WHAT: what a page said.
said() { grep -o "data-$2=\"[^\"]*\"" "$work/$1.dom" | head -n 1 | sed 's/^[^"]*"//; s/"$//; s/&quot;/"/g' || true; }

# picture NAME SIZE THEME URL: a picture, and whether the page fits into its window. A picture of nothing has a few thousand bytes.
picture() {
  local width=${2%,*} name=$1-${2%,*}-$3
  open "$name" "$2" "$3" "$4" --screenshot="$out/$name.png"
  (( $(stat -c %s "$out/$name.png") > 12000 )) || fail "$name: nothing in the picture"
  [[ $(said "$name" window) == "$width" ]] || fail "$name: the window is $(said "$name" window) wide"
  (( $(said "$name" wide) <= width )) || fail "$name: the page is $(said "$name" wide) pixels wide"
  [[ $(said "$name" dark) == "$([[ $3 == dark ]] && echo true || echo false)" ]] || fail "$name: not $3"
}

# pictures NAME PAGE [PLACE]: both sizes in both themes, two at a time.
pictures() {
  local url=file://$(probe "$2")${3:-} size
  for size in 1280,900 390,844; do
    picture "$1" "$size" light "$url" & local light=$!
    picture "$1" "$size" dark "$url" || exit 1
    wait "$light" || exit 1
    ! cmp -s "$out/$1-${size%,*}-light.png" "$out/$1-${size%,*}-dark.png" || fail "$1: light and dark are the same"
  done
  echo "ok    $1: 1280 and 390 pixels wide, light and dark, nothing beyond the edge: ${out#"$PWD/"}/$1-*.png"
}

build() { dotnet build -c Release "$1" -v q > "$work/log" 2>&1 || { cat "$work/log" >&2; fail "dotnet build $1"; }; }
# .ci/run has built the solution.
[[ ${CI:-} == true ]] || { build src/Football.Tool; build docs/Site; }
football() { dotnet src/Football.Tool/bin/Release/net10.0/football.dll "$@" > /dev/null 2> "$work/log" || { cat "$work/log" >&2; fail "football $1"; }; }

# --- the page to play with, beside all others: twenty seconds of it are kicks

football gallery --out "$work/gallery"
python3 tests/play.py "$work/gallery/play.html" "$out" > "$work/play.log" 2>&1 & player=$!

# --- the page that moves

cat > "$work/post.json" <<'JSON'
{"name": "Off the bar", "scenario": {"launch": {"position": [0, 0.11, 0], "velocity": [-2, 6.2, -24], "spin": [30, 20, 0]},
 "goals": [{"center": [0, 0, -22], "facing": [0, 0, 1]}], "stop": {"at": "rest"}}}
JSON
cat > "$work/wall.json" <<'JSON'
{"name": "Over the wall", "scenario": {"launch": {"position": [0, 0.11, 0], "velocity": [6.5, 8.4, -23], "spin": [-11, 60, -3]},
 "goals": [{"center": [0, 0, -22], "facing": [0, 0, 1]}], "stop": {"at": "rest"},
 "obstacles": [{"name": "wall", "shape": "box", "center": [1.5, 0.925, -9.35], "halfSize": [1.6, 0.925, 0.2]}]}}
JSON
football replay "$work/post.json" "$work/wall.json" -o "$work/replay.html"

pictures replay "$work/replay.html" "#time=0.9"
# What the page says that it drew, and whether the pixels of the canvas say so too.
drawn=$(said replay-1280-light drawn)
[[ -n $drawn ]] || fail "replay: nothing was drawn"
for part in '"time":0.9' '"shots":2' '"balls":2' '"faces":[1-9]' '"ground":[1-9]' '"marks":[1-9]' '"pieces":[1-9][0-9][0-9]' '"lines":[1-9][0-9]'; do
  grep -qE "$part" <<< "$drawn" || fail "replay: $part is not in $drawn"
done
read -r blue orange white <<< "$(said replay-1280-light pixels)"
(( blue > 300 && orange > 300 && white > 500 )) || fail "replay: too few pixels of the paths and of the goal ($blue, $orange, $white)"
echo "ok    replay: drew $(tr -d '"{}' <<< "$drawn"); pixels of both paths and of the goal: $blue, $orange, $white"

open later 1280,900 light "file://$work/replay.html#time=2.5" & later=$!
# Frames of the virtual time, which passes whether or not the machine has time to show them.
sed 's|<head>|<head><script>requestAnimationFrame = function (f) { return setTimeout(function () { f(performance.now()); }, 50); };</script>|' "$work/replay.html" > "$work/plays.html"
open plays 1280,900 light "file://$work/plays.html"
wait "$later" || exit 1
grep -q '"time":2.5' <<< "$(said later drawn)" || fail "replay: the time in the address is not shown"
grep -qE '"time":0\.[1-9]' <<< "$(said plays drawn)" || fail "replay: it does not play"
echo "ok    replay: plays, and shows the time that the address names"

# What a person does: keys, the slider, a drag that turns, the pointer over a path; beside each what is then to be seen.
acts=$(probe "$work/replay.html" '
  const id = function (name) { return document.getElementById(name); }, stage = id("stage"), done = [];
  const time = function () { return JSON.parse(stage.dataset.drawn).time; };
  const key = function (name) { document.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true })); };
  const pointer = function (kind, x, y) { stage.dispatchEvent(new PointerEvent(kind, { pointerId: 1, clientX: x, clientY: y, bubbles: true })); };
  const told = function (what, is) { if (is) done.push(what); };
  stage.setPointerCapture = function () { };
  key("Home"); told("home", time() === 0);
  key("ArrowRight"); told("on", time() === 0.02);
  key("ArrowLeft"); told("back", time() === 0);
  key("n"); const event = time(); told("event", event > 0.5);
  key("End"); told("end", time() > event);
  key("ArrowDown"); told("slower", id("speed").value === "0.5");
  id("time").value = 1.25; id("time").dispatchEvent(new Event("input")); told("slider", time() === 1.25);
  key("3"); told("view", document.querySelector("[data-view=above]").getAttribute("aria-pressed") === "true");
  key("1");
  const before = stage.toDataURL();
  pointer("pointerdown", 700, 300); pointer("pointermove", 820, 330); pointer("pointerup", 820, 330); told("turned", stage.toDataURL() !== before);
  key("1");
  const d = stage.getContext("2d").getImageData(0, 0, stage.width, stage.height).data;
  let path = 0;
  while (path < d.length && (d[path] !== 0 || d[path + 1] !== 114 || d[path + 2] !== 178)) path += 4;
  pointer("pointermove", path / 4 % stage.width, Math.floor(path / 4 / stage.width)); told("numbers", /m\/s[^]*rad\/s/.test(id("tip").textContent));
  id("shots").querySelector("input").click(); told("hidden", JSON.parse(stage.dataset.drawn).shots === 1);
  key(" "); told("pause", id("play").getAttribute("aria-label") === "Pause"); key(" ");
  document.body.dataset.acts = done.join(" ");
')
open acts 1280,900 light "file://$acts#time=1"
acts=$(said acts acts)
[[ $acts == "home on back event end slower slider view turned numbers hidden pause" ]] || fail "replay: of what a person does only this works: $acts"
echo "ok    replay: keys, slider, drag, pointer and boxes do what they say: $acts"

# --- the gallery

pictures gallery "$work/gallery/index.html"
shots=$(grep -o '<article ' "$work/gallery/index.html" | wc -l || true)
copies=$(probe "$work/gallery/index.html" '
  const copied = [];
  Object.defineProperty(navigator, "clipboard", { value: { writeText: function (text) { copied.push(text); return Promise.resolve(); } } });
  for (const button of document.querySelectorAll("button")) button.click();
  document.body.dataset.copied = copied.filter(function (text) { return /^using FootballPhysics|football replay -/.test(text); }).length;
')
open copies 1280,900 light "file://$copies"
buttons=$(grep -o 'aria-label="Copy the line"' "$work/gallery/index.html" | wc -l || true)
(( $(said copies copied) == buttons && buttons > shots )) || fail "gallery: $(said copies copied) of $buttons lines can be copied"
echo "ok    gallery: $shots shots, $(said copies copied) lines to copy"

# The page that moves, picture by picture: at the kick the ball lies behind nothing; whoever drags the camera down stays above the grass; nets give way; a story ends before the ball has rolled out, and begins again.
plays=$(probe "$work/gallery/replay.html" '
  const id = function (name) { return document.getElementById(name); }, stage = id("stage"), picture = id("picture"), told = { seen: 0, above: 0, bulged: 0, plays: 0, free: [] };
  const drawn = function () { return JSON.parse(stage.dataset.drawn); };
  const pointer = function (kind, x, y) { stage.dispatchEvent(new PointerEvent(kind, { pointerId: 1, clientX: x, clientY: y, bubbles: true })); };
  const key = function (name) { document.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true })); };
  stage.setPointerCapture = function () { };
  for (const option of picture.options) {
    picture.value = option.value; picture.dispatchEvent(new Event("change"));
    if (id("play").getAttribute("aria-label") === "Pause") told.plays++;
    key("Home");
    const at = drawn().ball, on = at === null ? null : document.elementFromPoint(at[0], at[1]);
    if (on === stage) told.seen++; else told.free.push(option.value);
    pointer("pointerdown", 600, 300); pointer("pointermove", 600, 40); pointer("pointerup", 600, 40);
    if (drawn().eye > 0.2) told.above++;
    let deepest = 0;
    for (let t = 0; t !== 40; t++) { id("time").value = 0.1 * t; id("time").dispatchEvent(new Event("input")); deepest = Math.max(deepest, drawn().bulges); }
    if (deepest !== 0) told.bulged++;
  }
  document.body.dataset.told = [picture.options.length, told.plays, told.seen, told.above, told.bulged, told.free.join(",")].join(" ");
')
for size in 1280,900 390,844; do
  open plays "$size" light "file://$plays"
  read -r all playing seen above bulged hidden <<< "$(said plays told)"
  (( all == shots && playing == all && above == all && seen == all && bulged >= 8 )) || fail "replay, ${size%,*} pixels: of $all pictures $playing play when chosen, $seen show the ball at the kick (not $hidden), $above keep the camera above the grass, $bulged move a net"
done
echo "ok    replay: of $all pictures all play when chosen, show the ball at the kick with nothing on it, keep the camera above the grass; the nets move in $bulged"

# --- the site

dotnet docs/Site/bin/Release/net10.0/football-site.dll "$work/site" > "$work/log" 2>&1 || { cat "$work/log" >&2; fail "docs/Site"; }
pictures site "$work/site/index.html"
pictures type "$work/site/api-ball.html"
search=$(probe "$work/site/index.html" 'document.getElementById("search").value = "roll back"; prepare().then(show);')
open search 1280,900 light "file://$search"
grep -q '<li><a href="networking.html#rollback"' "$work/search.dom" || fail "site: the search does not find what is there"
echo "ok    site: $(ls "$work/site"/*.html | grep -vc probe) pages; the search answers"

wait "$player" || { player=; cat "$work/play.log" >&2; exit 1; }
player=
sed "s|$PWD/||g" "$work/play.log"
