"""GDSII, read by gdspy. What overlaps on a layer is one piece, as on a mask."""
from __future__ import annotations

import struct
import tempfile
import warnings

from .drawing import MOST_SHAPES, Drawing, Options, Refused

ENDLIB, STRNAME, AREF, TEXT, XY, ENDEL = 0x0400, 0x0606, 0x0B00, 0x0C00, 0x1003, 0x1100


def records(data: bytes):
    """Kind and content of each; the file must be whole, as a reader takes what is cut short for its end."""
    at, kind = 0, None
    while at + 4 <= len(data) and kind != ENDLIB:
        size, kind = struct.unpack_from(">HH", data, at)
        if size < 4 or size % 2 or at + size > len(data):
            kind = None
            break
        yield kind, data[at + 4:at + size]
        at += size
    if kind != ENDLIB:
        raise Refused(f"the file is damaged or cut short at byte {at} of {len(data)}; write it once more")


def look_through(data: bytes):
    """How many records of each kind, and of each cell the corners of its arrays, three (x, y) each, in steps of the file."""
    counts: dict[int, int] = {}
    arrays: dict[bytes, list] = {}
    cell, in_array = b"", False
    for kind, content in records(data):
        counts[kind] = counts.get(kind, 0) + 1
        if kind == STRNAME:
            cell = content.rstrip(b"\0")
            arrays[cell] = []
        in_array = kind == AREF or (in_array and kind != ENDEL)
        if in_array and kind == XY and len(content) == 24:
            arrays.setdefault(cell, []).append(struct.unpack(">6i", content))
    if counts.get(XY, 0) > MOST_SHAPES:
        raise Refused(f"the file holds more than {MOST_SHAPES} shapes; keep only the layer of the channels in it")
    return counts, arrays


def set_out_arrays(library, arrays):
    """Puts single references in the place of arrays: gdspy 1.4.2 has their spacings along x and y only, and takes the slant out of
    rows that are shifted against each other."""
    import gdspy

    step = library.precision / library.unit
    for name, cell in library.cell_dict.items():
        corners = iter(arrays.get(name.encode(), []))
        references = []
        for reference in cell.references:
            if not isinstance(reference, gdspy.CellArray):
                references.append(reference)
                continue
            x, y, x_column, y_column, x_row, y_row = next(corners)
            for i in range(reference.columns):
                for j in range(reference.rows):
                    u, v = i / reference.columns, j / reference.rows
                    at = (step * (x + u * (x_column - x) + v * (x_row - x)), step * (y + u * (y_column - y) + v * (y_row - y)))
                    references.append(gdspy.CellReference(reference.ref_cell, at, reference.rotation, reference.magnification,
                                                          reference.x_reflection))
        cell.references = references


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
    counts, arrays = look_through(data)
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
        set_out_arrays(library, arrays)
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
    if counts.get(TEXT):
        drawing.skipped["labels (TEXT)"] = counts[TEXT]
    chosen = wanted if wanted is not None else next(iter(polygons)) if len(polygons) == 1 else None
    if chosen is not None and len(polygons.get(chosen, {})) > 1:
        raise Refused(f"layer {chosen} is in several top cells: {', '.join(sorted(polygons[chosen]))}; keep one of them in the file")
    for layer in sorted(polygons):
        for shapes in polygons[layer].values():
            for k, points in enumerate(shapes, 1):
                drawing.add(layer, points * scale, True, "polygon", str(k))
    return drawing
