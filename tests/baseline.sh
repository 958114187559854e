#!/usr/bin/env bash
# Writes tests/Baseline/Football.Physics.nupkg anew: the public surface of the last version, as reference assemblies, which packing compares with.
# To be run when a version is released, not when a break is found: that goes into the upgrade table of docs/changelog.md first.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
dotnet build -c Release src/Football.Physics -v q
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for target in netstandard2.1 net8.0 net10.0; do
  mkdir -p "$work/lib/$target"
  cp "src/Football.Physics/obj/Release/$target/ref/Football.Physics.dll" "$work/lib/$target/"
done
version=$(dotnet msbuild src/Football.Physics -getProperty:Version)
cat > "$work/Football.Physics.nuspec" <<NUSPEC
<?xml version="1.0" encoding="utf-8"?>
<package xmlns="http://schemas.microsoft.com/packaging/2013/05/nuspec.xsd">
  <metadata>
    <id>Football.Physics</id>
    <version>$version</version>
    <authors>Football.Physics</authors>
    <description>The public surface of $version, without code.</description>
    <dependencies><group targetFramework=".NETStandard2.1" /><group targetFramework="net8.0" /><group targetFramework="net10.0" /></dependencies>
  </metadata>
</package>
NUSPEC
# One time for every entry, and no extra fields: the same bytes from the same surface.
find "$work" -exec touch -d 2026-01-01T00:00:00Z {} +
mkdir -p tests/Baseline
rm -f tests/Baseline/Football.Physics.nupkg
(cd "$work" && TZ=UTC python3 - "$OLDPWD/tests/Baseline/Football.Physics.nupkg" <<'PY'
import os, sys, zipfile
with zipfile.ZipFile(sys.argv[1], "w", zipfile.ZIP_DEFLATED, compresslevel=9) as package:
    for folder, _, files in sorted(os.walk(".")):
        for name in sorted(files):
            entry = zipfile.ZipInfo(os.path.join(folder, name)[2:], (2026, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            package.writestr(entry, open(os.path.join(folder, name), "rb").read())
PY
)
ls -l tests/Baseline
