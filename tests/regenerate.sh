#!/usr/bin/env bash
# Writes anew what is generated from the code: the golden hashes (golden.sh does those alone), docs/api.md, the pictures of docs/, llms.txt, the tables of docs/c.md, what the programs in README.md and docs/ print, the
# table of docs/internals/accuracy.md, and the errors of the reference cases, the C header and the hashes of tests/Native; and lowers the ceilings of tests/ceilings.tsv.
# Look at the differences before committing them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# First: the site, which tests write, contains the pictures.
dotnet run -c Release --project docs/Site -- --pictures
FOOTBALL_REGENERATE=1 dotnet test -c Release tests/Package.Tests
FOOTBALL_REGENERATE=1 dotnet test -c Release tests/Football.Physics.Tests --filter "FullyQualifiedName~ReferenceBoundTests|FullyQualifiedName~ProfileTests|FullyQualifiedName~CeilingTests"
FOOTBALL_REGENERATE=1 dotnet test -c Release tests/Football.Physics.Labs.Tests --filter FullyQualifiedName~ReadmeTests
FOOTBALL_REGENERATE=1 dotnet test -c Release tests/Football.Physics.Native.Tests
dotnet run -c Release --project src/Football.Tool -- replay docs/free-kick.json -o out/free-kick.html --svg docs/free-kick.svg > /dev/null
git --no-pager diff --stat -- tests/ceilings.tsv tests/Golden tests/Native src/Football.Physics.Native/include tests/Football.Physics.Tests/Reference docs README.md llms.txt
