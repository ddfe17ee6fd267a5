"""A cell in shear at two shear numbers: the runs, and two figures of them.

usage: example.py [FOLDER [KEY=VALUE...]], as example.py out numerics.dx="0.5 um"
"""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

import tanktread  # noqa: E402

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "example")
keys = dict(word.split("=", 1) for word in sys.argv[2:])
folder.mkdir(parents=True, exist_ok=True)
case = folder / "shear.toml"
if not case.exists():
    tanktread.new(case, "shear")

runs = {G: tanktread.run(case, folder / f"G{G}", set={"flow.shear_number": G, **keys}) for G in (0.1, 0.3)}

# How far the cell deforms, over the time in units of the shear.
figure, axes = plt.subplots(figsize=(5, 3.5), layout="constrained")
for G, run in runs.items():
    deformation = run.estimate("taylor_inertia")
    cell = run.cells.of_cell(0)
    axes.plot(1e3 * cell["time"], cell["taylor_inertia"], label=f"G = {G}: D = {deformation}")
axes.set(xlabel="time [ms]", ylabel="Taylor deformation D")
axes.legend()
figure.savefig(folder / "deformation.png", dpi=150)

# The cells at the end, on the speed of the flow.
figure, both = plt.subplots(len(runs), 1, figsize=(6, 4), layout="constrained")
for axes, (G, run) in zip(both, runs.items()):
    last = run.frame(-1)
    length, width = (1e6 * side for side in last.box)
    speed = axes.imshow(1e3 * last.velocity[:, :, 0], extent=(0, length, 0, width), origin="lower", cmap="coolwarm")
    tanktread.draw_cells(last, axes, facecolor="none")
    axes.set_title(f"G = {G}, {1e3 * last.time:.0f} ms")
    figure.colorbar(speed, ax=axes, label="mm/s")
figure.savefig(folder / "cells.png", dpi=150)

for G, run in runs.items():
    for check in run.checks:
        if check["verdict"] != "ok":
            print(f"G = {G}: {check['sentence']}")
