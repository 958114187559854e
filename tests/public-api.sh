#!/usr/bin/env bash
# Writes the public surface anew into src/Football.Physics/PublicAPI.Unshipped.txt, from what the analyzer finds that is not on record.
# Look at the differences before committing them: what is gone or changed goes into the upgrade table of docs/changelog.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../src/Football.Physics"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
echo '#nullable enable' > PublicAPI.Unshipped.txt
dotnet build -c Release -f net10.0 -p:RunAnalyzers=true -p:RunAnalyzersDuringBuild=true -p:TreatWarningsAsErrors=false \
  "-p:OutputPath=$work/bin/" "-p:IntermediateOutputPath=$work/obj/" > "$work/log" || { cat "$work/log"; exit 1; }
{
  echo '#nullable enable'
  sed -n "s/.*warning RS0016: Symbol '\(.*\)' is not part of the declared public API.*/\1/p" "$work/log" | grep -v '(forwarded,' | LC_ALL=C sort -u
} > "$work/surface"
mv "$work/surface" PublicAPI.Unshipped.txt
grep -c . PublicAPI.Unshipped.txt
