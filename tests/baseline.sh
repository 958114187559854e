#!/usr/bin/env bash
# Writes tests/Baseline anew: the public surface of the last version of each package, as reference assemblies, which packing compares with.
# To be run when a version is released, not when a break is found: that goes into docs/changelog.md first.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
rm -f tests/Baseline/*
for part in Football.Physics Football.Physics.{Batch,Engines,Thesis,Tracks}; do
  dotnet build -c Release "src/$part" -v q
  dependency=
  [[ $part == Football.Physics ]] || dependency='<dependency id="Football.Physics" version="0.1.0" />'
  for target in netstandard2.1 net8.0 net10.0; do
    mkdir -p "$work/$part/lib/$target"
    cp "src/$part/obj/Release/$target/ref/$part.dll" "$work/$part/lib/$target/"
  done
  version=$(dotnet msbuild "src/$part" -t:FindVersion -getProperty:Version)
  cat > "$work/$part/$part.nuspec" <<NUSPEC
<?xml version="1.0" encoding="utf-8"?>
<package xmlns="http://schemas.microsoft.com/packaging/2013/05/nuspec.xsd">
  <metadata>
    <id>$part</id>
    <version>$version</version>
    <authors>Football.Physics</authors>
    <description>The public surface of $version, without code.</description>
    <dependencies>$(for framework in .NETStandard2.1 net8.0 net10.0; do echo "<group targetFramework=\"$framework\">${dependency/0.1.0/$version}</group>"; done)</dependencies>
  </metadata>
</package>
NUSPEC
  # One time for every entry, and no extra fields: the same bytes from the same surface.
  (cd "$work/$part" && TZ=UTC python3 - "$OLDPWD/tests/Baseline/$part.nupkg" <<'PY'
import os, sys, zipfile
with zipfile.ZipFile(sys.argv[1], "w", zipfile.ZIP_DEFLATED, compresslevel=9) as package:
    for folder, _, files in sorted(os.walk(".")):
        for name in sorted(files):
            entry = zipfile.ZipInfo(os.path.join(folder, name)[2:], (2026, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            package.writestr(entry, open(os.path.join(folder, name), "rb").read())
PY
  )
done
ls -l tests/Baseline
