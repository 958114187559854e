#!/usr/bin/env bash
# What a data set must bear, with the program as it is published: kill -9 and resume, any number of threads and shards, registers of any width, a closed
# pipe, a full disk, and memory that does not grow with the rows.
#   tests/sweep.sh              one line a check; exit code 1 at the first that fails
#   COUNT=10000000 tests/sweep.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
SECONDS=0

export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_CLI_UI_LANGUAGE=en
export MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=${UseSharedCompilation:-false}

count=${COUNT:-500000}
most_mib=300
work=$(mktemp -d)
log=$work/log
: > "$log"
trap 'rm -rf "$work"' EXIT

fail() {
  echo "FAIL  $1" >&2
  [[ -s $log ]] && tail -n 20 "$log" >&2
  exit 1
}

ok() { echo "ok    $1"; : > "$log"; }

program=src/Football.Tool/bin/Release/net10.0/football.dll
[[ -e $program ]] || dotnet build -c Release src/Football.Tool > "$log" 2>&1 || fail "dotnet build"
football() { dotnet "$program" "$@"; }
rows() { football sweep --count "$count" --seed 7 --format npy --out "$@" >> "$log" 2>&1; }
same() {
  local file
  for file in "$work"/one/*; do
    cmp "$file" "$1/$(basename "$file")" >> "$log" 2>&1 || fail "$2: other bytes"
  done
}

rows "$work/one" --jobs 2 || fail "sweep"
said=$(tail -n 1 "$log")
mib=$(sed -E 's/.* at most ([0-9]+) MiB.*/\1/' <<< "$said")
(( mib <= most_mib )) || fail "$mib MiB of memory; allowed: $most_mib"
ok "$count rows, $(du -sm "$work/one" | cut -f 1) MiB on disk; ${said#*: }"

rows "$work/jobs" --jobs 1 || fail "one thread"
same "$work/jobs" "one thread"
rm -r "$work/jobs"
ok "one thread and two: the same bytes"

# tests/cluster.sh has sixteen.
for (( i = 1; i <= 7; i++ )); do rows "$work/parts" --shard "$i/7" --jobs $(( 1 + i % 2 )) || fail "shard $i of 7"; done
football sweep merge "$work/parts" >> "$log" 2>&1 || fail "merge of 7 shards"
same "$work/parts" "7 shards"
rm -r "$work/parts"
ok "7 shards, merged: the same bytes"

DOTNET_EnableAVX512=0 DOTNET_EnableAVX512F=0 rows "$work/narrow" || fail "without AVX-512"
same "$work/narrow" "without AVX-512"
rm -r "$work/narrow"
ok "without AVX-512: the same bytes"

# Killed at three times, each later than the one before; then it may end.
killed=0
before=-1
for delay in 0.1 0.2 0.3; do
  dotnet "$program" sweep --count "$count" --seed 7 --format npy --out "$work/killed" >> "$log" 2>&1 &
  pid=$!
  certain() { sed -nE 's/^  "rows": ([0-9]+),/\1/p' "$work/killed/checkpoint.json" 2> /dev/null || true; }
  while kill -0 "$pid" 2> /dev/null; do
    at=$(certain)
    (( ${at:-0} > before && ${at:-0} > 0 )) && break
    sleep 0.02
  done
  sleep "$delay"
  if kill -9 "$pid" 2> /dev/null; then killed=$(( killed + 1 )); fi
  wait "$pid" 2> /dev/null || true
  before=$(certain)
  before=${before:-$count}
done
rows "$work/killed" || fail "resume"
same "$work/killed" "kill -9 and resume"
(( killed > 0 )) || fail "it was never killed: too few rows"
resumed=$(tail -n 1 "$log")
rm -r "$work/killed"
ok "kill -9, $killed times, and resumed: the same bytes;${resumed#*rows,}"

status=0
{ football sweep --count 1000000000000 2>> "$log" || echo "$?" > "$work/status"; } | head -n 1 > /dev/null
status=$(< "$work/status")
[[ $status == 141 ]] || fail "a closed pipe: exit code $status"
ok "a closed pipe ends it at once, with 141"

mkdir "$work/full"
ln -s /dev/full "$work/full/rows.csv"
if football sweep --count 1000000000000 --format csv --out "$work/full" > "$log" 2>&1; then fail "a full disk"; fi
grep -q "No space left" "$log" || fail "a full disk is not told"
ok "a full disk ends it at once: $(tail -n 1 "$log" | sed "s|$work/||")"

echo "ok    sweep.sh: $SECONDS s"
