"""DXF, read by ezdxf. Shapes of model space; blocks are inserted, layers that cannot be seen left out."""
from __future__ import annotations

import io
import math
import re

import numpy as np

from . import curves
from .drawing import Drawing, Options, Refused

UNITS = {1: (25400.0, "inch"), 4: (1000.0, "mm"), 5: (1e4, "cm"), 6: (1e6, "m"), 13: (1.0, "um")}
MOST_INSERTS = 100_000
DEEPEST = 16  # blocks within blocks


def text_of(data: bytes) -> str:
    if data.startswith(b"AutoCAD Binary DXF"):
        raise Refused("this is a binary DXF; save it as ASCII DXF")
    data = data.removeprefix(b"\xef\xbb\xbf")
    # Since AutoCAD 2007 (AC1021) the text is UTF-8; before, in the code page that the header names.
    version = re.search(rb"\$ACADVER\s+1\s+AC(\d+)", data)
    page = re.search(rb"\$DWGCODEPAGE\s+3\s+ANSI_(\d+)", data)
    encoding = "utf-8" if version and int(version[1]) >= 1021 else f"cp{page[1].decode()}" if page else "cp1252"
    try:
        return data.decode(encoding, errors="replace")
    except LookupError:
        return data.decode("cp1252", errors="replace")


def unit_of(data: bytes, options: Options) -> tuple[float, str]:
    """µm of one unit of the drawing, and how that is known. ezdxf says metres where no header says anything."""
    said = re.search(rb"\$INSUNITS\s+70\s+(\d+)", data[:1 << 20])
    number = int(said[1]) if said else None
    if options.unit is not None:
        text = f"{options.unit:.10g} um, as given"
        return options.unit, text + (f" (the file says {UNITS[number][1]})" if number in UNITS else "")
    if number in UNITS:
        return UNITS[number][0], f"1 {UNITS[number][1]}, as $INSUNITS = {number} in the file says"
    why = "has no $INSUNITS" if number is None else f"says $INSUNITS = {number}" + (", no unit" if number == 0 else "")
    raise Refused(f"the file {why}; write unit = \"1 mm\", or what one unit of the drawing is")


class Reader:
    def __init__(self, doc, drawing: Drawing, scale: float, off: float):
        self.doc, self.drawing, self.scale = doc, drawing, scale
        self.off = off / scale  # in units of the drawing
        self.inserts = 0

    def hidden(self, layer: str) -> str:
        if layer not in self.doc.layers:
            return ""
        entry = self.doc.layers.get(layer)
        return "layer frozen" if entry.is_frozen() else "layer off" if entry.is_off() else ""

    def read(self, entities, outer: str | None = None, depth: int = 0):
        """`outer` is the layer of the INSERT, which those on layer 0 take."""
        for entity in entities:
            layer = entity.dxf.get("layer", "0")
            if outer is not None and layer == "0":
                layer = outer
            why = self.hidden(layer)
            if why or entity.dxf.get("invisible", 0):
                self.drawing.skipped[f"on {layer}: {why or 'invisible'}"] += 1
            elif entity.dxftype() == "INSERT":
                self.insert(entity, layer, depth)
            else:
                self.entity(entity, layer)

    def insert(self, entity, layer: str, depth: int):
        block = self.doc.blocks.get(entity.dxf.name)
        if block is None:
            return self.drawing.refuse(layer, f"INSERT of block '{entity.dxf.name}', which the file does not have")
        if block.block.is_xref:
            return self.drawing.refuse(layer, f"INSERT of '{entity.dxf.name}', an external reference; bind it in the drawing program")
        if depth >= DEEPEST:
            raise Refused(f"blocks within blocks, deeper than {DEEPEST}; explode them in the drawing program")
        if tuple(entity.dxf.extrusion)[:2] != (0, 0):
            return self.drawing.refuse(layer, "INSERT turned out of the plane (extrusion)")
        for single in (entity.multi_insert() if entity.mcount > 1 else [entity]):
            self.inserts += 1
            if self.inserts > MOST_INSERTS:
                raise Refused(f"more than {MOST_INSERTS} inserted blocks; keep those of the channels")
            skipped = []
            parts = list(single.virtual_entities(skipped_entity_callback=lambda e, why: skipped.append(e.dxftype())))
            for kind in skipped:
                self.drawing.refuse(layer, f"{kind} in block '{entity.dxf.name}' cannot be inserted so; explode the block")
            self.read(parts, layer, depth + 1)

    def entity(self, entity, layer: str):
        kind = entity.dxftype()
        reader = getattr(self, "read_" + kind.lower(), None)
        if kind in ("POINT",):
            self.drawing.skipped["POINT"] += 1
        elif reader is None:
            advice = "; move text to another layer, or make outlines of it" if kind in ("TEXT", "MTEXT", "ATTDEF", "ATTRIB") else \
                "; explode it into lines in the drawing program"
            self.drawing.refuse(layer, f"{kind} is no outline{advice}")
        else:
            # Lines, ellipses and splines have places in the plane, all others in that of their extrusion.
            x, y, z = entity.dxf.get("extrusion", (0, 0, 1))
            if abs(x) > 1e-9 or abs(y) > 1e-9:
                return self.drawing.refuse(layer, f"{kind} turned out of the plane (extrusion {x:g}, {y:g}, {z:g})")
            self.mirror = -1.0 if z < 0 else 1.0
            reader(entity, layer)

    def add(self, entity, layer: str, points, closed: bool, in_plane: bool = False):
        points = np.asarray([tuple(p)[:2] for p in points], float).reshape(-1, 2) * self.scale
        if not in_plane:
            points[:, 0] *= self.mirror  # of extrusion (0, 0, -1)
        handle = entity.dxf.get("handle", None)
        self.drawing.add(layer, points, closed, entity.dxftype(), f"#{handle}" if handle else "")

    def read_line(self, line, layer):
        self.add(line, layer, [line.dxf.start, line.dxf.end], False, True)

    def read_arc(self, a, layer):
        start = math.radians(a.dxf.start_angle)
        sweep = math.radians((a.dxf.end_angle - a.dxf.start_angle) % 360.0 or 360.0)
        self.add(a, layer, curves.arc(tuple(a.dxf.center), a.dxf.radius, start, sweep, self.off), False)

    def read_circle(self, c, layer):
        self.add(c, layer, curves.arc(tuple(c.dxf.center), abs(c.dxf.radius), 0.0, 2 * math.pi, self.off)[:-1], True)

    def read_ellipse(self, e, layer):
        """centre + cos t · major + sin t · minor, where minor is ratio · (extrusion × major)."""
        x, y, _ = e.dxf.major_axis
        minor = self.mirror * e.dxf.ratio * np.array([-y, x])
        sweep = (e.dxf.end_param - e.dxf.start_param) % (2 * math.pi) or 2 * math.pi
        whole = abs(sweep - 2 * math.pi) < 1e-9
        longest = max(math.hypot(x, y), math.hypot(*minor))
        t = np.array(curves.arc((0, 0), longest, e.dxf.start_param, sweep, self.off))
        cos, sin = t[:, :1] / longest, t[:, 1:] / longest
        points = np.array(tuple(e.dxf.center)[:2]) + cos * np.array([x, y]) + sin * minor
        self.add(e, layer, points[:-1] if whole else points, whole, True)

    def read_spline(self, spline, layer):
        if not len(spline.control_points):
            return self.drawing.refuse(layer, "SPLINE of fit points alone: programs draw different curves through them; save it with "
                                              "control points, or as a polyline")
        points = np.array([tuple(p)[:2] for p in spline.flattening(0.5 * self.off, segments=8)], float)
        closed = bool(spline.closed) or float(np.abs(points[0] - points[-1]).max()) <= 1e-9 * float(np.abs(points).max())
        self.add(spline, layer, points, closed, True)

    def bulged(self, vertices, closed: bool):
        """Points along (x, y, bulge)."""
        if not len(vertices):
            return []
        points = [vertices[0][:2]]
        pairs = list(zip(vertices, [*vertices[1:], vertices[0]]))
        for (x, y, bulge), (end_x, end_y, _) in pairs if closed else pairs[:-1]:
            points.extend(curves.bulged((x, y), (end_x, end_y), bulge, self.off)[1:])
        return points[:-1] if closed else points

    def read_lwpolyline(self, polyline, layer):
        vertices = list(polyline.get_points("xyseb"))
        if any(v[2] or v[3] for v in vertices) or polyline.dxf.get("const_width", 0.0):
            return self.drawing.refuse(layer, "LWPOLYLINE with a width; draw its two sides, or explode it")
        self.add(polyline, layer, self.bulged([(v[0], v[1], v[4]) for v in vertices], polyline.closed), polyline.closed)

    def read_polyline(self, polyline, layer):
        if polyline.get_mode() not in ("AcDb2dPolyline", "AcDb3dPolyline"):
            return self.drawing.refuse(layer, "POLYLINE that is a mesh; draw outlines in the plane")
        # Of a polyline fitted by a spline the corners of its frame (16) are no part of it.
        vertices = [v for v in polyline.vertices if not v.dxf.get("flags", 0) & 16]
        widths = [polyline.dxf.get("default_start_width", 0.0), polyline.dxf.get("default_end_width", 0.0)]
        widths += [v.dxf.get(key, 0.0) for v in vertices for key in ("start_width", "end_width")]
        if any(widths):
            return self.drawing.refuse(layer, "POLYLINE with a width; draw its two sides, or explode it")
        places = [(v.dxf.location.x, v.dxf.location.y, v.dxf.get("bulge", 0.0)) for v in vertices]
        self.add(polyline, layer, self.bulged(places, polyline.is_closed), polyline.is_closed, polyline.get_mode() == "AcDb3dPolyline")

    def read_solid(self, solid, layer):
        corners = [solid.dxf.vtx0, solid.dxf.vtx1, solid.dxf.get("vtx3", solid.dxf.vtx2), solid.dxf.vtx2]  # they run 1 2 4 3
        self.add(solid, layer, corners, True)

    read_trace = read_solid

    def read_hatch(self, hatch, layer):
        for path in hatch.paths:
            if hasattr(path, "vertices"):
                self.add(hatch, layer, self.bulged([tuple(v) for v in path.vertices], True), True)
                continue
            points = []
            for edge in path.edges:
                kind = type(edge).__name__
                if kind == "LineEdge":
                    points += [tuple(edge.start)[:2], tuple(edge.end)[:2]]
                elif kind == "ArcEdge":
                    start, end = math.radians(edge.start_angle), math.radians(edge.end_angle)
                    sweep = (end - start) % (2 * math.pi) or 2 * math.pi
                    piece = curves.arc(tuple(edge.center), edge.radius, start, sweep, self.off)
                    points += [tuple(p) for p in (piece if edge.ccw else piece[::-1])]
                else:
                    return self.drawing.refuse(layer, f"HATCH with an edge of kind {kind}; draw its outline as a polyline")
            self.add(hatch, layer, points, True)


def read(data: bytes, options: Options) -> Drawing:
    import ezdxf

    text = text_of(data)
    scale, unit = unit_of(data, options)
    try:
        doc = ezdxf.read(io.StringIO(text.replace("\r\n", "\n").replace("\r", "\n")))
    except (ezdxf.DXFError, ValueError, KeyError, IndexError, TypeError, AttributeError) as error:
        raise Refused(f"this is no whole DXF: {error}; save it once more in the drawing program") from None
    drawing = Drawing(unit=unit)
    reader = Reader(doc, drawing, scale, options.off)
    reader.read(doc.modelspace())
    for name in doc.layout_names():
        if name != "Model" and (count := len([e for e in doc.layout(name) if e.dxftype() != "VIEWPORT"])):
            drawing.skipped[f"in paper space '{name}'"] += count
    return drawing
