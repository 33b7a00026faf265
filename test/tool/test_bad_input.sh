#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Bad input: exit status 1, one line with file, place and reason on standard error, and nothing written anywhere.
# Usage: test_bad_input.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

count=0

# refuses PATH PATTERN: the file at the path, which the directory of the test holds or not.
refuses() {
  local before after
  before=$(ls -A)
  run build --method bca --eps 1e-3 "$1" -o out.json
  after=$(ls -A)
  expect_status 1
  expect_line "bounding_arcs: $1: $2"
  [ "${#err}" -lt 800 ] || fail "$command_line: a line of ${#err} characters"
  expect_silence
  [ "$before" = "$after" ] || fail "$command_line: left files behind: $after"
  count=$((count + 1))
}

# bad NAME PATTERN CONTENT: a file of that content, with printf's escapes.
bad() {
  # shellcheck disable=SC2059
  printf "$3" > "$1"
  refuses "$1" "$2"
  rm -f "$1"
}

# repeated TEXT N
repeated() { local many; printf -v many '%*s' "$2" ''; printf '%s' "${many// /$1}"; }

B='"type":"bezier"' D='"degree":1' P='"control_points":[[0,0],[1,0]]'
S='"type":"bspline","degree":2,"control_points":[[0,0],[1,0],[1,1]]'

# What is no file, no text, or no JSON.
refuses missing.json '*: *o such file*'
refuses missing/curve.json '*: *o such file*'
mkdir directory.json
refuses directory.json '*: *directory*'
rmdir directory.json
ln -s loop.json loop.json
refuses loop.json '*: *'
rm loop.json
bad empty.json 'line 1, column 1: *empty file*' ''
bad space.json 'line 1, column 1: *empty file*' ' \n\t\n'
bad elf.json 'line 1, column 1: *' '\177ELF\002\001\000\000\200\377'
bad nul.json 'line 1, column 1: *' '\000\000\000'
bad png.json 'line 1, column 1: *' '\211PNG\r\n\032\n\000\000\000\rIHDR'
bad utf16.json 'line 1, column 1: *UTF-16*' '\377\376{\000}\000'
bad utf8.json 'line 1, column 1[0-9]: *' '{"name":"a\377"}'
bad truncated.json 'line 2, column *: *' "{$B,\n$D,\"control_po"
bad open.json 'line 1, column *: *' "{$B,$D,$P"
bad comma.json 'line 1, column *: *' "{$B,$D,$P,}"
bad quotes.json 'line 1, column 2: *' "{'type':'bezier'}"
bad comment.json 'line 1, column *: *' "{$B,$D,$P} // a line"
bad two.json 'line 1, column *: *' "{$B,$D,$P}{$B,$D,$P}"
bad html.json 'line 2, column 2, <html>: *' '<!DOCTYPE html>\n<html><body>404</body></html>'
bad deep.json '*at most 64 levels*' "$(repeated '[' 200000)"
bad deep_objects.json '*at most 64 levels*' "$(repeated '{"a":' 100000)"
bad deep_points.json '*at most 64 levels*' "{$B,$D,\"control_points\":$(repeated '[' 200)$(repeated ']' 200)}"

# JSON that is no curve.
bad list.json 'document: *' '[]'
bad number.json 'line 1, column 1: expected JSON, SVG or text DXF, found *' '17'
bad null.json 'document: *' 'null'
bad curves_number.json 'curves: expected a list*' '{"curves":7}'
bad curves_null.json 'curves\[1\]: *' "{\"curves\":[{$B,$D,$P},null]}"
bad no_type.json 'curve: *type*' "{$D,$P}"
bad type.json 'type: *ellipse*' "{\"type\":\"ellipse\",$D,$P}"
bad type_list.json 'type: *' "{\"type\":[\"bezier\"],$D,$P}"
bad no_degree.json 'curve: *degree*' "{$B,$P}"
bad degree_zero.json 'degree: *found 0' "{$B,\"degree\":0,\"control_points\":[[0,0]]}"
bad degree_negative.json 'degree: *found -1' "{$B,\"degree\":-1,$P}"
bad degree_half.json 'degree: *found 1.5' "{$B,\"degree\":1.5,$P}"
bad degree_huge.json 'degree: *' "{$B,\"degree\":4294967297,$P}"
bad degree_text.json 'degree: *"1"' "{$B,\"degree\":\"1\",$P}"
bad degree_other.json 'control_points: expected 3 of *, found 2' "{$B,\"degree\":2,$P}"
bad no_points.json 'curve: *control_points*' "{$B,$D}"
bad points_empty.json 'control_points: *' "{$B,$D,\"control_points\":[]}"
bad points_flat.json 'control_points\[0\]: *point*' "{$B,$D,\"control_points\":[0,0,1,0]}"
bad points_short.json 'control_points\[1\]: *point*' "{$B,$D,\"control_points\":[[0,0],[1]]}"
bad points_3d.json 'control_points\[0\]: *point*' "{$B,$D,\"control_points\":[[0,0,0],[1,0,0]]}"
bad points_object.json 'control_points\[1\]: *point*' "{$B,$D,\"control_points\":[[0,0],{\"x\":1,\"y\":0}]}"
bad points_text.json 'control_points\[1\]\[0\]: *finite number*' "{$B,$D,\"control_points\":[[0,0],[\"1\",0]]}"
bad points_null.json 'control_points\[1\]\[1\]: *finite number*' "{$B,$D,\"control_points\":[[0,0],[1,null]]}"
bad points_true.json 'control_points\[1\]\[1\]: *finite number*' "{$B,$D,\"control_points\":[[0,0],[1,true]]}"
bad nan.json 'line 1, column *: *' "{$B,$D,\"control_points\":[[0,0],[NaN,0]]}"
bad infinity.json 'line 1, column *: *' "{$B,$D,\"control_points\":[[0,0],[-Infinity,0]]}"
bad overflow.json 'control_points\[1\]\[0\]: *finite number*' "{$B,$D,\"control_points\":[[0,0],[1e400,0]]}"
bad overflow_below.json 'control_points\[1\]\[1\]: *finite number*' \
  "{$B,$D,\"control_points\":[[0,0],[0,-1e999999999999]]}"
bad great.json 'control_points\[1\]\[0\]: *2^1000*' "{$B,$D,\"control_points\":[[0,0],[1e308,0]]}"
bad twice.json '*found "degree" twice' "{$B,$D,$D,$P}"
bad name.json 'name: *string*' "{\"name\":7,$B,$D,$P}"
bad closed.json 'closed: *true or false*' "{$B,$D,$P,\"closed\":\"yes\"}"
bad periodic.json 'periodic: expected false of a bezier, found true' "{$B,$D,$P,\"periodic\":true}"
bad second.json 'curves\[1\].degree: *' "{\"curves\":[{$B,$D,$P},{$B,\"degree\":99,$P}]}"
bad list_in_list.json 'curves\[1\]: *object*list of 2' "{\"type\":7,\"curves\":[{$B,$D,$P},[1,2]]}"
bad first_of_two.json 'curves\[0\].degree: *found 0' "{\"curves\":[{\"degree\":0,\"closed\":1,$B,$P},null]}"
bad first_of_three.json 'curves\[0\].closed: *found 1' "{\"curves\":[{\"closed\":1,\"degree\":0,$B,$P},null]}"
bad control.json '*' "{\"name\":\"\\\\u001b[31m\",\"type\":\"\\\\n\\\\u001b[31m\",$D,$P}"

# Weights and knots.
bad weights_count.json '*: *weights*' "{$B,$D,$P,\"weights\":[1]}"
bad weights_more.json '*: *weights*' "{$B,$D,$P,\"weights\":[1,1,1]}"
bad weights_zero.json 'weights\[1\]: *positive*' "{$B,$D,$P,\"weights\":[1,0]}"
bad weights_negative.json 'weights\[0\]: *positive*' "{$B,$D,$P,\"weights\":[-1,1]}"
bad weights_text.json 'weights\[0\]: *number*' "{$B,$D,$P,\"weights\":[\"1\",1]}"
bad weights_number.json 'weights: *list*' "{$B,$D,$P,\"weights\":1}"
bad weights_overflow.json 'weights\[1\]: *finite number*' "{$B,$D,$P,\"weights\":[1,1e400]}"
bad weights_great.json 'weights\[1\]: *2^500*' "{$B,$D,$P,\"weights\":[1,1e300]}"
bad nurbs_no_weights.json 'curve: *weights*' "{\"type\":\"nurbs\",$D,$P,\"knots\":\"uniform\"}"
bad bezier_knots.json 'knots: *' "{$B,$D,$P,\"knots\":[0,0,1,1]}"
bad no_knots.json 'curve: *knots*' "{$S}"
bad knots_text.json 'knots: *clamped*' "{$S,\"knots\":\"clamped\"}"
bad knots_count.json 'curve: knots: expected 6 *, found 5' "{$S,\"knots\":[0,0,0,1,1]}"
bad knots_order.json 'curve: knot 4: expected no less than knot 3, found 0.5' "{$S,\"knots\":[0,0,0,1,0.5,1]}"
bad knots_equal.json 'curve: *' "{$S,\"knots\":[0,0,0,0,0,0]}"
bad knots_null.json 'knots\[3\]: *' "{$S,\"knots\":[0,0,0,null,1,1]}"
bad knots_overflow.json 'knots\[5\]: *' "{$S,\"knots\":[0,0,0,1,1,1e400]}"
bad spline_points.json 'curve: control points: expected at least 6 of *, found 2' \
  "{\"type\":\"bspline\",\"degree\":5,$P,\"knots\":\"uniform\"}"

# SVG.
svg() { bad "$1.svg" "$2" "<svg xmlns=\"http://www.w3.org/2000/svg\">\n$3\n</svg>\n"; }
bad angle.svg 'line 1, column 1: XML*' '<'
bad truncated.svg 'line 2, column *: XML*' '<svg>\n<path d="M0 0L1'
bad mismatch.svg 'line 2, column *: XML*' '<svg>\n<g></svg>'
bad binary.svg 'line 1, column 6: *NUL*' '<svg>\000\001\002'
bad no_svg.svg 'line 1, column 2, <drawing>: *' '<drawing/>'
svg nothing '*no curve in the drawing*' ''
svg no_move 'line 2, column 2, <path>, attribute d, character 1: *' '<path d="L1 1"/>'
svg odd 'line 2, column 2, <path id="p">, attribute d, character *: *number*' '<path id="p" d="M0 0L1 1 2"/>'
svg letter 'line 2, *, attribute d, character *: *' '<path d="M0 0 Y1 1"/>'
svg not_finite 'line 2, *, attribute d, character *: *' '<path d="M0 0L nan 1"/>'
svg too_great 'line 2, *, attribute d, character *: *2^1000*' '<path d="M0 0L1e400 1"/>'
svg flag 'line 2, *, attribute d, character *: *flag*' '<path d="M0 0A1 1 0 7 0 1 1"/>'
svg radius 'line 2, *<circle>, attribute r*: *' '<circle r="-1"/>'
svg unit 'line 2, *<rect>, attribute width*: *unit*' '<rect width="3furlongs" height="1"/>'
svg points 'line 2, *<polygon>, attribute points*: *number*' '<polygon points="0 0 1 1 2"/>'
svg transform 'line 2, *<g>, attribute transform*: *' '<g transform="spin(3)"><circle r="1"/></g>'
svg transformed 'line 2, *<circle>: *2^1000*' '<g transform="scale(1e300) scale(1e300)"><circle r="1"/></g>'
svg use_itself 'line 2, *<use>: *itself*' '<g id="a"><use href="#a"/></g>'
svg use_each_other 'line 2, *<use>: *itself*' '<g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g>'
svg use_nothing 'line 2, *<use>: *nothing*' '<use href="#nothing"/>'
svg use_outside 'line 2, *<use>: expected a reference into this file, found *' '<use href="/etc/passwd#a"/>'
svg deep '*at most 256 levels*' "$(repeated '<g>' 20000)$(repeated '</g>' 20000)"
doubling='<circle id="u0" r="1"/>'
for ((i = 1; i < 40; ++i)); do
  doubling+="<g id=\"u$i\"><use href=\"#u$((i - 1))\"/><use href=\"#u$((i - 1))\"/></g>"
done
svg doubling '*added by use elements*' "$doubling"
use=$(repeated '<use href="#x"/>' 3000)
svg switch '*added by use elements*' "<switch id=\"x\">$(repeated '<a requiredExtensions="y"/>' 3000)</switch>$use"
svg text '*added by use elements*' "<g id=\"x\">$(repeated '<![CDATA[y]]>' 3000)</g>$use"
svg name '*or repeated long ids' "<path id=\"$(repeated i 30000)\" d=\"$(repeated 'M0 0h1' 3000)\"/>"
entities='<!DOCTYPE svg [<!ENTITY a "1">'
for name in b c d e f; do entities+="<!ENTITY $name \"&a;&a;&a;&a;&a;&a;&a;&a;\">"; done
bad entities.svg '*: *' "$entities]><svg><path d=\"M0 0 &f;\"/></svg>"

[ "$count" -ge 45 ] || fail "only $count bad files"

# One bad file among good ones is as bad, wherever it stands, and for every subcommand.
good=$root/examples/data/a_wrench.json
echo '{' > bad.json
for order in "bad.json $good" "$good bad.json" "$good bad.json $good"; do
  for subcommand in 'build --method sfa --eps 1e-2' 'verify --method bca --eps 1e-2' 'compare --eps 1e-2'; do
    # shellcheck disable=SC2086
    run $subcommand $order
    expect_status 1
    expect_line 'bounding_arcs: bad.json: line *: *'
    expect_silence
  done
done
rm bad.json

# Names of files are shown safely: one line, no control characters.
name=$'a\nb\e[31m.json'
echo '{' > "$name"
run build --method bca --eps 1 "$name"
expect_status 1
expect_line 'bounding_arcs: a\\x0Ab\\x1B\[31m.json: line *'
rm "$name"

# An eps that the coordinates do not resolve in double is said, with what was reached. Exact coordinates resolve
# anything: there it is the number of regions that ends the run.
points='[[1e6,1e6],[1000001,1000002],[1000003,999999],[1000004,1000001]]'
echo "{\"name\":\"far\",$B,\"degree\":3,\"control_points\":$points}" > far.json
for method in bca sfa bilens; do
  for eps in 1e-14 1e-100 1e-300 5e-324; do
    run build --method $method --eps $eps far.json -o out.json
    expect_status 1
    below='eps * is below what its coordinates and parameters resolve in the double kernel; * was reached'
    expect_line "bounding_arcs: far.json: curve \"far\": $below"
    expect_silence
  done
  for kernel in filtered exact; do
    run build --method $method --kernel $kernel --eps 1e-30 --max-regions 300 far.json -o out.json
    expect_status 1
    expect_line 'bounding_arcs: far.json: curve "far": eps 1e-30 needs more than 300 nodes for *'
    expect_silence
  done
done
expect_files far.json

finish
