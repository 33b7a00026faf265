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
wrench=examples/data/a_wrench.json rabbit=examples/data/d_rabbit.json cat=examples/data/e_cat.json
points=$'0.9 0.9\n-0.9 0.2\n0.2 -0.2\n0 0.6\n-0.5 -0.9'

for method in bca sfa bilens fat-arc fat-biarc box oriented-box hull; do
  "$tool" build --method $method --eps 0.3 --format svg $images/loop.json -o $images/loop_$method.svg
done
"$tool" build --method bca --eps 100 --format svg $images/loop.json -o $images/loop_spirals.svg
"$tool" arcs --eps 0.05 --format svg $images/loop.json -o $images/loop_arcs.svg
"$tool" query closest --points - --format svg $rabbit -o $images/query_closest.svg <<< "$points"
"$tool" query locate --points - --format svg $rabbit -o $images/query_locate.svg <<< "$points"
"$tool" query hausdorff --format svg $wrench $rabbit -o $images/query_hausdorff.svg
"$tool" query intersect --format svg $wrench $rabbit -o $images/query_intersect.svg
"$tool" query hull --format svg $rabbit -o $images/query_hull.svg
"$tool" boolean union $rabbit $cat --format svg -o $images/boolean.svg
"$tool" arrange $rabbit $cat --format svg -o $images/arrangement.svg
"$tool" offset --distance 0.03,-0.03,-0.06 --eps 1e-3 --format svg $rabbit -o $images/offset.svg
"$tool" medial-axis --eps 1e-4 --discs --format svg $rabbit -o $images/medial_axis.svg
"$tool" medial-axis --frame --cells --eps 0.2 --format svg $images/strokes.svg -o $images/voronoi.svg
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
# The pictures of the recipe in tool.md; a tenth of a pixel is enough there.
mkdir "$scratch/mount"
bash examples/part_to_tool_path.sh "$tool" "$scratch/mount" > /dev/null
for picture in "$scratch"/mount/*.svg; do
  sed -E '/<(title|text)/!s/([0-9]\.[0-9])[0-9]+/\1/g' "$picture" > "$images/mount_$(basename "$picture")"
done
# README's picture: offsets and the axis in one. The axis is moved and scaled so that its curve, of class c, is that of
# the offsets.
"$tool" offset --distance 0.04,-0.04,-0.08 --eps 1e-3 --format svg $wrench -o "$scratch/offset.svg"
"$tool" medial-axis --eps 1e-3 --prune 0.005 --format svg $wrench -o "$scratch/axis.svg"
awk '
  { gsub(/<\/?g>/, "") }
  /^<svg/ && !curves { split($0, quoted, "\""); width = quoted[4]; height = quoted[6] }
  /class="c"/ {
    split($0, number, /[MCL ]+/)
    x[++curves] = number[4]; y[curves] = number[5]; reach[curves] = number[8]
  }
  /class="c"/ && curves == 1 { curve = $0 }
  /class="[oi]"/ { offsets = offsets $0 "\n" }
  /class="[av]"/ { axis = axis $0 "\n" }
  END {
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" width / 2 "\" height=\"" (height - 60) / 2 \
          "\" viewBox=\"0 60 " width " " height - 60 "\">"
    print "<title>a curve, its offsets and its medial axis</title>"
    print "<style>path{fill:none;stroke-width:2.5;stroke-linejoin:round}.c{stroke:#555;stroke-width:5}"
    print ".o{stroke:#0072b2}.i{stroke:#d55e00}.a{stroke:#009e73}.v{fill:#009e73}</style>"
    print "<rect y=\"60\" width=\"100%\" height=\"100%\" fill=\"#fff\"/>"
    scale = (reach[1] - x[1]) / (reach[2] - x[2])
    printf "<g transform=\"translate(%f %f) scale(%f)\">\n", x[1] - scale * x[2], y[1] - scale * y[2], scale
    printf "%s</g>\n%s%s\n</svg>\n", axis, offsets, curve
  }' "$scratch/offset.svg" "$scratch/axis.svg" | sed -E '/transform/!s/([0-9]\.[0-9]{2})[0-9]+/\1/g' \
  > $images/wrench.svg
# The chord frame of (t, t^2) on [0, 1], with the names of symbols.md, and its two arcs.
awk 'BEGIN {
  pi = atan2(0, -1)
  print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"620\" height=\"480\" viewBox=\"0 0 620 480\">"
  print "<title>the chord frame of a piece</title>"
  print "<style>path{fill:none;stroke-width:2}text{font:italic 18px serif}.n{font:16px sans-serif}</style>"
  print "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>"
  outer = sqrt(2) * 300 / (2 * sin(pi / 4))
  inner = sqrt(2) * 300 / (2 * sin(atan2(2, 1) - pi / 4))
  ends = "M60 420A%.1f %.1f 0 0 0 360 120"
  printf "<path style=\"fill:#cfe3f3\" d=\"" ends "A%.1f %.1f 0 0 1 60 420\"/>\n", outer, outer, inner, inner
  printf "<path stroke=\"#0072b2\" d=\"" ends "\"/>\n", outer, outer
  printf "<path stroke=\"#d55e00\" d=\"" ends "\"/>\n", inner, inner
  print "<path stroke=\"#000\" stroke-width=\"3\" d=\"M60 420Q210 420 360 120\"/>"
  print "<path stroke=\"#888\" stroke-dasharray=\"6 4\" d=\"M60 420L430 50\"/>"
  print "<path stroke=\"#009e73\" d=\"M60 420H240M360 120L395 50\"/>"
  print "<path stroke=\"#888\" d=\"M150 420A90 90 0 0 0 123.6 356.4M402.4 77.6A60 60 0 0 0 386.8 66.3\"/>"
  split("38 442 p0|345 110 p1|245 426 T0|398 44 T1|" \
        "136 444 \316\2610|408 92 \316\2611|190 274 D|254 312 C(t)", label, "|")
  for (i = 1; i in label; ++i) {
    split(label[i], part, " ")
    printf "<text x=\"%d\" y=\"%d\">%s</text>\n", part[1], part[2], part[3]
  }
  print "<text class=\"n\" x=\"300\" y=\"350\" fill=\"#0072b2\">outer arc: touches T0</text>"
  print "<text class=\"n\" x=\"60\" y=\"200\" fill=\"#d55e00\">inner arc: touches T1</text>"
  print "</svg>"
}' > $images/frame.svg
# The rooms, ground first: each uses those below it in the picture.
awk 'BEGIN {
  rows = split("exchange verify study|arrangement offset medial_axis|chain overlay boolean|tree query|" \
               "frame spiral region|number polynomial curve arc", row, "|")
  split("CGAL, proofs, studies|results for users|what results are made of|one tree, and searches|" \
        "pieces and their regions|numbers and curves", what, "|")
  print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"750\" height=\"" rows * 52 + 10 "\">"
  print "<title>rooms</title><style>text{font:16px sans-serif}rect{fill:#cfe3f3}.t{fill:#555}</style>"
  print "<rect width=\"100%\" height=\"100%\" style=\"fill:#fff\"/>"
  for (i = 1; i <= rows; ++i) {
    y = i * 52 - 42
    printf "<text class=\"t\" x=\"10\" y=\"%d\">%s</text>\n", y + 26, what[i]
    for (k = split(row[i], room, " "); k > 0; --k)
      printf "<rect x=\"%d\" y=\"%d\" width=\"124\" height=\"40\" rx=\"4\"/><text x=\"%d\" y=\"%d\">%s</text>\n",
             220 + (k - 1) * 130, y, 230 + (k - 1) * 130, y + 26, room[k]
  }
  print "</svg>"
}' > $images/rooms.svg
bash doc/make_stability.sh "$tool"  # tables, too
# Timed, so that it is never the same twice: on a quiet machine.
"$tool" compare --queries --eps 1e-6 --methods bca,sfa,bilens,fat-arc,fat-biarc,oriented-box,hull,box --repeat 20 \
  --format svg examples/data/*.json -o $images/which_region.svg
