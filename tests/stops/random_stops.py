#!/usr/bin/env python3
"""Stops a run at random moments, by every kind of stop in turn or by kill -9 alone, goes on after each, and holds the files to those of a run
without a stop; usage: random_stops.py PROGRAM [--stops N] [--kills N]"""
import argparse
import random
import signal
import sys
import time

from runs import Runs, difference, interrupts

END = 3000  # us: some seconds of a run


def stop(runs, name, kind, chance, seconds):
    """One session that is stopped somehow, if it does not end before. Its exit code."""
    if kind == "--max-time":
        return runs.run(name, "--max-time", f"{chance.uniform(0.01, seconds):.3f}s")[0]
    if kind == "--until":
        return runs.run(name, "--until", f"{chance.uniform(1, END):.1f} us")[0]
    process = runs.start(name)
    time.sleep(chance.uniform(0.0, seconds))
    process.send_signal(kind)
    if kind != signal.SIGKILL and chance.random() < 0.5:  # as schedulers do
        time.sleep(chance.uniform(0.0, 0.2))
        process.send_signal(signal.SIGTERM)
    process.communicate()
    return process.returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--stops", type=int, default=0)
    parser.add_argument("--kills", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    chance = random.Random(options.seed)
    kinds = [*interrupts(), "--max-time", "--until", signal.SIGKILL]
    wrong = 0
    with Runs(options.program, END) as runs:
        begin = time.monotonic()
        assert runs.run("whole")[0] == 0
        seconds = time.monotonic() - begin
        whole = runs.results("whole")
        for what, count in (("stops", options.stops), ("kills", options.kills)):
            done = ended = 0
            while done < count:
                name = f"{what}-{ended}"
                # A few per run, so that later parts of it are met too; those early in a session find it starting.
                code = None
                for _ in range(chance.randint(1, 6)):
                    kind = chance.choice(kinds) if what == "stops" else signal.SIGKILL
                    code = stop(runs, name, kind, chance, chance.choice((0.02, 0.2, 1.0)) * seconds)
                    # A signal before the handlers are there ends the process, as it ends any.
                    expected = {0, 75, -9} if kind in (signal.SIGKILL, "--max-time", "--until") else {0, 75, -kind, -signal.SIGTERM}
                    if code not in expected:
                        wrong += 1
                        print(f"{name}: {kind}: exit code {code}", flush=True)
                    done += code != 0
                    if code == 0:
                        break
                code, told = runs.run(name)
                differ = difference(whole, runs.results(name)) if code == 0 else [told]
                if differ:
                    wrong += 1
                    print(f"{name}: exit code {code}, differ: {differ}", flush=True)
                ended += 1
            print(f"{done} {what} in {ended} runs, {wrong} wrong", flush=True)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
