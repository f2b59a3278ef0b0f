#!/usr/bin/env bash
# slurm_test.sh SOURCE BINARY: job arrays of scripts/slurm on a Slurm of one node that this starts:
# parts, one of them requeued while it renders, have the bits of one rendering, and so have frames. A
# task near its time limit requeues itself alone, and one that is cancelled does not. Status 77 where
# Slurm is not installed or this is not root.
set -euo pipefail

source=$1 binary=$2
for program in slurmctld slurmd munged sbatch scontrol; do
    command -v "$program" >/dev/null || exit 77
done
((EUID == 0)) || exit 77

work=$(mktemp -d)
chmod 755 "$work"
pids=()
stop() {
    scancel --user=root 2>/dev/null || true
    ((${#pids[@]} == 0)) || kill "${pids[@]}" 2>/dev/null || true
    wait 2>/dev/null || true
    rm -rf "$work"
}
trap stop EXIT

fail() {
    printf 'slurm_test: %s\n' "$*" >&2
    tail -n 20 "$work"/*.log "$work"/*.parts/*.log >&2 2>/dev/null || true
    exit 1
}

# within SECONDS COMMAND...: waits until the command succeeds.
within() {
    local end=$((SECONDS + $1))
    shift
    until "$@" >/dev/null 2>&1; do
        ((SECONDS < end)) || fail "in vain: $*"
        sleep 0.2
    done
}

free_port() {
    python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])'
}

start_slurm() {
    local host cores
    host=$(hostname -s)
    cores=$(nproc)
    mkdir -p "$work"/{state,spool,munge}
    chmod 700 "$work/munge"
    head -c 128 /dev/urandom >"$work/munge/key"
    chmod 400 "$work/munge/key"
    munged --foreground --force --key-file="$work/munge/key" --socket="$work/munge.socket" \
        --pid-file="$work/munge/pid" --log-file="$work/munge.log" --seed-file="$work/munge/seed" \
        >"$work/munged.log" 2>&1 &
    pids+=($!)
    within 10 test -S "$work/munge.socket"
    cat >"$work/slurm.conf" <<CONF
ClusterName=etalon
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
CryptoType=crypto/munge
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SchedulerType=sched/backfill
SelectType=select/cons_tres
ReturnToService=2
SchedulerParameters=requeue_setup_env_fail
NodeName=$host NodeAddr=127.0.0.1 CPUs=$cores State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
    export SLURM_CONF=$work/slurm.conf
    slurmctld -D -f "$SLURM_CONF" >"$work/slurmctld.log" 2>&1 &
    pids+=($!)
    within 20 scontrol ping
    slurmd -D -f "$SLURM_CONF" >"$work/slurmd.log" 2>&1 &
    pids+=($!)
    within 30 bash -c 'sinfo -h -o %T | grep -q idle'
}

is_over() { [[ -z $(squeue -h -j "$1" 2>/dev/null) ]]; }
is_running() { [[ $(squeue -h -j "$1" -o %T 2>/dev/null) == RUNNING ]]; }
is_pending() { [[ $(squeue -h -j "$1" -o %T 2>/dev/null) == PENDING ]]; }

same_pixels() {
    "$ETALON" compare "$1" "$2" --fail-above mse=0 >/dev/null || fail "$1 is not $2"
}

check_parts() {
    local scene=$source/scenes/features/glass.p3f options=(--spp 64 --resolution 160x120 -q)
    "$ETALON" render "$scene" "${options[@]}" -o whole.exr
    "$source/scripts/slurm/submit" parts 4 'all %j.exr' "$scene" "${options[@]}" >submitted
    mapfile -t jobs <submitted
    within 120 is_over "${jobs[1]}"
    [[ -e 'all %j.exr' ]] || fail "nothing was merged"
    same_pixels 'all %j.exr' whole.exr
}

# A task that is put back into the queue while it renders goes on from its checkpoint.
check_requeued() {
    local scene=$source/scenes/features/glass.p3f
    local options=(--spp 4096 --resolution 160x120 -t 1 --checkpoint-every 0.2 -q)
    "$source/scripts/slurm/submit" parts 2 requeued.exr "$scene" "${options[@]}" >submitted
    mapfile -t jobs <submitted
    within 60 is_running "${jobs[0]}_1"
    within 60 test -s requeued.exr.parts/1.exr.checkpoint
    scontrol requeue "${jobs[0]}_1"
    within 60 is_pending "${jobs[0]}_1"
    scontrol update JobId="${jobs[0]}_1" StartTime=now
    within 300 is_over "${jobs[1]}"
    [[ -e requeued.exr ]] || fail "nothing was merged after a task was requeued"
    scontrol show job "${jobs[0]}_1" | grep -q Restarts=1 || fail "no task was started again"
    "$ETALON" render "$scene" "${options[@]:0:4}" -q -o whole.exr
    same_pixels requeued.exr whole.exr
}

# Each task has the node to itself, so that the first is done when the last, which has the number of
# the whole array, gets the signal that comes before the time limit.
check_near_limit() {
    local scene=$source/scenes/features/glass.p3f
    local options=(--spp 4096 --resolution 160x120 --checkpoint-every 0.2 -q)
    SBATCH_EXCLUSIVE=exclusive "$source/scripts/slurm/submit" parts 2 limited.exr "$scene" "${options[@]}" >submitted
    mapfile -t jobs <submitted
    within 300 is_running "${jobs[0]}_2"
    within 60 test -s limited.exr.parts/2.exr.checkpoint
    scancel --batch --signal=TERM "${jobs[0]}_2"
    within 60 is_pending "${jobs[0]}_2"
    [[ -z $(squeue -h -t PENDING,RUNNING -j "${jobs[0]}_1") ]] || fail "a task that is done was requeued"
    scontrol update JobId="${jobs[0]}_2" StartTime=now
    within 300 is_over "${jobs[1]}"
    "$ETALON" render "$scene" "${options[@]:0:4}" -q -o whole.exr
    same_pixels limited.exr whole.exr
}

check_cancelled() {
    local scene=$source/scenes/features/glass.p3f
    "$source/scripts/slurm/submit" parts 1 cancelled.exr "$scene" --spp 1000000 --checkpoint-every 0.2 -q >submitted
    mapfile -t jobs <submitted
    within 60 test -s cancelled.exr.parts/1.exr.checkpoint
    scancel "${jobs[0]}"
    within 60 is_over "${jobs[0]}"
    sleep 1
    is_over "${jobs[0]}" || fail "a task that was cancelled was requeued"
    is_over "${jobs[1]}" || fail "the merge still waits for a task that was cancelled"
}

check_frames() {
    for frame in 0007 0008; do cp "$source/scenes/features/spheres.p3f" "shot.$frame.p3f"; done
    local options=(--spp 4 --resolution 40x30 -q)
    "$source/scripts/slurm/submit" frames 07 08 'out/%04d/shot.exr' 'shot.%04d.p3f' "${options[@]}" >submitted
    within 60 is_over "$(cat submitted)"
    "$ETALON" render shot.0007.p3f "${options[@]}" -o whole.exr
    for frame in 0007 0008; do same_pixels "out/$frame/shot.exr" whole.exr; done
}

export ETALON=$binary/bin/etalon
cd "$work"
start_slurm
check_parts
check_requeued
check_near_limit
check_cancelled
check_frames
