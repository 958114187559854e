#!/usr/bin/env bash
# Runs samples/cluster on a real Slurm with two nodes on this machine, with Dask and with GNU parallel: 16 shards, one of them killed half-way and requeued,
# must merge to the bytes that one process writes. So must 8 shards of Dask, one of whose two workers is killed.
#   tests/cluster.sh            one line a check; exit code 1 at the first that fails
# Needs slurm-wlm, munge, parallel and python3-distributed (Debian's packages of these names). Slurm and munge have folders, a key and ports of their own, listen on the
# loopback only, and are stopped at the end.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
SECONDS=0

export DOTNET_NOLOGO=1 DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_CLI_UI_LANGUAGE=en DOTNET_TieredPGO=0
export MSBUILDTERMINALLOGGER=off MSBUILDDISABLENODEREUSE=1 UseSharedCompilation=${UseSharedCompilation:-false}
export PATH=$PATH:/usr/sbin:/sbin

# munge trusts no folder that others may write to.
work=$(mktemp -d)
log=$work/log
: > "$log"
pids=()

finish() {
  local pid
  for pid in "$work"/*.pid; do
    [[ -s $pid ]] && pids+=("$(< "$pid")")
  done
  (( ${#pids[@]} == 0 )) || kill "${pids[@]}" 2> /dev/null || true
  for pid in "${pids[@]}"; do
    for (( i = 0; i < 50; i++ )); do running "$pid" || break; sleep 0.1; done
    if running "$pid"; then kill -9 "$pid" 2> /dev/null || :; fi
  done
  rm -rf "$work"
}

# A process that nobody waits for stays as a zombie where the first process of the machine is no init.
running() { [[ -r /proc/$1/stat && $(cut -d ' ' -f 3 "/proc/$1/stat" 2> /dev/null) != Z ]]; }

fail() {
  echo "FAIL  $1" >&2
  [[ -s $log ]] && tail -n 20 "$log" >&2
  tail -qn 5 "$work"/slurm*.log "$work"/tasks/*.log 2> /dev/null >&2 || true
  exit 1
}

ok() { echo "ok    $1"; : > "$log"; }

# until_true SECONDS WHAT COMMAND…
until_true() {
  local end=$(( SECONDS + $1 )) what=$2
  shift 2
  until "$@" > /dev/null 2>> "$log"; do
    (( SECONDS < end )) || fail "$what"
    sleep 0.2
  done
}

trap finish EXIT

# --- what one process writes

program=$root/src/Football.Tool/bin/Release/net10.0/football.dll
[[ -e $program ]] || dotnet build -c Release src/Football.Tool > "$log" 2>&1 || fail "dotnet build"
export FOOTBALL="dotnet $program" SWEEP=$root/samples/cluster/sweep.json FORMAT=npy SEED=7
export COUNT=640000
$FOOTBALL sweep "$SWEEP" --count "$COUNT" --seed "$SEED" --format "$FORMAT" --out "$work/one" > "$log" 2>&1 || fail "one process"
ok "one process: $COUNT rows, $(du -sk "$work/one" | cut -f 1) KiB"

# same WHAT FOLDER: the merged files are those of one process.
same() {
  $FOOTBALL sweep merge "$2" >> "$log" 2>&1 || fail "$1: merge"
  local file
  for file in "$work"/one/*; do
    cmp "$file" "$2/$(basename "$file")" >> "$log" 2>&1 || fail "$1: other bytes"
  done
  ok "$1: the same bytes in $(ls "$work/one" | wc -l) files"
}

# --- GNU parallel

ROWS=$work/parallel samples/cluster/parallel.sh 16 > "$log" 2>&1 || fail "GNU parallel"
same "GNU parallel, 16 shards" "$work/parallel"

# --- Dask: two workers, one of which is killed with everything that it started

dask_port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
(cd "$work" && exec /usr/bin/python3 /usr/bin/dask-scheduler --host 127.0.0.1 --port "$dask_port" --no-dashboard > "$work/dask-scheduler.log" 2>&1) &
pids+=($!)
start_worker() {
  # A group of its own, so that a machine's end can be played.
  (cd "$work" && exec setsid /usr/bin/python3 /usr/bin/dask-worker "tcp://127.0.0.1:$dask_port" --no-nanny --no-dashboard --nthreads 1 --name "$1" > "$work/dask-$1.log" 2>&1) &
  pids+=($!)
}
start_worker 1
killed=$!
ROWS=$work/dask /usr/bin/python3 samples/cluster/dask_sweep.py "tcp://127.0.0.1:$dask_port" 8 > "$work/dask.out" 2>&1 &
dask=$!
pids+=("$dask")
certain() { grep -qs '"rows": [1-9]' "$work"/dask/shard-*/checkpoint.json; }
until_true 60 "rows by Dask" certain
kill -9 -- "-$killed"
# The second worker starts late: all rows until now are those of the first.
start_worker 2
wait "$dask" || { cp "$work/dask.out" "$log"; fail "Dask"; }
# The other worker has resumed a shard: less than all of its rows were left.
resumed=$(awk -v all=$(( COUNT / 8 )) '{ for (i = 2; i < NF; i++) if ($(i + 1) == "of" && $(i + 2) == "them" && $i < all) { print; exit } } /all there before/ { print; exit }' "$work/dask.out")
[[ -n $resumed ]] || { cp "$work/dask.out" "$log"; fail "no shard of Dask was resumed"; }
ok "Dask: 8 shards on two workers, one of which was killed after its first certain rows"
same "Dask, 8 shards" "$work/dask"

# --- Slurm

head -c 1024 /dev/urandom > "$work/munge.key"
chmod 400 "$work/munge.key"
chmod 755 "$work"
mkdir "$work/state" "$work/tasks"
munged --key-file="$work/munge.key" --socket="$work/munge.socket" --pid-file="$work/munge.pid" --log-file="$work/munge.log" \
  --seed-file="$work/munge.seed" --num-threads=1 > "$log" 2>&1 || fail "munged"

# Three ports that nobody has.
ports=$(python3 - <<'PORTS' 2> /dev/null || echo "26817 26818 26819"
import socket
sockets = [socket.socket() for _ in range(3)]
for one in sockets: one.bind(("127.0.0.1", 0))
print(*[one.getsockname()[1] for one in sockets])
PORTS
)
read -r control_port port1 port2 <<< "$ports"
host=$(hostname -s)
cat > "$work/slurm.conf" <<CONF
ClusterName=football
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$control_port
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
CredType=cred/munge
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
StateSaveLocation=$work/state
SlurmctldPidFile=$work/slurmctld.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdPidFile=$work/slurmd-%n.pid
SlurmdLogFile=$work/slurmd-%n.log
SlurmdSpoolDir=$work/spool-%n
SlurmdParameters=config_overrides
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=1,batch_sched_delay=0,sched_min_interval=1000
JobRequeue=1
KillWait=1
MinJobAge=300
ReturnToService=2
MpiDefault=none
SwitchType=switch/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
NodeName=football[1-2] NodeHostname=$host NodeAddr=127.0.0.1 Port=[$port1,$port2] CPUs=2 RealMemory=2000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=10 State=UP
CONF
export SLURM_CONF=$work/slurm.conf
slurmctld -c > "$log" 2>&1 || fail "slurmctld"
for node in football1 football2; do
  mkdir "$work/spool-$node"
  slurmd -N "$node" >> "$log" 2>&1 || fail "slurmd $node"
done
idle() { [[ $(sinfo --noheader --states=idle --format=%D) == 2 ]]; }
until_true 60 "two nodes that are idle" idle
ok "Slurm: $(sinfo --version), two nodes, ports $ports"

# The script of samples/cluster as it stands; what a task may have is cut down to this machine.
submit() {
  rm -rf "$work/slurm" "$work/tasks"
  mkdir "$work/tasks"
  job=$(ROWS=$work/slurm sbatch --parsable --cpus-per-task=1 --mem-per-cpu=500M --time=5 --output="$work/tasks/%a.log" --chdir="$work/tasks" \
    samples/cluster/sweep.sh 2> "$log") || fail "sbatch"
}

# One that has written rows that are certain, and is not done, is killed as by the machine's end.
half() {
  local shard
  for shard in "$work"/slurm/shard-*; do
    if [[ ! -e $shard/manifest.json ]] && grep -qs '"rows": [1-9]' "$shard/checkpoint.json"; then
      index=$(sed -E 's/.*shard-0*([0-9]+)-of-.*/\1/' <<< "$shard")
      scancel --full --signal=KILL "${job}_$index" 2> /dev/null || true
      sleep 0.3
      [[ ! -e $shard/manifest.json ]] && victim=$shard && return 0
    fi
  done
  return 1
}
# On a busy machine all may have ended before one was caught: then all again.
caught() {
  local end=$(( SECONDS + 120 ))
  until half; do
    (( SECONDS < end )) || fail "no task was caught half-way"
    [[ -n $(squeue --noheader --job="$job" 2> /dev/null) ]] || return 1
    sleep 0.02
  done
}
tries=0
until submit && caught; do
  (( ++tries < 6 )) || fail "six times all tasks had ended before one was caught half-way"
done
left=$(awk '/"rows"/ { gsub(/[^0-9]/, ""); print }' "$victim/checkpoint.json")
# none ARGUMENTS…: squeue answers, and lists nothing.
none() { local listed; listed=$(squeue --noheader "$@") && [[ -z $listed ]]; }
gone() { none --states=running,completing --job="${job}_$index"; }
until_true 60 "the killed task's end" gone
scontrol requeue "${job}_$index" 2> "$log" || fail "scontrol requeue"
# A cluster waits two minutes before it runs a task again. It is not to be at once: a node takes a launch in the second of the kill, counted in whole
# seconds, for the one that was killed, and drops it.
scontrol update JobId="${job}_$index" StartTime=now+2seconds 2> "$log" || fail "scontrol update"

drained() { none --job="$job"; }
until_true 180 "the end of all tasks" drained
said=$(tail -n 1 "$work/tasks/$index.log")
now=$(sed -E 's/.* ([0-9]+) of them now .*/\1/' <<< "$said")
# Killed between its last checkpoint and its manifest, it has nothing left to do.
[[ $said == *", all there before;"* ]] && now=0
[[ $now =~ ^[0-9]+$ && $(( now + left )) == $(( COUNT * index / 16 - COUNT * (index - 1) / 16 )) ]] || fail "task $index did not go on after $left rows: $said"
ok "Slurm: 16 tasks, of which task $index was killed after $left certain rows, requeued, and made the other $now"
same "Slurm, 16 shards" "$work/slurm"

echo "ok    cluster.sh: $SECONDS s"
