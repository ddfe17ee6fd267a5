#!/usr/bin/env bash
# ezdxf 0.18.1 (Debian 12, python3-ezdxf 0.18.1-1, Python 3.11): the name of a unit.
#
# Guess: `ezdxf.units.unit_name(4)` is a word for millimetres, so that a message can name the unit of a drawing.
# Seen:  it raises IndexError for every one of the units 0 to 24 that $INSUNITS may hold.
# Why it matters: a message about a drawing's unit, which users most often get wrong, must bring its own words.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -qq python3-ezdxf=0.18.1-1 python3-pyparsing=3.0.9-1 python3-typing-extensions=4.4.0-1
for package in *.deb; do dpkg-deb -x "$package" root; done

PYTHONPATH=root/usr/lib/python3/dist-packages /usr/bin/python3 - <<'PYTHON'
import sys

import ezdxf
from ezdxf import units

failed = []
for unit in range(25):
    try:
        units.unit_name(unit)
    except IndexError:
        failed.append(unit)
print(f"ezdxf {ezdxf.__version__}, Python {sys.version.split()[0]}: IndexError for {len(failed)} of 25 units")
assert ezdxf.__version__ == "0.18.1" and len(failed) == 25
PYTHON
