#!/bin/bash
# A Slurm cluster of two nodes on this machine, for a test: no systemd, no cgroups, nothing outside its folder. Root only.
#   slurm_one_machine.sh start FOLDER PORT      then SLURM_CONF=FOLDER/slurm.conf
#   slurm_one_machine.sh stop FOLDER
set -eu
command=$1
folder=$(readlink -f "$2")

if [ "$command" = stop ]; then
    for file in "$folder"/run/slurmd.*.pid "$folder"/run/slurmctld.pid "$folder"/munge/munged.pid; do
        [ -s "$file" ] && kill "$(cat "$file")" 2>/dev/null || true
    done
    exit 0
fi

port=$3
host=$(hostname -s)
user=$(getent passwd munge >/dev/null && echo munge || id -un)
mkdir -p "$folder"/{state,log,run,munge,spool.n1,spool.n2}
chmod 755 "$folder"
(umask 077 && head -c 1024 /dev/urandom >"$folder/munge/munge.key")
chown -R "$user": "$folder/munge"
chmod 755 "$folder/munge"
runuser -u "$user" -- /usr/sbin/munged --key-file="$folder/munge/munge.key" --socket="$folder/munge/socket" \
    --pid-file="$folder/munge/munged.pid" --log-file="$folder/munge/munged.log" --seed-file="$folder/munge/munged.seed"
cat >"$folder/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
# A job that is begun anew waits until its credential has expired.
AuthInfo=socket=$folder/munge/socket,cred_expire=5
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool.%n
SlurmctldPidFile=$folder/run/slurmctld.pid
SlurmdPidFile=$folder/run/slurmd.%n.pid
SlurmctldLogFile=$folder/log/slurmctld.log
SlurmdLogFile=$folder/log/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/backfill
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0,bf_interval=1
ReturnToService=2
KillWait=2
NodeName=n[1-2] NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 1)),$((port + 2)) CPUs=1 State=UNKNOWN
PartitionName=batch Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
# slurmd loads a cgroup plugin even with task/none; finding one by itself fails where /sys/fs/cgroup is not mounted.
echo 'CgroupPlugin=cgroup/v1' >"$folder/cgroup.conf"
export SLURM_CONF="$folder/slurm.conf"
/usr/sbin/slurmctld -f "$SLURM_CONF"
for node in n1 n2; do /usr/sbin/slurmd -f "$SLURM_CONF" -N "$node"; done
for _ in $(seq 100); do
    [ "$(sinfo -h -t idle -N 2>/dev/null | wc -l)" = 2 ] && exit 0
    sleep 0.2
done
tail -5 "$folder"/log/*.log >&2
exit 1
