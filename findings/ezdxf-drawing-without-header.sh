#!/usr/bin/env bash
# ezdxf 0.18.1 (Debian 12, python3-ezdxf 0.18.1-1): the unit of a drawing that does not say one.
#
# Guess: a DXF drawing without $INSUNITS has no unit; ezdxf answers 0, "unitless", however the unit came to be missing.
# Seen:  with a HEADER section that lacks $INSUNITS `Drawing.units` is 0; without a HEADER section,
#        as the format allows and exporters of bare ENTITIES write, it is 6, metres.
# Why it matters: a chip drawn in um is then taken a million times too large, and no reader of `units` can tell.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -qq python3-ezdxf=0.18.1-1 python3-pyparsing=3.0.9-1 python3-typing-extensions=4.4.0-1
for package in *.deb; do dpkg-deb -x "$package" root; done

PYTHONPATH=root/usr/lib/python3/dist-packages /usr/bin/python3 - <<'PYTHON'
import io

import ezdxf

entities = "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0.0\n20\n0.0\n11\n100.0\n21\n0.0\n0\nENDSEC\n0\nEOF\n"
header = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n"
seen = [ezdxf.read(io.StringIO(text)).units for text in (header + entities, entities)]
print(f"ezdxf {ezdxf.__version__}: units {seen[0]} with a HEADER without $INSUNITS, {seen[1]} without a HEADER")
assert ezdxf.__version__ == "0.18.1" and seen == [0, 6]
PYTHON
