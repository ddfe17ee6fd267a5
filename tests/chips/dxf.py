"""DXF drawings become the loops that were drawn. Files are written by ezdxf, KLayout, OpenSCAD and Inkscape.

usage: dxf.py SOURCE_DIR
"""
import math
import sys

from common import area, box, data, expect, expect_refused, expect_same, folder, fork, loops_of, near, np, off_circle, run_tests

import ezdxf


def drawing(draw, unit=13, version="R2010", **header):
    doc = ezdxf.new(version)
    doc.header["$INSUNITS"] = unit
    draw(doc.modelspace(), doc)
    path = folder / "drawing.dxf"
    doc.saveas(path)
    return path


def test_the_fork_in_every_unit_is_that_of_the_csv():
    for unit, um in ((1, 25400.0), (4, 1e3), (5, 1e4), (6, 1e6), (13, 1.0)):
        points = [(x / um, y / um) for x, y in fork()]
        loops, told = loops_of(drawing(lambda m, d: m.add_lwpolyline(points, close=True), unit))
        expect_same(loops, [fork()], 1e-6)
        expect(f"$INSUNITS = {unit}" in told["unit"], told)


def test_turned_and_mirrored_and_in_loose_lines():
    c, s = math.cos(0.3), math.sin(0.3)
    turned = [(c * x + s * y, s * x - c * y) for x, y in fork()]

    def lines(m, d):
        for k in range(len(turned)):
            a, b = turned[k], turned[(k + 1) % len(turned)]
            m.add_line(*((a, b) if k % 3 else (b, a)))
    loops, told = loops_of(drawing(lines))
    expect_same(loops, [turned], 1e-6)
    expect("13 loose pieces joined" in told["joined"], told)


def test_small_gaps_are_closed_and_told_large_ones_refused():
    corners = box(0, 0, 100, 40)

    def lines(gap):
        def draw(m, d):
            for k in range(4):
                a, b = corners[k], corners[(k + 1) % 4]
                m.add_line(a, (b[0] - gap, b[1]) if k == 0 else b)
        return draw
    loops, told = loops_of(drawing(lines(0.004)))
    expect_same(loops, [corners], 0.005)
    expect("largest gap closed 0.004 um, of 0.01 um allowed" in told["joined"], told)
    expect_refused("an outline is open at (99.5, 0) um; the nearest other end is at (100, 0) um, a gap of 0.5 um", drawing(lines(0.5)))


def test_units_are_asked_for_where_the_file_has_none():
    for unit in (0, 2):
        path = drawing(lambda m, d: m.add_lwpolyline(box(0, 0, 10, 10), close=True), unit)
        expect_refused(f"says $INSUNITS = {unit}", path)
        expect_same(loops_of(path, unit=2.0)[0], [box(0, 0, 20, 20)], 1e-6)
    bare = folder / "bare.dxf"  # without a header, as some programs write
    bare.write_text("0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\n0\n10\n0.0\n20\n0.0\n40\n+5.0\n0\nENDSEC\n0\nEOF\n")
    expect_refused("has no $INSUNITS", bare)
    expect(near(area(loops_of(bare, unit=1.0)[0][0]), math.pi * 25, 0.5), "circle")


def test_sizes_that_no_chip_has():
    expect_refused("chips are 1 um to 10 cm long", drawing(lambda m, d: m.add_lwpolyline(fork(), close=True), 4))
    expect_refused("chips are 1 um to 10 cm long", drawing(lambda m, d: m.add_lwpolyline(box(0, 0, 0.2, 0.1), close=True), 13))


def test_curves_are_off_by_no_more_than_the_chord():
    for chord in (0.02, 0.5):
        loops, _ = loops_of(drawing(lambda m, d: m.add_circle((50, 20), 30)), chord=chord)
        expect(off_circle(loops[0], (50, 20), 30) <= chord * 1.001, chord)
        # Two half circles by bulges, positive ones to the right of the way.
        loops, _ = loops_of(drawing(lambda m, d: m.add_lwpolyline([(0, 0, 1), (40, 0, 1)], format="xyb", close=True)), chord=chord)
        expect(off_circle(loops[0], (20, 0), 20) <= chord * 1.001, chord)
    loops, _ = loops_of(drawing(lambda m, d: m.add_lwpolyline([(0, 0, 0.5), (40, 0, 0), (40, 30, 0), (0, 30, 0)], format="xyb", close=True)))
    expect(near(loops[0][:, 1].min(), -10.0, 0.02), "dips to the right")  # 20 bulge below the chord

    def half(m, d):  # an arc and the line that closes it
        m.add_arc((0, 0), 25, 0, 180)
        m.add_line((-25, 0), (25, 0))
    loops, _ = loops_of(drawing(half))
    expect(near(area(loops[0]), 0.5 * math.pi * 625, 2.0), "half")


def test_ellipses_and_splines():
    loops, _ = loops_of(drawing(lambda m, d: m.add_ellipse((10, 10), (30, 40), 0.4)))
    along, up = ((loops[0] - (10, 10)) @ np.array([[0.6, -0.8], [0.8, 0.6]])).T
    expect(abs(np.hypot(along / 50, up / 20) - 1).max() < 1e-3, "ellipse")
    expect(near(area(loops[0]), math.pi * 1000, 3.0), area(loops[0]))
    control = [(0, 0, 0), (40, -10, 0), (60, 30, 0), (30, 60, 0), (-10, 40, 0)]
    loops, _ = loops_of(drawing(lambda m, d: m.add_spline().set_closed(control)))
    # Uniform cubic B-spline: on [0, 1] between four of its points.
    p = np.array(control, float)[:, :2]
    t = np.linspace(0, 1, 4000)[:, None]
    exact = np.vstack([((1 - t)**3 * p[k] + (3 * t**3 - 6 * t**2 + 4) * p[(k + 1) % 5] + (-3 * t**3 + 3 * t**2 + 3 * t + 1) * p[(k + 2) % 5]
                        + t**3 * p[(k + 3) % 5]) / 6 for k in range(5)])
    middles = 0.5 * (loops[0] + np.roll(loops[0], -1, 0))
    off = max(np.hypot(*(exact - m).T).min() for m in middles)
    expect(off < 0.03, off)
    expect_refused("SPLINE of fit points alone", drawing(lambda m, d: m.add_spline([(0, 0), (40, -10), (60, 30)])))


def test_blocks_are_inserted_as_they_are_turned_scaled_and_repeated():
    def draw(m, d):
        d.layers.add("CHANNEL")
        post = d.blocks.new("POST", base_point=(1, 1))
        post.add_lwpolyline(box(1, 1, 2, 4), close=True)  # on layer 0: takes that of the insert
        pair = d.blocks.new("PAIR")
        pair.add_blockref("POST", (0, 0))
        pair.add_blockref("POST", (10, 0), dxfattribs={"xscale": -1})
        m.add_blockref("PAIR", (100, 50), dxfattribs={"layer": "CHANNEL", "rotation": 90, "xscale": 2, "yscale": 3})
        m.add_blockref("POST", (0, 0), dxfattribs={"layer": "CHANNEL", "column_count": 2, "row_count": 2, "column_spacing": 20,
                                                  "row_spacing": 30, "rotation": 90})
    loops, told = loops_of(drawing(draw))
    posts = [box(-4 - 30 * row, 20 * column, 4, 2) for row in (0, 1) for column in (0, 1)]  # rows and columns turn too
    expect_same(loops, posts + [box(88, 50, 12, 4), box(88, 66, 12, 4)], 1e-6)
    expect(told["layer"] == "CHANNEL: 6 LWPOLYLINE", told)


def test_layers_that_cannot_be_seen_and_paper_space_are_left_out_and_told():
    def draw(m, d):
        d.layers.add("OFF").off()
        d.layers.add("FROZEN").freeze()
        m.add_lwpolyline(box(0, 0, 50, 20), close=True, dxfattribs={"layer": "WALLS"})
        for layer in ("OFF", "FROZEN"):
            m.add_circle((25, 10), 4, dxfattribs={"layer": layer})
        m.add_circle((25, 10), 4, dxfattribs={"layer": "WALLS"})
        m.add_point((1, 1), dxfattribs={"layer": "WALLS"})
        d.layout("Layout1").add_circle((0, 0), 3)
    path = drawing(draw)
    visible = "WALLS\n100\nAcDbCircle"  # ezdxf 0.18 writes no code 60
    path.write_text(path.read_text().replace(visible, visible.replace("\n", "\n 60\n1\n", 1)))
    loops, told = loops_of(path)
    expect_same(loops, [box(0, 0, 50, 20)], 1e-6)
    for part in ("1 on OFF: layer off", "1 on FROZEN: layer frozen", "1 on WALLS: invisible", "1 in paper space 'Layout1'", "1 POINT"):
        expect(part in told["left out"], part, told)
    expect_refused('layer "OFF" holds nothing that can be seen; layers with shapes (and how many): WALLS (1); left out: 1 on OFF: layer off',
                   folder / "drawing.dxf", layer="OFF")


def test_several_layers_need_a_choice():
    def draw(m, d):
        m.add_polyline2d(box(0, 0, 50, 20), close=True, dxfattribs={"layer": "Kanäle"})
        m.add_polyline2d(box(-10, -10, 90, 60), close=True, dxfattribs={"layer": "FRAME"})
        m.add_text("chip 7", dxfattribs={"layer": "FRAME"})
    for version in ("R12", "R2000", "R2010"):
        path = drawing(draw, version=version)
        unit = {"unit": 1.0} if version == "R12" else {}
        expect_refused('write layer = "FRAME", or another of (with how many shapes): FRAME (1), Kanäle (1)', path, **unit)
        loops, told = loops_of(path, layer="Kanäle", **unit)
        expect_same(loops, [box(0, 0, 50, 20)], 1e-6)
        expect("2 on layer FRAME" in told["left out"], told)
        expect_refused("TEXT is no outline", path, layer="FRAME", **unit)


def test_extrusions_of_minus_z_mirror_others_are_refused():
    down = {"extrusion": (0, 0, -1)}

    def draw(m, d):
        m.add_lwpolyline([(0, 0, 0.5), (40, 0, 0), (40, 30, 0), (0, 30, 0)], format="xyb", close=True, dxfattribs=down)
        m.add_circle((60, 10), 5, dxfattribs=down)
        m.add_arc((100, 0), 10, 0, 90, dxfattribs=down)
        for a, b in (((-110, 0), (-100, 0)), ((-100, 0), (-100, 10))):  # lines are not mirrored
            m.add_line(a, b, dxfattribs=down)
    loops, _ = loops_of(drawing(draw))
    expect(len(loops) == 3, len(loops))
    centres = sorted(round(float(loop[:, 0].min()), 2) for loop in loops)
    expect(centres == [-110.0, -65.0, -40.0], centres)
    dips = next(loop for loop in loops if near(loop[:, 0].min(), -40, 1e-6))
    expect(near(dips[:, 1].min(), -10, 0.02), "the bulge is still below")
    expect_refused("turned out of the plane", drawing(lambda m, d: m.add_circle((0, 0), 5, dxfattribs={"extrusion": (0, 1, 0)})))


def test_old_polylines_solids_and_hatches():
    def spline_fit(m, d):
        flags = [16, 8, 8, 16, 8, 8, 16]
        places = [(500, 500), (0, 0), (30, 0), (500, -500), (30, 20), (0, 20), (-500, 0)]
        polyline = m.add_polyline2d(places, close=True)
        polyline.dxf.flags |= 4
        for vertex, flag in zip(polyline.vertices, flags):
            vertex.dxf.flags = flag
    expect_same(loops_of(drawing(spline_fit, version="R12"), unit=1.0)[0], [box(0, 0, 30, 20)], 1e-6)
    expect_same(loops_of(drawing(lambda m, d: m.add_solid([(0, 0), (30, 0), (0, 20), (30, 20)])))[0], [box(0, 0, 30, 20)], 1e-6)

    def hatched(m, d):  # with its outline drawn too, and a hole
        m.add_lwpolyline(box(0, 0, 60, 20), close=True)
        hatch = m.add_hatch()
        hatch.paths.add_polyline_path(box(0, 0, 60, 20), is_closed=True)
        edge = hatch.paths.add_edge_path()
        edge.add_arc((30, 10), 5, 0, 360)
    loops, told = loops_of(drawing(hatched))
    expect(near(sum(map(area, loops)), 1200 + math.pi * 25, 0.5) and len(loops) == 2, list(map(area, loops)))
    expect("drawn twice" in told["joined"], told)


def test_what_has_no_one_outline_is_refused_by_name():
    for name, draw in {
        "LWPOLYLINE with a width": lambda m, d: m.add_lwpolyline([(0, 0), (50, 0)], dxfattribs={"const_width": 5}),
        "POLYLINE with a width": lambda m, d: m.add_polyline2d([(0, 0, 3, 3), (50, 0, 3, 3)], format="xyse"),
        "POLYLINE that is a mesh": lambda m, d: m.add_polymesh((3, 3)),
        "MTEXT is no outline": lambda m, d: m.add_mtext("inlet"),
        "RAY is no outline": lambda m, d: m.add_ray((0, 0), (1, 0)),
        "cross at (20, 5) um and (20, 15) um": lambda m, d: [m.add_lwpolyline(box(*b), close=True) for b in ((0, 5, 60, 10), (20, 0, 80, 30))],
        "crosses itself at (10, 5) um": lambda m, d: m.add_lwpolyline([(0, 0), (20, 10), (20, 0), (0, 10)], close=True),
        "4 ends of lines meet at (0, 0) um": lambda m, d: [m.add_line((0, 0), b) for b in ((9, 0), (0, 9), (-9, 0), (0, -9))],
        "no outline is in the file": lambda m, d: None,
    }.items():
        expect_refused(name, drawing(draw))
    path = drawing(lambda m, d: m.add_circle((0, 0), 5))
    ezdxf.readfile(path).saveas(folder / "binary.dxf", fmt="bin")
    expect_refused("binary DXF", folder / "binary.dxf")


def test_damaged_files():
    path = drawing(lambda m, d: m.add_circle((0, 0), 5))
    text = path.read_text()
    (folder / "half.dxf").write_text(text[:text.index("AcDbCircle") + 14])
    expect_refused("no whole DXF", folder / "half.dxf")
    (folder / "word.dxf").write_text(text.replace("AcDbCircle\n", "AcDbCircle\nnumber\n"))
    expect_refused("no whole DXF", folder / "word.dxf")
    (folder / "empty.dxf").write_text("")
    expect_refused("the file is empty", folder / "empty.dxf")


def test_files_of_other_programs():
    loops, _ = loops_of(data / "openscad.dxf", unit=1.0)
    expect(len(loops) == 2 and near(area(loops[0]) - area(loops[1]), 2526.12, 0.01), list(map(area, loops)))
    loops, told = loops_of(data / "inkscape.dxf", unit=1e3)
    expect(len(loops) == 2 and near(area(loops[0]), 1800 * 200, 1), list(map(area, loops)))
    loops, _ = loops_of(data / "klayout.dxf", unit=1.0, layer="L2D5")
    expect(len(loops) == 12, len(loops))
    # KLayout writes holes as cuts there and back; they are holes again.
    loops, _ = loops_of(data / "klayout-holes.dxf", unit=1.0)
    expect_same(loops, [box(0, 0, 100, 40), [(20, 10), (30, 20), (20, 30)], box(60, 10, 10, 10)], 1e-6)


def test_the_same_file_gives_the_same_bytes():
    from chips.__main__ import convert
    from chips.drawing import Options
    path = data / "openscad.dxf"
    expect(convert(path, Options(unit=1.0)) == convert(path, Options(unit=1.0)), "bytes")


run_tests(sys.modules[__name__])
