#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# stability: its columns, families, formats and errors.
# Usage: test_stability.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

columns='family,delta,method,formula,kernel,quantity,rel_error,abs_error,condition,number,seed,curve,command'
curve=$root/doc/images/loop.json

# expect_rows N PATTERN: the last run, in CSV, has so many rows like the extended regular expression.
expect_rows() {
  local found
  found=$(grep -cE -e "$2" "$results/out")
  [ "$found" -eq "$1" ] || fail "$command_line: $found rows like $2 instead of $1"
}

run stability --family subdivision
expect_status 0
expect_finite
first=$(grep -v '^# ' "$results/out" | head -1)
[ "$first" = "$columns" ] || fail "$command_line: columns are $first"
for fact in "version: $("$tool" --version)" 'compiler: [A-Z]' 'flags: .*-ffp-contract=off' 'instruction set: [a-z]'; do
  expect_rows 1 "^# $fact"
done
# 41 lengths, 2 formulas, 4 kernels; no joints of BCA; two bisectors of the textbook's, which filtered does not tell
expect_rows $((41 * (2 * 4 * 17 + 3 * 2))) '^subdivision,'
expect_rows $((41 * 3 * 2)) ',textbook,[a-z-]*,bisector,'
expect_rows $((41 * 2 * 3)) ',filtered,joint,|,(float|long-double),nothing,|,bca,.*,double,thickness,'
expect_rows 0 ',bca,[a-z]*,[a-z-]*,joint,'
for kernel in float double long-double; do expect_rows $((41 * (2 * 17 + 2))) ",$kernel,"; done
expect_rows $((41 * 2 * 17)) ,filtered,
grep '^subdivision' "$results/out" > subdivision.csv
awk -F, '$4 == "stable" && $6 != "outside" && $5 ~ /^(double|filtered)$/ && $7 > 16 * 2^-52' "$results/out" > above
[ ! -s above ] || fail "$command_line: above 16 ulp: $(head -3 above)"
awk -F, '$4 == "textbook" && $5 == "double" && $6 == "thickness" && $2 < 1e-6 && $7 < 0.5' "$results/out" > kept
[ ! -s kept ] || fail "$command_line: the textbook keeps digits: $(head -3 kept)"
rm above kept

run stability --family random --count 10 --seed 7 --format json
expect_status 0
expect_finite
for key in version compiler flags instruction_set; do
  [ "$(grep -c "\"$key\":\"[^\"]" "$results/out")" -eq 1 ] || fail "$command_line: no $key"
done
for key in family delta method formula kernel quantity rel_error abs_error condition number seed curve command; do
  [ "$(grep -c "\"$key\":" "$results/out")" -eq "$(grep -c '"family":' "$results/out")" ] ||
    fail "$command_line: rows without $key"
done
cp "$results/out" first
run stability --family random --count 10 --seed 7 --format json -o again
expect_status 0
expect_silence
cmp -s first again || fail "$command_line: the same seed gives other rows"
run stability --family random --count 5 --seed 8
grep -q '^random,' "$results/out" || fail "$command_line: no rows"
rm first again

run stability "$curve"
expect_status 0
expect_rows 0 '^(near|subdivision|random)'
expect_rows $((2 * 4 * 17 + 3 * 2)) '^curves,0,'
run stability --methods bca --family subdivision "$curve"
grep -q '^curves,' "$results/out" && grep -q '^subdivision,' "$results/out" || fail "$command_line: a family is missing"

run stability --format svg "$curve" --family subdivision -o plot.svg
expect_status 0
for word in center radius joint thickness 'bca, textbook' 'bilens, stable' subdivision curves; do
  grep -qF "$word" plot.svg || fail "the plot says nothing of $word"
done
! grep -qiE "$NO_NUMBER" plot.svg || fail 'the plot has numbers that are none'
rm plot.svg

# Rows again by their own commands: those of every family, from files and from a hunt.
run stability --family random --count 30 "$curve" -o rows.csv --worst worst.json --jobs 2
expect_status 0
cat subdivision.csv >> rows.csv
rm subdivision.csv
run stability --condition --hunt-steps 300 --methods sfa --quantities radius
expect_status 0
grep '^hunt,' "$results/out" >> rows.csv
[ "$(grep -c '^hunt,' rows.csv)" -eq 1 ] || fail "$command_line: no row"
awk 'NR % 199 == 10 || /^hunt/' rows.csv > some.csv
[ "$(wc -l < some.csv)" -gt 18 ] || fail "$(wc -l < some.csv) rows to try again"
while read -r row; do
  again=$(sed 's/.*,"bounding_arcs //; s/"$//; s/""/"/g' <<< "$row")
  eval "run $again"
  expect_status 0
  wanted=$(cut -d, -f3-9 <<< "$row")
  [ "$(grep -v '^# ' "$results/out" | tail -n +2 | cut -d, -f3-9)" = "$wanted" ] ||
    fail "$wanted comes out otherwise: $again"
done < some.csv
thickness=bca,textbook,double,thickness
worst=$(sed -n "s/^\(random\|curves\),[^,]*,$thickness,\([^,]*\),.*/\2/p" rows.csv | sort -g | tail -1)
rm rows.csv some.csv

# The worst curves are a file of curves for others, too.
grep -q '"name":"random [0-9]*, delta [0-9]*: bca textbook double thickness, relative error ' worst.json ||
  fail 'the names of the worst curves do not say what they are'
run stability --quantities thickness --methods bca --formulas textbook --kernels double worst.json
expect_status 0
largest=$(grep '^curves,' "$results/out" | cut -d, -f7 | sort -g | tail -1)
[ "$largest" = "$worst" ] || fail "$command_line: the worst error is $largest instead of $worst"
run build --method bca --eps 1e30 worst.json
expect_status 0
run verify --method bca --eps 1e30 worst.json
expect_status 0
run build --method bca --eps 1e30 --format svg worst.json
expect_status 0
rm worst.json

# The problem loses the thickness of nearly circular pieces, as 1/delta; of short ones the textbook does.
run stability --condition --family subdivision --methods bca --quantities thickness --kernels double --formulas textbook
expect_status 0
awk -F, '/^subdivision/ && !($9 > 1 && $9 < 1000)' "$results/out" > ill
[ ! -s ill ] || fail "$command_line: ill-conditioned: $(cut -d, -f1-9 ill | head -3)"
run stability --condition --curve '{"type":"bezier","degree":2,"control_points":[[1,0],[1.00001,1],[0,1]],
  "weights":[1,1,2]}' --methods bca --quantities thickness --kernels double --formulas stable
awk -F, '/^curves/ && $9 > 1e5 && $9 < 1e7 && $7 < 1e-14' "$results/out" > ill
[ "$(wc -l < ill)" -ge 1 ] || fail "$command_line: $(grep ^curves "$results/out" | cut -d, -f1-9)"
rm ill

# Normals keep their digits on flat curves, where the center, two almost parallel lines intersected, does not; and so
# does the problem.
run stability --format markdown --condition --formulas textbook --kernels double --family near-linear --methods bca
expect_status 0
expect_finite
awk -F ' *[|] *' 'NR == 1 { wanted = "normalbisectorcenterradiusjointthickness"; bad = $7 $8 $9 $10 $11 $12 != wanted }
  NR > 2 && $3 < 1e-6 { ++lines; bad += $7 + 0 > 1e-15 || $9 + 0 < 1e-12 || $12 + 0 < 0.5 || $9 !~ /\([1-9]/ }
  NR > 2 && last && $3 > last * 1.02e-4 { ++bad }
  NR > 2 { last = $3 }
  END { exit !(lines >= 3 && !bad) }' "$results/out" || fail "$command_line: $(cat "$results/out")"

# A family of one's own, in any order, has the rows of its curves, by falling delta.
member() { printf '{"type":"bezier","degree":2,"control_points":[[0,0],[0.5,0],[1,%s]]%s}' "$1" "$2"; }
printf '{"curves":[%s,%s,%s]}' "$(member 1e-8 ',"delta":1e-8')" "$(member 1 ',"delta":1')" "$(member 0.3 '')" > own.json
few='--methods bca --quantities thickness --kernels double --formulas textbook'
run stability $few own.json
expect_rows 1 '^curves,0,'
deltas=$(grep '^own,' "$results/out" | cut -d, -f2 | tr '\n' ' ')
[ "$deltas" = '1 1e-08 ' ] || fail "$command_line: the deltas of own are $deltas"
own=$(grep '^own,1e-08' "$results/out" | cut -d, -f3-8)
run stability $few --curve "$(member 1e-8 '')"
[ "$(grep '^curves,0' "$results/out" | cut -d, -f3-8)" = "$own" ] || fail "$command_line: not $own"
run stability --costs --methods bca --format markdown own.json
expect_rows 3 '^. (own|curves) .* bca '
refuses_delta() {
  member 1 ",\"delta\":$1" > wrong.json
  run stability wrong.json
  expect_status 1
  expect_line "bounding_arcs: wrong.json: *delta: expected a number above 0*"
}
for delta in 0 -1 '"x"' null; do refuses_delta "$delta"; done
rm own.json wrong.json

# The methods that are compared have a thickness; box is a side of the chord's, and keeps its digits.
run stability --methods fat-arc,fat-biarc,box,oriented-box,hull --family near-linear --kernels double
expect_status 0
expect_rows $((85 * 5)) ',(fat-arc|fat-biarc|box|oriented-box|hull),textbook,double,thickness,'
awk -F, '$3 == "box" && $7 > 16 * 2^-52' "$results/out" > off
[ ! -s off ] || fail "$command_line: $(head -2 off)"
rm off
run stability --methods hull --formulas textbook --hunt-steps 80
expect_rows 1 '^hunt,.*,hull,textbook,double,thickness,'

# What exactness costs, and what goes wrong without it: a row for each picked delta and method.
words='--family subdivision --format'
run stability --costs $words csv
expect_status 0
expect_finite
expect_rows $((3 * 3)) '^subdivision,[^,]*,(bca|sfa|bilens),[0-9]+,'
awk -F, '/^subdivision/ { shares = $15 + $16 + $17 + $18; bad += shares < 0.98 || shares > 1.02; ++rows }
  END { exit rows == 0 || bad }' "$results/out" || fail "$command_line: the stages of the filter are not all"
run stability --consequences $words json
expect_status 0
none='"wrong verdicts":0,"not held":0,"wrong counts":0,"torn offsets":0}'
[ "$(grep -c "\"formula\":\"stable\",$none" "$results/out")" -eq 9 ] ||
  fail "$command_line: stable formulas mislead, too"
grep '"formula":"textbook"' "$results/out" | grep -q '"wrong counts":1,"torn offsets":' ||
  fail "$command_line: the textbook does not"
run stability --consequences --formulas textbook --methods bca $words markdown
expect_rows $((2 + 3)) '^\|'
# Where arcs are moved about their centers, offsets of nearly straight pieces do not begin where they should.
run stability --consequences --family near-linear --formulas textbook --methods sfa --format json
grep '"delta":1e-08' "$results/out" | grep -q '"torn offsets":1}' || fail "$command_line: no offset is torn"
grep '"delta":1,' "$results/out" | grep -q '"torn offsets":0}' || fail "$command_line: torn where nothing is small"

# What rounded figures decide differs from the exact verdict on a strip beside each curve.
run stability --verdicts --format csv
expect_status 0
expect_rows 3 '^(side of arc|tangency|point location),65536,[1-9][0-9]*$'

# The page's tables are made again by the commands beside them, and prose stays.
{
  printf 'before\n<!-- made by bounding_arcs %s -->\n| old |\n<!-- made -->\nafter\n' \
    "stability --consequences --formulas textbook --methods bca $words markdown"
} > page.md
bash "$root/doc/make_stability.sh" "$tool" page.md none
cp page.md first.md
bash "$root/doc/make_stability.sh" "$tool" page.md none
cmp -s first.md page.md || fail 'doc/make_stability.sh: a page that is made twice differs'
[ "$(grep -c '^| subdivision' page.md)" -eq 3 ] && ! grep -q old page.md || fail "doc/make_stability.sh: $(cat page.md)"
[ "$(head -1 page.md)$(tail -1 page.md)" = beforeafter ] || fail 'doc/make_stability.sh: the prose is gone'
rm page.md first.md

# A hunt finds the same in as many steps, more in more, and says how many they were.
run stability --hunt 0.5 --methods bca --quantities thickness --seed 3
expect_status 0
expect_line 'bounding_arcs: hunted for * steps; --hunt-steps * --seed 3 finds the same'
steps=$(sed 's/.*--hunt-steps \([0-9]*\) .*/\1/' <<< "$err")
grep '^hunt,' "$results/out" > hunted
run stability --hunt-steps "$steps" --methods bca --quantities thickness --seed 3
grep '^hunt,' "$results/out" | cmp -s - hunted || fail "$command_line: finds something else"
rm hunted

# A study that takes minutes says so after some seconds, though nobody watches.
timeout 60 "$tool" stability --family random --count 100000 > "$results/out" 2> "$results/err" &
study=$!
for _ in $(seq 500); do [ ! -s "$results/err" ] || break; sleep 0.1; done
kill "$study"
wait "$study" 2> "$results/wait"
command_line='stability of 100000 spirals'
err=$(cat "$results/err")
expect_line 'bounding_arcs: measuring random, spirals: * of 100000 after * s, some * s to come'

# refuses STATUS PATTERN ARGUMENTS
refuses() {
  local wanted=$1 pattern=$2
  shift 2
  run stability "$@"
  expect_status "$wanted"
  expect_line "bounding_arcs: $pattern"
  expect_silence
  expect_files
}
refuses 2 '*family*' --family round
refuses 2 '*family*' --family ''
refuses 2 '*format*' --format table
refuses 2 '*count*' --family random --count 0
refuses 2 '*seed*' --family random --seed x
refuses 2 '*--methods*' --methods disc
refuses 2 '--methods: expected bca, sfa or bilens with --costs, found box' --costs --methods bca,box
refuses 2 '--methods: expected bca, sfa or bilens with --consequences, found hull' --consequences --methods hull
refuses 2 '*--formulas*' --formulas best
refuses 2 '*--kernels*' --kernels exact
refuses 2 '*--quantities*' --quantities width
refuses 2 '*--jobs*' --jobs 0
refuses 2 '*--hunt*' --hunt 0
refuses 2 '*--hunt*' --hunt nan
refuses 2 '*--hunt-steps*' --hunt-steps 0
refuses 2 '*--hunt*' --hunt 1 --hunt-steps 1
refuses 2 '*--hunt*--family*' --hunt-steps 1 --family random
refuses 2 '--costs: expected no hunt beside it, found --hunt' --costs --hunt-steps 1
refuses 2 '--consequences: expected no file of worst curves, found --worst' --consequences --worst worst.json
refuses 2 '--format: expected csv, json or markdown with --costs, found svg' --costs --format svg
refuses 2 '*--costs*' --costs --consequences
refuses 2 '*--verdicts*' --verdicts --costs
refuses 2 '--quantities: expected figures*bisectors*' --hunt-steps 1 --quantities bisector
refuses 2 '--quantities: expected figures*no joint*' --hunt-steps 1 --methods bca --quantities joint
refuses 1 'no/worst.json*' --worst no/worst.json "$curve"
refuses 1 '--curve*' --curve '{"type":"bezier"'
refuses 1 '--curve: part: expected parameters*' --curve '{"type":"bezier","degree":1,"control_points":[[0,0],[1,1]],
  "part":[0.5,0.5]}'
refuses 1 '--curve: part: *two parameters*' --curve '{"type":"bezier","degree":1,"control_points":[[0,0],[1,1]],
  "part":[0.5]}'
refuses 1 '*only a bezier*' --curve '{"type":"bspline","degree":1,"control_points":[[0,0],[1,1]],"knots":[0,0,1,1],
  "part":[0,1]}'
refuses 1 '--curve: curve "curve": expected a part within one spiral segment, found one beyond it' \
  --curve '{"type":"bezier","degree":2,"control_points":[[0,0],[1,2],[2,0]],"part":[0.25,0.75]}'
refuses 1 'missing.json*' missing.json
refuses 1 'no/plot.svg*' --format svg -o no/plot.svg "$curve"

run stability --help
expect_status 0
for word in Examples '  bounding_arcs stability ' FILES --family --count --seed --format --output outside --curve \
    --methods --formulas --kernels --quantities --condition --worst --hunt --hunt-steps --jobs \
    near-linear markdown bisector --costs --consequences --verdicts; do
  grep -qF -e "$word" "$results/out" || fail "$command_line: says nothing of $word"
done

finish
