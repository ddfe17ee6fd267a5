#!/usr/bin/env bash
# Where no development package is found, one message names them all and the command that installs them.
# usage: missing_packages.sh SOURCE
set -euo pipefail
source=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

only=(-DCMAKE_DISABLE_FIND_PACKAGE_HDF5=ON)  # which a compiler wrapper finds anywhere
for kind in PACKAGE INCLUDE LIBRARY; do only+=("-DCMAKE_FIND_ROOT_PATH_MODE_$kind=ONLY"); done
if cmake -S "$source" -B "$folder" -DCMAKE_FIND_ROOT_PATH="$folder/nothing" "${only[@]}" >"$folder/log" 2>&1; then
    echo "configured without any package"
    exit 1
fi
line=$(grep "apt-get install" "$folder/log")
for package in libfmt-dev libhdf5-dev nlohmann-json3-dev libcli11-dev libeigen3-dev libtomlplusplus-dev libxxhash-dev zlib1g-dev \
               libgtest-dev librapidcheck-dev; do
    grep -q -w -e "$package" <<<"$line" || { echo "$package is not in: $line"; exit 1; }
done
[ "$(grep -c "CMake Error" "$folder/log")" = 1 ] || { cat "$folder/log"; exit 1; }
