#!/usr/bin/env bash
# h5wasm 0.10.3 (npm, HDF5 2.0.0), which reads HDF5 in a browser or node, on files of h5py 3.7 / HDF5 1.10 (Debian 12).
#
# Guess: a dataset has the same attributes whether its file is opened itself or reached by an external link.
# Seen:  numbers and texts of fixed length do; a text of variable length, as h5py writes a str, is empty through the link.
#        HDF5 prints errors of its global heap; h5wasm raises none and gives "".
# Why it matters: results that are still being written are one file of links to the frames; a page then shows no units.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -c "import h5py" 2>/dev/null || { echo "needs: apt-get install python3-h5py" >&2; exit 1; }
npm init -y >npm.log
npm install --silent h5wasm@0.10.3 >>npm.log

/usr/bin/python3 - <<'PYTHON'
import h5py
import numpy as np

with h5py.File("frame.h5", "w") as file:
    data = file.create_dataset("x", data=np.arange(3.0))
    data.attrs["unit"] = "m"
    data.attrs["unit_fixed"] = np.bytes_("m")
    data.attrs["spacing"] = 0.5
with h5py.File("links.h5", "w") as file:
    file["x"] = h5py.ExternalLink("frame.h5", "/x")
with h5py.File("links.h5") as file:
    assert file["x"].attrs["unit"] == "m"
print("h5py", h5py.version.version, "HDF5", h5py.version.hdf5_version, "reads unit = m through the link")
PYTHON
cat >read.mjs <<'JAVASCRIPT'
import assert from 'assert';
import h5wasm from 'h5wasm/node';

await h5wasm.ready;
const seen = {};
for (const name of ['frame.h5', 'links.h5']) {
  const data = new h5wasm.File(name, 'r').get('x');
  seen[name] = [data.attrs.unit.value, data.attrs.unit_fixed.value, data.attrs.spacing.value];
  assert.deepStrictEqual([...data.value], [0, 1, 2]);
}
console.log('h5wasm 0.10.3, unit, unit_fixed, spacing:', JSON.stringify(seen));
assert.deepStrictEqual(seen, {'frame.h5': ['m', 'm', 0.5], 'links.h5': ['', 'm', 0.5]});
JAVASCRIPT
node read.mjs 2>hdf5.log
