#!/bin/sh
# A Slurm of one node, this machine, in a folder: slurm_node.sh FOLDER. Needs root.
set -eu
folder=$1
host=$(hostname -s)
mkdir -p "$folder/state" "$folder/spool" /run/munge
if ! munge -n >/dev/null 2>&1; then
  chown munge /run/munge
  setpriv --reuid munge --regid munge --clear-groups munged --force
fi
cat >"$folder/slurm.conf" <<END
ClusterName=bounce
SlurmctldHost=$host(127.0.0.1)
AuthType=auth/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
SlurmctldPort=16817
SlurmdPort=16818
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
JobAcctGatherType=jobacct_gather/none
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 RealMemory=4096 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
SLURM_CONF=$folder/slurm.conf slurmctld
SLURM_CONF=$folder/slurm.conf slurmd
