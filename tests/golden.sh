#!/usr/bin/env bash
# Writes tests/Golden/golden.txt anew: the bits that every runtime must reproduce. Look at the difference before committing it.
#   tests/golden.sh
#   tests/golden.sh --states [COMMIT]    writes artifacts/golden-states-COMMIT.txt: each line with its path every 0.1 s, by the library of the commit; default: the working tree
#   tests/golden.sh --moved COMMIT [TO]  prints each line that moved from the library of a commit to that of another one, with its largest change in metres; TO: a commit; default: the working tree
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# The golden programs are those of the working tree; only the library is that of the commit.
states() {
  local root=$PWD out=artifacts/golden-states${1:+-$1}.txt
  mkdir -p artifacts
  if [[ -n ${1:-} ]]; then
    root=$(mktemp -d)
    trap 'rm -rf "$root"' RETURN
    git archive "$1" | tar -x -C "$root"
    rm -r "$root/tests"
    git ls-files -z tests/Golden tests/Package.Consumer | tar -c --null -T - | tar -x -C "$root"
  fi
  dotnet run -c Release -v q --project "$root/tests/Package.Consumer" -p:RunAnalyzers=false -p:LibraryProject=true -p:TargetFrameworks=net10.0 -- --states 2> /dev/null > "$out" || { cat "$out" >&2; return 1; }
  echo "$out"
}

case ${1:-} in
  --states)
    states "${2:-}" ;;
  --moved)
    from=$(states "$2")
    to=$(states "${3:-}")
    tests/golden_moves.py "$from" "$to" ;;
  *)
    FOOTBALL_REGENERATE=1 dotnet test -c Release tests/Package.Tests -p:RunAnalyzers=false --filter "FullyQualifiedName~GoldenTests"
    git --no-pager diff --stat -- tests/Golden ;;
esac
