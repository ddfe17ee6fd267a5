"""The page of a run, and of two side by side, in Chromium: no error, no request, the player moves, each control does what it says.

usage: player.py TANKTREAD SOURCE_DIR   exit code 77: there is no Chromium, nothing was tried
"""
import csv
import math
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import time

from chromium import program
from page import Page, near

if not program():
    print("skipped: Chromium is not installed (tools/install browser)")
    sys.exit(77)
tanktread, source = (pathlib.Path(word).resolve() for word in sys.argv[1:])


def make(folder, name, *settings):
    case = source / "cases/05-channel/case.toml"
    told = [word for setting in ("numerics.dx=0.5 um", f"name={name}", *settings) for word in ("--set", setting)]
    subprocess.run([tanktread, "run", case, "-o", folder / name, "-j", "1", "--progress", "none", *told], check=True, capture_output=True)


def report(*folders, figures=True):
    """Figures take the longest; without gnuplot on the path there are none."""
    environment = dict(os.environ) if figures else {**os.environ, "PATH": str(folders[0])}
    subprocess.run([tanktread, "report", *folders], check=True, capture_output=True, cwd=folders[0].parent, env=environment)


def reads_well(page, where):
    """At both widths, light and dark: nothing wider than the window, picture and controls within its height, text with contrast."""
    page.look(1280, 800)
    page.open(where)
    back = {}
    for width, dark in ((1280, False), (390, False), (390, True), (1280, True)):
        page.look(width, 800, dark)
        page.settle()
        assert page.run("document.documentElement.scrollWidth <= innerWidth"), f"wider than {width}"
        assert page.run("player.canvas.offsetHeight + element('controls').offsetHeight <= innerHeight"), f"higher than the window at {width}"
        if width < 500:
            cut = page.run("[...document.querySelectorAll('.scroll td')].filter((c) => c.offsetParent && "
                           "(c.scrollWidth > c.clientWidth + 1 || c.getBoundingClientRect().right > innerWidth)).map((c) => c.textContent)")
            assert not cut, f"values cut off at {width}: {cut}"
        back[dark] = sum(page.run("""(() => { const probe = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
            probe.drawImage(player.canvas, 0, 0); return [...probe.getImageData(0, 0, 1, 1).data].slice(0, 3); })()"""))
        for name in ("--ink", "--soft", "--link"):
            contrast = page.contrast(name)
            assert contrast >= 4.5, f"{name} has a contrast of {contrast:.1f}, dark: {dark}"
    assert back[False] == 765 and back[True] < 150, f"the picture follows the system: {back}"
    page.look(1280, 800)
    page.settle()
    lost = page.run("[...document.querySelectorAll('nav a, h2 a')].filter((a) => !document.querySelector(a.getAttribute('href'))).length")
    assert lost == 0 and page.run("document.querySelectorAll('nav li').length") >= 7, "contents list"


def numbers_are_there(page):
    text = page.run("document.querySelector('#numbers ~ .scroll').innerText")
    found = dict(re.findall(r"^(.+?)\t([\d.e+-]+)\t", text, re.MULTILINE))
    near(float(found["shear number G"]), 0.4, 1e-9, "G = 1.2e-3 · 500 · 4e-6 / 6e-6")
    velocity = float(found["mean velocity U"]) * 1e-3
    near(float(found["Reynolds number of the channel"]), 1025 * velocity * 20e-6 / 1.2e-3, 2e-3, "Re of the channel")
    near(float(found["Reynolds number of a cell"]), 1025 * velocity / 20e-6 * 16e-12 / 1.2e-3, 1e-4, "Re of a cell")
    assert float(found["wall shear stress"]) > 1.0


def time_goes_by(page):
    """Play, pause, pace, slider."""
    page.run("clock.set(0)")
    before = page.picture_hash()
    page.pick("pace", "1 : 1" + "\u2009" + "000")
    page.push("play")
    page.wait("clock.time() > 0.6e-3", 20)
    assert page.run("element('play').textContent") == "Pause" and page.picture_hash() != before, "the cells move"
    # Between two pictures; the clock waits where the machine stands still for long, hence three tries.
    paces = [page.run("""new Promise((done) => requestAnimationFrame((from) => {
        const start = clock.time();
        setTimeout(() => requestAnimationFrame((to) => done((clock.time() - start) / (to - from) * 1e6)), 500);
    }))""") for _ in range(3)]
    near(min(paces, key=lambda p: abs(p - 1)), 1.0, 0.03, "1 s shows 1 ms")
    page.push("play")
    stood = page.time()
    time.sleep(0.1)
    assert page.time() == stood and page.run("element('play').textContent") == "Play"
    page.run("(() => { const s = element('scrub'); s.value = 3e-3; s.dispatchEvent(new Event('input')); })()")
    near(page.time(), 3e-3, 1e-9, "the slider sets the time")
    assert page.run("element('clock').textContent").startswith("t = 3.0"), "in ms"
    assert any(t.startswith("true pace") for t in page.run("[...element('pace').options].map((o) => o.text)"))


def keys_work(page):
    page.run("player.canvas.focus()")
    times = page.run("data.playing[0].player.times")
    for key, wanted in (("Home", times[0]), ("ArrowRight", times[1]), ("ArrowRight", times[2]), ("ArrowLeft", times[1]), ("End", times[-1])):
        page.press(key)
        near(page.time(), wanted, 1e-12, key)
    page.press("Home")
    page.press(" ")
    page.wait("clock.playing() && clock.time() > 0")
    page.press(" ")
    assert not page.run("clock.playing()")
    scrolled = page.run("scrollY")
    page.press("ArrowDown")
    assert page.run("player.state.cell.number") == 0 and page.run("scrollY") == scrolled, "down chooses a cell"
    page.press("ArrowDown")
    assert page.run("player.state.cell.number") == 1
    page.press("Escape")
    assert page.run("player.state.cell") is None
    visited = []
    for _ in range(14):
        page.press("Tab")
        visited.append(page.run("document.activeElement.id || document.activeElement.tagName"))
    wanted = ["play", "scrub", "pace", "colour", "background", "cell", "save-png", "save-webm"]
    assert visited[:8] == wanted and visited[-1] not in wanted, f"Tab goes on: {visited}"


def colours_tell(page, folder):
    page.run("clock.set(4e-3)")
    seen = {}
    for name in page.run("[...element('colour').options].map((o) => o.text)"):
        page.pick("colour", name)
        seen[name] = page.picture_hash()
    assert len(set(seen.values())) == len(seen) == 7, f"each looks its own way: {list(seen)}"
    page.pick("colour", "λ_C")
    assert page.white_share() < 0.05, "all of the box has a colour"
    page.push("background")
    assert page.white_share() > 0.3, "without the speed the plasma is white"
    page.push("background")
    # What the page carries of stretch and tension is what the run had.
    rows = [row for row in csv.DictReader((folder / "cells.csv").open()) if row["cell"] == "0"]
    row = min(rows, key=lambda r: abs(float(r["time [s]"]) - 4e-3))
    found = page.run("""(() => { const p = data.playing[0].player, s = p.stretch, at = p.frame(clock.time()) * p.nodeCount;
        return [...s.level.slice(at, at + p.first[1])].map((b) => [s.low + (s.high - s.low) * b / 255, s.tension[0][b]]); })()""")
    step = page.run("(data.playing[0].player.stretch.high - data.playing[0].player.stretch.low) / 255")
    near(max(s for s, _ in found), float(row["stretch_max"]), 0.51 * step, "largest stretch")
    near(min(s for s, _ in found), float(row["stretch_min"]), 0.51 * step, "smallest stretch")
    for stretch, tension in found:
        hard = 1 + 0.55 * math.expm1(16 * abs(stretch - 1))
        near(tension, 6e-6 * (stretch ** 1.5 - stretch ** -1.5) * hard, 1e-12, "tension, Eqs. 10 and 12")


def cells_answer(page, folder):
    page.run("clock.set(4e-3)")
    page.settle()
    centre = page.run("""(() => { const panel = player.panels()[0], p = cells.outline(panel, panel.run.player.frame(clock.time()), 4);
        return [0, 1].map((i) => p.filter((_, k) => k % 2 === i).reduce((a, b) => a + b) / (p.length / 2)); })()""")
    page.point_at(*centre)
    assert page.run("!element('cell-panel').hidden && player.state.cell.number") == 4 and page.run("element('cell-name').textContent") == "Cell 4"
    rows = [row for row in csv.DictReader((folder / "cells.csv").open()) if row["cell"] == "4"]
    row = min(rows, key=lambda r: abs(float(r["time [s]"]) - 4e-3))
    told = dict(page.run("[...element('cell-numbers').rows].map((r) => [r.cells[0].textContent, r.cells[1].textContent])"))
    near(float(told["y [µm]"]), 1e6 * float(row["y [m]"]), 1e-2, "y of the cell")
    near(float(told["lambda_C"]), float(row["lambda_C"]), 1e-3, "its λ_C")
    page.wait("document.querySelector('#cell-panel canvas')")
    y = page.run("player.panels()[0].y")
    page.point_at(centre[0], y + 2)
    assert page.run("player.state.cell") is None and page.run("element('cell-panel').hidden"), "plasma is no cell"
    page.pick("cell", "cell 7")
    assert page.run("player.state.cell.number") == 7
    page.pick("cell", "none")


def charts_follow(page):
    page.run("element('charts').scrollIntoView()")
    page.settle()
    shown = page.run("[...document.querySelectorAll('#charts select')].map((s) => s.value)")
    assert shown == ["lambda_C", "taylor_inertia", "y", "wall_shear_stress"], shown
    box = page.run("(({ x, y, width, height }) => [x, y, width, height])(document.querySelector('#charts .u-over').getBoundingClientRect())")
    page.click(box[0] + 0.5 * box[2], box[1] + 0.5 * box[3])
    page.settle()
    near(page.time(), 3e-3, 5e-5, "a click in a chart sets the time")
    mark = page.run("document.querySelector('#charts .now').getBoundingClientRect().x")
    near(mark, box[0] + 0.5 * box[2], 2.5, "and the line goes there")


def saved(page, folder, ending, within):
    """The file that comes, once all of it is there: the browser writes it piece by piece."""
    until, before = time.monotonic() + within, b""
    while time.monotonic() < until:
        for path in folder.glob("*." + ending):
            now = path.read_bytes()
            if now and now == before:
                return now
            before = now
        time.sleep(0.3)
    note = page.run("element('save-note').textContent")
    raise AssertionError(f"no {ending} came in {within} s; the page says '{note}', {[p.name for p in folder.iterdir()]} {page.complaints}")


def pictures_are_saved(page, folder):
    folder.mkdir()
    page.save_to(folder)
    page.push("save-png")
    png = saved(page, folder, "png", 20)
    assert png[:8] == b"\x89PNG\r\n\x1a\n" and list(struct.unpack(">II", png[16:24])) == page.run(
        "[2 * player.canvas.clientWidth, 2 * player.canvas.clientHeight]"), "twice as sharp as the page"
    page.pick("pace", "1 : 200")
    page.run("window.earliest = clock.last; clock.onChange(() => { window.earliest = Math.min(window.earliest, clock.time()); })")
    page.push("save-webm")
    page.wait("clock.playing()")
    assert page.run("element('save-webm').textContent") == "Stop recording"
    webm = saved(page, folder, "webm", 20)
    assert webm[:4] == b"\x1a\x45\xdf\xa3" and b"webm" in webm[:64] and len(webm) > 10000, f"{len(webm)} bytes"
    near(page.run("window.earliest"), 0.0, 1e-12, "one pass, from the start")
    near(page.time(), page.run("clock.last"), 1e-12, "to the end")
    assert page.run("element('save-webm').textContent") == "Record WebM"


def runs_stand_side_by_side(page):
    page.run("clock.set(3.3e-3)")
    page.settle()
    assert page.run("player.panels().length") == 2
    shown = page.run("player.panels().map(({ run }) => run.player.times[run.player.frame(clock.time())])")
    near(shown[0], 3e-3, 5e-5, "the frame of each run is the latest at this time")
    near(shown[1], 3.2e-3, 5e-5, "by time, not by number")
    both = page.picture_hash()
    boxes = page.run("element('which').querySelectorAll('input').length")
    assert boxes == 2 and not page.run("element('which').hidden")
    page.run("element('which').querySelectorAll('input')[0].click()")
    page.settle()
    assert page.run("player.panels().map((p) => p.run.label)") == ["second"] and page.picture_hash() != both
    page.run("element('which').querySelectorAll('input')[1].click()")
    assert page.run("player.state.shown.length") == 1, "one stays"


with tempfile.TemporaryDirectory() as scratch:
    place = pathlib.Path(scratch)
    make(place, "first", "time.end=6 ms", "output.frames=0.5 ms")
    make(place, "second", "time.end=4 ms", "output.frames=0.4 ms", "cells.seed=2")
    make(place, "plasma", "time.end=0.1 ms", "numerics.fluid_only=true", "numerics.dx=1 um")
    report(place / "first")
    report(place / "plasma", figures=False)
    report(place / "first", place / "second", figures=False)
    with Page(place) as page:
        first = place / "first/report.html"
        reads_well(page, first)
        numbers_are_there(page)
        time_goes_by(page)
        keys_work(page)
        colours_tell(page, place / "first")
        cells_answer(page, place / "first")
        charts_follow(page)
        pictures_are_saved(page, place / "saved")
        reads_well(page, place / "comparison/report.html")
        runs_stand_side_by_side(page)
        page.open(place / "plasma/report.html")
        page.settle()
        assert page.run("player.panels().length") == 1 and page.run("element('colour').length") >= 1, "a run without cells has a page too"
        assert not page.complaints, page.complaints
print("the pages did what they say")
