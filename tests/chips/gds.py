"""GDSII layouts become the loops that a mask of them has. Files are written by gdspy and KLayout.

usage: gds.py SOURCE_DIR
"""
import sys

from common import area, box, data, expect, expect_refused, expect_same, folder, fork, loops_of, near, off_circle, run_tests

import gdspy


def layout(draw, unit=1e-6, precision=1e-9):
    library = gdspy.GdsLibrary(unit=unit, precision=precision)
    cell = gdspy.Cell("TOP", exclude_from_current=True)
    library.add(cell)
    draw(cell, library)
    path = folder / "layout.gds"
    library.write_gds(str(path))
    return path


def test_the_fork_is_that_of_the_csv_whatever_the_unit():
    for unit, step, um in ((1e-6, 1e-9, 1.0), (1e-3, 1e-9, 1e3), (1e-6, 5e-9, 1.0)):
        path = layout(lambda c, l: c.add(gdspy.Polygon([(x / um, y / um) for x, y in fork()], layer=3)), unit, step)
        loops, told = loops_of(path)
        expect_same(loops, [fork()], 1e-6)
        expect(told["layer"] == "3/0: 1 polygon", told)
    loops, told = loops_of(path, unit=2.0)
    expect(near(loops[0].max(), 340, 1e-6) and "as given (the file says 1 um)" in told["unit"], told)


def test_what_overlaps_is_one_piece_and_keyholes_are_holes():
    def draw(c, l):
        c.add(gdspy.Rectangle((0, 0), (50, 20)))
        c.add(gdspy.Rectangle((40, 5), (90, 15)))
        c.add(gdspy.Rectangle((90, 5), (100, 15)))  # touches
        c.add(gdspy.Rectangle((10, 5), (20, 10)))  # lies within: no hole, as on a mask
        c.add(gdspy.Polygon([(0, 30), (40, 30), (40, 60), (0, 60), (0, 45), (10, 45), (10, 50), (20, 50), (20, 40), (10, 40), (10, 45), (0, 45)]))
    loops, _ = loops_of(layout(draw))
    wide = [(0, 0), (50, 0), (50, 5), (100, 5), (100, 15), (50, 15), (50, 20), (0, 20)]
    expect_same(loops, [wide, box(0, 30, 40, 30), box(10, 40, 10, 10)], 1e-6)


def test_references_turned_mirrored_scaled_and_arrays():
    def draw(c, l):
        post = gdspy.Cell("POST", exclude_from_current=True)
        post.add(gdspy.Polygon([(0, 0), (4, 0), (0, 2)]))
        l.add(post)
        c.add(gdspy.CellReference(post, (10, 0), rotation=90, magnification=2, x_reflection=True))
        c.add(gdspy.CellArray(post, 3, 2, (8, 5), (100, 50), rotation=90))
    loops, _ = loops_of(layout(draw))
    posts = [[(100 - 5 * j, 50 + 8 * i), (100 - 5 * j, 54 + 8 * i), (98 - 5 * j, 50 + 8 * i)] for i in range(3) for j in range(2)]
    expect_same(loops, [[(10, 0), (10, 8), (14, 0)], *posts], 1e-6)


def test_rows_of_an_array_that_are_shifted_stay_so():
    # KLayout: 4 x 3 posts, 10 um apart along x, rows at (1, 8). gdspy alone takes the shift out.
    loops, told = loops_of(data / "klayout.gds", layer="2/5")
    middles = sorted((round(float(m[0]), 3), round(float(m[1]), 3)) for m in (0.5 * (loop.min(0) + loop.max(0)) for loop in loops))
    expect(middles == sorted((10.0 * i + j, 8.0 * j) for i in range(4) for j in range(3)), middles)
    expect(all(off_circle(loop, m, 2) < 0.02 for loop, m in ((loop, 0.5 * (loop.min(0) + loop.max(0))) for loop in loops)), "circles")


def test_paths_have_their_width():
    loops, told = loops_of(data / "klayout.gds", layer="1")
    outer = [(0, 0), (100, 0), (100, 17.5), (122.5, 17.5), (122.5, 60), (117.5, 60), (117.5, 22.5), (100, 22.5), (100, 40), (0, 40)]
    expect_same(loops, [outer, [(20, 10), (30, 20), (20, 30)], box(60, 10, 10, 10)], 1e-6)
    expect("1 labels (TEXT), 12 on layer 2/5" in told["left out"], told)
    for ends, more in (("flush", 0), ("extended", 3), ((2, 4), 0)):
        path = layout(lambda c, l: c.add(gdspy.FlexPath([(0, 0), (50, 0)], 6, ends=ends, gdsii_path=True)))
        loops, _ = loops_of(path)
        left, right = (2, 4) if isinstance(ends, tuple) else (more, more)
        expect_same(loops, [box(-left, -3, 50 + left + right, 6)], 1e-6)


def test_layers_have_to_be_named_where_there_are_several():
    def draw(c, l):
        c.add(gdspy.Rectangle((0, 0), (50, 20), layer=1))
        c.add(gdspy.Rectangle((0, 0), (70, 20), layer=1, datatype=2))
    path = layout(draw)
    expect_refused('write layer = "1/0", or another of (with how many shapes): 1/0 (1), 1/2 (1)', path)
    expect_same(loops_of(path, layer="1/2")[0], [box(0, 0, 70, 20)], 1e-6)
    expect_refused('layer "7/0" holds nothing that can be seen; layers with shapes (and how many): 1/0 (1), 1/2 (1)', path, layer="7")
    expect_refused("number/datatype", path, layer="METAL")

    def two(c, l):
        c.add(gdspy.Rectangle((0, 0), (50, 20)))
        other = gdspy.Cell("OTHER", exclude_from_current=True)
        other.add(gdspy.Rectangle((0, 0), (10, 10)))
        l.add(other)
    expect_refused("several top cells: OTHER, TOP", layout(two))


def test_damaged_and_endless_files():
    whole = layout(lambda c, l: c.add(gdspy.Rectangle((0, 0), (50, 20)))).read_bytes()
    for name, content in (("cut", whole[:-10]), ("torn", whole[:6] + b"\0\0" + whole[8:])):
        (folder / f"{name}.gds").write_bytes(content)
        expect_refused("damaged or cut short at byte", folder / f"{name}.gds")

    def nest(c, l):  # 100 x 100 x 100 x 100 posts
        inner = gdspy.Cell("A0", exclude_from_current=True)
        inner.add(gdspy.Rectangle((0, 0), (1, 1)))
        l.add(inner)
        for k in range(1, 5):
            outer = gdspy.Cell(f"A{k}", exclude_from_current=True)
            outer.add(gdspy.CellArray(inner, 10, 10, (2, 2)))
            l.add(outer)
            inner = outer
        c.add(gdspy.CellReference(inner))
    expect_refused("more than 300000 shapes", layout(nest))


def test_an_outline_that_crosses_itself():
    expect_refused("crosses itself at (10, 5) um", layout(lambda c, l: c.add(gdspy.Polygon([(0, 0), (20, 10), (20, 0), (0, 10)]))))


run_tests(sys.modules[__name__])
