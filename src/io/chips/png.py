"""PNG masks, read by Pillow: contours at half brightness."""
from __future__ import annotations

import io

import numpy as np

from .drawing import Drawing, Options, Refused

MOST_PIXELS = 40_000_000
FEW = 40  # pixels across, below which a mask of black and white alone is off by per cents


def brightness(image) -> tuple[np.ndarray, list[str]]:
    """0 to 1, row 0 at the bottom; over white where it is transparent."""
    told = []
    if image.mode in ("I", "I;16", "I;16B"):
        grey = np.asarray(image, dtype=float) / 65535.0
        return grey[::-1], told
    rgba = np.asarray(image.convert("RGBA"), dtype=float) / 255.0
    colour, alpha = rgba[..., :3] @ (0.299, 0.587, 0.114), rgba[..., 3]
    grey = colour * alpha + 1.0 - alpha
    seen = colour[alpha > 0.0]
    if alpha.min() < 1.0 and (not seen.size or np.ptp(seen) == 0.0):
        grey = 1.0 - alpha  # one colour on nothing: what is drawn counts as dark
        told.append("one colour on a transparent ground: what is drawn is dark, the ground bright")
    return grey[::-1], told


def steps(grey: np.ndarray) -> int:
    return len(np.unique(grey[:: max(1, len(grey) // 500)]))


def contours(share: np.ndarray, pixel: float, finest: float):
    """What is above 1/2, as one shape [µm]; at the border of the image closed along it."""
    import contourpy
    from shapely.geometry import Polygon, box
    from shapely.ops import unary_union

    rows, columns = share.shape
    beyond = np.pad(share, 1, mode="edge")  # contours go straight out, and are cut at the border
    x, y = np.arange(columns + 2) - 0.5, np.arange(rows + 2) - 0.5
    generator = contourpy.contour_generator(x, y, beyond, fill_type=contourpy.FillType.OuterOffset)
    shapes = []
    for points, offsets in zip(*generator.filled(0.5, 2.0)):
        rings = [points[a:b] for a, b in zip(offsets, offsets[1:]) if b - a > 3]
        if rings:
            shape = Polygon(rings[0], rings[1:]).simplify(finest)
            shapes.append(shape if shape.is_valid else shape.buffer(0))
    return unary_union(shapes).intersection(box(0, 0, columns, rows)), pixel


def read(data: bytes, options: Options) -> Drawing:
    from PIL import Image, UnidentifiedImageError

    if options.pixel is None:
        raise Refused("a picture has no unit of length; write pixel = \"0.5 um\", the side of a pixel")
    if options.fluid not in ("bright", "dark"):
        raise Refused("which part of a picture are the channels? write fluid = \"bright\" or \"dark\"")
    Image.MAX_IMAGE_PIXELS = None  # bounded here
    try:
        image = Image.open(io.BytesIO(data), formats=["PNG"])
        if image.width * image.height > MOST_PIXELS:
            raise Refused(f"{image.width} x {image.height} pixels are more than {MOST_PIXELS:_}; cut or shrink the picture")
        image.load()
    except (UnidentifiedImageError, OSError, SyntaxError, ValueError) as error:
        raise Refused(f"this is no whole PNG: {error}") from None
    grey, remarks = brightness(image)
    share = grey if options.fluid == "bright" else 1.0 - grey
    if not share.max() > 0.5:
        raise Refused(f"nothing in the picture is {options.fluid}: its brightness goes from {grey.min():.3g} to {grey.max():.3g} of 1, "
                      "and channels are told at 1/2; stretch its levels")
    if share.min() > 0.5:
        raise Refused(f"all of the picture is {options.fluid}; draw walls around the channels, or write fluid = "
                      f"\"{'dark' if options.fluid == 'bright' else 'bright'}\"")
    two = steps(grey) <= 2
    finest = 0.25 if two else 0.1
    if options.chord is not None:
        finest = min(finest, options.chord / options.pixel)
    shape, pixel = contours(share, options.pixel, finest)
    drawing = Drawing(unit=f"{pixel:.10g} um a pixel, as given", remarks=remarks)
    for part in getattr(shape, "geoms", [shape]):
        if part.geom_type == "Polygon" and not part.is_empty:
            for ring in (part.exterior, *part.interiors):
                drawing.add("the picture", np.array(ring.coords)[:-1] * pixel, True, "contour")
    across = 2.0 * shape.area / shape.length
    if two and across < FEW:
        drawing.remarks.append(f"the mask is black and white alone, with channels of {across:.3g} pixels across on average; save it with "
                               f"grey edges (antialiased), or with {FEW} pixels across: the flow is off by about 2 % at 20")
    return drawing
