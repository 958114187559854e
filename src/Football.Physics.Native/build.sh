#!/usr/bin/env bash
# Builds the C library and writes the installed layout: lib, include, and the files for CMake's find_package.
#   src/Football.Physics.Native/build.sh DIR [RID]       RID: default this machine, or linux-x64, linux-arm64, win-x64, osx-arm64
# NativeAOT links for the system it runs on: build for Windows on Windows, and for macOS on a Mac. On x64, Debian's gcc-aarch64-linux-gnu links for linux-arm64.
# A library for Linux needs glibc 2.31 or later.
set -euo pipefail
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=${UseSharedCompilation:-false}

(( $# >= 1 && $# <= 2 )) || { sed -n '2,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
# DIR is relative to the folder of the caller.
mkdir -p "$1"
out=$(cd "$1" && pwd)
cd "$(dirname "${BASH_SOURCE[0]}")"
here=$(dotnet --info | awk '$1 == "RID:" { print $2; exit }')
case $here in *-arm64) here=linux-arm64 ;; debian*|ubuntu*|linux*) here=linux-x64 ;; esac
rid=${2:-$here}

work=$(mktemp -d)
# Inside the repository, whose folder the compiler replaces in paths: each build has the same bytes, whatever the folder of the clone.
build=$PWD/../../artifacts/native-$rid
rm -rf "$build"
mkdir -p "$build"
build=$(cd "$build" && pwd)
trap 'rm -rf "$work" "$build"' EXIT
compiler=$(command -v clang || command -v gcc || :)
options=()
if [[ $rid == linux-arm64 && $here == linux-x64 ]]; then
  # NativeAOT passes clang's option --target. gcc does not accept it; its name already contains the target.
  printf '#!/usr/bin/env bash\nargs=()\nfor arg; do [[ $arg == --target=* ]] || args+=("$arg"); done\nexec aarch64-linux-gnu-gcc "${args[@]}"\n' > "$work/gcc"
  chmod +x "$work/gcc"
  compiler=aarch64-linux-gnu-gcc
  options=("-p:CppCompilerAndLinker=$work/gcc" -p:ObjCopyName=aarch64-linux-gnu-objcopy -p:LinkerFlavor=bfd)
fi
if [[ $rid == linux-* ]]; then
  mkdir "$work/glibc"
  ./glibc.sh "$work/glibc" "$compiler"
  options+=("-p:GlibcStandIns=$work/glibc")
fi

dotnet publish -c Release "-p:NativeSystem=$rid" --artifacts-path "$build" -o "$work" -p:RunAnalyzers=false "${options[@]}" Football.Physics.Native.csproj >&2

mkdir -p "$out/include" "$out/lib/cmake/football_physics"
cp include/football_physics.h "$out/include/"
cp cmake/football_physics-config.cmake "$out/lib/cmake/football_physics/"
case $rid in
  win-*) mkdir -p "$out/bin" && cp "$work/football_physics.dll" "$out/bin/" && cp "$build"/bin/Football.Physics.Native/release_"$rid"/native/football_physics.lib "$out/lib/" ;;
  osx-*) cp "$work/libfootball_physics.dylib" "$out/lib/" ;;
  *) cp "$work/libfootball_physics.so" "$out/lib/" ;;
esac
