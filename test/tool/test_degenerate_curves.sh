#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Degenerate curves are normal input: by turns of methods each is built in double and in exact arithmetic, proven, also
# with certified regions, studied for its stability, and approximated by two kinds of chains of arcs.
# Usage: test_degenerate_curves.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

# holds NAME EPS: by one of the methods, by turns, the curve of NAME.json is built in double, and in exact arithmetic
# if that is one of $exact_methods, drawn, and proven as it is written; by the next one its certified regions are
# proven. It has a study of stability of that method with no number that is none, if $is_studied.
exact_methods='bca sfa bilens' is_studied=1 turn=0 drawn=(bca sfa bilens)
kinds_of_chains=("--continuity "{tangent,position}" --side "{two,inner,outer})
holds() {
  local file=$1.json eps=$2 method=${drawn[turn % 3]} kernel formats
  for kernel in double exact; do
    [ $kernel = double ] || [[ $exact_methods == *$method* ]] || continue
    run build --method $method --eps "$eps" --kernel $kernel "$file"
    expect_status 0
    expect_finite
    grep -q '"thickness":' "$results/out" || fail "$command_line: no region"
  done
  run build --method $method --eps "$eps" --format svg "$file"
  expect_status 0
  expect_finite
  run verify --method $method --eps "$eps" --format json "$file"
  expect_status 0
  grep -q '"failed":\[\]' "$results/out" || fail "$command_line: unproven: $(sed -n 2,3p "$results/out")"
  run verify --certified --method "${drawn[(turn + 1) % 3]}" --eps "$eps" --format json "$file"
  expect_status 0
  expect_finite
  grep -q '"failed":\[\]' "$results/out" || fail "$command_line: unproven: $(sed -n 2,3p "$results/out")"
  formats=(csv svg)  # by turns; json tells the same numbers as csv
  if [ -n "$is_studied" ]; then
    run stability --methods "${drawn[turn % 3]}" --format "${formats[turn % 2]}" "$file"
    expect_status 0
    expect_finite
  fi
  local kind
  for kind in 0 3; do  # of the six kinds of chains two, by turns
    kind=$(((turn + kind) % 6))
    run arcs --eps "$eps" ${kinds_of_chains[kind]} --format json "$file"
    expect_status 0
    expect_finite
    grep -q '"error":' "$results/out" || fail "$command_line: no arc"
  done
  turn=$((turn + 1))
  run arcs --eps "$eps" --format svg "$file"
  expect_status 0
  expect_finite
}

# bezier NAME EPS POINTS [WEIGHTS]
bezier() {
  local points weights=
  IFS=' ' read -r -a points <<< "$3"
  [ $# -lt 4 ] || weights=",\"weights\":[$4]"
  local list=
  for p in "${points[@]}"; do list+="${list:+,}[$p]"; done
  printf '{"type":"bezier","degree":%d,"control_points":[%s]%s}\n' $((${#points[@]} - 1)) "$list" "$weights" > "$1.json"
  holds "$1" "$2"
}

# spline NAME EPS DEGREE KNOTS POINTS [MORE KEYS]
spline() {
  local points list=
  IFS=' ' read -r -a points <<< "$5"
  for p in "${points[@]}"; do list+="${list:+,}[$p]"; done
  printf '{"type":"bspline","degree":%d,"knots":%s,"control_points":[%s]%s}\n' "$3" "$4" "$list" "${6:-}" > "$1.json"
  holds "$1" "$2"
}

bezier handle_start        1e-4 '0,0 0,0 1,1 2,0'
bezier handle_end          1e-4 '0,0 1,1 2,0 2,0'
bezier handles_both        1e-4 '0,0 0,0 2,1 2,1'
bezier handle_start_square 1e-4 '0,0 0,0 2,1'
bezier handles_triple      1e-4 '0,0 0,0 0,0 2,1 3,5'
bezier handle_quintic      1e-4 '0,0 0,0 1,1 2,0 3,2 3,2'
bezier inner_coincident    1e-4 '0,0 1,1 1,1 2,0'
bezier inner_coincident_4  1e-4 '0,0 1,1 1,1 1,1 2,0'
bezier three_coincident    1e-4 '0,0 0,0 0,0 1,2'

bezier line_uniform        1e-4 '0,0 1,2'
bezier line_uniform_cubic  1e-4 '0,0 1,2 2,4 3,6'
bezier line_speed          1e-4 '0,0 1,2 1.5,3 4,8'
bezier line_folded         1e-4 '0,0 3,6 -2,-4 1,2'
bezier line_folded_square  1e-4 '0,0 2,1 1,0.5'
bezier line_horizontal     1e-4 '0,1 1,1 2,1 3,1'
bezier line_vertical       1e-4 '1,0 1,1 1,5 1,3'
bezier line_closed         1e-4 '0,0 1,1 2,2 0,0'
bezier line_rational       1e-4 '0,0 1,2 3,6' '1,2,0.5'
bezier line_rounded        1e-2 '0.1,0.1 0.2,0.2 0.30000000000000004,0.3 0.4,0.4'
bezier point_line          1e-4 '1,1 1,1'
bezier point_cubic         1e-4 '0.1,0.7 0.1,0.7 0.1,0.7 0.1,0.7'
bezier point_rational      1e-4 '0.1,0.7 0.1,0.7 0.1,0.7' '1,2,3'

bezier closed              1e-4 '0,0 2,1 -1,2 0,0'
bezier closed_smooth       1e-4 '0,0 1,0 1,2 -1,2 -1,0 0,0'
bezier there_and_back      1e-4 '0,0 1,1 0,0'
bezier there_and_back_4    1e-4 '0,0 1,0 2,3 1,0 0,0'
bezier cusp_half           1e-4 '0,0 1,1 0,1 1,0'
bezier cusp_third          1e-4 '0,0 0,2 2,0 -0.5,1.5'
bezier cusp_rounded        1e-4 '0,0 0.7,0.7 0,0.7 0.7,0'
bezier cusp_at_start       1e-4 '0,0 0,0 0,1 1,3'
bezier loop                1e-4 '0,0 3,2 -2,2 1,0'
bezier almost_cusp         1e-4 '0,0 1,1 0.000001,1 1,0'

bezier arc_exact           1e-4 '0,1 1,1 1,0' '1,1,2'
bezier arc_rounded         1e-4 '1,0 1,1 0,1' '1,0.70710678118654757,1'
bezier arc_elevated        1e-4 '1,0 1,0.66666666666666663 0.66666666666666663,1 0,1' '3,3,3,3'
bezier semicircle          1e-4 '1,0 1,1 0,1 -1,1 -1,0' \
  '1,0.70710678118654757,0.66666666666666663,0.70710678118654757,1'
bezier ellipse             1e-4 '2,0 2,1 0,1' '1,1,2'
bezier hyperbola           1e-4 '0,1 1,1 1,0' '1,3,1'

bezier inflection_start    1e-4 '0,0 1,1 2,2 4,3'
bezier inflection_end      1e-4 '0,0 1,1 2,1 3,1'
bezier inflection_half     1e-4 '0,0 1,1 2,-1 3,0'
bezier vertex_start        1e-4 '0,0 1,0 2,1'
bezier vertex_end          1e-4 '2,1 1,0 0,0'
# Here a coordinate of a joint, of SFA and bilens, is exactly 0 without CORE::Expr knowing it before its separation
# bound, which takes it minutes. BCA is rational.
exact_methods=bca
bezier inflection_both     1e-4 '0,0 1,0 2,0 3,1 4,2 5,3'
bezier inflection_double   1e-4 '0,0 1,0 2,0 3,0 4,1'
bezier vertex_double       1e-4 '0,0 1,0 2,0 3,0 4,0 5,1'
exact_methods='bca sfa bilens'

bezier x_double_root       1e-4 '0,0 1,1 0,2 1,3'
bezier y_double_root       1e-4 '0,1 1,0 2,1 3,0'
bezier x_close_roots       1e-4 '0,0 1,1 0.0000000000001,2 1,3'
bezier axis_symmetric      1e-4 '-1,0 -1,1 1,1 1,0'

bezier near_straight_1e-8  1e-11 '0,0 1,1e-8 2,-1e-8 3,0'
bezier near_straight_1e-14 1e-4 '0,0 1,1e-14 2,-1e-14 3,0'
bezier near_straight_1e-200 1e-2 '0,0 1,1e-200 2,3e-200 3,0'
bezier near_straight_slant 1e-2 '0.1,0.2 1.1,1.2 2.1,2.2 3.1,3.2'
bezier near_circle         1e-6 '1,0 1,0.55228474983079334 0.55228474983079334,1 0,1'
bezier near_circle_weight  1e-9 '1,0 1,1 0,1' '1,0.7071067811865,1'

bezier offset_1e6          1e-6 '1000000,1000000 1000000.001,1000000.002 1000000.003,999999.999 1000000.004,1000000.001'
bezier offset_1e6_line     1e-6 '1000000.001,1000000.001 1000000.002,1000000.002 1000000.003,1000000.003'
bezier tiny_1e-150         1e-154 '0,0 1e-150,2e-150 2e-150,-1e-150 3e-150,1e-150'
bezier huge_1e150          1e146 '0,0 1e150,2e150 2e150,-1e150 3e150,1e150'
bezier tiny_1e-150_weights 1e-154 '0,0 1e-150,2e-150 2e-150,-1e-150' '1,2,0.5'
bezier huge_1e150_weights  1e146 '0,0 1e150,2e150 2e150,-1e150' '1,2,0.5'
# The curve turns within 1e-150 of its start, less than the spacing of parameters that cut it: the piece there is no
# spiral.
bezier sizes_mixed         1e-4 '0,0 1e-150,1e-150 1,2 3,1'
# Here it turns within 1e-20.
bezier sizes_mixed_1e-20   1e-4 '0,0 1e-20,1e-20 1,2 3,1'
bezier eps_above_curve     1e3 '0,0 1,2 2,-1 3,1'

bezier degree_1            1e-4 '0.3,0.7 0.4,0.9'
bezier degree_15           1e-1 '0,0 1,3 2,-1 3,4 4,0 5,-2 6,3 7,1 8,-1 9,2 10,5 11,0 12,-3 13,2 14,1 15,0'
is_studied=  # which takes 15 s in exact arithmetic
bezier degree_15_weights   1e-1 '0,0 1,3 2,-1 3,4 4,0 5,-2 6,3 7,1 8,-1 9,2 10,5 11,0 12,-3 13,2 14,1 15,0' \
  '1,2,1,3,1,1,2,1,0.5,1,1,2,1,1,3,1'
is_studied=1

spline kink_triple_knot    1e-4 3 '[0,0,0,0,1,1,1,2,2,2,2]' '0,0 1,2 2,2 3,0 4,-2 4,3 6,1'
spline kink_reversal       1e-4 3 '[0,0,0,0,1,1,1,2,2,2,2]' '0,0 1,2 2,2 3,0 2,2 1,2 0,1'
spline knots_double        1e-4 3 '[0,0,0,0,1,1,2,2,2,2]' '0,0 1,2 2,2 3,0 4,-2 5,3'
spline knots_close         1e-4 3 '[0,0,0,0,1,1.0000000000000002,2,2,2,2]' '0,0 1,2 2,2 3,0 4,-2 5,3'
spline points_coincident   1e-4 3 '"uniform"' '0,0 1,2 1,2 1,2 1,2 3,1 4,0'
spline points_line         1e-4 3 '"uniform"' '0,0 1,1 3,3 2,2 5,5'
spline polygon             1e-4 1 '"uniform"' '0,0 1,2 1,2 3,1 0,0' ',"periodic":true'
spline periodic_square     1e-4 2 '"uniform"' '0,0 1,0 1,1 0,1' ',"periodic":true'

for name in circle circle_rounded_weights cubic_hook_double_knot; do
  cp "$root/test/data/nurbs/$name.json" .
  holds $name 1e-4
done

# Nothing is written that was not asked for.
mkdir elsewhere
cd elsewhere
echo '{"type":"bezier","degree":3,"control_points":[[0,0],[1,1],[0,0],[1,1]]}' > back_and_forth.json
for kernel in double filtered exact; do
  for method in bca sfa bilens; do
    run build --method $method --eps 0.1 --kernel $kernel back_and_forth.json
    expect_status 0
    run verify --method $method --eps 0.1 --kernel $kernel back_and_forth.json
    expect_status 0
  done
done
[ "$(ls)" = back_and_forth.json ] || fail "left behind: $(ls)"
cd ..

# What is out of the range that is served is refused in a line that tells the range.
echo '{"name":"thin","type":"bezier","degree":2,"control_points":[[0,0],[1,1e-305],[2,0]]}' > refused.json
for command in 'build --method bca --eps 1' 'verify --method sfa --eps 1' 'compare --eps 1' 'arcs --eps 1' stability; do
  run $command refused.json
  expect_status 1
  refused='control points: expected a line, or a box at least 2^-1000 (1e-301) as thin as long, found 2 by 1e-305'
  expect_line "bounding_arcs: refused.json: curve \"thin\": $refused"
done
# A segment has no thickness.
echo '{"name":"flat","type":"bezier","degree":1,"control_points":[[0,5e-324],[2,-5e-324]]}' > flat.json
for command in 'build --method bca --eps 1' 'verify --method sfa --eps 1e-9' 'verify --method bilens --eps 1e-9' \
  'arcs --eps 1' 'query hull' 'offset --distance 1 --eps 1e-9' arrange; do
  run $command flat.json
  expect_status 0
  expect_finite
done

finish
