#!/usr/bin/env bash
# The first use of each thing in a process, in a program that is published with its code compiled ahead of time (ReadyToRun). A table in Markdown.
#   benchmarks/firstuse.sh
# Just in time: dotnet run -c Release --project benchmarks/Football.Physics.Benchmarks -- quick --only "first use"
. "$(dirname "${BASH_SOURCE[0]}")/publish.sh"
dotnet publish benchmarks/Football.Physics.Benchmarks -c Release -r "$rid" --self-contained false -p:PublishReadyToRun=true -p:RunAnalyzers=false \
  -p:NuGetLockFilePath=obj/ready.lock.json --artifacts-path "$work" -o "$work/out" > "$work/log" 2>&1 || { tail -n 5 "$work/log" >&2; exit 1; }
dotnet "$work/out/Football.Physics.Benchmarks.dll" quick --only "first use"
