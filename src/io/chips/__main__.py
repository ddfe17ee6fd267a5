"""usage: python3 -m chips FILE OUT [--layer L] [--unit UM] [--pixel UM] [--chord UM] [--fluid WORD]

Writes OUT/loops.csv and OUT/told.json: {"found": [[label, text]], "remarks": [text]}, or {"faults": [text]} (exit 2), or
{"missing": [module]} (exit 3). Lengths are in µm.
"""
from __future__ import annotations

import argparse
import importlib.util
import json
import os
import pathlib
import resource
import signal
import sys

MOST_SECONDS, MOST_MEMORY = 300, 8 << 30
# By the end of the name: what reads it, with which modules, how many bytes it may have.
KINDS = {"dxf": ("ezdxf", 200), "gds": ("gdspy", 400), "svg": ("svgelements", 50), "png": ("PIL contourpy", 200)}
ENDINGS = {"gdsii": "gds", "gds2": "gds"}


def kind_inside(data: bytes) -> str:
    """What the bytes are, whatever the name says."""
    head = data[:4096].lstrip(b"\xef\xbb\xbf").lstrip()
    for start, kind in ((b"\x89PNG", "png"), (b"\x00\x06\x00\x02", "gds"), (b"AutoCAD Binary DXF", "dxf"), (b"AC10", "a DWG"),
                        (b"%SEMI-OASIS", "an OASIS"), (b"\x1f\x8b", "a compressed"), (b"%PDF", "a PDF"), (b"\xff\xd8\xff", "a JPEG"),
                        (b"II*\x00", "a TIFF"), (b"MM\x00*", "a TIFF"), (b"BM", "a BMP")):
        if head.startswith(start):
            return kind
    if data.startswith(b"\x00\x06\x00\x02"):
        return "gds"
    if head.startswith(b"<") and b"<svg" in data[:65536]:
        return "svg"
    lines = head.split(b"\n")[:200]
    return "dxf" if any(line.strip() == b"SECTION" or line.strip() == b"999" for line in lines) else "no known kind of"


def read(path: pathlib.Path, options):
    from .drawing import Refused

    ending = path.suffix.lower().lstrip(".")
    kind = ENDINGS.get(ending, ending)
    data = path.read_bytes()
    most = KINDS[kind][1]
    if len(data) > most << 20:
        raise Refused(f"the file has {len(data) / 1e6:.0f} MB, and {most} are the most that is read; keep only the layer of the "
                      "channels in it")
    inside = kind_inside(data)
    if not data:
        raise Refused("the file is empty")
    if inside != kind:
        raise Refused(f"this is {inside if ' ' in inside else 'a ' + inside.upper()} file, not a {kind.upper()}; "
                      + ("give it the name it should have" if inside in KINDS else f"save it as {kind.upper()}"))
    return importlib.import_module("." + kind, __package__).read(data, options)


def csv_of(loops) -> str:
    text = "# x, y in um, loops parted by empty lines\n"
    for loop in loops:
        text += "".join(f"{x:.6f}".rstrip("0").rstrip(".") + "," + f"{y:.6f}".rstrip("0").rstrip(".") + "\n" for x, y in loop) + "\n"
    return text


def convert(path: pathlib.Path, options) -> tuple[str, dict]:
    import numpy as np

    from .drawing import Refused, counted
    from .outlines import outlines

    drawing = read(path, options)
    drawing.select(options.layer if path.suffix.lower() not in (".gds", ".gdsii", ".gds2") else
                   importlib.import_module(".gds", __package__).layer_of(options.layer))
    result = outlines(drawing, options.off)
    points = np.vstack(result.loops)
    low, high = points.min(axis=0), points.max(axis=0)
    size = f"{high[0] - low[0]:.6g} x {high[1] - low[1]:.6g} um"
    if not 1.0 <= (high - low).max() <= 1e5:
        raise Refused(f"what is drawn measures {size}, with a unit of {drawing.unit}; chips are 1 um to 10 cm long: write the right "
                      + ("pixel" if options.pixel else "unit"))
    if len(points) > 1_000_000:
        raise Refused(f"the loops have {len(points)} points; write a larger chord, as in chord = \"0.1 um\"")
    layers = "; ".join(f"{layer}: " + ", ".join(f"{count} {kind}" for kind, count in drawing.kinds[layer].items())
                       for layer in drawing.taken if drawing.kinds[layer])
    perimeter = sum(float(np.hypot(*(np.roll(loop, -1, 0) - loop).T).sum()) for loop in result.loops)
    found = [["drawing", f"{size}, from ({low[0]:.6g}, {low[1]:.6g}) to ({high[0]:.6g}, {high[1]:.6g}) um"], ["unit", drawing.unit],
             ["layer", layers]]
    if drawing.skipped:
        found.append(["left out", ", ".join(f"{count} {why}" for why, count in sorted(drawing.skipped.items()))])
    found.append(["loops", f"{counted(len(result.loops), 'loop')} of {len(points)} points; area {result.area:.6g} um^2, mean width "
                  f"{2 * result.area / perimeter:.4g} um"])
    found += [["joined", text] for text in result.found]
    return csv_of(result.loops), {"found": found, "remarks": drawing.remarks}


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("file", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    for name in ("unit", "pixel", "chord"):
        parser.add_argument("--" + name, type=float)
    parser.add_argument("--layer")
    parser.add_argument("--fluid", default="inside")
    given = vars(parser.parse_args())
    path, out = given.pop("file"), given.pop("out")

    def tell(code: int, told: dict) -> int:
        (out / "told.json").write_text(json.dumps(told))
        return code

    kind = path.suffix.lower().lstrip(".")
    needed = ["numpy", "shapely", *KINDS[ENDINGS.get(kind, kind)][0].split()]
    if missing := [module for module in needed if importlib.util.find_spec(module) is None]:
        return tell(3, {"missing": missing})

    from .drawing import Options, Refused

    def out_of_time(*_):
        raise Refused(f"reading took more than {MOST_SECONDS} s; keep only the layer of the channels in the file")

    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    signal.signal(signal.SIGALRM, out_of_time)
    signal.alarm(MOST_SECONDS)
    try:
        csv, told = convert(path, Options(**given))
    except Refused as refused:
        return tell(2, {"faults": list(refused.messages)})
    except (MemoryError, RecursionError):
        return tell(2, {"faults": ["the file takes more memory than chips do; keep only the layer of the channels in it"]})
    (out / "loops.csv").write_text(csv)
    return tell(0, told)


if __name__ == "__main__":
    os.environ["OMP_NUM_THREADS"] = "1"
    sys.exit(main())
