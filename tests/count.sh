#!/usr/bin/env bash
# Prints the numbers of README.md: how many tests there are, and how long they take.
#   tests/count.sh         runs the tests as README.md says, and prints the number of tests, of skipped ones, the minutes and the processors
#   tests/count.sh LOG     prints the numbers of passed, failed and skipped tests in a log of dotnet test
set -euo pipefail

# A line of the log: Passed!  - Failed:     0, Passed:    12, Skipped:     1, Total:    13, Duration: 1 s - Some.Tests.dll (net10.0)
count() {
  awk '
    /^ *(Passed|Failed|Skipped)! +- Failed: +[0-9]+, Passed: +[0-9]+, Skipped: +[0-9]+, Total: / {
      split($0, part, ",")
      for (i = 1; i <= 3; i++) { gsub(/[^0-9]/, "", part[i]) }
      failed += part[1]; passed += part[2]; skipped += part[3]
    }
    END { print passed + 0, failed + 0, skipped + 0 }' "$1"
}

if (( $# > 0 )); then
  count "$1"
  exit
fi

cd "$(dirname "${BASH_SOURCE[0]}")/.."
log=$(mktemp)
trap 'rm -f "$log"' EXIT
start=$SECONDS
status=0
tests/blocks.py run README.md#start 2 2>&1 | tee "$log" || status=$?
read -r passed failed skipped < <(count "$log")
awk -v passed="$passed" -v failed="$failed" -v skipped="$skipped" -v seconds=$(( SECONDS - start )) -v processors="$(nproc)" 'BEGIN {
  printf "%d tests: %d passed, %d failed, %d skipped; %.1f minutes on %d processors\n", passed + failed + skipped, passed, failed, skipped, seconds / 60, processors
}'
exit "$status"
