#!/usr/bin/env python3
"""Damages checkpoints: flips bytes, cuts the end off, leaves a piece out. Each must be told and passed over for the one before, and the run must end as
one without damage; usage: damage.py PROGRAM [--damages N]"""
import argparse
import random
import sys

from runs import Runs, difference


def damaged(content, chance):
    kind = chance.choice(("flip", "cut", "hole"))
    at = chance.randrange(len(content))
    if kind == "cut":
        return content[:at]
    if kind == "hole":
        return content[:at] + content[at + chance.randint(1, 1000):]
    return content[:at] + bytes([content[at] ^ (1 << chance.randrange(8))]) + content[at + 1:]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--damages", type=int, default=20)
    options = parser.parse_args()
    chance = random.Random(3)
    wrong = 0
    with Runs(options.program) as runs:
        assert runs.run("whole")[0] == 0
        whole = runs.results("whole")
        for until in ("100 us", "200 us"):
            assert runs.run("part", "--until", until)[0] == 75
        current = runs.folder / "tried" / "checkpoint" / "current"
        for _ in range(options.damages):
            runs.copy("part", "tried")
            current.write_bytes(damaged(current.read_bytes(), chance))
            code, told = runs.run("tried")
            log = (runs.folder / "tried" / "run.log").read_text()
            faults = [] if code == 0 else [f"exit code {code}: {told}"]
            faults += [] if "checkpoint passed over" in log else ["not told"]
            faults += [] if code or not difference(whole, runs.results("tried")) else ["differs"]
            wrong += bool(faults)
            for fault in faults:
                print(fault)
    print(f"{options.damages} damaged checkpoints, {wrong} wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
