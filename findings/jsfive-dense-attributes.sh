#!/usr/bin/env bash
# jsfive 0.4.2 (npm), which reads HDF5 in a browser, on files of h5py 3.7 / HDF5 1.10 (Debian 12).
#
# Guess: what a group's attributes are does not depend on how many there are; or an error says that they cannot be read.
# Seen:  of a group written with libver "latest", eight attributes are all read; nine come out as none, without an error,
#        since HDF5 stores more than eight in another way ("dense"). With libver "earliest" nine are read.
# Why it matters: units and times of simulation results are attributes; a page then shows numbers without them.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -c "import h5py" 2>/dev/null || { echo "needs: apt-get install python3-h5py" >&2; exit 1; }
npm init -y >npm.log
npm install --silent jsfive@0.4.2 >>npm.log

/usr/bin/python3 - <<'PYTHON'
import h5py

for version in ("earliest", "latest"):
    for count in (8, 9):
        with h5py.File(f"{version}-{count}.h5", "w", libver=version) as file:
            group = file.create_group("frame")
            for k in range(count):
                group.attrs[f"a{k}"] = float(k)
print("h5py", h5py.version.version, "HDF5", h5py.version.hdf5_version)
PYTHON
cat >read.mjs <<'JAVASCRIPT'
import fs from 'fs';
import assert from 'assert';
import * as hdf5 from 'jsfive';

const counts = {};
for (const name of ['earliest-8', 'earliest-9', 'latest-8', 'latest-9']) {
  const bytes = fs.readFileSync(name + '.h5');
  const file = new hdf5.File(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), name);
  counts[name] = Object.keys(file.get('frame').attrs).length;
}
console.log('jsfive 0.4.2, attributes read:', counts);
assert.deepStrictEqual(counts, {'earliest-8': 8, 'earliest-9': 9, 'latest-8': 8, 'latest-9': 0});
JAVASCRIPT
node read.mjs
