#!/usr/bin/env bash
# What a step costs through each border, in ns a step: C#, C, Python with one ball and with 4 096. A table in Markdown; the least of many rounds, one after the other.
#   benchmarks/borders.sh
# Needs a C compiler and Debian's python3-numpy.
. "$(dirname "${BASH_SOURCE[0]}")/publish.sh"

src/Football.Physics.Native/build.sh "$work/prefix" 2> "$work/log" || { tail -n 5 "$work/log" >&2; exit 1; }
dotnet build -c Release benchmarks/Borders -o "$work/csharp" > "$work/log" 2>&1 || { tail -n 5 "$work/log" >&2; exit 1; }
gcc -O2 -std=c99 -I"$work/prefix/include" benchmarks/Borders/cost.c -o "$work/cost" -L"$work/prefix/lib" -lfootball_physics "-Wl,-rpath,$work/prefix/lib"
cp -R src/Football.Physics.Python/football_physics "$work/"
cp "$work/prefix/lib/libfootball_physics.so" "$work/football_physics/"

echo "| | ns a step |"
echo "|---|--:|"
dotnet "$work/csharp/Borders.dll"
"$work/cost"
PYTHONPATH=$work /usr/bin/python3 benchmarks/Borders/cost.py
