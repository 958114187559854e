#!/usr/bin/env bash
# Packs the package for Unity: samples/Unity/pack.cs, which runs without bash too.
#   samples/Unity/build.sh [DIR]             the .tgz in DIR (default out)
#   samples/Unity/build.sh --branch NAME     the built package as a git branch, for Unity's "Install package from git URL"
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=${UseSharedCompilation:-false}
exec dotnet run samples/Unity/pack.cs "$@"
