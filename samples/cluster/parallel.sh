#!/usr/bin/env bash
# Runs the sweep with GNU parallel, on one machine or with --sshlogin on several that share the folder:
#   ./parallel.sh 16
# Each shard uses one thread, and each processor runs one shard at a time. A failed shard is retried twice. You can repeat the command.
set -euo pipefail
export SHARDS=${1:-16}

seq "$SHARDS" | parallel --will-cite --retries 3 --halt now,fail=1 \
  "${FOOTBALL:-football} sweep ${SWEEP:-sweep.json} --count ${COUNT:-1000000} --seed ${SEED:-1} --shard {}/$SHARDS --jobs 1 --format ${FORMAT:-npy} --out ${ROWS:-rows}"
