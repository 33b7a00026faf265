#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Tool paths as a user asks for them: G-code of offsets and arcs, V-carving as G-code, DXF and CSV, units, and what is
# said of wrong options.
# Usage: test_toolpath.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

# expect_output: what the last run printed is the text on standard input.
expect_output() {
  expect_status 0
  diff "$results/out" - > "$results/diff" || fail "$command_line: $(head -c 600 "$results/diff")"
}
svg() { printf '<svg xmlns="http://www.w3.org/2000/svg"%s>%s</svg>\n' "$1" "$2"; }
# rounded: fields of the last run's CSV with six digits.
rounded() {
  awk -F, -v OFS=, 'NR > 1 { for (i = 3; i <= NF; ++i) $i = sprintf("%.6g", $i) } 1' "$results/out" > rows
  mv rows "$results/out"
}
svg '' '<path id="slot" d="M0 0H10A2 2 0 0 1 10 4H0A2 2 0 0 1 0 0Z"/>' > slot.svg
svg '' '<path id="bar" d="M0 0H8V2H0Z"/>' > bar.svg
svg '' '<path id="ring" fill-rule="evenodd" d="M0 0H20V20H0ZM8 8H12V12H8Z"/>' > ring.svg
svg ' width="2in" height="2in" viewBox="0 0 2 2"' '<path id="bar" d="M0 0H1V1H0Z"/>' > inch.svg
svg ' width="20cm" height="20cm" viewBox="0 0 20 20"' '<path id="bar" d="M0 0H1V1H0Z"/>' > cm.svg

# The islands' insets first, from the one next to the island on, then the others from the innermost one on.
run offset ring.svg --distance=-1,-2 --join miter --eps 0.01 --format gcode --feed 600 --depth 1.5 --safe-height 3
grep -E '^\(offset|^G0 X' "$results/out" | paste -sd' ' > order
echo '(offset -1) G0 X7 Y-7 (offset -2) G0 X6 Y-6 (offset -2) G0 X2 Y-2 (offset -1) G0 X1 Y-1' | diff order - ||
  fail "$command_line: another order: $(cat order)"
rm order

run offset slot.svg --distance=-1 --eps 0.01 --format gcode --feed 600 --depth 1.5
expect_line '*slot.svg: no unit is told: coordinates are taken as mm'
expect_output << 'END'
(units: mm)
(passes: 1, cut 26.28, air 1 beside lifts)
G17 G21 G90 G91.1 G94
G0 Z5
(offset -1)
G0 X0 Y-1
G1 Z-1.5 F600
G1 X10 Y-1
G2 X10 Y-3 I0 J-1
G1 X0 Y-3
G2 X0 Y-1 I0 J1
G0 Z5
M2
END

# A header comes first as it is; a file's ending is as good as --format. Inches stay inches, all else becomes mm.
printf '%%\nM3 S12000' > header
run arcs inch.svg --eps 0.001 --feed 20 --depth 0.1 --header header -o inch.nc
expect_status 0
expect_silence
diff inch.nc - << 'END' || fail "$command_line: other G-code"
%
M3 S12000
(units: inches)
(passes: 1, cut 4, air 0 beside lifts)
G17 G20 G90 G91.1 G94
G0 Z0.2
(curve bar)
G0 X0 Y0
G1 Z-0.1 F20
G1 X1 Y0
G1 X1 Y-1
G1 X0 Y-1
G1 X0 Y0
G0 Z0.2
M2
END
run arcs cm.svg --eps 0.001 --feed 20 --depth 0.1 --format gcode
expect_status 0
expect_line '*cm.svg: 1 unit is 10 mm: coordinates are written in mm'
grep -qx 'G1 X10 Y-10' "$results/out" || fail "$command_line: coordinates are not in mm"
grep -qx 'G1 Z-0.1 F20' "$results/out" || fail "$command_line: depth and feed are not in mm"
# Coordinates are in the unit that drawings are converted to: that of the first file, or of --units.
has_lines() { for line in "$@"; do grep -qxF "$line" "$results/out" || fail "$command_line: no line $line"; done; }
run arcs cm.svg inch.svg --eps 0.001 --feed 20 --format gcode
expect_status 0
[[ $err == *'inch.svg: converted from units of 25.4 mm to units of 10 mm, as in cm.svg'* ]] ||
  fail "$command_line: $err"
has_lines '(units: mm)' 'G1 X10 Y-10' 'G1 X25.4 Y-25.4'
run arcs slot.svg inch.svg --eps 0.001 --feed 20 --format gcode
expect_status 0
expect_line '*slot.svg: no unit told: 1 unit is taken for 25.4 mm, as in inch.svg'
has_lines '(units: inches)' 'G1 X1 Y-1'
run arcs inch.svg --units mm --eps 0.001 --feed 20 --format gcode
expect_status 0
expect_line '*inch.svg: converted from units of 25.4 mm to mm'
has_lines '(units: mm)' 'G1 X25.4 Y-25.4'
run offset cm.svg --units in --distance 1 --join miter --eps 0.001 --feed 20 --format gcode
expect_status 0
expect_line '*cm.svg: converted from units of 10 mm to in'
has_lines '(units: inches)' 'G1 X-1 Y1'
run medial-axis bar.svg --units in --eps 0.01 --v-bit 90 --feed 20 --format gcode
expect_status 0
expect_line '*bar.svg: no unit told: 1 unit is taken for 1 in'
has_lines '(units: inches)' 'G1 X7 Y-1'
rm header inch.nc

# A bar 2 wide: a bit of 90 degrees goes 1 deep along the middle, and 0 at the corners.
run medial-axis bar.svg --eps 0.01 --v-bit 90 --format gcode --feed 300
expect_output << 'END'
(units: mm)
(passes: 3, cut 11.66, air 11.07 beside lifts)
G17 G21 G90 G91.1 G94
G0 Z5
(carve)
G0 X0 Y-2
G1 Z0 F300
G1 X1 Y-1 Z-1
G1 X7 Y-1
G1 X8 Y0 Z0
G0 Z5
(carve)
G0 X8 Y-2
G1 Z0 F300
G1 X7 Y-1 Z-1
G0 Z5
(carve)
G0 X0 Y0
G1 Z0 F300
G1 X1 Y-1 Z-1
G0 Z5
M2
END
run medial-axis bar.svg --eps 0.01 --v-bit 90 --format csv
rounded
cp "$results/out" whole
expect_output << 'END'
path,kind,x,y,z,bulge
0,carve,0,2,0,0
0,carve,1,1,-1,0
0,carve,7,1,-1,0
0,carve,8,0,0,0
1,carve,8,2,0,0
1,carve,7,1,-1,0
2,carve,0,0,0,0
2,carve,1,1,-1,0
END
# Half as deep: corners are carved down to that, and the middle is a pocket.
run medial-axis bar.svg --eps 0.01 --v-bit 90 --max-depth 0.5 --format csv
rounded
expect_output << 'END'
path,kind,x,y,z,bulge
0,carve,0,0,0,0
0,carve,0.5,0.5,-0.5,0
1,carve,0,2,0,0
1,carve,0.5,1.5,-0.5,0
2,carve,8,2,0,0
2,carve,7.5,1.5,-0.5,0
3,carve,8,0,0,0
3,carve,7.5,0.5,-0.5,0
4,pocket,7.5,0.5,-0.5,0
4,pocket,7.5,1.5,-0.5,0
4,pocket,0.5,1.5,-0.5,0
4,pocket,0.5,0.5,-0.5,0
4,pocket,7.5,0.5,-0.5,0
END
# A ridge at that depth, or above it by so little that there is no pocket, is carved at that depth.
run medial-axis bar.svg --eps 0.01 --v-bit 90 --max-depth 1 --format csv
rounded
expect_output < whole
rm whole
run medial-axis bar.svg --eps 0.01 --v-bit 90 --max-depth 0.9999 --format csv
rounded
expect_output << 'END'
path,kind,x,y,z,bulge
0,carve,0,2,0,0
0,carve,0.9999,1.0001,-0.9999,0
0,carve,1,1,-0.9999,0
0,carve,7,1,-0.9999,0
0,carve,7.0001,0.9999,-0.9999,0
0,carve,8,0,0,0
1,carve,8,2,0,0
1,carve,7.0001,1.0001,-0.9999,0
2,carve,0,0,0,0
2,carve,0.9999,0.9999,-0.9999,0
END
# A flat tool clears the pocket: half of its diameter within the outline first, then so much further. Its G-code is its
# own; other forms have it beside the bit's.
run medial-axis bar.svg --eps 0.01 --v-bit 90 --max-depth 0.5 --flat-tool 0.4 --format csv
expect_status 0
[ -z "$err" ] || fail "$command_line: said $err"
rounded
[ "$(grep flat "$results/out" | cut -d, -f2- | sort -u | paste -sd' ')" = "flat,0.7,0.7,-0.5,0 flat,0.7,1.3,-0.5,0 \
flat,0.9,0.9,-0.5,0 flat,0.9,1.1,-0.5,0 flat,7.1,0.9,-0.5,0 flat,7.1,1.1,-0.5,0 flat,7.3,0.7,-0.5,0 \
flat,7.3,1.3,-0.5,0" ] || fail "$command_line: $(grep flat "$results/out")"
grep -q carve "$results/out" || fail "$command_line: not beside the bit's"
run medial-axis bar.svg --eps 0.01 --v-bit 90 --max-depth 0.5 --flat-tool 0.4 --feed 300 --format gcode
expect_status 0
[ "$(grep '^(' "$results/out" | tail -n +3 | paste -sd' ')" = '(flat) (flat)' ] ||
  fail "$command_line: has other passes"
run medial-axis bar.svg --eps 0.01 --v-bit 90 --max-depth 0.5 --flat-tool 1 --feed 300 --format gcode
expect_status 1
expect_silence
expect_line '*bar.svg: --flat-tool: expected a diameter that has room in what is flat, found 1'
run medial-axis bar.svg --eps 0.01 --v-bit 90 --max-depth 0.5 --flat-tool 1e-9 --format csv
expect_status 2
run medial-axis bar.svg --eps 0.01 --v-bit 90 --flat-tool 1 --format csv
expect_status 2
expect_line 'bounding_arcs: --flat-tool: expected --max-depth beside it, found none'
# A picture: cuts in colours of their depths, with a scale; ways through the air dashed.
run medial-axis bar.svg --eps 0.01 --v-bit 90 --max-depth 0.5 --flat-tool 0.4 --format svg
expect_status 0
for part in 'class="w"' stroke-dasharray '>0.25</text>' '5 paths of the bit, the deepest at 0.5; 2 of the'; do
  grep -qF "$part" "$results/out" || fail "$command_line: no $part"
done
[ "$(grep -c 'class="r"' "$results/out")" -eq 4 ] || fail "$command_line: not four ways through the air"
# in DXF they are 3D polylines, which read back as such, and outlines at their depth
run medial-axis bar.svg --eps 0.01 --v-bit 90 --max-depth 0.5 -o bar.dxf
expect_status 0
expect_line '*bar.svg: 1 outline of flat bottoms at the depth 0.5, the inset at 0.5: what they enclose is left to *'
[ "$(grep -c '^POLYLINE' bar.dxf)" -eq 4 ] || fail "$command_line: not four 3D polylines"
[ "$(grep -c '^SEQEND' bar.dxf)" -eq 4 ] || fail "$command_line: polylines without an end"
[ "$(grep -c '^LWPOLYLINE' bar.dxf)" -eq 1 ] || fail "$command_line: not one pocket"
tr -d '\r' < bar.dxf | paste -d' ' - - > groups
[ "$(grep -cE '^ *30 -0\.5$' groups)" -eq 4 ] || fail "$command_line: not a vertex at the depth of each branch"
[ "$(grep -cE '^ *38 -0\.5$' groups)" -eq 1 ] || fail "$command_line: the pocket is not at its depth"
rm groups
run medial-axis bar.svg --units cm --eps 0.01 --v-bit 90 --max-depth 0.5 -o cm.dxf
tr -d '\r' < cm.dxf | paste -d' ' - - | grep -A1 INSUNITS | grep -qE '^ *70 5$' || fail "$command_line: not in cm"
rm cm.dxf
# and a pocket that is a circle is one at its depth
svg '' '<circle id="disc" r="5"/>' > disc.svg
run medial-axis disc.svg --eps 0.01 --v-bit 90 --max-depth 1 -o disc.dxf
tr -d '\r' < disc.dxf | paste -d' ' - - | sed -n '/^ *0 CIRCLE/,/^ *40/p' | grep -qE '^ *30 -1$' ||
  fail "$command_line: no circle at its depth"
rm disc.dxf
run info bar.dxf --format json
expect_status 0
[ "$(grep -o '"name": *"carve' "$results/out" | wc -l)" -eq 4 ] || fail "$command_line: the branches are not read back"
rm bar.dxf

# Without a bit the axis is what it is.
run medial-axis bar.svg --eps 0.01 --format csv
[ "$(head -n 1 "$results/out")" = edge,x,y,radius,left,right ] || fail "$command_line: $(head -n 1 "$results/out")"

# Wrong usage, which names what is missing.
run medial-axis bar.svg --eps 0.01 --v-bit 90 --conics --format csv
expect_status 2
expect_line 'bounding_arcs: --conics: expected no path of a tool beside it, found csv'
run arcs slot.svg --eps 0.01 --format gcode --feed 1 --plain
expect_status 2
expect_line 'bounding_arcs: --format: expected svg with --plain, which no other form has, found gcode'
run offset slot.svg --distance=-1 --eps 0.01 --format gcode
expect_status 2
expect_line 'bounding_arcs: --feed: expected a number above 0 with --format gcode, found none'
run medial-axis bar.svg --eps 0.01 --format gcode --feed 1
expect_status 2
expect_line 'bounding_arcs: --v-bit: expected an angle with --format gcode, found none'
run medial-axis bar.svg --eps 0.01 --max-depth 1 --format csv
expect_status 2
expect_line 'bounding_arcs: --max-depth: expected --v-bit beside it, found none'
run medial-axis bar.svg --eps 0.01 --max-depth 1 --v-bit 90
expect_status 2
expect_line 'bounding_arcs: --format: expected dxf, csv, svg or gcode with --max-depth, found json'
run medial-axis bar.svg --eps 0.01 --max-depth 1 --v-bit 90 --frame 1 --format csv
expect_status 2
expect_line 'bounding_arcs: --max-depth: expected no frame beside it, found --frame'
run medial-axis bar.svg --eps 0.5 --max-depth 0.5 --v-bit 90 --format csv
expect_status 2
expect_line 'bounding_arcs: --eps: expected less than *, found 0.5'
run arcs slot.svg --eps 0.01 --format gcode --feed 1 --header none.nc
expect_status 1
expect_line 'bounding_arcs: none.nc: *'
run arcs slot.svg --eps 0.01 --format gcode --feed 1 --digits 0
expect_status 2
svg ' width="1mm" height="1mm" viewBox="0 0 1 1"' '<path id="far" d="M1e9 0h1v1"/>' > far.svg
run arcs far.svg --eps 0.01 --format gcode --feed 1 --digits 9
expect_status 1
expect_line 'bounding_arcs: far.svg: gcode: expected coordinates with at most 15 digits, found more; --digits *'

rm ./*
finish
