"""GDSII, read by gdspy. What overlaps on a layer is one piece, as on a mask."""
from __future__ import annotations

import struct
import tempfile
import warnings

from .drawing import MOST_SHAPES, Drawing, Options, Refused

HEADER, ENDLIB, XY, TEXT = 0x0002, 0x0400, 0x1003, 0x0C00


def check_records(data: bytes) -> dict[int, int]:
    """How many records of each kind; the file must be whole, as a reader takes what is cut short for its end."""
    counts: dict[int, int] = {}
    at, kind = 0, None
    while at + 4 <= len(data) and kind != ENDLIB:
        size, kind = struct.unpack_from(">HH", data, at)
        if size < 4 or size % 2 or at + size > len(data):
            break
        counts[kind] = counts.get(kind, 0) + 1
        at += size
    if kind != ENDLIB:
        raise Refused(f"the file is damaged or cut short at byte {at} of {len(data)}; write it once more")
    if counts.get(XY, 0) > MOST_SHAPES:
        raise Refused(f"the file holds more than {MOST_SHAPES} shapes; keep only the layer of the channels in it")
    return counts


def layer_of(text: str | None) -> str | None:
    if text is None:
        return None
    parts = text.split("/")
    if len(parts) > 2 or not all(part.strip().isdigit() for part in parts):
        raise Refused(f"layer = \"{text}\" is no layer of GDSII; write number/datatype, as in layer = \"1/0\"")
    return f"{int(parts[0])}/{int(parts[1]) if len(parts) == 2 else 0}"


def expect_bounded(library, tops):
    """Counts what references multiply before they are multiplied."""
    sizes: dict[str, float] = {}

    def size(cell, above):
        if cell.name in above:
            raise Refused(f"cell '{cell.name}' holds itself")
        if cell.name not in sizes:
            own = sum(len(p.polygons) if hasattr(p, "polygons") else 1 for p in cell.polygons) + 10 * len(cell.paths)
            for reference in cell.references:
                if isinstance(reference.ref_cell, str):
                    raise Refused(f"cell '{reference.ref_cell}' is used but not in the file")
                own += getattr(reference, "columns", 1) * getattr(reference, "rows", 1) * size(reference.ref_cell, above | {cell.name})
            sizes[cell.name] = own
        return sizes[cell.name]

    if sum(size(cell, frozenset()) for cell in tops) > MOST_SHAPES:
        raise Refused(f"with all cells inserted there are more than {MOST_SHAPES} shapes; keep only those of the channels")


def read(data: bytes, options: Options) -> Drawing:
    import gdspy

    wanted = layer_of(options.layer)
    records = check_records(data)
    library = gdspy.GdsLibrary()
    with warnings.catch_warnings(record=True) as told, tempfile.NamedTemporaryFile(suffix=".gds") as file:
        warnings.simplefilter("always")
        file.write(data)
        file.flush()
        try:
            library.read_gds(file.name, units="import")
        except Refused:
            raise
        except Exception as error:  # gdspy raises whatever its parts do
            raise Refused(f"this is no whole GDSII file: {error}") from None
        tops = library.top_level()
        if not tops:
            raise Refused("the file holds no cell")
        expect_bounded(library, tops)
        polygons = {}
        for cell in tops:
            for (layer, datatype), shapes in cell.get_polygons(by_spec=True).items():
                polygons.setdefault(f"{layer}/{datatype}", {})[cell.name] = shapes
    in_file = library.unit * 1e6
    scale = options.unit or in_file
    unit = f"{scale:.10g} um, as the file says" if options.unit is None else \
        f"{scale:.10g} um, as given (the file says {in_file:.10g} um)"
    drawing = Drawing(unit=unit, union=True)
    drawing.remarks = list(dict.fromkeys(str(w.message) for w in told))
    if records.get(TEXT):
        drawing.skipped["labels (TEXT)"] = records[TEXT]
    chosen = wanted if wanted is not None else next(iter(polygons)) if len(polygons) == 1 else None
    if chosen is not None and len(polygons.get(chosen, {})) > 1:
        raise Refused(f"layer {chosen} is in several top cells: {', '.join(sorted(polygons[chosen]))}; keep one of them in the file")
    for layer in sorted(polygons):
        for shapes in polygons[layer].values():
            for k, points in enumerate(shapes, 1):
                drawing.add(layer, points * scale, True, "polygon", str(k))
    return drawing
