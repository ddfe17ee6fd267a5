#!/usr/bin/env bash
# gdspy 1.4.2 (Debian 12, python3-gdspy 1.4.2-2+b7, Python 3.11): arrays (AREF) of GDSII whose rows are shifted.
#
# Guess: an array of 4 x 3 posts, 10 um apart along x, each row 1 um to the right of and 8 um above the one below, as GDSII and KLayout
#        write it in one AREF, is read as these twelve posts.
# Seen:  the posts stand in straight rows: the shift is gone, without a warning. In an AREF that is mirrored and turned too, as KLayout
#        0.28.5 writes this array, the twelve stand in three places.
# Why it matters: an array that sorts cells by size (deterministic lateral displacement) works by this shift, and would be simulated without.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -qq python3-gdspy=1.4.2-2+b7 python3-numpy=1:1.24.2-1+deb12u1 libblas3 liblapack3 libgfortran5
for package in *.deb; do dpkg-deb -x "$package" root; done
library=$(dirname "$(find root -name libblas.so.3 | head -n 1)"):$(dirname "$(find root -name liblapack.so.3 | head -n 1)")
library=$library:$(dirname "$(find root -name 'libgfortran.so.5' | head -n 1)")

LD_LIBRARY_PATH=$library PYTHONPATH=root/usr/lib/python3/dist-packages /usr/bin/python3 - <<'PYTHON'
import struct

import gdspy
import numpy as np


def record(kind, content=b""):
    return struct.pack(">HH", 4 + len(content), kind) + content


def real(value):  # 8 bytes, base 16
    exponent, mantissa = 64, value
    while mantissa >= 1:
        mantissa, exponent = mantissa / 16, exponent + 1
    while mantissa < 1 / 16:
        mantissa, exponent = mantissa * 16, exponent - 1
    return struct.pack(">BBHI", exponent, *((int(mantissa * 2**56) >> shift) & mask for shift, mask in ((48, 255), (32, 65535), (0, 2**32 - 1))))


def layout(transform, x, y):  # steps of 1 nm
    date = b"\0\x01" * 12
    square = struct.pack(">10i", 0, 0, 2000, 0, 2000, 2000, 0, 2000, 0, 0)
    return b"".join([
        record(0x0002, b"\x02\x58"), record(0x0102, date), record(0x0206, b"LB"), record(0x0305, real(1e-3) + real(1e-9)),
        record(0x0502, date), record(0x0606, b"POST"),
        record(0x0800), record(0x0D02, b"\0\1"), record(0x0E02, b"\0\0"), record(0x1003, square), record(0x1100), record(0x0700),
        record(0x0502, date), record(0x0606, b"TOP\0"),
        record(0x0B00), record(0x1206, b"POST"), transform, record(0x1302, struct.pack(">2h", *((4, 3) if not transform else (3, 4)))),
        record(0x1003, struct.pack(">6i", 0, 0, *x, *y)), record(0x1100), record(0x0700), record(0x0400)])


def places(content):
    with open("array.gds", "wb") as file:
        file.write(content)
    polygons = gdspy.GdsLibrary(infile="array.gds", units="import").cell_dict["TOP"].get_polygons()
    return sorted(tuple(float(v) for v in np.round(p.min(axis=0), 3)) for p in polygons)


drawn = sorted((10.0 * i + 1.0 * j, 8.0 * j) for i in range(4) for j in range(3))
read = places(layout(b"", (40000, 0), (3000, 24000)))
print(f"gdspy {gdspy.__version__}")
print("drawn", drawn)
print("read ", read)
assert gdspy.__version__ == "1.4.2"
assert read == sorted((10.0 * i, 8.0 * j) for i in range(4) for j in range(3)) and read != drawn
turned = places(layout(record(0x1A01, b"\x80\0") + record(0x1C05, real(180.0)), (3000, 24000), (40000, 0)))
print("mirrored and turned by 180 deg, as KLayout writes it:", turned)
wanted = sorted((x - 2.0, y) for x, y in drawn)  # each square lies to the left of its place
assert len(set(turned) & set(wanted)) <= 1
PYTHON
