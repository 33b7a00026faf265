#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# From a DXF part to tool paths: the recipe of doc/tool.md. Prints each command and what it says, as the page shows
# them. The drawings, and all files that the commands write, are in DIRECTORY then.
# Usage: part_to_tool_path.sh TOOL DIRECTORY
set -euo pipefail
tool=$(realpath "$1")
mkdir -p "$2"
cp "$(dirname "${BASH_SOURCE[0]}")"/data/mount/*.dxf "$2"
cd "$2"
bounding_arcs() { "$tool" "$@"; }

# Shows each command on standard input and runs it. A line that ends by | or \ goes on in the next one.
follow() {
  local line command='' prompt='$ '
  while IFS= read -r line; do
    echo "$prompt$line"
    command+=$line$'\n' prompt=''
    [[ $line != *['|\\'] ]] || continue
    eval "$command" 2>&1 < /dev/null
    command='' prompt='$ '
  done
}

follow << 'END'
bounding_arcs info mount.dxf
bounding_arcs info mount.dxf -o drawing.svg
bounding_arcs info mount.dxf --layers Cut --join-ends 0.01
bounding_arcs boolean union mount.dxf ear.dxf --layers Cut --join-ends 0.01 |
  bounding_arcs boolean difference - bolt.dxf -o part.dxf
bounding_arcs info part.dxf -o part.svg
bounding_arcs thickness part.dxf --eps 0.1 --below 5 -o thin.svg || echo too thin
bounding_arcs offset part.dxf --distance 2 --eps 0.01 --feed 600 --depth 5 -o contour.nc
bounding_arcs offset part.dxf --distance 2 --eps 0.01 -o contour.svg
head -12 contour.nc
bounding_arcs offset part.dxf --distance -4,-6,-8,-10,-12,-14,-16,-18,-20 --eps 0.01 --feed 600 --depth 1 -o pocket.nc
bounding_arcs offset part.dxf --distance -4,-6,-8,-10,-12,-14,-16,-18,-20 --eps 0.01 -o pocket.svg
sed -En 's/^.offset (.*).$/\1/p' pocket.nc | paste -sd' '
bounding_arcs medial-axis mount.dxf --layers Engrave --eps 0.01 --v-bit 60 --max-depth 3 --feed 300 -o carving.nc
bounding_arcs medial-axis mount.dxf --layers Engrave --eps 0.01 --v-bit 60 --max-depth 3 --flat-tool 1.5 \
  --feed 300 -o flat.nc
bounding_arcs medial-axis mount.dxf --layers Engrave --eps 0.01 --v-bit 60 --max-depth 3 --flat-tool 1.5 -o carving.svg
head -9 carving.nc
END
