"""SVG drawings become the loops that were drawn, y upwards from the lower edge of the page. Files also of Inkscape and OpenSCAD.

usage: svg.py SOURCE_DIR
"""
import math
import sys

from common import area, box, data, expect, expect_refused, expect_same, folder, fork, loops_of, near, np, off_circle, run_tests


def page(content, head='width="0.2mm" height="0.1mm" viewBox="0 0 200 100"'):
    path = folder / "page.svg"
    path.write_text('<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
                    f'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" {head}>{content}</svg>')
    return path


def path_of(points):
    return '<path d="M' + " ".join(f"{x},{y}" for x, y in points) + 'z"/>'


def test_the_fork_is_that_of_the_csv_in_mm_and_turned():
    down = [(x, 40 - y) for x, y in fork()]
    wanted = [(x, y + 60) for x, y in fork()]
    expect_same(loops_of(page(path_of(down)))[0], [wanted], 1e-6)
    mm = [(x / 1000, y / 1000) for x, y in down]
    expect_same(loops_of(page(path_of(mm), 'width="0.2mm" height="0.1mm" viewBox="0 0 0.2 0.1"'))[0], [wanted], 1e-6)
    inches = [(x / 25400 * 72, y / 25400 * 72) for x, y in down]  # points, as from a PDF
    high = 0.1 / 25.4 * 72
    expect_same(loops_of(page(path_of(inches), f'width="{2 * high}pt" height="{high}pt" viewBox="0 0 {2 * high} {high}"'))[0], [wanted], 1e-6)
    turned = f'<g transform="translate(0,100) rotate(-90)"><g transform="scale(-1,1)">{path_of(down)}</g></g>'
    expect_same(loops_of(page(turned))[0], [[(y, -x) for x, y in down]], 1e-6)


def test_pages_without_a_unit_ask_for_it():
    for head in ('width="200" height="100" viewBox="0 0 200 100"', 'viewBox="0 0 200 100"', 'width="100%" height="100%"', 'width="200px" height="100px"'):
        path = page('<rect x="10" y="20" width="30" height="40"/>', head)
        expect_refused("the file has no unit", path)
        loops, told = loops_of(path, unit=2.0)
        expect(near(np.ptp(loops[0][:, 0]), 60, 1e-6), told)
    loops, told = loops_of(page('<rect x="0" y="0" width="96" height="48"/>', 'width="30mm" height="50mm"'))  # no viewBox: 96 to the inch
    expect_same(loops, [box(0, 50000 - 12700, 25400, 12700)], 1e-5)


def test_the_drawing_lies_on_the_page_as_preserveAspectRatio_says():
    rect = '<rect x="0" y="0" width="100" height="100"/>'
    for aspect, wanted in {"": box(50, 0, 100, 100), "xMinYMid": box(0, 0, 100, 100), "xMaxYMin meet": box(100, 0, 100, 100),
                           "none": box(0, 0, 200, 100), "xMidYMax slice": box(0, 0, 200, 200), "xMidYMin slice": box(0, -100, 200, 200)}.items():
        head = 'width="0.2mm" height="0.1mm" viewBox="0 0 100 100"' + (f' preserveAspectRatio="{aspect}"' if aspect else "")
        expect_same(loops_of(page(rect, head))[0], [wanted], 1e-6)


def test_curves_are_off_by_no_more_than_the_chord():
    for chord in (0.02, 0.3):
        loops, _ = loops_of(page('<circle cx="50" cy="50" r="30"/><path d="M100 50a20 20 0 0 1 40 0 20 20 0 0 1-40 0z"/>'), chord=chord)
        expect(off_circle(loops[0], (50, 50), 30) <= 1.01 * chord and off_circle(loops[1], (120, 50), 20) <= 1.01 * chord, chord)
    loops, _ = loops_of(page('<path d="M0 0C60 0 60 80 0 80z"/>'), chord=0.02)
    p = np.array([(0, 100), (60, 100), (60, 20), (0, 20)], float)
    t = np.linspace(0, 1, 8000)[:, None]
    exact = (1 - t)**3 * p[0] + 3 * t * (1 - t)**2 * p[1] + 3 * t * t * (1 - t) * p[2] + t**3 * p[3]
    middles = 0.5 * (loops[0] + np.roll(loops[0], -1, 0))
    expect(max(np.hypot(*(exact - m).T).min() for m in middles if m[0] > 1) < 0.021, "Bézier")
    loops, _ = loops_of(page('<ellipse cx="50" cy="50" rx="40" ry="10" transform="rotate(30 50 50)"/>'))
    expect(near(area(loops[0]), math.pi * 400, 4.0), area(loops[0]))
    loops, _ = loops_of(page('<rect x="10" y="10" width="60" height="30" rx="5"/>'))
    expect(near(area(loops[0]), 1800 - (4 - math.pi) * 25, 1.0), area(loops[0]))


def test_uses_groups_and_layers():
    content = ('<defs><rect id="post" x="0" y="0" width="4" height="4"/><rect x="0" y="0" width="9" height="9"/></defs>'
               '<symbol id="s"><rect x="0" y="0" width="9" height="9"/></symbol>'
               '<g inkscape:groupmode="layer" id="layer1" inkscape:label="Channels"><rect x="0" y="0" width="100" height="40"/>'
               '<use xlink:href="#post" x="10" y="10"/><use href="#post" transform="translate(30 10) scale(2)"/></g>'
               '<g inkscape:groupmode="layer" id="layer2" inkscape:label="Frame"><rect x="0" y="0" width="200" height="100"/></g>'
               '<g style="display:none"><rect x="50" y="10" width="9" height="9"/></g><rect visibility="hidden" x="60" y="10" width="9" height="9"/>')
    path = page(content)
    wanted = [box(0, 60, 100, 40), box(10, 86, 4, 4), box(30, 82, 8, 8)]
    expect_refused('write layer = "Channels", or another of (with how many shapes): Channels (3), Frame (1)', path)
    for name in ("Channels", "layer1"):
        loops, told = loops_of(path, layer=name)
        expect_same(loops, wanted, 1e-6)
        for part in ("1 on layer the page", "1 on layer Frame", "1 display: none", "1 visibility: hidden"):
            expect(part in told["left out"] or "page" in part or "Frame" in part, part, told)
    expect_refused('layer "gone" holds nothing', path, layer="gone")


def test_what_cannot_be_read_is_refused_by_name():
    rect = '<rect x="0" y="0" width="100" height="40" {}/>'
    for name, content in {
        "rect with a clip-path": rect.format('clip-path="url(#c)"'),
        "rect with a mask": rect.format('style="fill:red;mask:url(#m)"'),
        "rect with a css transform": rect.format('style="transform: rotate(3deg)"'),
        "a style sheet in the file sets transform": "<style>.a{transform:scale(2)}</style>" + rect.format('class="a"'),
        "text is no outline; make paths of it": '<text x="3" y="3">in</text>' + rect,
        "image is no outline": '<image href="a.png"/>',
        "use of a symbol": '<symbol id="s">' + rect + '</symbol><use href="#s"/>',
        "use of something that is not in the file": '<use href="#s"/>',
        "svg within svg": '<svg viewBox="0 0 1 1">' + rect + "</svg>",
        "a use that holds itself": '<g id="a"><use href="#a"/></g>',
        "an outline is open at (0, 100) um": '<path d="M0 0H50V40"/>',
        "transform = \"turn(3)\" cannot be read": rect.format('transform="turn(3)"'),
    }.items():
        expect_refused(name, page(content.replace("{}", "")))
    (folder / "half.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg" width="1mm"')
    expect_refused("no whole SVG", folder / "half.svg")


def test_files_of_other_programs():
    loops, _ = loops_of(data / "inkscape.svg")
    expect(len(loops) == 2 and near(np.ptp(loops[0][:, 0]), 1800, 1e-3) and off_circle(loops[1], (1000, 500), 60) < 0.03, loops)
    loops, _ = loops_of(data / "openscad.svg", unit=1.0)
    expect(len(loops) == 2 and near(area(loops[0]) - area(loops[1]), 2526.12, 0.01), list(map(area, loops)))


run_tests(sys.modules[__name__])
