"""Contours of masks lie where half brightness is, row 0 at the top. Files are written by Pillow and Inkscape.

usage: png.py SOURCE_DIR
"""
import math
import sys

from common import area, box, data, expect, expect_refused, expect_same, folder, fork, loops_of, near, np, run_tests

from PIL import Image


def save(image, **options):
    path = folder / "mask.png"
    (image if isinstance(image, Image.Image) else Image.fromarray(image)).save(path, **options)
    return path


def grey(inside, width, height, fine=8):
    """A mask with grey edges: the share of each pixel that is inside; inside(x, y) with y upwards, in pixels."""
    x = (np.arange(width * fine) + 0.5) / fine
    y = height - (np.arange(height * fine) + 0.5) / fine
    share = inside(x[None], y[:, None]).reshape(height, fine, width, fine).mean((1, 3))
    return np.round(255 * share).astype(np.uint8)


def drawn_fork(per_um):
    """The fork, 4 um from the lower left corner; its ends on the right are at the border of the picture."""
    ring = (np.array(fork()) + (4, 44)) * per_um

    def inside(x, y):
        odd = np.zeros(np.broadcast(x, y).shape, bool)
        for (x1, y1), (x2, y2) in zip(ring, np.roll(ring, -1, 0)):
            if y1 != y2:
                odd ^= ((y1 > y) != (y2 > y)) & (x < x1 + (y - y1) * (x2 - x1) / (y2 - y1))
        return odd
    return grey(inside, 174 * per_um, 88 * per_um)


def distance_to(points, ring):
    a, b = ring, np.roll(ring, -1, 0)
    along = b - a
    t = np.clip(np.einsum("pkj,kj->pk", points[:, None] - a, along) / (along**2).sum(1), 0, 1)
    return np.hypot(*np.moveaxis(points[:, None] - (a + t[..., None] * along), -1, 0)).min(1)


def test_the_fork_is_within_its_pixels():
    for per_um, within, share in ((1, 0.8, 4e-3), (2, 0.4, 2e-3), (4, 0.2, 1e-3)):
        loops, told = loops_of(save(drawn_fork(per_um)), pixel=1 / per_um, fluid="bright")
        ring = np.array(fork()) + (4, 44)
        expect(len(loops) == 1 and distance_to(loops[0], ring).max() < within, per_um, distance_to(loops[0], ring).max())
        expect(abs(area(loops[0]) / 3857.5 - 1) < share, per_um, area(loops[0]))
        right = loops[0][np.isclose(loops[0][:, 0], 174)]  # closed along the border
        expect(near(np.ptp(right[:, 1]), 71.5 + 8.5 - 0.0, within), right)


def test_inclined_channels_have_their_width():
    for across, within in ((20, 1e-2), (40, 5e-3)):
        for angle in (7.0, 18.4, 33.0, 45.0):
            c, d = math.cos(math.radians(angle)), math.sin(math.radians(angle))
            along, up = (lambda x, y: c * (x - 100.3) + d * (y - 100.7)), (lambda x, y: c * (y - 100.7) - d * (x - 100.3))
            image = grey(lambda x, y: (np.abs(along(x, y)) < 60) & (np.abs(up(x, y)) < 0.5 * across), 200, 200)
            loops, _ = loops_of(save(image), pixel=1.0, fluid="bright")
            sides = np.array([up(x, y) for x, y in loops[0] if abs(along(x, y)) < 55])
            expect(abs(area(loops[0]) / (120 * across) - 1) < within, across, angle, area(loops[0]))
            expect(np.abs(np.abs(sides) - 0.5 * across).max(initial=0.0) < 0.3, across, angle, sides)


def test_openings_at_the_border_are_closed_along_it_with_square_corners():
    image = np.zeros((30, 60), np.uint8)
    image[10:20] = 255
    expect_same(loops_of(save(image), pixel=0.5, fluid="bright")[0], [box(0, 5, 30, 5)], 1e-6)
    image[:] = 255 - image
    expect_same(loops_of(save(image), pixel=0.5, fluid="dark")[0], [box(0, 5, 30, 5)], 1e-6)
    image[:10] = 255
    expect_same(loops_of(save(255 - image), pixel=0.5, fluid="bright")[0], [box(0, 5, 30, 5)], 1e-6)


def test_every_kind_of_png_gives_the_same():
    edge = np.zeros((40, 40))
    edge[10:30, 5:35] = 1.0
    edge[5:10, 5:15] = 1.0  # so that up and down differ
    eight = (edge * 255).astype(np.uint8)
    wanted, _ = loops_of(save(eight), pixel=1.0, fluid="bright")
    expect(wanted[0][:, 1].max() == 35.0 and near(area(wanted[0]), 650, 4), "up is up", wanted)
    rgb = Image.fromarray(eight).convert("RGB")
    palette = rgb.quantize(2)
    alpha = Image.fromarray(np.dstack([np.zeros((40, 40, 3), np.uint8), eight[..., None]]))  # black on nothing, as rsvg draws
    white = Image.fromarray(np.dstack([np.full((40, 40, 3), 255, np.uint8), eight[..., None]]))
    for name, image, fluid in (("rgb", rgb, "bright"), ("palette", palette, "bright"), ("1 bit", Image.fromarray(eight > 0), "bright"),
                               ("16 bit", Image.fromarray((edge * 65535).astype(np.uint16)), "bright"),
                               ("grey and alpha", Image.fromarray(eight).convert("LA"), "bright"),
                               ("black on nothing", alpha, "dark"), ("white on nothing", white, "dark")):
        loops, told = loops_of(save(image), pixel=1.0, fluid=fluid)
        expect_same(loops, wanted, 1e-6)
    half = (np.where(edge > 0, 33000, 32000)).astype(np.uint16)  # compared as 16 bits
    expect(near(area(loops_of(save(Image.fromarray(half)), pixel=1.0, fluid="bright")[0][0]), 610, 30), "16 bits")


def test_masks_of_few_pixels_in_two_shades_are_warned_of():
    disc = np.hypot(*(np.mgrid[:60, :60] - 29.5)) < 20
    loops, told = loops_of(save((disc * 255).astype(np.uint8)), pixel=1.0, fluid="bright")
    expect("black and white alone" in told["remarks"][0], told)
    expect(abs(area(loops[0]) / disc.sum() - 1) < 0.01, area(loops[0]))
    loops, told = loops_of(save(drawn_fork(2)), pixel=0.5, fluid="bright")
    expect(told["remarks"] == [], told)


def test_what_a_picture_does_not_say_is_asked_for():
    path = save(drawn_fork(1))
    expect_refused("pixel = \"0.5 um\"", path, fluid="bright")
    expect_refused("fluid = \"bright\" or \"dark\"", path, pixel=1.0)
    expect_refused("chips are 1 um to 10 cm long: write the right pixel", path, pixel=1000.0, fluid="bright")
    expect_refused("nothing in the picture is bright: its brightness goes from 0 to 0.00392", save((np.eye(20) > 0).astype(np.uint8)),
                   pixel=1.0, fluid="bright")
    expect_refused("all of the picture is bright", save(np.full((20, 20), 255, np.uint8)), pixel=1.0, fluid="bright")
    content = save(drawn_fork(1)).read_bytes()
    (folder / "cut.png").write_bytes(content[:len(content) // 2])
    expect_refused("no whole PNG", folder / "cut.png", pixel=1.0, fluid="bright")
    Image.new("1", (9000, 9000)).save(folder / "vast.png")
    expect_refused("are more than", folder / "vast.png", pixel=1.0, fluid="bright")


def test_files_of_other_kinds_than_their_names():
    (folder / "picture.dxf").write_bytes(save(drawn_fork(1)).read_bytes())
    expect_refused("this is a PNG file, not a DXF; give it the name it should have", folder / "picture.dxf", unit=1.0)
    (folder / "drawing.png").write_bytes((data / "klayout.gds").read_bytes())
    expect_refused("this is a GDS file, not a PNG", folder / "drawing.png", pixel=1.0, fluid="bright")
    (folder / "word.gds").write_bytes(b"AC1027 and more")
    expect_refused("this is a DWG file, not a GDS; save it as GDS", folder / "word.gds")
    (folder / "drawing.svg").write_bytes((data / "openscad.dxf").read_bytes())
    expect_refused("this is a DXF file, not a SVG", folder / "drawing.svg")


def test_a_file_of_inkscape():
    loops, _ = loops_of(data / "inkscape.png", pixel=5.0, fluid="dark")
    expect(len(loops) == 2 and near(area(loops[0]), 1800 * 200, 20) and abs(area(loops[1]) / (math.pi * 3600) - 1) < 0.01, list(map(area, loops)))


run_tests(sys.modules[__name__])
