#!/usr/bin/env python3
"""Each key at both ends of its range, alone and in pairs: a run that goes well, or a refusal whose advice works when followed.

usage: ranges.py PROGRAM [COUNT] [SEED]     COUNT of the settings, drawn at random; else all alone and as many pairs
"""
import csv
import itertools
import math
import os
import random
import re
import resource
import subprocess
import sys
import tempfile

program = sys.argv[1]
count = int(sys.argv[2]) if len(sys.argv) > 2 else 0
random.seed(int(sys.argv[3]) if len(sys.argv) > 3 else 2014)
rounds = 8
processor_time, patience = 60, 1200  # s: of work, and by the clock of a machine that others use too

case = """format = 1
[domain]
length = "20 um"
width = "12 um"
[flow]
drive = "pressure"
pseudo_shear_rate = "200 /s"
[cells]
count = 1
radius = "2.7 um"
layout = "single"
[numerics]
dx = "0.5 um"
[time]
end = "4 ms"
"""
# A key that means something only beside others.
company = {"flow.pressure_gradient": {"flow.pseudo_shear_rate": None}, "layer.thickness": {"layer.viscosity": "6 cP"},
           "flow.shear_rate": {"flow.drive": "shear", "flow.pseudo_shear_rate": None},
           "flow.shear_number": {"flow.drive": "shear", "flow.pseudo_shear_rate": None},
           "layer.viscosity": {"layer.thickness": "3 um"}, "cells.aspect_ratio": {"cells.shape": "ellipse"},
           "cells.hematocrit": {"cells.count": None, "cells.layout": "random"}, "membrane.area_dilation_ratio": {"membrane.law": "skalak"},
           "contact.repulsion_range": {"contact.short_range_repulsion": "true"},
           "contact.repulsion_strength": {"contact.short_range_repulsion": "true"},
           "cells.count": {"cells.layout": "random"}, "membrane.area_stiffness": {"membrane.hold_area": "false"}}
networks = ["fork", "t-junction", "bend", "expansion", "loop", "serpentine"]
# Places, a file or ports: they have tests of their own.
need_more = {("cells.layout", "explicit"), ("cells.shape", "file"), *(("geometry.shape", word) for word in networks)}
left_out = {"format", "output.checkpoint", "cells.positions", "cells.seed"}


def ends_of_ranges():
    """(key, value) at each end, and for keys of words each word."""
    keys = subprocess.run([program, "keys", "--markdown"], capture_output=True, text=True, check=True).stdout
    table = ""
    for line in keys.splitlines():
        if header := re.match(r"## (?:\[(.*)\]|At the top)", line):
            table = header[1] or ""
        if "NAME" in table or table.startswith("["):  # channels that are drawn, kinds: they have tests of their own
            continue
        row = re.match(r"\| `(\w+) = (.*)` \| .* \| (.*) \|$", line)
        if not row or f"{table}.{row[1]}" in left_out or row[1] in left_out:
            continue
        if re.search(rf'with shape = "({"|".join(networks)})"', line):
            continue
        key, bounds = f"{table}.{row[1]}", row[3].split(";")[0].replace("\\|", "|")
        for sign, number, unit in re.findall(r"([<>])=? (-?[\d.e+-]+)(?: ([^,;|]*))?", bounds):
            open_end = f"{sign} {number}" in bounds
            value = float(number)
            if open_end:
                value = 1e-12 if value == 0 else value * (1 + (1e-6 if sign == ">" else -1e-6))
            number = str(int(value)) if row[2] == "1" or key == "cells.count" else repr(value)
            yield key, f"{number} {unit}".strip()
        if "|" in bounds and not row[2].startswith("["):
            for word in re.findall(r"\b[a-z][\w-]*", bounds[bounds.index("|"):] if re.match("[<>]", bounds) else bounds):
                if (key, word) not in need_more:
                    yield key, word


def command(settings, folder):
    words = [program, "run", "case.toml", "-j", "1", "--progress", "none", "--fresh", "--max-time", "2s", "-o", folder]
    for key, value in settings.items():
        if value is not None:
            words += ["--set", f"{key}={value}"]
    return words


def execute(words):
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (3 << 29, 3 << 29))
        resource.setrlimit(resource.RLIMIT_CPU, (processor_time, processor_time))
    try:
        run = subprocess.run(words, capture_output=True, text=True, timeout=patience, preexec_fn=limit)
        return (run.returncode, run.stderr) if run.returncode != -9 else ("a hang", "")
    except subprocess.TimeoutExpired:
        return "a hang", ""


def is_sound(folder):
    """Every number of the series that is there is finite, or nan where it is not defined."""
    rows = list(csv.reader(open(f"{folder}/series.csv")))
    columns = [name.split(" ")[0] for name in rows[0]]
    needed = [k for k, name in enumerate(columns) if name in ("time", "step", "mass", "momentum_x")]
    return len(rows) > 1 and all(math.isfinite(float(row[k])) for row in rows[1:] for k in needed) and \
        not any(word in ("inf", "-inf") for row in rows for word in row)


def follow(message, settings):
    """What the first fault advises: settings that were tried, key = value to write, or a key to leave out."""
    message = (message.splitlines() or [""])[0]
    table = re.search(r"\[(\w+(?:\.\w+)?)\]", message)
    known = {key.rsplit(".", 1)[-1]: key for key, _ in ends} | {k.rsplit(".", 1)[-1]: k for k in settings}
    beside = re.search(r"--set (\w+(?:\.\w+)*)\.\w+=", message)  # as in "needs aspect_ratio = 1.5"
    table = table or beside
    full = lambda word: word if "." in word else known.get(word, f"{table[1]}.{word}" if table else word)
    if tried := re.search(r"Write ((?:--set [\w.]+=(?:\"[^\"]*\"|[\w.+-]+) )+)\(tried", message):
        return {key: value.strip('"') for key, value in re.findall(r'--set ([\w.]+)=("[^"]*"|\S+)', tried[1])}
    if both := re.search(r"(\w+) and (\w+) are both given", message):
        return {full(both[2]): None}
    if write := re.search(r'(?:[Ww]rite|needs) (?:at most )?([\w.]+) = ("[^"]*"|\[.*\]|[\w.+-]+)', message):
        return {full(write[1]): write[2].strip('"')}
    if out := re.search(r"leave (?:it|(\w+)(?:, \w+)* and \w+|(\w+)) out", message):
        named = [w for w in re.findall(r"\w+", out[0]) if w in known]
        named = named or re.findall(r"(\w+) (?:=|means)", message)[:1]
        return {full(word): None for word in named}
    return None


def settings_in_file():
    table, result = "", {}
    for line in case.splitlines():
        if line.startswith("["):
            table = line.strip("[]") + "."
        elif " = " in line:
            key, value = line.split(" = ")
            result[table + key] = value.strip('"')
    return result


def write_case(settings):
    """Settings that are None are taken out of the file."""
    table, text = "", ""
    for line in case.splitlines():
        if line.startswith("["):
            table = line.strip("[]") + "."
        if not (" = " in line and table + line.split(" = ")[0] in settings):
            text += line + "\n"
    open("case.toml", "w").write(text)


def attempt(settings):
    """None if it ends well, else what went wrong."""
    settings = dict(settings)
    told = []
    for _ in range(rounds):
        write_case(settings)
        code, message = execute(command(settings, "run"))
        if code in (0, 75):
            return None if is_sound("run") else "numbers that are not finite"
        told.append(f"{code}: {message.strip().splitlines()[0][:300] if message.strip() else ''}")
        if code != 2:
            break
        advice = follow(message, settings)
        if not advice or all(settings.get(k, "-") == v for k, v in advice.items()):
            break
        settings.update(advice)
    return "\n    ".join(told)


ends = list(ends_of_ranges())


def drawn():
    alone = [{**company.get(key, {}), key: value} for key, value in ends]
    pairs = [{**company.get(a[0], {}), **company.get(b[0], {}), a[0]: a[1], b[0]: b[1]}
             for a, b in itertools.combinations(ends, 2) if a[0] != b[0]]
    random.shuffle(pairs)
    everything = alone + pairs[:len(alone)]
    return random.sample(everything, count) if count else everything


def main():
    bad = 0
    todo = drawn()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for settings in todo:
            if wrong := attempt(settings):
                bad += 1
                print(f"{settings}\n    {wrong}", flush=True)
        os.chdir("/")
    print(f"{len(todo)} settings, {bad} of them wrong")
    return bad > 0


sys.exit(main())
