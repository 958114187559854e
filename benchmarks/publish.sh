# Sourced by the scripts that publish programs: sets a working directory, and the name of this system.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=false
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
rid=$(dotnet --info | awk '$1 == "RID:" { print $2; exit }')
case $rid in *-arm64) rid=linux-arm64 ;; *) rid=linux-x64 ;; esac
