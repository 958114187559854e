#!/usr/bin/env bash
# Writes stand-ins for two libraries of glibc, against which the C library is linked, so that it also loads on systems with glibc 2.31 (Debian 11).
#   src/Football.Physics.Native/glibc.sh DIR COMPILER       writes DIR/libpthread.so.0 and DIR/libdl.so.2
# glibc 2.32 and 2.34 moved functions of threads and of loading into libc.so.6 under new versions. They also kept the old versions. The stand-ins define the old
# versions, so that the linker records those; at run time, glibc's own libraries supply the functions.
set -euo pipefail
(( $# == 2 )) || { sed -n '2,3s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
dir=$1 compiler=$2
newest=31

# Lines "name version": the latest version up to 2.31 of each function whose default version is later.
readelf -W --dyn-syms "$("$compiler" -print-file-name=libc.so.6)" | awk -v newest=$newest '
  match($8, /@+GLIBC_2\./) {
    name = substr($8, 1, RSTART - 1)
    version = substr($8, RSTART + RLENGTH)
    split(version, part, ".")
    if ($8 ~ /@@/ && part[1] + 0 > newest) { moved[name] = 1 }
    else if (part[1] + 0 <= newest && part[1] + 0 >= at[name] + 0) { at[name] = part[1]; old[name] = version }
  }
  END { for (name in moved) if (name in old) print name, "GLIBC_2." old[name] }' | sort > "$dir/moved"

# stand_in LIBRARY PATTERN: a library with the functions whose names match.
stand_in() {
  awk -v pattern="$2" '$1 ~ pattern { print "void " $1 "(void) {}" }' "$dir/moved" > "$dir/$1.c"
  awk -v pattern="$2" '$1 ~ pattern { names[$2] = names[$2] " " $1 ";" } END { for (version in names) print version " { global:" names[version] " };" }' "$dir/moved" > "$dir/$1.map"
  "$compiler" -shared -nostdlib -fPIC -fno-builtin -w "-Wl,-soname,$1" "-Wl,--version-script=$dir/$1.map" "$dir/$1.c" -o "$dir/$1"
}
stand_in libpthread.so.0 '^(pthread|sem)_'
stand_in libdl.so.2 '^dl(addr|close|error|open|sym|vsym)'
