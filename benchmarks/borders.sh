#!/usr/bin/env bash
# Measures the cost of a step through each interop boundary, in ns per step: C#, C, Python with one ball and with 4 096. Prints a table in Markdown; each time is the least of many rounds, one after another.
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
