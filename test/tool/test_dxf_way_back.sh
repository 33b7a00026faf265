#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# DXF files out as they came in: layers, colours and units, splines as splines, handles that need no repair. Where
# Python's ezdxf is there, its audit finds nothing.
# Usage: test_dxf_way_back.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

# dxf ENTITIES: a file of these in mm, groups with | between, with a layer of a colour by number and one of any colour.
layer() { printf '0|LAYER|2|%s|70|0|62|%s|' "$1" "$2"; }
dxf() {
  printf '0|SECTION|2|HEADER|9|$INSUNITS|70|4|0|ENDSEC|0|SECTION|2|TABLES|0|TABLE|2|LAYER|%s0|ENDTAB|0|ENDSEC|' \
    "$(layer Cut 1; layer Engrave '5|420|1193046')" | tr '|' '\n'
  printf '0|SECTION|2|ENTITIES|%s0|ENDSEC|0|EOF|' "$1" | tr '|' '\n'
}
square() {  # LAYER COLOUR FROM TO
  printf '0|LWPOLYLINE|8|%s|%s90|4|70|1|10|%s|20|0|10|%s|20|0|10|%s|20|8|10|%s|20|8|' "$1" "$2" "$3" "$4" "$4" "$3"
}
curve='0|SPLINE|8|Engrave|70|0|71|3|72|8|73|4|74|0|40|0|40|0|40|0|40|0|40|1|40|1|40|1|40|1|'
curve+='10|40|20|0|10|44|20|8|10|48|20|-8|10|52|20|0|'
dxf "$(square Cut '' 0 9)$(square Cut '62|3|' 10 19)$(square 0 '' 20 29)$(square Cut '62|7|420|66051|' 30 39)
$curve" | sed '/^$/d' > in.dxf
run arcs in.dxf --eps 0.1 --format dxf -o arcs.dxf
if [[ $err == *'without dxflib'* ]]; then finish; fi
expect_status 0

# entities FILE: kind, layer, number and true colour of each, a line each; layers FILE: likewise, of the table
groups='{ code = $1 + 0; getline; sub(/\r/, ""); value = $0 }'
entities() {
  awk "$groups"'
    function flush() { if (kind) print kind, layer, colour, rgb; kind = "" }
    code == 2 && value ~ /^[A-Z]+$/ { section = value } code == 0 { flush() }
    section == "ENTITIES" && code == 0 && value !~ /SEC/ { kind = value; layer = rgb = "-"; colour = 256 }
    code == 8 { layer = value } code == 62 { colour = value } code == 420 { rgb = value }' "$1"
}
layers() {
  awk "$groups"'
    function flush() { if (layer != "") print layer, colour, rgb; layer = "" }
    code == 0 { flush(); is_layer = value == "LAYER"; rgb = "-" }
    is_layer && code == 2 { layer = value } code == 62 { colour = value } code == 420 { rgb = value }' "$1" | sort
}
# expect_lines WANTED COMMAND FILE
expect_lines() {
  [ "$1" = "$("$2" "$3")" ] || fail "$command_line: $2 are $("$2" "$3") instead of $1"
}
expect_lines $'0 7 -\nCut 1 -\nEngrave 5 1193046' layers arcs.dxf
expect_lines $'LWPOLYLINE Cut 256 -\nLWPOLYLINE Cut 3 -\nLWPOLYLINE 0 256 -\nLWPOLYLINE Cut 7 66051
LWPOLYLINE Engrave 256 -' entities arcs.dxf

# audit FILE: each handle once, below the seed; owners are there; ezdxf finds neither errors nor what it would repair.
audit() {
  awk "$groups"'
    code == 2 && value ~ /^[A-Z]+$/ { section = value } code == 9 { name = value }
    code == 5 && section == "HEADER" && name == "$HANDSEED" { seed = value }
    (code == 5 && section != "HEADER") || code == 105 { if (value in have) bad = bad " " value; have[value] = 1
      if (length(value) > length(seed) || (length(value) == length(seed) && value >= seed)) bad = bad " above " value }
    code == 330 || code == 350 { owner[value] = 1 }
    END { for (o in owner) if (o != "0" && !(o in have)) bad = bad " no " o; print bad; exit bad != "" }' "$1" > bad ||
    fail "$command_line: handles$(cat bad)"
  rm bad
  if python3 -c 'import ezdxf' 2> "$results/none"; then
    python3 -c 'import sys, ezdxf
audit = ezdxf.readfile(sys.argv[1]).audit()
found = [entry.message for entry in audit.errors + audit.fixes]
print(found[:4])
sys.exit(len(found) > 0)' "$1" > found || fail "$command_line: ezdxf has $(cat found)"
    rm found
  fi
}
audit arcs.dxf

# Offsets are on layers of their distance, in the colour of their source; results of several kinds have no bad handle.
run offset in.dxf --distance=-0.1,0.25 --eps 0.01 --format dxf -o out.dxf
expect_lines $'0 7 -\noffset_-0.1 1 -\noffset_0.25 1 -' layers out.dxf
[ "$(entities out.dxf | grep -c 'offset_-0.1 3 -')" -eq 1 ] || fail "$command_line: colours $(entities out.dxf)"
audit out.dxf

# Curves themselves: a cubic is a SPLINE of the same control points, an arc of an ellipse one with weights.
printf '<svg xmlns="http://www.w3.org/2000/svg"><g stroke="#ff8000">%s</g></svg>' \
  '<path id="c" d="M0 0C1 2 3 2 4 0C5 -2 7 -2 8 0L4 9Z"/><ellipse id="e" cx="30" cy="5" rx="6" ry="3"/>' > in.svg
run boolean union in.svg --format dxf -o out.dxf
expect_status 0
expect_lines $'SPLINE c 256 -\nLWPOLYLINE c 256 -\nSPLINE e 256 -' entities out.dxf
expect_lines $'0 7 -\nc 30 16744448\ne 30 16744448' layers out.dxf
run boolean union out.dxf --format json -o again.json
expect_status 0
for points in '[[0.0,0.0],[1.0,-2.0],[3.0,-2.0],[4.0,0.0]]' '[[4.0,0.0],[5.0,2.0],[7.0,2.0],[8.0,0.0]]' \
  '[[8.0,0.0],[4.0,-9.0]]'; do
  reversed=$(sed -E 's/^\[(\[.*\])\]$/\1/; s/\],\[/]\n[/g' <<< "$points" | tac | paste -sd,)
  grep -qF "$points" again.json || grep -qF "[$reversed]" again.json || fail "$command_line: no piece $points"
done
[ "$(grep -c '"weights"' again.json)" -eq 4 ] || fail "$command_line: another ellipse in $(cat again.json)"
lengths() { run info "$1" --format csv && cut -d, -f6 "$results/out" | tail -n +2 | xargs printf '%.6f '; }
[ "$(lengths out.dxf)" = "$(lengths in.svg)" ] || fail "$command_line: another length, $(lengths out.dxf)"
audit out.dxf
run boolean union in.svg --format dxf --eps 1e-3 -o out.dxf
expect_status 0
! grep -q SPLINE out.dxf || fail "$command_line: has a spline"
audit out.dxf

# Corners that touch where all tangents agree come back as they were written: by the order of their entities.
svg() { printf '<svg xmlns="http://www.w3.org/2000/svg"><%s/></svg>' "$1"; }
svg 'rect width="4" height="2"' > rect.svg
svg 'ellipse cx="2" cy="1" rx="2" ry="1"' > ellipse.svg
svg 'rect width="4" height="4"' > square.svg
svg 'circle cx="2" cy="2" r="2"' > circle.svg
for words in 'rect ellipse 1.71681' 'square circle 3.43363'; do
  read -r plate hole area <<< "$words"
  for more in '' '--dxf-entities arcs --eps 1e-9'; do
    # shellcheck disable=SC2086
    run boolean difference "$plate.svg" "$hole.svg" $more -o corners.dxf
    expect_status 0
    run info corners.dxf --format csv
    [ "$(cut -d, -f4 "$results/out" | sort | uniq -c | tr -s ' ' | tr '\n' ,)" = ' 1 closed, 4 true,' ] ||
      fail "$command_line of $words $more: not 4 closed curves: $(cat "$results/out")"
    sum=$(cut -d, -f7 "$results/out" | awk '{ sum += $1 < 0 ? -$1 : $1 } END { printf "%.5f", sum }')
    [ "$sum" = "$area" ] || fail "$command_line: area $sum instead of $area"
  done
done

# Names of layers come back: blanks, letters beyond ASCII and beyond 16 bits; what DXF allows in no name is a _.
names=('Layer 1' $'Schn\xc3\xa4tt' $'Schn\xc3\xb6tt' $'\xe5\x88\x87\xe5\x89\xb2' $'a \xf0\x9f\x98\x80'
  $' a/b\xc3\xa4? ')
for i in "${!names[@]}"; do
  printf '<g inkscape:groupmode="layer" inkscape:label="%s"><rect id="%s" x="%s" width="4" height="2"/></g>' \
    "${names[i]}" $'Ma\xc3\x9f'"$i" "${i}0"
done > shapes
printf '<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="%s">%s</svg>' \
  http://www.inkscape.org/namespaces/inkscape "$(cat shapes)" > names.svg
run boolean union names.svg -o names.dxf
expect_status 0
! grep -q '[^ -~]' names.dxf || fail "$command_line: not in ASCII"
expect_lines '0 7 -
Layer 1 7 -
Schn\U+00E4tt 7 -
Schn\U+00F6tt 7 -
\U+5207\U+5272 7 -
_a_b\U+00E4__ 7 -
a \U+D83D\U+DE00 7 -' layers names.dxf
audit names.dxf
names[5]=$'_a_b\xc3\xa4__'
run info names.dxf --format csv
for i in "${!names[@]}"; do
  grep -qF ",Ma"$'\xc3\x9f'"$i,${names[i]},true" "$results/out" ||
    fail "$command_line: ${names[i]} has another name: $(cat "$results/out")"
done
# Files before DXF 2007 have bytes of a code page, which their header tells.
dxf "$(square $'Stra\xdfe \x80' '' 0 9)" | sed '/^$/d' > page.dxf
run info page.dxf --format csv
grep -qF $'Stra\xef\xbf\xbde' "$results/out" || fail "$command_line: a page that is not told: $(cat "$results/out")"
sed -i 's/^\$INSUNITS$/$DWGCODEPAGE\n3\nansi_1252\n9\n$INSUNITS/' page.dxf
run info page.dxf --format csv
grep -qF $'Stra\xc3\x9fe \xe2\x82\xac' "$results/out" || fail "$command_line: $(cat "$results/out")"
run info page.dxf --layers $'stra\xc3\x9fe \xe2\x82\xac'
expect_status 0

# Parts, axes, thin places.
run clip in.svg in.svg --keep on -o out.dxf
expect_status 0
grep -q '^SPLINE' out.dxf || fail "$command_line: no spline"
audit out.dxf
run clip in.svg in.svg --keep on -o out.csv
[ "$(head -1 out.csv)" = path,curve,name,bezier,t,t_end,x_from,y_from,x_to,y_to ] ||
  fail "$command_line: $(head -1 out.csv)"
grep -q '^0,0,c,0,0,1,0,0,4,0$' out.csv || fail "$command_line: $(cat out.csv)"
run medial-axis in.svg --eps 0.01 --conics -o out.dxf
expect_status 0
grep -q '^SPLINE' out.dxf || fail "$command_line: no spline"
audit out.dxf
run medial-axis in.svg --eps 0.01 -o out.csv
[ "$(head -1 out.csv)" = edge,x,y,radius,left,right ] || fail "$command_line: $(head -1 out.csv)"
run medial-axis in.svg --eps 0.01 -o axis.json
edges=$(grep -c polyline axis.json)
brackets=$(grep -o '"polyline":[^"]*' axis.json | tr -cd '[' | wc -c)  # one an edge and one a sample
[ "$brackets" -eq "$(($(wc -l < out.csv) - 1 + edges))" ] || fail "$command_line: another number of samples"
run medial-axis in.svg --eps 0.01 -o out.dxf
! grep -q '^SPLINE' out.dxf || fail "$command_line: has a spline"
run medial-axis in.svg --eps 0.01 --v-bit 60 --max-depth 1 -o out.dxf
expect_status 0
expect_lines $'0 7 -\ncarve 1 -\npocket 5 -' layers out.dxf
grep -q '^VERTEX' out.dxf && grep -q '^LWPOLYLINE' out.dxf || fail "$command_line: $(entities out.dxf)"
audit out.dxf
run thickness in.svg --eps 0.01 --below 2 -o out.dxf
expect_status 1
grep -q '^thin' out.dxf || fail "$command_line: nothing is thin"
audit out.dxf
printf '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H9L8 4L9 9H0L1 4Z"/></svg>' > waist.svg
run thickness waist.svg --eps 0.01 --format dxf
grep -q '^necks' "$results/out" || fail "$command_line: no neck"

# From SVG to DXF and back, y is what it was; a name is a layer where there is none.
run arcs in.svg --eps 0.01 --format dxf -o out.dxf
run boolean union out.dxf --format svg --plain -o out.svg
run info in.svg --format csv
cut -d, -f2,10-13 "$results/out" | tail -n +2 > wanted
run info out.svg --format csv
cut -d, -f2,10-13 "$results/out" | tail -n +2 | paste -d, wanted - | awk -F, '
  { if ($1 != $6) bad = 1; for (i = 2; i < 6; ++i) { d = $i - $(i + 5); if (d > 0.011 || d < -0.011) bad = 1 } }
  END { exit bad || NR != 2 }' || fail "$command_line: $(cat "$results/out") instead of $(cat wanted)"
grep -q 'stroke="#ff8000"' out.svg || fail "$command_line: another colour"

rm -f ./*
finish
