"""Small runs that are stopped, killed and gone on with, and whether their files are those of a run without a stop."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile

END = 400  # us
CASE = """format = 1
name = "tiny"
domain = { length = "20 um", width = "12 um" }
flow = { drive = "pressure", pseudo_shear_rate = "200 /s", hold = "mean-velocity" }
cells = { count = 1, radius = "2.7 um", layout = "single" }
numerics = { dx = "0.5 um" }
time = { end = "%g us" }
output = { series = "30 us", frames = "90 us", checkpoint = "1 h" }
"""
WALL_CLOCK = {"threads", "wall_seconds", "mlups", "cell_steps_per_second", "step_us"}


class Runs:
    """Directories below one of their own, in memory where that is possible."""

    def __init__(self, program, end=END):
        self.program = program
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="tanktread-stops-", dir="/dev/shm" if os.access("/dev/shm", os.W_OK) else None))
        (self.folder / "tiny.toml").write_text(CASE % end)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.folder, ignore_errors=True)

    def command(self, name, *options):
        return [self.program, "run", str(self.folder / "tiny.toml"), "-o", str(self.folder / name), "-j", "1", "--progress", "none", *options]

    def start(self, name, *options, environment=None):
        return subprocess.Popen(self.command(name, *options), env={**os.environ, **(environment or {})},
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)

    def run(self, name, *options, environment=None):
        """Exit code (below 0: the signal) and what was told."""
        process = self.start(name, *options, environment=environment)
        told = process.communicate(timeout=300)[1]
        return process.returncode, told

    def copy(self, name, to):
        shutil.rmtree(self.folder / to, ignore_errors=True)
        shutil.copytree(self.folder / name, self.folder / to, symlinks=True)

    def results(self, name):
        """All that two runs must have in common."""
        folder = self.folder / name
        summary = json.loads((folder / "summary.json").read_text())
        status = json.loads((folder / "status.json").read_text())
        provenance = json.loads((folder / "PROVENANCE.json").read_text())
        files = {file: (folder / file).read_bytes() for file in ("series.csv", "cells.csv", "profiles.csv", "resolved.toml", "case.toml")}
        return {**files, "frames.h5": frames(folder / "frames.h5"), "summary": without_clock(summary), "state": provenance["state_hash"],
                "status": (status["status"], status["step"], status["steps"]), "ending": provenance["sessions"][-1]["ending"],
                "left": sorted(p.name for p in folder.rglob("*") if p.suffix == ".tmp")}


def without_clock(summary):
    return {key: value for key, value in summary.items() if key not in WALL_CLOCK}


def frames(path):
    """Every attribute and array of the file by its name."""
    import h5py

    found = {}
    with h5py.File(path, "r") as file:
        def take(name, node):
            found[name] = {key: str(value) for key, value in node.attrs.items()}
            if isinstance(node, h5py.Dataset):
                found[name]["bytes"] = node[()].tobytes()
        take("/", file)
        file.visititems(take)
    return found


def difference(one, other):
    """The names of what differs."""
    return [key for key in one if one[key] != other[key]]


def interrupts():
    return [getattr(signal, "SIG" + name) for name in ("INT", "TERM", "HUP", "USR1", "USR2", "XCPU")]
