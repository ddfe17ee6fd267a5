#!/usr/bin/env bash
# Inkscape 1.2.2 (Debian 12, inkscape 1.2.2-2+deb12u1): a circle exported to DXF on the command line.
#
# Guess: `inkscape drawing.svg -o drawing.dxf` writes the circle as a CIRCLE, as arcs, or as a fine polygon.
# Seen:  a circle as drawn is left out, without a word. Made a path first (Object to Path), it becomes an octagon of eight LINEs,
#        whose area is 10 % too small. The size of the page is lost too: no $INSUNITS.
# Why it matters: the posts of a chip vanish, or let more fluid pass than those that will be made. Export SVG, which is exact.
# Needs inkscape, python3-lxml and python3-numpy to be installed (apt-get install inkscape=1.2.2-2+deb12u1 python3-lxml).
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
inkscape --version 2>/dev/null | grep -q "Inkscape 1.2.2" || { echo "Inkscape 1.2.2 is not installed" >&2; exit 1; }
cat > drawing.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="1mm" height="1mm" viewBox="0 0 1000 1000"><circle id="post" cx="500" cy="500" r="60"/></svg>
SVG
inkscape drawing.svg -o circle.dxf 2>/dev/null
inkscape drawing.svg --actions="select-all;object-to-path" --export-plain-svg -o path.svg 2>/dev/null
inkscape path.svg -o path.dxf 2>/dev/null
/usr/bin/python3 - <<'PYTHON'
import math


def lines(name):
    """Ends of the LINEs of a DXF, those of no length left out."""
    text = open(name).read().split("\n")
    pairs = list(zip((c.strip() for c in text[::2]), (v.strip() for v in text[1::2])))
    kinds = {value for code, value in pairs if code == "0"}
    assert not kinds & {"CIRCLE", "ARC", "LWPOLYLINE", "POLYLINE", "SPLINE", "ELLIPSE"} and not any(v == "$INSUNITS" for _, v in pairs)
    found, at = [], None
    for code, value in pairs:
        if code == "0":
            at = {} if value == "LINE" else None
            found.extend([at] if at is not None else [])
        elif at is not None and code in ("10", "20", "11", "21"):
            at[code] = float(value)
    ends = [((l["10"], l["20"]), (l["11"], l["21"])) for l in found]
    return [(a, b) for a, b in ends if math.dist(a, b) > 1e-9]


octagon = lines("path.dxf")
area = abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in octagon)) / 2
radius = (max(a[0] for a, _ in octagon) - min(a[0] for a, _ in octagon)) / 2
share = area / (math.pi * radius**2)
print(f"circle: {len(lines('circle.dxf'))} lines; as a path: {len(octagon)} lines, {100 * (1 - share):.1f} % of the area are missing")
assert not lines("circle.dxf") and len(octagon) == 8 and 0.85 < share < 0.95
PYTHON
