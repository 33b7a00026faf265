#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the pictures in doc/images/ again, by the tool; that of a report is a browser's picture of its page, and that of
# stability takes a minute.
# Usage: bash doc/make_pictures.sh [TOOL]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tool=${1:-build/release/src/tool/bounding_arcs}
images=doc/images
wrench=examples/data/a_wrench.json rabbit=examples/data/d_rabbit.json
points=$'0.9 0.9\n-0.9 0.2\n0.2 -0.2\n0 0.6\n-0.5 -0.9'

for method in bca sfa bilens fat-arc fat-biarc box oriented-box hull; do
  "$tool" build --method $method --eps 0.3 --format svg $images/loop.json -o $images/loop_$method.svg
done
"$tool" arcs --eps 0.05 --format svg $images/loop.json -o $images/loop_arcs.svg
"$tool" query closest --points - --format svg $rabbit -o $images/query_closest.svg <<< "$points"
"$tool" query locate --points - --format svg $rabbit -o $images/query_locate.svg <<< "$points"
"$tool" query hausdorff --format svg $wrench $rabbit -o $images/query_hausdorff.svg
"$tool" query intersect --format svg $wrench $rabbit -o $images/query_intersect.svg
"$tool" query hull --format svg $rabbit -o $images/query_hull.svg
"$tool" offset --distance 0.03,-0.03,-0.06 --eps 1e-3 --format svg $rabbit -o $images/offset.svg
"$tool" medial-axis --eps 1e-4 --discs --format svg $rabbit -o $images/medial_axis.svg
"$tool" medial-axis --frame --eps 0.2 --format svg $images/strokes.svg -o $images/voronoi.svg
"$tool" stability --format svg -o $images/stability.svg
# Timed, so that it is never the same twice: on a quiet machine.
"$tool" compare --queries --eps 1e-6 --methods bca,sfa,bilens,fat-arc,fat-biarc,oriented-box,hull,box --repeat 20 \
  --format svg examples/data/*.json -o $images/which_region.svg
