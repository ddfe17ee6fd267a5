#!/usr/bin/env python3
"""Kills a run at each single file-system call, and lets each fail, of a start, a resume and an end. Whatever happened, the same command must then
come to the same files as a run that met nothing. A file that is put in its place as a whole has a second try: one error does not show. Run with `--every 1` for all of them; usage: each_call.py PROGRAM SHIM [--every N]"""
import argparse
import errno
import sys

from runs import Runs, difference

ERRORS = [errno.ENOSPC, errno.EIO, errno.EDQUOT, errno.EACCES, errno.ENOENT]
# A run that meets the clock (status.json every two seconds) makes some calls more or less: the last few may not be reached.
# What a run does, and what is there before it: the name of the directory to begin from, and the options.
PHASES = {"start": (None, ["--until", "100 us"]), "resume": ("part", ["--until", "200 us"]), "end": ("part", [])}


# Files that are written beside their place and moved there, and what renames them.
PLACED = ["/status.json.tmp", "/PROVENANCE.json.tmp", "/summary.json.tmp", "/checkpoint/current.tmp", "/status.json", "/checkpoint/current"]


def first_and_last_of_each_kind(calls):
    numbers = {}
    for number, (name, path) in enumerate(calls, 1):
        if name == "rename" or (path.endswith(".tmp") and name in ("open", "write", "fsync", "close")):
            numbers.setdefault(name, []).append(number)
    return sorted({number for all_of in numbers.values() for number in (all_of[0], all_of[-1])})


def show_errors_once(runs, shim, phase, whole):
    """Lets one call on each of those files fail; tells how many errors were not made up for at once."""
    tried = wrong = 0
    for file in PLACED:
        calls = count_calls(runs, shim, phase, FAULTY_ENDS=file)
        for number in first_and_last_of_each_kind(calls):
            settings = {"FAULTY_ENDS": file, "FAULTY_AT": str(number), "FAULTY_ERROR": str(errno.EIO)}
            tried += 1
            if fault := what_is_wrong(runs, shim, phase, settings, [0 if phase == "end" else 75], whole):
                wrong += 1
                print(f"{phase}, one error at call {number}, {' '.join(calls[number - 1])}: {fault}")
    print(f"{phase}: one error at {tried} calls that have a second try, {wrong} wrong", flush=True)
    return wrong


def count_calls(runs, shim, phase, **settings):
    before, options = PHASES[phase]
    log = runs.folder / "log"
    log.unlink(missing_ok=True)
    prepare(runs, before)
    runs.run("tried", *options, environment=faulty(runs, shim, FAULTY_LOG=str(log), **settings))
    if not log.exists():
        return []
    return [line.split(" ", 2)[1:] for line in log.read_text().splitlines()]


def prepare(runs, before):
    runs.copy(before or "none", "tried")


def faulty(runs, shim, **settings):
    return {"LD_PRELOAD": shim, "FAULTY_BELOW": str(runs.folder / "tried"), **settings}


def what_is_wrong(runs, shim, phase, settings, expected, whole):
    before, options = PHASES[phase]
    prepare(runs, before)
    code, told = runs.run("tried", *options, environment=faulty(runs, shim, **settings))
    if code not in expected:
        return f"exit code {code}: {told.strip()}"
    code, told = runs.run("tried")
    if code != 0:
        return f"cannot go on: exit code {code}: {told.strip()}"
    differ = difference(whole, runs.results("tried"))
    return f"differ: {', '.join(differ)}" if differ else None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("shim")
    parser.add_argument("--every", type=int, default=1, help="take only every n-th call")
    parser.add_argument("--phase", choices=PHASES, action="append")
    options = parser.parse_args()
    failures = 0
    with Runs(options.program) as runs:
        (runs.folder / "none").mkdir()
        assert runs.run("whole")[0] == 0
        whole = runs.results("whole")
        assert runs.run("part", "--until", "100 us")[0] == 75
        for phase in options.phase or PHASES:
            calls = count_calls(runs, options.shim, phase)
            kinds = {"kill": lambda n: ({}, [-9, 0, 75]), "kill in half": lambda n: ({"FAULTY_HALF": "1"}, [-9, 0, 75]),
                     "error": lambda n: ({"FAULTY_ERROR": str(ERRORS[n % len(ERRORS)])}, [0, 4, 5, 75])}
            for kind, settings in kinds.items():
                tried = wrong = 0
                for number in range(1 + (7 * len(kind)) % options.every, len(calls) + 1, options.every):
                    if kind == "kill in half" and calls[number - 1][0] != "write":
                        continue
                    environment, expected = settings(number)
                    tried += 1
                    fault = what_is_wrong(runs, options.shim, phase, {"FAULTY_AT": str(number), **environment}, expected, whole)
                    if fault:
                        wrong += 1
                        print(f"{phase}, {kind} at call {number}, {' '.join(calls[number - 1])} {environment}: {fault}")
                print(f"{phase}: {kind} at {tried} of {len(calls)} calls, {wrong} wrong", flush=True)
                failures += wrong
            failures += show_errors_once(runs, options.shim, phase, whole)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
