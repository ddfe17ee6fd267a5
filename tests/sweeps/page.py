#!/usr/bin/env python3
"""The page of a sweep in Chromium, of 2, 9, 20 and 200 runs: all is drawn, in time, and each control does what it says.

usage: page.py PROGRAM [FOLDER for pictures]
Ends with 77 where there is no Chromium: skipped.
"""
import itertools
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "page"))
import chromium  # noqa: E402

program, pictures = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else None
if chromium.program() is None:
    print("skipped: no Chromium; tools/install browser")
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


def texts(page, selector):
    return page.run(f"[...document.querySelectorAll('{selector}')].map((e) => e.textContent)")


def choose(page, list_id, text):
    page.run(f"""(() => {{ const list = element('{list_id}');
        list.selectedIndex = [...list.options].findIndex((o) => o.text === {text!r});
        list.dispatchEvent(new Event('change')); }})()""")


def is_whole(page, count):
    """All is drawn, and nothing hangs over the edge."""
    assert len(texts(page, "#plots figure")) == 5, "overlaps are the same in all runs"
    assert "overlaps 0" in page.run("element('same').textContent")
    assert len(texts(page, "#runs tbody tr")) == count
    assert len(texts(page, "#differences tbody tr")) == 5
    failed = texts(page, ".notice li")
    assert len(failed) == (count > 2) and all("<node> moved" in each for each in failed), failed
    for width in (1280, 390):
        for dark in (False, True):
            page.look(width, 900, dark)
            page.settle()
            over = page.run("document.documentElement.scrollWidth - document.documentElement.clientWidth")
            assert over <= 0, f"{count} runs at {width}: {over} too wide"
        if pictures:
            page.picture(f"{pictures}/{count}-{width}.png", whole=True)
    page.look(1280, 900)


def controls_work(page):
    """Of the 200 runs: three axes."""
    assert len(texts(page, "#curves li")) == 4, "viscosities as curves"
    points = len(texts(page, "#plots figure:first-child circle"))
    assert points == 40, f"{points}: each a mean over five seeds"
    assert "mean of 5 runs" in page.run("document.querySelector('#plots g title').textContent")
    choose(page, "as-curves", "none")
    assert len(texts(page, "#plots figure:first-child circle")) == 10, "of the first viscosity"
    choose(page, "at-1", "mean over all")
    assert "mean of 20 runs" in page.run("document.querySelector('#plots g title').textContent")
    choose(page, "along", "cells.cytoplasm_viscosity")
    assert texts(page, "#plots figure:first-child svg > text")[-1] == "cytoplasm_viscosity [cP]"
    before = texts(page, "#differences tbody tr")
    page.run("(() => { const list = element('second'); list.selectedIndex = 1; list.dispatchEvent(new Event('change')); })()")
    assert texts(page, "#differences tbody tr") != before
    for order in (1, -1):
        page.run("[...document.querySelectorAll('#runs thead button')].find((b) => b.textContent === 'lambda_C').click()")
        shown = page.run("[...document.querySelectorAll('#runs tbody tr')].map((r) => runs[r.cells[0].textContent - 1].means[1]).map((m) => m && m[0])")
        assert shown[-1] is None and shown[:-1] == sorted(shown[:-1], reverse=order < 0), "those without a value last"


with tempfile.TemporaryDirectory() as name:
    place = pathlib.Path(name)
    with chromium.Chromium(place) as page:
        page.look(1280, 900)
        for count, axes in SWEEPS.items():
            folder = place / str(count)
            invent(folder, axes)
            subprocess.run([program, "report", str(folder)], check=True, stdout=subprocess.DEVNULL)
            begin = time.monotonic()
            page.open(folder / "report.html")
            page.settle()
            print(f"{count} runs: {len((folder / 'report.html').read_bytes()) / 1e3:.0f} kB, shown after {time.monotonic() - begin:.2f} s", flush=True)
            is_whole(page, count)
        controls_work(page)
        assert not page.complaints, page.complaints
