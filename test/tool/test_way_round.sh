#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A drawing through all forms: SVG, union, SVG, offset, DXF, arcs, SVG, and through pipes of JSON. Coordinates, units,
# layers, colours and, where a form has them, ids come back.
# Usage: test_way_round.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

size='width="80mm" height="40mm" viewBox="0 0 160 80"'
cat > in.svg << END
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" $size>
<g inkscape:groupmode="layer" inkscape:label="Cut" fill="none" stroke="#ff0000">
<path id="plate" d="M10 10H90V70H10Z"/><path id="slot" d="M30 30A5 5 0 0 0 30 40H60A5 5 0 0 0 60 30Z"/></g>
<g inkscape:groupmode="layer" inkscape:label="Engrave" fill="none" stroke="#0000ff">
<circle id="disc" cx="120" cy="30" r="12"/><path id="leaf" d="M110 60C120 50 130 50 140 60C130 65 120 65 110 60Z"/></g>
</svg>
END
# facts FILE: layer, length and box of each curve, in mm and in any order; in the plane of the first drawing
facts() {
  run info "$1" --units mm --format csv
  tail -n +2 "$results/out" | awk -F, '{ printf "%s %.2f %.2f %.2f %.2f\n", $3, $6, $10, $12, $12 - $10 }' | sort
}
# same WANTED FOUND: no line more or less
same() { [ "$1" = "$2" ] || fail "$command_line: is $2 instead of $1"; }
plain_facts() { facts "$1" | cut -d' ' -f1-4; }

run boolean union in.svg --plain -o union.svg
expect_status 0
grep -qF "$size" union.svg || fail "$command_line: another page"
for id in plate slot disc leaf; do grep -q "id=\"$id\"" union.svg || fail "$command_line: no $id"; done
same "$(plain_facts in.svg)" "$(plain_facts union.svg)"
same "$(grep -oE 'stroke="#[0-9a-f]*"' in.svg | sort -u)" "$(grep -oE 'stroke="#[0-9a-f]*"' union.svg | sort -u)"

run offset union.svg --distance 1 --eps 0.001 --units mm --format dxf -o offset.dxf
if [[ $err == *'without dxflib'* ]]; then finish; fi
expect_status 0
run arcs offset.dxf --eps 0.001 --plain -o arcs.svg
expect_status 0
run offset union.svg --distance 1 --eps 0.001 --units mm --plain -o offset.svg
expect_status 0
same "$(plain_facts offset.svg)" "$(plain_facts offset.dxf)"
same "$(plain_facts offset.svg)" "$(plain_facts arcs.svg)"
same "$(facts offset.svg)" "$(facts arcs.svg)"  # y, too: mirrored twice
grep -qE '<svg [^>]*width="[0-9.]+mm"' arcs.svg || fail "$command_line: no mm"
grep -qF 'inkscape:label="offset_1"' arcs.svg || fail "$command_line: another layer"
names() { run info "$1" --format csv && tail -n +2 "$results/out" | cut -d, -f2 | sort | paste -sd' '; }
same 'disc leaf plate slot' "$(names offset.dxf)"
same 'disc leaf plate slot' "$(names arcs.svg)"
# Here colours are those of the sources; 1 mm around the plate is from 4 to 46.
same '#0000ff #ff0000' "$(grep -oE 'stroke="#[0-9a-f]*"' arcs.svg | grep -oE '#[0-9a-f]+' | sort -u | paste -sd' ')"
plain_facts arcs.svg | grep -q '^offset_1 .* 4.00 46.00$' || fail "$command_line: $(plain_facts arcs.svg)"

# Pipes of JSON tell what the drawing tells, and the page alone is lost.
"$tool" boolean union in.svg | "$tool" boolean union - | "$tool" boolean union - --plain -o pipe.svg ||
  fail 'a pipe of JSON ends with an error'
same "$(facts union.svg)" "$(facts pipe.svg)"
same "$(grep -c '<path' union.svg)" "$(grep -c '<path' pipe.svg)"
same "$(grep -oE '(id|stroke)="[^"]*"' union.svg | sort)" "$(grep -oE '(id|stroke)="[^"]*"' pipe.svg | sort)"
"$tool" clip in.svg in.svg --keep on | "$tool" arcs - --eps 0.001 --units mm -o clip.dxf 2> "$results/err" ||
  fail 'clip ends with an error'
same "$(plain_facts in.svg)" "$(plain_facts clip.dxf)"
same 'disc leaf plate slot' "$(names clip.dxf)"
run boolean union offset.dxf -o again.json
run offset again.json --distance 1 --eps 0.001
grep -q '"unit_in_mm":1,' "$results/out" || fail "$command_line: the unit is lost"

rm -f ./*
finish
