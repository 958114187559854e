#!/usr/bin/env bash
# Measures the cost of fitting a minute's track: football fit --match, and fit_match from Python. Complete processes alternate on one core; each time is the least of several rounds. Prints ratios to the tool.
#   benchmarks/tracks.sh [ROUNDS]      default 7
# Needs a C compiler and Debian's python3-numpy.
rounds=${1:-7}
. "$(dirname "${BASH_SOURCE[0]}")/publish.sh"

src/Football.Physics.Native/build.sh "$work/prefix" 2> "$work/log" || { tail -n 5 "$work/log" >&2; exit 1; }
dotnet publish -c Release src/Football.Tool -o "$work/tool" > "$work/log" 2>&1 || { tail -n 5 "$work/log" >&2; exit 1; }
cp -R src/Football.Physics.Python/football_physics "$work/"
cp "$work/prefix/lib/libfootball_physics.so" "$work/football_physics/"
export PYTHONPATH=$work
/usr/bin/python3 benchmarks/Borders/track.py make "$work/track.csv"

# timed COMMAND...: prints the seconds that the command takes.
timed() {
  local start=$EPOCHREALTIME
  taskset -c 0 "$@" > "$work/said" 2> "$work/log" || { tail -n 5 "$work/log" >&2; exit 1; }
  awk -v from="$start" -v to="$EPOCHREALTIME" 'BEGIN { print to - from }'
}
least() { sort -g | head -n 1; }
for (( i = 0; i < rounds; i++ )); do
  timed dotnet "$work/tool/football.dll" fit --match "$work/track.csv" >> "$work/tool.times"
  timed /usr/bin/python3 benchmarks/Borders/track.py fit "$work/track.csv" >> "$work/python.times"
done
cat "$work/said"
awk -v tool="$(least < "$work/tool.times")" -v python="$(least < "$work/python.times")" 'BEGIN {
  print "| | s | ratio |"
  print "|---|--:|--:|"
  printf "| football fit --match | %.2f | 1 |\n| Python, `fit_match` | %.2f | %.2f |\n", tool, python, python / tool
}'
