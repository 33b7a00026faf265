#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The arrange subcommand as a user runs it: cells of known numbers and areas, pictures, what is said of wrong input.
# Usage: test_arrange.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

# A square of side 2, a stroke across it and on, and one within that meets neither.
cat > square.json <<'JSON'
{"name":"square","type":"bspline","degree":1,"knots":[0,0,1,2,3,4,4],"closed":true,
 "control_points":[[0,0],[2,0],[2,2],[0,2],[0,0]]}
JSON
cat > strokes.json <<'JSON'
{"curves":[{"name":"across","type":"bezier","degree":1,"control_points":[[-1,1],[3,1]]},
 {"name":"within","type":"bezier","degree":2,"control_points":[[0.5,0.2],[1,0.9],[1.5,0.2]]}]}
JSON

# expect_cells V E F: so many vertices, edges and faces.
expect_cells() {
  local found
  found=$(python3 -c '
import json, sys
cells = json.load(open(sys.argv[1]))
vertices, edges, faces = cells["vertices"], cells["edges"], cells["faces"]
for e in edges:
    assert e["source"]["from"][0] < e["source"]["to"][1], "an edge against its curve"
    assert e.get("also") != [], "an empty list of others"
sides = sum(len(b) for f in faces for b in f["boundaries"])
assert sides == 2 * len(edges), "an edge without a face on either side"
for i, f in enumerate(faces):
    assert f["bounded"] == (i > 0) == (f["area"] is not None)
    for boundary in f["boundaries"]:
        at = None
        for part in boundary + boundary[:1]:
            edge = edges[part["edge"]]
            start, end = (edge["from"], edge["to"]) if part["forwards"] else (edge["to"], edge["from"])
            assert at in (None, start), "a boundary with a gap"
            assert edge["left" if part["forwards"] else "right"] == i, "a boundary of another face"
            at = end
for v, vertex in enumerate(vertices):
    assert vertex["degree"] == sum((e["from"] == v) + (e["to"] == v) for e in edges), "a wrong degree"
print(len(vertices), len(edges), len(faces))
areas = sorted((f["area"] for f in faces[1:]), key=sum)
print(" ".join("%.6g" % ((a + b) / 2) for a, b in areas))
assert all(a <= b <= a + 1e-8 for a, b in areas), "bounds too far apart"
' "$results/out") || fail "$command_line: $found"
  [ "$(head -1 <<< "$found")" = "$1 $2 $3" ] || fail "$command_line: $(head -1 <<< "$found") cells instead of $1 $2 $3"
  areas=$(tail -1 <<< "$found")
}

run arrange square.json strokes.json
expect_status 0
expect_finite
# 4 corners, 4 of the first stroke, 2 of the second; the first stroke has 3 parts, the square 6, the second stroke 1
expect_cells 10 10 3
[ "$areas" = '2 2' ] || fail "$command_line: the areas are $areas"
grep -q '"name":"within","bezier":0,"from":\[0.0,0.0\],"to":\[1.0,1.0\]' "$results/out" ||
  fail "$command_line: no source"
# the same, from one file and the other way round, and twice
run arrange strokes.json square.json square.json
expect_cells 10 10 3
[ "$(grep -c '"also":\[{"file":2,"curve":0,"name":"square"' "$results/out")" -eq 6 ] ||
  fail "$command_line: the second square is not along the first"
# where a curve runs against an edge, its parameters fall
echo '{"name":"back","type":"bezier","degree":1,"control_points":[[3,0],[-1,0]]}' > back.json
run arrange square.json back.json
expect_cells 6 6 2
grep -q '"also":\[{"file":1,"curve":0,"name":"back","bezier":0,"from":\[0.75,0.75\],"to":\[0.25,0.25\]}\]' \
  "$results/out" || fail "$command_line: no other source"
# a closed curve is cut where its pieces join, and not where x turns
echo '{"name":"loop","type":"bezier","degree":3,"control_points":[[0,0],[3,0],[0,3],[0,0]]}' > loop.json
run arrange loop.json
expect_cells 1 1 2
[ "$areas" = '1.35' ] || fail "$command_line: the area is $areas"
# a hairpin of some ulp between two crossings: there is a face, and its area is above 0
cat > hairpin.json <<'JSON'
{"curves":[{"name":"pin","type":"bezier","degree":2,"control_points":[[0,1],[1e-15,-1],[2e-15,1]]},
 {"name":"line","type":"bezier","degree":1,"control_points":[[-1,0.5],[1,0.5]]}]}
JSON
run arrange hairpin.json
expect_cells 6 6 2
python3 -c 'import sys; sys.exit(not 0 < float(sys.argv[1]) < 1e-15)' "$areas" || fail "$command_line: area $areas"
run arrange "$root/examples/data/d_rabbit.json" "$root/examples/data/e_cat.json"
expect_status 0
run arrange square.json strokes.json --format svg -o cells.svg
expect_status 0
grep -q '<title>arrangement: 10 vertices, 10 edges, 3 faces</title>' cells.svg || fail "$command_line: no title"
[ "$(grep -c 'class="f"' cells.svg)" -eq 2 ] || fail "$command_line: not two faces"
[ "$(grep -c 'class="v"' cells.svg)" -eq 6 ] || fail "$command_line: not six orange vertices"

echo '{"name":"point","type":"bezier","degree":1,"control_points":[[1,1],[1,1]]}' > point.json
run arrange point.json
expect_status 0
grep -q '"degree":0' "$results/out" || fail "$command_line: a point is no vertex"
run arrange missing.json
expect_status 1
expect_silence
run arrange square.json --eps 0
expect_status 2
run arrange - -
expect_status 2

finish
