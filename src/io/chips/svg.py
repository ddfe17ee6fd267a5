"""SVG: the outlines of shapes, whatever paints them. Paths and transforms are read by svgelements."""
from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET

import numpy as np

from . import curves
from .drawing import Drawing, Options, Refused

XLINK, INKSCAPE = "{http://www.w3.org/1999/xlink}", "{http://www.inkscape.org/namespaces/inkscape}"
SVG = "{http://www.w3.org/2000/svg}"
SHAPES = {"path", "rect", "circle", "ellipse", "line", "polyline", "polygon"}
GROUPS = {"g", "a", "svg"}
UNSEEN = {"defs", "symbol", "marker", "pattern", "mask", "clipPath", "linearGradient", "radialGradient", "filter", "title", "desc",
          "metadata", "style", "script", "view", "namedview"}
MM = {"mm": 1.0, "cm": 10.0, "in": 25.4, "pt": 25.4 / 72, "pc": 25.4 / 6, "Q": 0.25}
TRANSFORM = re.compile(r"(\s*,?\s*(matrix|translate|scale|rotate|skewX|skewY)\s*\([-+\d.eE\s,]+\))+\s*")
MOST_USES, DEEPEST = 100_000, 64


def plain(element) -> str:
    """The name of an element of SVG; that of another kind with its braces."""
    return element.tag.removeprefix(SVG) if isinstance(element.tag, str) else "comment"


def style_of(element) -> dict[str, str]:
    """Properties of its own: attributes, and over them those of `style`."""
    own = {name: value.strip() for name, value in element.attrib.items() if "{" not in name}
    for part in own.pop("style", "").split(";"):
        name, colon, value = part.partition(":")
        if colon:
            own["css transform" if name.strip() == "transform" else name.strip()] = value.strip()
    return own


class Reader:
    def __init__(self, root, drawing: Drawing, off: float, wanted: str | None):
        self.drawing, self.off, self.wanted = drawing, off, wanted
        self.by_id = {e.get("id"): e for e in root.iter() if e.get("id")}
        self.uses = 0

    def layer_of(self, element, above: str) -> str:
        """The id that is asked for; else that of a layer of Inkscape."""
        names = (element.get("id"), element.get(INKSCAPE + "label"))
        if self.wanted is not None:
            return self.wanted if self.wanted in names else above
        if element.get(INKSCAPE + "groupmode") == "layer":
            return names[1] or names[0] or above
        return above

    def read(self, element, matrix, layer: str, depth: int = 0):
        import svgelements

        name = plain(element)
        if name in UNSEEN or name == "comment" or "{" in name:
            return
        own = style_of(element)
        layer = self.layer_of(element, layer)
        if own.get("display") == "none":
            self.drawing.skipped["display: none"] += 1
            return
        for key in ("clip-path", "mask", "css transform"):
            if own.get(key, "none") != "none":
                advice = "apply it in the drawing program" if key != "css transform" else "write it as the attribute transform"
                self.drawing.refuse(layer, f"{name} with a {key}; {advice}")
        if depth > DEEPEST:
            raise Refused(f"groups deeper than {DEEPEST}, or a use that holds itself")
        if own.get("transform"):
            if not TRANSFORM.fullmatch(own["transform"]):  # svgelements passes over what it does not know
                raise Refused(f"transform = \"{own['transform'][:60]}\" cannot be read")
            matrix = svgelements.Matrix(own["transform"]) * matrix
        if name == "svg" and depth > 0:
            self.drawing.refuse(layer, "svg within svg; ungroup it in the drawing program")
        elif name in GROUPS:
            for child in element:
                self.read(child, matrix, layer, depth + 1)
        elif name == "use":
            self.use(element, own, matrix, layer, depth)
        elif own.get("visibility") in ("hidden", "collapse"):
            self.drawing.skipped["visibility: hidden"] += 1
        elif name in SHAPES:
            self.shape(element, name, matrix, layer)
        else:
            advice = "; make paths of it (Object to Path)" if name in ("text", "flowRoot") else ""
            self.drawing.refuse(layer, f"{name} is no outline{advice}")

    def use(self, element, own, matrix, layer: str, depth: int):
        import svgelements

        self.uses += 1
        if self.uses > MOST_USES:
            raise Refused(f"more than {MOST_USES} uses; keep those of the channels")
        target = self.by_id.get((element.get("href") or element.get(XLINK + "href") or "").removeprefix("#"))
        if target is None:
            return self.drawing.refuse(layer, "use of something that is not in the file")
        if plain(target) in ("symbol", "svg"):
            return self.drawing.refuse(layer, f"use of a {plain(target)}; unlink the clone in the drawing program")
        shift = svgelements.Matrix.translate(length(own.get("x", "0")), length(own.get("y", "0")))
        self.read(target, shift * matrix, layer, depth + 1)

    def shape(self, element, name: str, matrix, layer: str):
        import svgelements

        known = {"path": svgelements.Path, "rect": svgelements.Rect, "circle": svgelements.Circle, "ellipse": svgelements.Ellipse,
                 "line": svgelements.SimpleLine, "polyline": svgelements.Polyline, "polygon": svgelements.Polygon}
        values = {key: value for key, value in element.attrib.items() if key in
                  ("d", "points", "x", "y", "width", "height", "rx", "ry", "cx", "cy", "r", "x1", "y1", "x2", "y2")}
        try:
            path = svgelements.Path(values["d"]) if name == "path" and "d" in values else svgelements.Path(known[name](**values))
            path = path * matrix
            path.reify()
        except Exception as error:  # svgelements raises whatever its parts do
            raise Refused(f"{name} '{element.get('id', '')}' cannot be read: {error}") from None
        label = f"'{element.get('id')}'" if element.get("id") else ""
        points, closed = [], False
        for segment in [*path, None]:
            if segment is None or isinstance(segment, svgelements.Move):
                if len(points) > 1:
                    self.drawing.add(layer, points, closed or name in ("rect", "circle", "ellipse", "polygon"), name, label)
                points, closed = [segment.end] if segment is not None else [], False
            elif isinstance(segment, svgelements.Close):
                closed = True
            else:
                if closed:  # goes on after z from where the outline began
                    self.drawing.add(layer, points, True, name, label)
                    points, closed = [points[0]], False
                points.extend(self.flat(segment)[1:])

    def flat(self, segment) -> np.ndarray:
        import svgelements

        if isinstance(segment, svgelements.Arc):
            widest = max(segment.rx, segment.ry)
            if not widest > 0.0 or segment.sweep == 0.0:
                return np.array([segment.start, segment.end])
            count = len(curves.arc((0, 0), widest, 0.0, segment.sweep, self.off)) - 1
            return np.array([segment.start, *(segment.point(k / count) for k in range(1, count)), segment.end])
        if isinstance(segment, svgelements.QuadraticBezier):
            return curves.bezier([segment.start, segment.control, segment.end], self.off)
        if isinstance(segment, svgelements.CubicBezier):
            return curves.bezier([segment.start, segment.control1, segment.control2, segment.end], self.off)
        return np.array([segment.start, segment.end])


def length(text: str) -> float:
    """A length in user units."""
    match = re.fullmatch(r"\s*([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*([a-zA-Z%]*)\s*", text)
    if not match or match[2] not in ("", "px", *MM):
        raise Refused(f"\"{text[:40]}\" is no length")
    return float(match[1]) * (MM[match[2]] * 96 / 25.4 if match[2] in MM else 1.0)


def in_mm(root, key: str) -> float | None:
    """The size of the page where it is given in a unit of length."""
    match = re.fullmatch(r"\s*([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*([a-zA-Z]+)\s*", root.get(key, ""))
    return float(match[1]) * MM[match[2]] if match and match[2] in MM else None


def page(root, options: Options):
    """µm of a user unit along x and y, the place in user units that is the lower left corner, and how the unit is known."""
    box = [float(word) for word in re.split(r"[\s,]+", root.get("viewBox", "").strip()) if word]
    width, height = in_mm(root, "width"), in_mm(root, "height")
    if box and (len(box) != 4 or not box[2] > 0 or not box[3] > 0):
        raise Refused(f"viewBox = \"{root.get('viewBox')}\" cannot be read")
    if options.unit is not None:
        low = (box[0], box[1] + box[3]) if box else (0.0, length(root.get("height", "0")) if "%" not in root.get("height", "") else 0.0)
        return (options.unit, options.unit), low, f"{options.unit:.10g} um, as given"
    if width is None or height is None:
        raise Refused("the file has no unit: width and height of the page are in pixels or missing; write unit = \"1 um\", or what "
                      "one unit of the drawing is")
    if not box:  # a pixel is 1/96 inch
        pixel = 25.4e3 / 96
        return (pixel, pixel), (0.0, height * 1e3 / pixel), f"{pixel:.10g} um, a pixel, as there is no viewBox"
    x, y = width * 1e3 / box[2], height * 1e3 / box[3]
    aspect = root.get("preserveAspectRatio", "xMidYMid").split()
    if aspect[0] == "none" or math.isclose(x, y, rel_tol=1e-9):
        said = f"{x:.10g} um" + ("" if math.isclose(x, y, rel_tol=1e-9) else f" along x, {y:.10g} um along y")
        return (x, y), (box[0], box[1] + box[3]), f"{said}, as the size of the page and the viewBox say"
    scale = max(x, y) if "slice" in aspect else min(x, y)
    # Where the drawing lies on the page: in the middle, or at the side that is named.
    share = {"Min": 0.0, "Mid": 0.5, "Max": 1.0}
    left = (width * 1e3 - box[2] * scale) * share.get(aspect[0][1:4], 0.5)
    top = (height * 1e3 - box[3] * scale) * share.get(aspect[0][5:8], 0.5)
    low = (box[0] - left / scale, box[1] + (height * 1e3 - top) / scale)
    return (scale, scale), low, f"{scale:.10g} um, as the size of the page and the viewBox say"


def check_styles(root):
    """Rules of style sheets are not followed; those that would move or hide shapes are refused."""
    for element in root.iter(SVG + "style"):
        for word in ("transform", "clip-path", "mask", "display", "visibility"):
            if re.search(rf"(?<![-\w]){word}\s*:", element.text or ""):
                raise Refused(f"a style sheet in the file sets {word}; write it as an attribute of the shapes")


def read(data: bytes, options: Options) -> Drawing:
    import svgelements

    try:
        root = ET.fromstring(data)
    except (ET.ParseError, LookupError, ValueError) as error:
        raise Refused(f"this is no whole SVG: {error}") from None
    if plain(root) != "svg":
        raise Refused("this is XML, but no SVG")
    check_styles(root)
    (x, y), (left, low), unit = page(root, options)
    drawing = Drawing(unit=unit)
    # y goes up from the lower edge of the page.
    matrix = svgelements.Matrix(x, 0, 0, -y, -x * left, y * low)
    Reader(root, drawing, options.off, options.layer).read(root, matrix, "the page")
    return drawing
