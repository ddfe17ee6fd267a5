#!/usr/bin/env python3
"""Bad case texts, --set items, flags and paths: each ends with 2, 4 or 5 and a message, none with a crash or a hang.

usage: bad_inputs.py PROGRAM SOURCE [COUNT] [SEED]
"""
import collections
import os
import random
import re
import subprocess
import sys
import tempfile

program, source = sys.argv[1:3]
count = int(sys.argv[3]) if len(sys.argv) > 3 else 1200
random.seed(int(sys.argv[4]) if len(sys.argv) > 4 else 2014)
patience = 60  # s; one waits 10 s for a pipe that nobody writes into

channel = open(f"{source}/cases/05-channel/case.toml", "rb").read()
lines = channel.split(b"\n")
settings = [n for n, line in enumerate(lines) if re.match(rb"\s*\w+\s*=", line)]
keys = subprocess.run([program, "keys", "--markdown"], capture_output=True, text=True, check=True).stdout
known = set(re.findall(r"^\| `(\w+) =", keys, re.M))


def paths_of_keys():
    """table.key, its bounds."""
    table = ""
    for line in keys.splitlines():
        if header := re.match(r"## (?:\[(.*)\]|At the top)", line):
            table = header[1] or ""
        if row := re.match(r"\| `(\w+) = .*\| .* \| (.*) \|$", line):
            yield (f"{table}.{row[1]}" if table else row[1]), row[2]


bounded = list(paths_of_keys())


def text(case):
    return ["check", ("case.toml", case)]


def changed_line(change):
    at = random.choice(settings)
    key, value = lines[at].split(b"=", 1)
    return text(b"\n".join(lines[:at] + change(key.strip(), value.split(b"#")[0].strip()) + lines[at + 1:]))


def misspelt_key():
    def change(key, value):
        wrong = key
        while wrong.decode() in known:
            at = random.randrange(len(key))
            wrong = random.choice([key[:at] + key[at + 1:] or b"q", key[:at] + b"x" + key[at:],
                                   key + b"_", key.upper() + b"q", b'"' + key + b' "'])
        return [wrong + b" = " + value]
    return changed_line(change)


def wrong_value():
    values = [b"true", b"[]", b"{}", b"1979-05-27", b"nan", b"-inf", b'""', b'"  "', b'"1..2 um"', b'"1e999 m"',
              b'"0x10 um"', b'"5 parsec"', b'"5 um/"', b'"(((((1"', b'"3 um^99"', b'"\xc2\xb5"', b"[[[]]]", b'"5 m m m m m"',
              b'"' + b"9" * 400 + b' um"', b"'''", b"'a\x01'", b"\xff\xfe", b'"\\q"', b"99999999999999999999", b"1e", b"=", b""]
    return changed_line(lambda key, value: [key + b" = " + (random.choice(values) if key != b"name" else b"7.5")])


def broken_structure():
    at = random.choice(settings)
    line = lines[at]
    deep = random.randrange(17, 60)
    inserts = [b"[", b"]]", b"[[domain]]", b"[a.b", b"x = {", b"x = [", b'x = "', b"x = '''", b"x = 1\nx = 2", line + b"\n" + line,
               b"[domain]\n[domain]", b"\x00", b"x\x7f = 1", b"\xc3\x28", b"= 3", b"[]", b"nothing", b".a = 1", b"a..b = 1",
               b"x = " + b"[" * deep + b"]" * deep, b".".join([b"k"] * (deep + 2)) + b" = 1",
               b"[" + b".".join([b"k"] * (deep + 2)) + b"]", b"x = " + b"{a=" * deep + b"1" + b"}" * deep, b"[@ase]"]
    whole = [b"", b"\n", b"\xff\xfe" + channel, b"\xef\xbb\xbf", channel[:random.randrange(200)], b"\x89PNG\r\n\x1a\n" + os.urandom(300),
             b"a=1\n" * 3000, b"#" * (1 << 20) + b"#\n" + channel, os.urandom(2000)]
    if random.random() < 0.3:
        return text(random.choice(whole))
    return text(b"\n".join(lines[:at] + [random.choice(inserts)] + lines[at:]))


def out_of_range():
    path, bounds = random.choice([(p, b) for p, b in bounded if re.search(r"[<>]=? ", b)])
    sign, number, unit = random.choice(re.findall(r"([<>])=? (-?[\d.e+-]+)(?: ([^,;]*))?", bounds))
    number = float(number)
    number += (1 if sign == "<" else -1) * random.choice([1e-3, 1, 1e30, 1e290]) * max(abs(number), 1)
    return ["check", "channel", "--set", f"{path}={number!r} {unit or ''}".strip()]


def bad_set():
    items = ["", "=", "flow", "flow=", "flow.drive", ".=1", "flow..drive=x", "flow.drive=", "a.b.c.d.e.f=1", "flow.drive.x=1",
             "k" * 5000 + "=1", "domain.width=" + "9" * 5000, "cells.radius=ä", "cells.radius=4 µmm", "name=../up", "name=",
             "name=" + "n" * 300, "name=a/b", "name=-rf", "name=x\n", "name=ä", "name=..", "cells.positions=[[[[", "cells.seed=-1",
             "cells.seed=1.5", "time.end=0 s", "time.end=1 ms ms", "flow.hold=[a",              "membrane.hardening.apply_to=sheer", "cells.shape=file", "cells.file=/dev/zero", "output=1", "format=2",
             "numerics.dx=0.21 um", "numerics.jump_correction=maybe", "cells.count=1e3", "cells.count=0", "time.average_from=1 h",
             "cells.cytoplasm_viscosity=6 cP cP cP cP cP cP cP", "flow.drive=\x1b[31m", "cells.layout=single"]
    return ["check", "channel", "--set", random.choice(items)]


def bad_flags():
    times = ["5", "-5m", "5 parsecs", "m", "", "1e999h", "nan", "1h-5m", "0s", "--", "1m1"]
    moments = ["5", "-1 ms", "1 ms ms", "nan", "1e400 s", "1 h", "ms", "0 ms", "1 m"]
    return random.choice([
        [random.choice(["chek", "ru", "", "x" * 3000, "--", "-", "ä", "-q", "--verson", "RUN"])],
        ["run", "channel", random.choice(["--frsh", "-z", "--threads=0", "-j-1", "-j1e9", "-jx", "-j", "--set", "-o", "--until"])],
        ["run", "channel", "--max-time", random.choice(times)],
        ["run", "channel", "--until", random.choice(moments)],
        ["run", "channel", "--progress", random.choice(["bars", "", "JSON", "ä"])],
        ["run", "channel", "-o", random.choice(["", "channel", "/dev/null", "channel/x", "/proc/x", "y" * 300, "occupied"])],
        ["run", "channel", "channel"], ["check"], ["run"], ["export", "empty"], ["report"], ["status", "a", "b"],
        ["new", random.choice(["", "x/" * 3000, "y" * 300, "/proc/x", "there", "dangling/x"])],
        ["new", "fresh", "--from", random.choice(["", "nothing", "ä", "../channel"])],
        ["keys", random.choice(["no-such-key", "ä", "x" * 3000])],
        ["export", "empty", "--to", random.choice(["vtk", "csv", "png", "", "pdf"])]])


def bad_path():
    verb = random.choice([["check"], ["run"], ["resume"], ["status"], ["report"], ["calibrate"], ["export", "--to", "csv"]])
    names = ["nowhere", ".", "empty", "/dev/zero", "/dev/null", "/dev/full", "loop", "dangling", "hollow", "there.toml/x", "p" * 256, "p/" * 3000,
             "", "\n", "/proc/self/mem", "/proc/kcore", "/dev/stdin", "\udcff", "channel/..", "garbage", "/dev/tty"]
    return verb + [random.choice(names)]


makers = [misspelt_key, wrong_value, broken_structure, out_of_range, bad_set, bad_flags, bad_path]


def prepare():
    """What the inputs find in their folder."""
    open("channel", "wb").write(channel)
    open("there.toml", "wb").write(channel)
    os.mkdir("empty")
    os.mkdir("occupied")
    open("occupied/mine", "w").write("not of tanktread\n")
    os.symlink("loop", "loop")
    os.symlink("nowhere/x", "dangling")
    os.truncate(os.open("hollow", os.O_CREAT | os.O_WRONLY), 1 << 40)
    os.mkdir("garbage")
    for name in ("case.toml", "resolved.toml", "status.json", "PROVENANCE.json", "summary.json", "series.csv", "cells.csv", "frames.h5"):
        open(f"garbage/{name}", "wb").write(os.urandom(1000))


def end_of(words):
    files = [word for word in words if isinstance(word, tuple)]
    for name, content in files:
        open(name, "wb").write(content)
    try:
        run = subprocess.run([program] + [w[0] if isinstance(w, tuple) else w for w in words],
                             stdin=subprocess.DEVNULL, capture_output=True, timeout=patience)
        return run.returncode, run.stderr.decode(errors="replace")
    except subprocess.TimeoutExpired:
        return "a hang", ""


def main():
    ends = collections.Counter()
    bad = 0
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        prepare()
        os.mkfifo("pipe")
        inputs = [["check", "pipe"]] + [makers[n % len(makers)]() for n in range(count)]
        for words in inputs:
            code, message = end_of(words)
            ends[code] += 1
            wrong = code not in (2, 4, 5) or not message.strip() or "internal" in message
            if wrong or any(len(line) > 9000 for line in message.splitlines()):
                bad += 1
                print(f"{code}: {repr(words)[:400]}\n    {message[:300]}")
        os.chdir("/")
    print(f"{len(inputs)} inputs: " + ", ".join(f"{n} ended with {code}" for code, n in sorted(ends.items(), key=str)))
    return bad > 0


sys.exit(main())
