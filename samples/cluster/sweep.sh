#!/usr/bin/env bash
# One task of a Slurm array is one shard of a sweep. From this folder:
#   sbatch sweep.sh                                       16 shards of a million rows into ./rows
#   COUNT=1000000000 sbatch --array=1-1000 sweep.sh       other sizes
#   football sweep merge rows                             when all tasks have ended
# A task that was preempted, killed or requeued runs the same line again. It resumes its shard, and skips a finished one.
#SBATCH --job-name=sweep
#SBATCH --array=1-16
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=2
#SBATCH --mem-per-cpu=500M
#SBATCH --time=04:00:00
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=sweep-%a.log
set -euo pipefail

# The command: the published program, the .NET tool, or a container ("apptainer run football.sif").
read -ra football <<< "${FOOTBALL:-football}"

exec "${football[@]}" sweep "${SWEEP:-sweep.json}" --count "${COUNT:-1000000}" --seed "${SEED:-1}" \
  --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --jobs "${SLURM_CPUS_PER_TASK:-1}" \
  --format "${FORMAT:-npy}" --out "${ROWS:-rows}"
