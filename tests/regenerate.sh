#!/usr/bin/env bash
# Writes anew what is generated from the code: tests/Golden/golden.txt and docs/api.md. Look at the differences before committing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
FOOTBALL_REGENERATE=1 dotnet test -c Release tests/Package.Tests --filter "FullyQualifiedName~GoldenTests|FullyQualifiedName~ApiReferenceTests"
git --no-pager diff --stat -- tests/Golden docs/api.md
