#!/usr/bin/env bash
# Writes the public surface anew into PublicAPI.Unshipped.txt of the library and of its parts, from what the analyzer finds that is not on record.
# Look at the differences before committing them: what is gone or changed since the last release goes into docs/changelog.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../src"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for part in Football.Physics Football.Physics.{Thesis,Tracks}; do
  echo '#nullable enable' > "$part/PublicAPI.Unshipped.txt"
  # That of the part alone: what the analyzer says of another one is not its own.
  dotnet build -c Release -f net10.0 -p:RunAnalyzers=true -p:RunAnalyzersDuringBuild=true -p:TreatWarningsAsErrors=false --no-incremental \
    --artifacts-path "$work/artifacts" "$part" > "$work/log" || { cat "$work/log"; exit 1; }
  {
    echo '#nullable enable'
    sed -n "s|.*warning RS0016: Symbol '\(.*\)' is not part of the declared public API.*\[.*/$part\.csproj.*|\1|p" "$work/log" | grep -v '(forwarded,' | LC_ALL=C sort -u
  } > "$work/surface"
  mv "$work/surface" "$part/PublicAPI.Unshipped.txt"
  echo "$part $(grep -c . "$part/PublicAPI.Unshipped.txt")"
done
