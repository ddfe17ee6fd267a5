#!/usr/bin/env python3
"""A sweep of 3 x 4 runs killed and stopped at random, gone on with by the same command: nothing is lost, nothing is made twice, and the table is
byte for byte that of a sweep without a stop; usage: random_stops.py PROGRAM [--stops N] [--places N] [--seed N]"""
import argparse
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

CASE = """format = 1
name = "tiny"
domain = { length = "20 um", width = "12 um" }
flow = { drive = "pressure", pseudo_shear_rate = "200 /s", hold = "mean-velocity" }
cells = { count = 1, radius = "2.7 um", layout = "single" }
numerics = { dx = "0.5 um" }
time = { end = "4 ms" }
output = { series = "30 us", frames = "0.5 ms", checkpoint = "1 h" }
"""
PLACES = 4  # of the second axis


def command(program, folder, name):
    radii = ", ".join(f"{2 + 0.8 * k / PLACES:g}" for k in range(PLACES)) + " um"
    return [program, "sweep", str(folder / "tiny.toml"), "--over", "flow.pseudo_shear_rate=100:300:100 /s", "--over", f"cells.radius={radii}", "-o", str(folder / name / "G"), "-j", "3", "--progress", "none"]


def start(program, folder, name):
    return subprocess.Popen(command(program, folder, name), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True)


def runs(folder, name):
    return sorted((folder / name / "G/runs").iterdir()) if (folder / name / "G/runs").exists() else []


def stop(process, kind, chance, seconds):
    """Stops the sweep somehow, if it does not end before. Its exit code and what it told."""
    time.sleep(chance.uniform(0.0, seconds))
    try:
        if kind == "group":  # as the machine going down: all of it
            os.killpg(process.pid, signal.SIGKILL)
            for child in pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split():
                os.kill(int(child), signal.SIGKILL)
        else:
            process.send_signal(kind)
    except (ProcessLookupError, FileNotFoundError):
        pass
    return process.wait(), process.stderr.read()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--stops", type=int, default=8)
    parser.add_argument("--places", type=int, default=PLACES)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    globals()["PLACES"] = options.places
    chance = random.Random(options.seed)
    folder = pathlib.Path(tempfile.mkdtemp(prefix="tanktread-sweeps-", dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None))
    wrong = []
    try:
        (folder / "tiny.toml").write_text(CASE)
        begin = time.monotonic()
        whole = start(options.program, folder, "whole")
        told = whole.communicate(timeout=300)[1]
        assert whole.returncode == 0, told
        seconds = time.monotonic() - begin
        files = [folder / "whole/G" / file for file in ("table.csv", "sweep.json", "sweep.toml")]
        assert len(runs(folder, "whole")) == 3 * PLACES
        stops = sweeps = 0
        kinds = [signal.SIGINT, signal.SIGTERM, signal.SIGUSR2, signal.SIGKILL, signal.SIGKILL, "group"]
        while stops < options.stops:
            name = f"stopped-{sweeps}"
            finished = {}
            for _ in range(chance.randint(2, 6)):
                kind = chance.choice(kinds)
                code, told = stop(start(options.program, folder, name), kind, chance, chance.choice((0.05, 0.5, 1.0)) * seconds)
                stops += code != 0
                allowed = {0, 75, -9} if kind in (signal.SIGKILL, "group") else {0, 75, -kind}  # before its handlers are there
                if code not in allowed:
                    wrong.append(f"{name}: {kind}: exit code {code}: {told}")
                for run, when in finished.items():
                    if (run / "summary.json").stat().st_mtime_ns != when:
                        wrong.append(f"{run.name} was finished and written again")
                finished = {run: (run / "summary.json").stat().st_mtime_ns for run in runs(folder, name) if (run / "summary.json").exists()}
                if code == 0:
                    break
            last = start(options.program, folder, name)
            told = last.communicate(timeout=300)[1]
            if last.returncode != 0:
                wrong.append(f"{name}: exit code {last.returncode} at the end: {told}")
            wrong += [f"{name}: {file.name} differs" for file in files if file.read_bytes() != (folder / name / "G" / file.name).read_bytes()]
            for run in runs(folder, "whole"):
                hashes = [json.loads((folder / each / "G/runs" / run.name / "PROVENANCE.json").read_text())["state_hash"] for each in ("whole", name)]
                if hashes[0] != hashes[1]:
                    wrong.append(f"{name}: {run.name}: another state at its end")
            shutil.rmtree(folder / name)
            sweeps += 1
        print(f"{stops} stops in {sweeps} sweeps of {3 * PLACES} runs ({seconds:.1f} s each), {len(wrong)} wrong")
        print("\n".join(wrong))
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
