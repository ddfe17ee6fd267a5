#!/usr/bin/env python3
"""Is everything on the disk that a loss of power must find there? From the file-system calls of a run: what is renamed into its place has been
synced before, its folder after; what a checkpoint counts has been synced before the checkpoint takes its place; usage: order.py PROGRAM SHIM"""
import pathlib
import shutil
import sys

from runs import Runs

# May be lost with the power: told again in two seconds, or for people only.
PASSING = {"status.json", "run.log"}


def faults(calls, folder):
    dirty, renamed, found = set(), {}, []
    for name, path in calls:
        if name in ("write", "truncate"):
            dirty.add(path)
        elif name == "fsync":
            dirty.discard(path)
            renamed.pop(path, None)
        elif name == "rename":
            source, target = path.split(" ")
            if pathlib.Path(target).name in PASSING:
                dirty.discard(source)
                continue
            if source in dirty:  # may come later, but before a checkpoint counts it
                dirty.discard(source)
                dirty.add(target)
            if target.endswith("checkpoint/current"):
                counted = [p for p in dirty if not p.endswith((".tmp", "run.log"))] + [t for t in renamed.values() if "/checkpoint/" not in t]
                found += [f"the checkpoint counts {p}, which is not on the disk" for p in counted]
            renamed[str(pathlib.Path(target).parent)] = target
    found += [f"{p} is not on the disk in the end" for p in dirty if pathlib.Path(p).name not in PASSING]
    return found + [f"the folder of {target} is not synced" for target in renamed.values()]


def calls_of(runs, shim, *options):
    log = runs.folder / "log"
    log.unlink(missing_ok=True)
    code, told = runs.run("run", *options, environment={"LD_PRELOAD": shim, "FAULTY_BELOW": str(runs.folder / "run"), "FAULTY_LOG": str(log)})
    assert code in (0, 75), told
    return [line.split(" ", 2)[1:] for line in log.read_text().splitlines()]


def synced_first(calls, current):
    """A stop does not wait for the disk: who goes on from it does, before there is a next one."""
    names = [name for name, path in calls if name == "fsync" and path == current or name == "rename" and path.endswith(" " + current)]
    return names[:1] == ["fsync"]


def main():
    program, shim = sys.argv[1:]
    with Runs(program) as runs:
        calls = calls_of(runs, shim)
        found = faults(calls, runs.folder / "run")
        shutil.rmtree(runs.folder / "run")
        calls_of(runs, shim, "--until", "100 us")
        if not synced_first(calls_of(runs, shim), str(runs.folder / "run/checkpoint/current")):
            found.append("the checkpoint of a stop is not synced by the run that goes on from it")
        for name in ("fsync", "rename", "write"):
            assert any(call[0] == name for call in calls), f"no {name} was seen"
    for fault in dict.fromkeys(found):
        print(fault)
    print(f"{len(calls)} calls, {len(found)} faults")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
