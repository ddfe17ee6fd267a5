"""Cases drawn in chip files, from check to resume: results stand alone.

usage: program.py SOURCE_DIR TANKTREAD   exit code 77: a library is missing, nothing was tried
"""
import json
import os
import pathlib
import re
import struct
import subprocess
import sys

from common import data, expect, folder, fork, loops_of, source  # exits where libraries are missing

import ezdxf
import gdspy
import numpy as np

tanktread = pathlib.Path(sys.argv[2]).resolve()
case = (source / "cases/07-fork/case.toml").read_text()
# Modules that this Python seems not to have.
(folder / "without").mkdir()
(folder / "without/sitecustomize.py").write_text("""
import importlib.util, os
found = importlib.util.find_spec
importlib.util.find_spec = lambda name, package=None: None if name in os.environ.get("WITHOUT", "").split() else found(name, package)
""")
missing = {"PYTHONPATH": str(folder / "without"), "WITHOUT": "ezdxf gdspy svgelements shapely"}
quick = ["--set", "numerics.fluid_only=true", "--set", "numerics.dx=1 um"]


def call(*words, code=0, **environment):
    done = subprocess.run([tanktread, *map(str, words)], cwd=folder, capture_output=True, text=True, env={**os.environ, **environment})
    expect(done.returncode == code, words, done.returncode, done.stdout, done.stderr)
    return done


def write_forks():
    points = fork()
    doc = ezdxf.new("R2010")
    doc.header["$INSUNITS"] = 4
    doc.modelspace().add_lwpolyline([(x / 1e3, y / 1e3) for x, y in points], close=True)
    doc.saveas(folder / "fork.dxf")
    library = gdspy.GdsLibrary(unit=1e-6, precision=1e-9)
    cell = gdspy.Cell("TOP", exclude_from_current=True)
    library.add(cell.add(gdspy.Polygon(points, layer=1)))
    library.write_gds(str(folder / "fork.gds"))
    path = " ".join(f"{x},{y}" for x, y in points)  # lies above the page, y downwards: the lower edge of the page is y = 0
    (folder / "fork.svg").write_text(f'<svg xmlns="http://www.w3.org/2000/svg" width="0.2mm" height="0.1mm" viewBox="0 -100 200 100">'
                                     f'<g transform="scale(1,-1)"><path d="M{path}z"/></g></svg>')
    (folder / "fork.csv").write_bytes((source / "cases/07-fork/fork.csv").read_bytes())
    for kind in ("dxf", "gds", "svg", "csv"):
        (folder / f"{kind}.toml").write_text(case.replace("fork.csv", f"fork.{kind}"))


write_forks()


def walls(told):
    return [line for line in told.stdout.splitlines() if re.match(r" +(walls|ports|lower|upper|inlet)", line)]


def test_a_fork_is_the_same_whatever_it_is_drawn_in():
    wanted = call("check", "csv.toml", *quick)
    for kind in ("dxf", "gds", "svg"):
        told = call("check", f"{kind}.toml", *quick)
        expect(walls(told) == walls(wanted) and len(walls(told)) >= 2, told.stdout, wanted.stdout)
        expect("170 x 80 um, from (0, -40) to (170, 40) um" in told.stdout, told.stdout)


def test_results_go_on_without_converter_and_drawing():
    (folder / "short.dxf").write_bytes((folder / "fork.dxf").read_bytes())
    (folder / "short.toml").write_text(case.replace("fork.csv", "short.dxf"))
    short = [*quick, "--set", "time.end=0.4 ms", "--set", "numerics.density_scale=1", "-o", "alone"]
    call("run", "short.toml", *short, "--until", "0.1 ms", code=75)
    kept = sorted(path.name for path in (folder / "alone/inputs").iterdir())
    expect(kept == ["short.dxf", "short.dxf.loops.csv"], kept)
    expect((folder / "alone/inputs/short.dxf").read_bytes() == (folder / "fork.dxf").read_bytes(), "the original is kept")
    expect('file = "inputs/short.dxf.loops.csv"' in (folder / "alone/resolved.toml").read_text(), "resolved.toml")
    (folder / "short.dxf").rename(folder / "away.dxf")
    call("resume", "alone", "--until", "0.2 ms", code=75, **missing)
    (folder / "away.dxf").rename(folder / "short.dxf")
    call("run", "short.toml", *short)  # the same case, read from the drawing
    call("report", "alone", **missing)


def test_sweeps_go_on_without_converter():
    over = ["--over", "port.inlet.mean_velocity=1 mm/s,2 mm/s", "-o", "sweep"]
    call("sweep", "dxf.toml", *quick, "--set", "time.end=0.01 ms", *over)
    kept = sorted(path.name for path in (folder / "sweep/inputs").iterdir())
    expect(kept == ["dxf.toml", "fork.dxf", "fork.dxf.loops.csv"], kept)
    call("sweep", "sweep/sweep.toml", "-o", "sweep", **missing)
    call("check", "sweep/inputs/dxf.toml", *quick, **missing)
    # Loops of another drawing are not taken.
    path = folder / "sweep/inputs/fork.dxf"
    path.write_text(path.read_text().replace("$ACADMAINTVER", "$ACADMAINTVER", 1) + "\n")
    told = call("check", "sweep/inputs/dxf.toml", *quick, code=2, **missing).stderr
    expect("takes python3 with" in told, told)


def test_what_is_missing_is_named_with_how_to_install_it():
    for name, packages in (("fork.dxf", "python3-shapely python3-ezdxf"), ("fork.gds", "python3-shapely python3-gdspy"),
                           ("fork.svg", "python3-shapely python3-svgelements")):
        told = call("geometry", name, code=2, **missing).stderr
        expect(f"sudo apt install python3 {packages}" in " ".join(told.split()), told)


def test_the_same_drawing_gives_the_same_bytes_and_they_are_the_loops():
    for name, *options in ((data / "klayout.gds", "--layer", "1/0"), (data / "inkscape.png", "--pixel", "5 um", "--fluid", "dark")):
        told = call("geometry", name, *options, "-o", "one.csv").stdout
        call("geometry", name, *options, "-o", "two.csv")
        expect((folder / "one.csv").read_bytes() == (folder / "two.csv").read_bytes(), name)
        for label in ("drawing", "unit", "layer", "loops", "wrote one.csv"):
            expect(label in told, told)
        expect("from (" in call("geometry", "one.csv").stdout, "loops are read again")


def test_keys_that_mean_nothing_for_a_file_are_told():
    def told(name, *settings):
        (folder / "wrong.toml").write_text(case.replace("fork.csv", name))
        return " ".join(call("check", "wrong.toml", *[word for s in settings for word in ("--set", s)], code=2).stderr.split())
    (folder / "mask.png").write_bytes((data / "inkscape.png").read_bytes())
    (folder / "chip.oas").write_text("%SEMI-OASIS")
    for part, words in {
        "pixel means nothing for fork.dxf; leave it out": ("fork.dxf", "geometry.pixel=1 um"),
        "layer means nothing for fork.csv; leave it out": ("fork.csv", "geometry.layer=A"),
        "write pixel = \"0.5 um\", the side": ("mask.png", "geometry.fluid=bright"),
        "write fluid = \"bright\" or \"dark\"": ("mask.png", "geometry.pixel=1 um"),
        "unit means nothing for a picture": ("mask.png", "geometry.unit=1 um", "geometry.pixel=1 um", "geometry.fluid=dark"),
        "fluid = \"dark\" is for pictures": ("fork.dxf", "geometry.fluid=dark"),
        "chip.oas is of no kind that is read": ("chip.oas",),
        "layer \"GONE\" holds nothing that can be seen; layers with shapes (and how many): 0 (1)": ("fork.dxf", "geometry.layer=GONE"),
        "cannot open": ("gone.dxf",),
    }.items():
        expect(part in told(*words), part, told(*words))
    told = call("geometry", "fork.dxf", "--unit", "3 ms", code=2).stderr
    expect("--unit 3 ms is not a length" in told, told)


def test_pictures_of_every_case_and_of_a_drawing():
    def size(path):
        content = path.read_bytes()
        expect(content.startswith(b"\x89PNG"), path)
        return struct.unpack(">II", content[16:24])
    coarse = ["--set", "numerics.dx=0.5 um"]
    for template, *settings in (("couette",), ("posts", *quick), ("chip", *coarse)):
        call("new", template, "--from", template)
        call("check", f"{template}.toml", "--picture", *settings)
        width, height = size(folder / f"{template}.png")
        expect(width >= 720 and height > 200, width, height)
    text = call("check", "chip.toml", "--picture", "chip.svg", *quick) and (folder / "chip.svg").read_text()
    for part in ("inlet: mean velocity 1 mm/s", "narrow: pressure 0 Pa", "20 μm"):
        expect(part in text, part)
    call("geometry", data / "klayout.gds", "--layer", "1", "--picture", "plate.png")
    size(folder / "plate.png")
    told = call("check", "chip.toml", "--picture", "chip.pdf", code=2).stderr
    expect("ends in .png or .svg" in told, told)
    # A case that cannot run is drawn all the same.
    call("check", "dxf.toml", "--set", "numerics.fluid_only=true", "--set", "numerics.dx=3 um", "--picture", "coarse.png", code=2)
    size(folder / "coarse.png")


def test_cells_of_the_chip_go_their_way():
    settings = ["--set", "numerics.dx=0.5 um", "--set", "time.end=10 ms", "--set", "output.frames=5 ms", "--set", "cells.seed=2"]
    call("run", source / "cases/09-chip/case.toml", *settings, "-o", "chip-run")
    summary = json.loads((folder / "chip-run/summary.json").read_text())
    rows = (folder / "chip-run/left.csv").read_text().splitlines()
    expect(len(rows) > 1 and summary, rows)
    # The committed drawing is what the script draws.
    loops, _ = loops_of(source / "cases/09-chip/chip.dxf", layer="CHANNELS")
    (folder / "draw.py").write_text((source / "cases/09-chip/draw.py").read_text())
    subprocess.run([sys.executable, folder / "draw.py"], check=True)
    again, _ = loops_of(folder / "chip.dxf", layer="CHANNELS")
    expect(all(np.array_equal(a, b) for a, b in zip(loops, again)) and len(loops) == len(again) == 2, "draw.py")


if __name__ == "__main__":
    from common import run_tests
    run_tests(sys.modules[__name__])
