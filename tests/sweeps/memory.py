#!/usr/bin/env python3
"""No more runs go at once than fit into memory; usage: memory.py PROGRAM"""
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

from random_stops import CASE


def running_at_once(program, folder, name, limit):
    """The most runs that went side by side. Two would be asked for."""
    line = [program, "sweep", str(folder / "tiny.toml"), "--over", "cells.radius=2, 2.2, 2.4 um", "--set", "time.end=200 ms", "--set",
            "time.average_from=auto", "-o", str(folder / name / "G"), "-j", "2", "--progress", "json"]
    bound = (lambda: resource.setrlimit(resource.RLIMIT_DATA, (limit, limit))) if limit else None
    done = subprocess.run(line, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, preexec_fn=bound, timeout=300)
    assert done.returncode == 0, done.stderr
    lines = [json.loads(each) for each in done.stderr.splitlines()]
    return max(each.get("running", 0) for each in lines)


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    (folder / "tiny.toml").write_text(CASE)
    two, one = running_at_once(sys.argv[1], folder, "free", None), running_at_once(sys.argv[1], folder, "narrow", 55_000_000)
    print(f"{two} at once, {one} in 55 MB")
    sys.exit(0 if (two, one) == (2, 1) else 1)
