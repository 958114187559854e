#!/usr/bin/env bash
# Publishes programs of one ball with NativeAOT, and prints their size and the time as a table in Markdown.
#   benchmarks/aot.sh
# Needs a C compiler.
. "$(dirname "${BASH_SOURCE[0]}")/publish.sh"

publish() {
  local start end
  dotnet restore tests/Package.Consumer -r "$rid" -p:NativeProgram=true "-p:SmallProgram=$1" -p:LibraryProject=true --artifacts-path "$work/$1" > "$work/log" 2>&1 \
    && dotnet build -c Release -f net8.0 src/Football.Physics --artifacts-path "$work/$1" -p:RunAnalyzers=false > "$work/log" 2>&1 \
    && start=$(date +%s) \
    && dotnet publish tests/Package.Consumer --no-restore -c Release -r "$rid" -p:NativeProgram=true "-p:SmallProgram=$1" -p:LibraryProject=true \
      --artifacts-path "$work/$1" -o "$work/out/$1" > "$work/log" 2>&1 \
    && end=$(date +%s) \
    || { tail -n 5 "$work/log" >&2; exit 1; }
  echo "| $2 | $(( $(stat -c %s "$work/out/$1/consumer") / 1024 )) | $(( end - start )) | $3 |"
}

echo "| program | KiB | publishing, s | reach |"
echo "|---|--:|--:|---|"
publish Nothing "without the library" ""
publish OneBall "one ball, as in the README" "≤ 3584 KiB, ≤ 20 s"
