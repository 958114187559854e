#!/usr/bin/env bash
# The same with GNU parallel, on one machine or with --sshlogin on several that share the folder:
#   ./parallel.sh 16
# One thread a shard, as many shards at a time as there are processors. A shard that failed is tried twice more; the whole can be run again.
set -euo pipefail
export SHARDS=${1:-16}

seq "$SHARDS" | parallel --will-cite --retries 3 --halt now,fail=1 \
  "${FOOTBALL:-football} sweep ${SWEEP:-sweep.json} --count ${COUNT:-1000000} --seed ${SEED:-1} --shard {}/$SHARDS --jobs 1 --format ${FORMAT:-npy} --out ${ROWS:-rows}"
