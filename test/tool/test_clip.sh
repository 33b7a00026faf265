#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The clip subcommand as a user runs it: parts inside, outside and along a region, and what is said of wrong input.
# Usage: test_clip.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

cat > square.json <<'JSON'
{"name":"square","type":"bspline","degree":1,"knots":[0,0,1,2,3,4,4],"closed":true,
 "control_points":[[0,0],[2,0],[2,2],[0,2],[0,0]]}
JSON
# across; along the lower side and beyond; a square that begins within and leaves it; a bend that stays outside
cat > strokes.json <<'JSON'
{"curves":[{"name":"across","type":"bezier","degree":1,"control_points":[[-1,1],[3,1]]},
 {"name":"along","type":"bezier","degree":1,"control_points":[[-1,0],[1,0]]},
 {"name":"beside","type":"bspline","degree":1,"knots":[0,0,1,2,3,4,4],"closed":true,
  "control_points":[[1,0.5],[3,0.5],[3,1.5],[1,1.5],[1,0.5]]},
 {"name":"bend","type":"bezier","degree":2,"control_points":[[5,0],[6,1],[7,0]]}]}
JSON

# expect_paths TEXT: name, first and last point of each path, and whether it is closed.
expect_paths() {
  local found
  found=$(python3 -c '
import json, sys
curves = json.load(open(sys.argv[1]))["curves"]
print("; ".join("%s %g,%g %g,%g%s" % (c["name"], *c["pieces"][0]["control_points"][0],
      *c["pieces"][-1]["control_points"][-1], " closed" if c["closed"] else "") for c in curves))
for c in curves:
    for p, q in zip(c["pieces"], c["pieces"][1:]):
        assert p["control_points"][-1] == q["control_points"][0], "a path with a gap"
' "$results/out") || fail "$command_line: $found"
  [ "$found" = "$1" ] || fail "$command_line: $found, instead of $1"
}

for kernel in filtered exact; do
  run clip strokes.json square.json --kernel $kernel
  expect_status 0
  expect_finite
  expect_paths 'across 0,1 2,1; beside 2,1.5 2,0.5'
done
run clip strokes.json square.json --kernel double  # segments are told by their coordinates
expect_status 0
run clip strokes.json square.json --keep outside
expect_paths 'across -1,1 0,1; across 2,1 3,1; along -1,0 0,0; beside 2,0.5 2,1.5; bend 5,0 7,0'
run clip strokes.json square.json --keep on
expect_paths 'along 0,0 1,0'
grep -q '"source":{"curve":1,"name":"along","bezier":0,"from":\[0.5,0.5\],"to":\[1.0,1.0\]}' "$results/out" ||
  fail "$command_line: no source"
run clip square.json square.json --keep on
expect_paths 'square 0,0 0,0 closed'
# what it writes is a curve file
run clip strokes.json square.json -o inside.json
run clip inside.json square.json --keep outside
expect_paths ''
run clip inside.json square.json
expect_paths 'across 0,1 2,1; beside 2,1.5 2,0.5'

run clip strokes.json square.json --format svg -o clipped.svg
expect_status 0
grep -q '<title>inside: 2 parts</title>' clipped.svg || fail "$command_line: no title"
printf '{"name":"open","type":"bezier","degree":1,"control_points":[[0,0],[1,1]]}\n' > open.json
run clip strokes.json open.json
expect_status 1
expect_silence
expect_line 'bounding_arcs: open.json: curve "open": expected a closed curve, which has an inside, found an '\
'open one'
run clip strokes.json missing.json
expect_status 1
run clip - -
expect_status 2
run clip strokes.json square.json --keep beside
expect_status 2

finish
