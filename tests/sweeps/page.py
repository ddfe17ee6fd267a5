#!/usr/bin/env python3
"""The page of a sweep in Chromium, of 2, 9, 20 and 200 runs: all is drawn, nothing fails; usage: page.py PROGRAM [FOLDER for screenshots]

Ends with 77 where there is no Chromium: skipped.
"""
import itertools
import json
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time

program, shots = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else None
chromium = shutil.which("chromium")
if chromium is None:
    print("skipped: no chromium; apt-get install chromium")
    sys.exit(77)

QUANTITIES = {"taylor_inertia": "", "lambda_C": "", "mean_velocity": "m/s", "cfl_gap": "m", "mu_rel": "", "overlaps": ""}
SWEEPS = {
    2: {"membrane.hardening.apply_to": ["none", "shear, bending, area, contact"]},
    9: {"flow.pseudo_shear_rate": ["50 /s", "150 /s", "500 /s"], "membrane.hardening.apply_to": ["none", "shear", "shear, bending, area, contact"]},
    20: {"flow.shear_number": ["0.01", "0.03", "0.1", "0.3", "1"], "cells.seed": ["1", "2", "3", "4"]},
    200: {"flow.shear_number": [f"{k / 10:g}" for k in range(1, 11)], "cells.cytoplasm_viscosity": ["1.2 cP", "6 cP", "12 cP", "20 cP"],
          "cells.seed": ["1", "2", "3", "4", "5"]},
}


def invent(folder, axes):
    """A sweep whose last run failed, or none of two."""
    chance, runs = random.Random(2014), []
    for number, values in enumerate(itertools.product(*axes.values())):
        name = f"run-{number}"
        (folder / "runs" / name).mkdir(parents=True)
        summary = {q: {"value": mean, "unit": unit, "mean": mean, "standard_error": 0.1 * chance.random()}
                   for q, unit in QUANTITIES.items() for mean in [0.0 if q == "overlaps" else 1 + chance.random()]}
        (folder / "runs" / name / "summary.json").write_text(json.dumps(summary))
        runs.append({"name": name, "directory": f"runs/{name}", "values": dict(zip(axes, values)), "ending": "done"})
    if len(runs) > 2:
        runs[-1] = {**runs[-1], "ending": "failed", "why": "unstable at step 4096: <node> moved"}
    record = {"format": 1, "name": "invented", "program": "", "case": "case.toml", "axes": [[key] for key in axes], "runs": runs}
    (folder / "sweep.json").write_text(json.dumps(record))


def browse(page, *options):
    return subprocess.run([chromium, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--enable-logging=stderr", *options,
                           page.as_uri()], capture_output=True, text=True, timeout=120)


wrong = []
with tempfile.TemporaryDirectory() as name:
    for count, axes in SWEEPS.items():
        folder = pathlib.Path(name) / str(count)
        invent(folder, axes)
        subprocess.run([program, "report", str(folder)], check=True, stdout=subprocess.DEVNULL)
        page = folder / "report.html"
        begin = time.monotonic()
        seen = browse(page, "--dump-dom")
        seconds = time.monotonic() - begin
        text = seen.stdout
        figures, bars = text.count("<figure"), text.count("<circle")
        rows = len(re.findall(r"<tr", text[text.index('id="runs"'):]))
        told = [line for line in seen.stderr.splitlines() if "CONSOLE" in line]
        print(f"{count} runs: {len(page.read_bytes()) / 1e3:.0f} kB, {figures} figures, {bars} points, {rows} rows, {seconds:.1f} s with the browser's start")
        wrong += told
        if figures != 5:  # overlaps are the same in all runs
            wrong.append(f"{count} runs: {figures} figures, not 5")
        if rows != count + 1:
            wrong.append(f"{count} runs: {rows} rows")
        if "overlaps 0" not in text or "B − A" not in text:
            wrong.append(f"{count} runs: no constants or no differences")
        if (count > 2) != ("&lt;node&gt; moved" in text):
            wrong.append(f"{count} runs: the failure is not told")
        for width in (1280, 390) if shots else ():
            browse(page, f"--window-size={width},2600", f"--screenshot={shots}/{count}-{width}.png")
print("\n".join(wrong))
sys.exit(1 if wrong else 0)
