#!/usr/bin/env bash
# Writes tests/Golden/golden.txt anew: the bits that every runtime must reproduce. Look at the difference before committing it.
#   tests/golden.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
FOOTBALL_REGENERATE=1 dotnet test -c Release tests/Package.Tests -p:RunAnalyzers=false --filter "FullyQualifiedName~GoldenTests"
git --no-pager diff --stat -- tests/Golden
