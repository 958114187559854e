#!/usr/bin/env bash
# The first use of each thing in a process, in a program that is published with its code compiled ahead of time (ReadyToRun). A table in Markdown.
#   benchmarks/firstuse.sh
# Just in time: dotnet run -c Release --project benchmarks/Football.Physics.Benchmarks -- quick --only "first use"
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=false
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
rid=$(dotnet --info | awk '$1 == "RID:" { print $2; exit }')
case $rid in *-arm64) rid=linux-arm64 ;; *) rid=linux-x64 ;; esac
dotnet publish benchmarks/Football.Physics.Benchmarks -c Release -r "$rid" --self-contained false -p:PublishReadyToRun=true -p:RunAnalyzers=false \
  -p:NuGetLockFilePath=obj/ready.lock.json --artifacts-path "$work" -o "$work/out" > "$work/log" 2>&1 || { tail -n 5 "$work/log" >&2; exit 1; }
dotnet "$work/out/Football.Physics.Benchmarks.dll" quick --only "first use"
