#!/usr/bin/env bash
# Counts the public types and members of the library and of its parts, by namespace, from the surfaces on record.
#   tests/public-types.sh [COMMIT]     of a commit, where the surface was elsewhere; default the sources as they are
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
python3 - "${1:-}" <<'PY'
import collections, pathlib, re, subprocess, sys

def surfaces(commit):
    if not commit:
        return {path.parent.name: path.read_text() for path in sorted(pathlib.Path("src").glob("Football.Physics*/PublicAPI.Unshipped.txt"))}
    names = subprocess.run(["git", "ls-tree", "-r", "--name-only", commit, "src"], capture_output=True, text=True, check=True).stdout.split()
    return {name.split("/")[1]: subprocess.run(["git", "show", f"{commit}:{name}"], capture_output=True, text=True, check=True).stdout
            for name in names if re.fullmatch(r"src/Football\.Physics[.\w]*/PublicAPI\.Unshipped\.txt", name)}

for assembly, text in surfaces(sys.argv[1]).items():
    lines = [line for line in text.splitlines() if "FootballPhysics" in line]
    types = [line for line in lines if not re.search(r"[( =]|->", line)]
    spaces = collections.Counter(line.split("<")[0].rpartition(".")[0] for line in types)
    print(f"{assembly}: {len(types)} types, {len(lines) - len(types)} members; " + ", ".join(f"{space} {n}" for space, n in sorted(spaces.items())))
PY
