#!/usr/bin/env python3
"""Runs the sweep with Dask: one task per shard, on workers that share the folder.

  ./dask_sweep.py tcp://HOST:8786 [SHARDS]     default 16

If a worker dies, the scheduler gives its shards to another worker, which resumes them. Needs dask and distributed.
"""
import os
import shlex
import subprocess
import sys

from dask.distributed import Client, as_completed

FOOTBALL = shlex.split(os.environ.get("FOOTBALL", "football"))
ROWS = os.path.abspath(os.environ.get("ROWS", "rows"))


def command(shard, shards):
    get = os.environ.get
    return [
        *FOOTBALL, "sweep", os.path.abspath(get("SWEEP", "sweep.json")), "--count", get("COUNT", "1000000"), "--seed", get("SEED", "1"),
        "--shard", f"{shard}/{shards}", "--jobs", "1", "--format", get("FORMAT", "npy"), "--out", ROWS,
    ]


def run(arguments):
    """Runs on a worker: only the arguments travel, not this file."""
    import subprocess

    return subprocess.run(arguments, check=True, capture_output=True, text=True).stderr.strip()


def main():
    shards = int(sys.argv[2]) if len(sys.argv) > 2 else 16
    with Client(sys.argv[1]) as client:
        # Retry several times: a worker that dies may take several shards with it.
        tasks = client.map(run, [command(i, shards) for i in range(1, shards + 1)], pure=False, retries=3)
        for _, said in as_completed(tasks, with_results=True):
            print(said, flush=True)
    subprocess.run([*FOOTBALL, "sweep", "merge", ROWS], check=True)


if __name__ == "__main__":
    main()
