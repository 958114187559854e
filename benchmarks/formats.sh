#!/usr/bin/env bash
# Writes the same rows as npy, CSV and Parquet. Prints the rate and memory that the tool reports for each, and the size on disk. Compares Parquet with CSV in DuckDB. Kills and resumes a Parquet run three times: the bytes must be the same.
#   benchmarks/formats.sh [ROWS]       default 10 000 000 (12 GB in the folder for temporary files)
. "$(dirname "${BASH_SOURCE[0]}")/publish.sh"
rows=${1:-10000000}

dotnet build -c Release src/Football.Tool -o "$work/tool" > "$work/log" 2>&1 || { tail -n 5 "$work/log" >&2; exit 1; }
dotnet build -c Release benchmarks/Formats -o "$work/formats" > "$work/log" 2>&1 || { tail -n 5 "$work/log" >&2; exit 1; }
# sweep FORMAT FOLDER
sweep() { dotnet "$work/tool/football.dll" sweep --count "$rows" --seed 7 --format "$1" --out "$work/$2" 2>&1 | tail -n 1; }

echo "| format | rows | rows/s | memory, MiB | on disk, MiB |"
echo "|---|--:|--:|--:|--:|"
for format in npy csv parquet; do
  said=$(sweep "$format" "$format")
  echo "| $format | $rows | $(sed -E 's/.* ([0-9]+) rows\/s.*/\1/' <<< "$said") | $(sed -E 's/.* at most ([0-9]+) MiB.*/\1/' <<< "$said") | $(du -sm "$work/$format" | cut -f 1) |"
  [[ $format == npy ]] && rm -r "$work/npy"
done
echo
echo "DuckDB, Parquet beside CSV: $(dotnet "$work/formats/Formats.dll" "$work/parquet/rows.parquet" "$work/csv/rows.csv")"
rm -r "$work/csv"

certain() { sed -nE 's/^  "rows": ([0-9]+),/\1/p' "$work/killed/checkpoint.json" 2> /dev/null || true; }
killed=0
for part in 1 2 3; do
  sweep parquet killed > "$work/said" 2> /dev/null &
  pid=$!
  # Kill a quarter later each time.
  until at=$(certain) && (( ${at:-0} >= part * rows / 4 )); do
    kill -0 "$pid" 2> /dev/null || break
    sleep 0.05
  done
  pkill -9 -f "$work/killed" && killed=$(( killed + 1 ))
  wait "$pid" 2> /dev/null || true
done
sweep parquet killed > "$work/said"
for file in "$work"/parquet/*; do cmp "$file" "$work/killed/$(basename "$file")"; done
echo "killed $killed times and resumed: the same bytes; $(sed -E 's/.*rows, //' "$work/said")"
