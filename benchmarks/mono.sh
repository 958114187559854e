#!/usr/bin/env bash
# Times the netstandard2.1 assembly next to the plain yardstick on Mono, the runtime closest to Unity's.
#   benchmarks/mono.sh [SECONDS]     time for each row; default 2
# Needs mono and mcs (Debian: mono-devel).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/Football.Physics.Mono"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
dotnet build -c Release -o "$work" > "$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
mcs -nologo -out:"$work/host.exe" -r:"$work/steps.dll" -r:Facades/netstandard.dll Host.cs
mono --version | head -n 1
echo
mono "$work/host.exe" "$@"
