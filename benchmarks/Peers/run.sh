#!/usr/bin/env bash
# Football.Physics and general engines with the same ball and the same shots: benchmarks/Peers/run.sh [SEED]
# FOOTBALL_NPM names the folder of the npm package; default: that which this script publishes. Writes the table to out/peers.md. Needs g++, node, npm and Debian's libbullet-dev and libode-dev (a missing engine is left out).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1
seed=${1:-1}
here=benchmarks/Peers
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p out

dotnet build -c Release "$here/dotnet" -v q > "$work/log" 2>&1 || { tail -n 5 "$work/log" >&2; exit 1; }
[[ -d $here/node/node_modules ]] || npm ci --prefix "$here/node" --ignore-scripts --no-audit --no-fund > "$work/log" 2>&1 || { tail -n 5 "$work/log" >&2; exit 1; }
node "$here/node/shots.mjs" "$seed" > "$work/shots"

npm=${FOOTBALL_NPM:-src/Football.Physics.Web/bin/package}
[[ -n ${FOOTBALL_NPM:-} ]] || dotnet publish -c Release src/Football.Physics.Web -v q > "$work/log" 2>&1 || { tail -n 5 "$work/log" >&2; exit 1; }

# play COMMAND...: one engine, one line of JSON; an engine that fails is named and left out.
play() { echo "$*" >&2; "$@" "$work/shots" ${extra:-} 2> "$work/log" | grep '^{' >> "$work/rows" || { echo "left out: $*" >&2; tail -n 3 "$work/log" >&2; }; }

# native NAME PACKAGE: compiles with pkg-config's flags.
native() {
  pkg-config --exists "$2" || { echo "left out: $1 is not installed" >&2; return; }
  g++ -std=c++20 -O2 -DPACKAGE_VERSION="\"$(pkg-config --modversion "$2")\"" $(pkg-config --cflags "$2") "$here/native/$1.cpp" -o "$work/$1" $(pkg-config --libs "$2")
  play "$work/$1"
}

play dotnet "$here/dotnet/bin/Release/net10.0/Peers.dll" football
play dotnet "$here/dotnet/bin/Release/net10.0/Peers.dll" minimal
extra=$npm play node "$here/node/football.mjs"
native bullet bullet
native ode ode
play node "$here/node/rapier.mjs"
extra=@dimforge/rapier3d-deterministic-compat play node "$here/node/rapier.mjs"
for peer in jolt havok cannon mujoco; do
  if [[ -f $here/node/$peer.mjs ]]; then play node "$here/node/$peer.mjs"; fi
done

node "$here/node/table.mjs" "$seed" "$work/rows" | tee out/peers.md
