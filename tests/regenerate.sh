#!/usr/bin/env bash
# Writes anew what is generated from the code: the golden hashes, docs/api.md, and what the programs in README.md and docs/ print.
# Look at the differences before committing them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
FOOTBALL_REGENERATE=1 dotnet test -c Release tests/Package.Tests
git --no-pager diff --stat -- tests/Golden docs README.md
