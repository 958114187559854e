#!/usr/bin/env bash
# Builds the extension for this machine, and puts it and the C library into the demo project.
#   samples/GDExtension/build.sh PREFIX [FLAGS...]       PREFIX: the folder that src/Football.Physics.Native/build.sh wrote; FLAGS: for the C compiler
# CC names the compiler; default gcc or clang. For an engine that was built with precision=double, add -DFOOTBALL_GODOT_DOUBLE.
set -euo pipefail

(( $# >= 1 )) || { sed -n '2,4s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
prefix=$(cd "$1" && pwd)
shift
cd "$(dirname "${BASH_SOURCE[0]}")"
compiler=${CC:-$(command -v gcc || command -v clang)}
bin=${FOOTBALL_BIN:-demo/addons/football/bin}
mkdir -p "$bin"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# The editor's help reads the documentation from memory.
for class in scene:FootballScene ball:FootballBall; do
  printf 'static const unsigned char %s_documentation[] = {\n' "${class%%:*}"
  od -An -v -tx1 "doc_classes/${class#*:}.xml" | sed 's/ \(..\)/0x\1,/g'
  printf '};\n'
done > "$work/documentation.h"

case $(uname -s) in
  Darwin) library=libfootball_physics.dylib name=libfootball_godot.dylib here=@loader_path ;;
  MINGW* | MSYS*) library=football_physics.dll name=football_godot.dll here= ;;
  *) library=libfootball_physics.so name=libfootball_godot.so here='$ORIGIN' ;;
esac
options=(-std=c99 -O2 -Wall -Wextra -pedantic -ffp-contract=off -fvisibility=hidden -shared)
[[ -z $here ]] || options+=(-fPIC "-Wl,-rpath,$here")
"$compiler" "${options[@]}" "$@" -I"$work" -I"$prefix/include" src/*.c -o "$bin/$name" -L"$prefix/lib" -lfootball_physics -lm
if [[ -e $prefix/bin/$library ]]; then cp "$prefix/bin/$library" "$bin/"; else cp "$prefix/lib/$library" "$bin/"; fi
echo "$bin/$name"
