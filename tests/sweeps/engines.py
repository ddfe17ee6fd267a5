#!/usr/bin/env python3
"""A sweep made by GNU parallel or by Slurm, its runs stopped on the way, has the table of one made by the program itself.

usage: engines.py PROGRAM parallel|slurm|limit
`limit` is Slurm with tasks that Slurm itself stops at a limit of one minute; it takes some minutes.
Ends with 77 where the engine is not there or cannot start: skipped. Slurm's daemons are started for this test alone.
"""
import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time

from random_stops import CASE

program, engine = sys.argv[1:]
END = {"limit": "time.end=1200 ms", "slurm": "time.end=240 ms", "parallel": "time.end=240 ms"}[engine]
SLURM_CONF = """ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
MpiDefault=none
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
ReturnToService=2
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/{proctrack}
TaskPlugin=task/none
KillWait=10
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
NodeName={host} NodeAddr=127.0.0.1 CPUs=8 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def skip(why):
    print(f"skipped: {why}")
    sys.exit(77)


def call(*words, check=True, **options):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, **options)
    if check and done.returncode != 0:
        sys.exit(f"{words[:3]} ended with {done.returncode}: {done.stdout}{done.stderr}")
    return done


def sweep(folder, name, *options):
    return call(program, "sweep", folder / "tiny.toml", "--over", "cells.radius=2, 2.2, 2.4 um", "--set", END, "--set",
                "time.average_from=auto", "-o", folder / name / "G", "--progress", "none", *options)


def table(folder, name):
    return (folder / name / "G/table.csv").read_text()


def by_parallel(folder):
    if shutil.which("parallel") is None or "GNU" not in call("parallel", "--version", check=False).stdout:
        skip("no GNU parallel; apt-get install parallel")
    line = sweep(folder, "other", "--parallel").stdout.strip()
    print(line)
    stopped = call("bash", "-c", line.replace("parallel ", "parallel --timeout 0.5 "), check=False)
    assert stopped.returncode != 0, "nothing was stopped"
    saved = [p.name for p in (folder / "other/G/runs").iterdir() if (p / "checkpoint/current").exists()]
    print(f"{len(saved)} runs were stopped with their state saved")
    assert saved
    call("bash", "-c", line)


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


def start_slurm(folder):
    if os.geteuid() != 0:
        skip("Slurm's daemons need root")
    for each in ("munged", "slurmctld", "slurmd", "sbatch"):
        if shutil.which(each, path=os.environ["PATH"] + ":/usr/sbin:/sbin") is None:
            skip(f"no {each}; apt-get install slurmctld slurmd slurm-client munge")
    for each in ("state", "spool"):
        (folder / each).mkdir()
    (folder / "munge.key").write_bytes(os.urandom(1024))
    (folder / "munge.key").chmod(0o400)
    (folder / "cgroup.conf").write_text("CgroupPlugin=autodetect\n")
    os.environ["SLURM_CONF"] = str(folder / "slurm.conf")
    os.environ["PATH"] += ":/usr/sbin:/sbin"
    call("munged", f"--key-file={folder}/munge.key", f"--socket={folder}/munge.socket", f"--pid-file={folder}/munged.pid",
         f"--log-file={folder}/munged.log", f"--seed-file={folder}/munge.seed", check=False)
    for proctrack in ("cgroup", "linuxproc"):  # as clusters have it, else what a container allows
        (folder / "slurm.conf").write_text(SLURM_CONF.format(host=socket.gethostname().split(".")[0], folder=folder, ports=free_ports(2), proctrack=proctrack))
        for each in ("slurmctld", "slurmd"):
            call(each, check=False)
        for _ in range(40):
            time.sleep(0.5)
            if "idle" in call("sinfo", "-h", "-o", "%T", check=False).stdout:
                return print(f"Slurm is up, processes tracked by {proctrack}")
        stop(folder, "slurmd", "slurmctld")
    logs = "".join((folder / f"{each}.log").read_text()[-500:] for each in ("slurmctld", "slurmd") if (folder / f"{each}.log").exists())
    skip(f"Slurm does not come up here: {logs}")


def stop(folder, *daemons):
    for each in daemons:
        path = folder / f"{each}.pid"
        if path.exists():
            try:
                os.kill(int(path.read_text()), 15)
            except (ProcessLookupError, ValueError):
                pass


def jobs():
    """State and restarts of each task or job that Slurm still knows, by its id."""
    text = call("scontrol", "-o", "show", "job", check=False).stdout
    found = {}
    for line in text.splitlines():
        field = dict(re.findall(r"(\w+)=(\S*)", line))
        if "JobState" in field:
            task = field.get("ArrayTaskId")
            found[f"{field['ArrayJobId']}_{task}" if task else field["JobId"]] = (field["JobState"], int(field.get("Restarts", 0)))
    return found


def by_slurm(folder):
    lines = sweep(folder, "other", "--slurm").stdout
    print(lines, end="")
    script = (folder / "other/G/slurm.sh").read_text()
    assert "#SBATCH --array=0-2\n" in script and "#SBATCH --signal=B:USR2@120" in script
    if engine == "limit":
        lines = lines.replace("--parsable", "--parsable --time=1 --signal=B:USR2@20")
    call("bash", "-c", lines, cwd=folder)
    begin, stopped, seen = time.monotonic(), set(), {}
    while time.monotonic() - begin < 500:
        time.sleep(0.3)
        known = jobs()
        for job, (state, restarts) in known.items():
            if "_" not in job or "-" in job:
                continue
            if state == "RUNNING":
                seen.setdefault(job, time.monotonic())
            if engine == "slurm" and state == "RUNNING" and job not in stopped and time.monotonic() - seen[job] > 1.0:
                stopped.add(job)  # as at the limit of a task
                call("scancel", "--signal=USR2", "--batch", job, check=False)
            if state == "PENDING" and restarts > 0:
                call("scontrol", "update", f"JobId={job}", "StartTime=now", check=False)  # else after two minutes
        if known and all(state in ("COMPLETED", "FAILED", "CANCELLED") for state, _ in known.values()):
            break
    print(known)
    assert any(restarts > 0 for _, restarts in known.values()), "no task was put into the queue again"
    assert all(state == "COMPLETED" for state, _ in known.values()), known
    assert "3 of 3 runs done" in (folder / "other/G/slurm-report.log").read_text()


folder = pathlib.Path(tempfile.mkdtemp(prefix="tanktread-engines-"))
folder.chmod(0o755)
try:
    (folder / "tiny.toml").write_text(CASE)
    if engine != "parallel":
        start_slurm(folder)
    (by_parallel if engine == "parallel" else by_slurm)(folder)
    call(program, "sweep", folder / "other/G", "--gather", "--progress", "none")
    whole = folder / "apart"  # not beside the other, which would be found
    whole.mkdir()
    shutil.copy(folder / "tiny.toml", whole)
    sweep(whole, "own")
    same = table(whole, "own") == table(folder, "other")
    print("the same table" if same else "another table")
    sys.exit(0 if same else 1)
finally:
    stop(folder, "slurmd", "slurmctld", "munged")
    shutil.rmtree(folder, ignore_errors=True)
