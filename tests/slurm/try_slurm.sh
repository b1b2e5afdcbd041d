#!/bin/sh
# try_slurm.sh [PROJECT]: runs Debian's Slurm with two nodes on this machine, renders shards and frames by
# tools/slurm_array.sh, kills one node in the middle, and holds what comes out against whole renders. Needs root and
# the packages slurm-wlm and munge; takes three minutes. It uses ports and files of its own.
set -eu
cd "$(dirname "$0")/../.."
project=$(realpath "${1:-./Project}")
[ "$(id -u)" -eq 0 ] || { echo "try_slurm.sh: needs root, for Slurm's daemons" >&2; exit 1; }
for program in slurmctld slurmd sbatch munged; do
    command -v $program > /dev/null || { echo "try_slurm.sh: $program is missing (slurm-wlm, munge)" >&2; exit 1; }
done
work=$(mktemp -d)
chmod 755 "$work"
daemons=
# has PROCESS WORD: whether its environment has it.
has() { tr '\0' '\n' 2> /dev/null < "/proc/$1/environ" | grep -qx "$2"; } 2> /dev/null
# tasks [WORD]: the processes that Slurm's tasks are here, with WORD in their environment, and what watches over them.
tasks() {
    for folder in /proc/[0-9]*; do
        id=${folder#/proc/}
        has "$id" "TRY_SLURM=$work" || continue
        has "$id" "${1:-SLURM_JOB_NAME=.*}" || continue
        echo "$id"
        parent=$(sed -n 's/^PPid:[^0-9]*//p' "$folder/status" 2> /dev/null)
        [ "$(cat "/proc/$parent/comm" 2> /dev/null)" != slurmstepd ] || echo "$parent"
    done
}
# Ends what this script started.
stop() {
    for id in $(tasks) $daemons; do kill -9 "$id" 2> /dev/null || true; done
    rm -rf "$work"
}
trap stop EXIT
export TRY_SLURM="$work" SLURM_CONF="$work/slurm.conf" PROJECT="$project"

fail() {
    echo "FAILED: $*" >&2
    tail -n 20 "$work"/*.log >&2
    exit 1
}
# until_true SECONDS SENTENCE COMMAND...
until_true() {
    left=$1
    sentence=$2
    shift 2
    while ! "$@" > /dev/null 2>&1; do
        left=$((left - 1))
        [ "$left" -gt 0 ] || fail "$sentence"
        sleep 1
    done
    echo "ok: $sentence"
}
daemon() {
    "$@" > /dev/null 2>&1 &
    started=$!
    daemons="$daemons $started"
}

dd if=/dev/urandom of="$work/key" bs=1024 count=1 2> /dev/null
chmod 400 "$work/key"
daemon munged --foreground --force --key-file="$work/key" --socket="$work/munge" --pid-file="$work/munge.pid" \
    --log-file="$work/munge.log" --seed-file="$work/seed"
host=$(hostname -s)
cat > "$SLURM_CONF" << CONF
ClusterName=try
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge
CredType=cred/munge
SlurmctldPort=16817
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd-%n.pid
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool-%n
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SlurmdTimeout=10
ReturnToService=2
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
NodeName=one NodeHostname=$host NodeAddr=127.0.0.1 Port=16818 CPUs=1
NodeName=two NodeHostname=$host NodeAddr=127.0.0.1 Port=16819 CPUs=1
PartitionName=all Nodes=one,two Default=YES State=UP MaxTime=INFINITE
CONF
mkdir "$work/state" "$work/spool-one" "$work/spool-two"
until_true 10 "munge answers" munge --socket="$work/munge" -n
daemon slurmctld -D -i
daemon slurmd -D -N one
daemon slurmd -D -N two
two=$started
idle() { [ "$(sinfo -h -N -o %t | grep -c idle)" -eq 2 ]; }
until_true 30 "two nodes are idle" idle

cp -r scenes Assets "$work"
cd "$work"
array="sh $OLDPWD/tools/slurm_array.sh"
count() { find . -maxdepth 1 -name "$1" | wc -l; }
over() { [ -z "$(squeue -h)" ]; }
options="--size 320x180 --spp 768 --checkpoint 0.5"

# shellcheck disable=SC2086 # options are words
"$project" scenes/soft_shadow.lua $options -q -o whole.png
# shellcheck disable=SC2086
$array shards 8 shards.png scenes/soft_shadow.lua $options
running_on_two() { tasks SLURMD_NODENAME=two | grep -q .; }
until_true 30 "a task runs on the second node" running_on_two
victims="$two $(tasks SLURMD_NODENAME=two)"
for id in $victims; do echo "kills: $(cat "/proc/$id/comm" 2> /dev/null)"; done
for id in $victims; do kill -9 "$id" 2> /dev/null || true; done
down() { sinfo -h -N -n two -o %t | grep -q down; }
until_true 60 "Slurm has missed the node" down
daemon slurmd -D -N two
until_true 240 "all jobs are over" over
[ "$(count 'shards.*-of-8.part')" -eq 8 ] || fail "there are $(count 'shards.*-of-8.part') shards of 8"
cmp shards.png whole.png || fail "the merged picture is not the whole one"
echo "ok: the merged picture has the bytes of the whole one"
grep -qi "requeu" slurmctld.log || fail "Slurm put no task back into the queue"
echo "ok: Slurm put the task back into the queue"

# What is missing, and only that, is submitted again.
rm shards.3-of-8.part shards.png
# shellcheck disable=SC2086
$array shards 8 shards.png scenes/soft_shadow.lua $options > said
cat said
grep -q "^tasks 3: " said || fail "another shard than the missing one was submitted"
until_true 60 "all jobs are over" over
cmp shards.png whole.png || fail "the picture merged again is not the whole one"
echo "ok: one missing shard was rendered again, and the picture is the whole one"

# shellcheck disable=SC2086
"$project" scenes/animation.lua --size 64x36 --spp 2 --frames 1-6 -q -o whole-##.png
$array frames 1-6 frame-##.png scenes/animation.lua --size 64x36 --spp 2
until_true 60 "all jobs are over" over
for i in 01 02 03 04 05 06; do cmp "frame-$i.png" "whole-$i.png" || fail "frame $i is another one"; done
echo "ok: the frames have the bytes of those of one run"
