#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Where output goes: a file is written whole or not at all, and what cannot be written is reported.
# Usage: test_output_file.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

curve=$root/examples/data/a_wrench.json
build=(build --method bca --eps 1e-6)

run "${build[@]}" "$curve"
expect_status 0
cp "$results/out" "$results/expected"
expected=$results/expected
[ "$(wc -c < "$expected")" -gt 100000 ] || fail 'the output is too small for the limits below'

# same FILE: it holds what goes to standard output without -o.
same() { cmp -s "$1" "$expected" || fail "$command_line: $1 differs from what standard output gets"; }
# refuses FILE PATTERN: the run failed with one line that names the file.
refuses() {
  expect_status 1
  expect_line "bounding_arcs: $1: *"
  [[ $err == *$2* ]] || fail "$command_line: $err says nothing of $2"
}

# The same output twice, to the file and to standard output, with standard output silent otherwise.
run "${build[@]}" "$curve" -o a.json
expect_status 0
expect_silence
expect_files a.json
same a.json
run "${build[@]}" "$curve" -o a.json
same a.json
run "${build[@]}" "$curve" -o -
same "$results/out"
run "${build[@]}" "$curve" --output "$PWD/a.json"
same a.json
for form in "build --method sfa --eps 1e-2 --format svg" "verify --method bilens --eps 1e-2 --format json" \
            "verify --method bilens --eps 1e-2 --format table" "build --method bilens --eps 1e-2 --kernel exact"; do
  # shellcheck disable=SC2086
  run $form "$curve" && cp "$results/out" "$results/first"
  # shellcheck disable=SC2086
  run $form "$curve" -o b.out
  expect_status 0
  cmp -s b.out "$results/first" || fail "$command_line: differs from run to run"
  rm -f b.out
done

# An existing file is replaced, also by less than it held, and also where a link leads to it; the link stays.
head -c 9999999 /dev/zero > a.json
run "${build[@]}" "$curve" -o a.json
same a.json
ln -s a.json link.json
echo old > a.json
run "${build[@]}" "$curve" -o link.json
same a.json
[ -L link.json ] || fail 'the link was replaced by a file'
expect_files a.json link.json
rm link.json

# The new file has the mode of the old one and, for the superuser, its owner; without an old one umask decides.
for mode in 600 640 666 755 200; do
  chmod $mode a.json
  [ "$(id -u)" -ne 0 ] || chown 12345:12345 a.json
  before=$(stat -c '%a %u:%g' a.json)
  run "${build[@]}" "$curve" -o a.json
  [ "$(stat -c '%a %u:%g' a.json)" = "$before" ] || fail "$before became $(stat -c '%a %u:%g' a.json)"
done
rm a.json
for mask in 022 077 002; do
  (umask $mask; "$tool" "${build[@]}" "$curve" -o a.json)
  [ "$(stat -c %a a.json)" = "$(printf %o $((0666 & ~mask)))" ] || fail "umask $mask gives mode $(stat -c %a a.json)"
  rm a.json
done

# A link to a file that is not there yet is followed, also through others and into another folder.
mkdir folder
ln -s folder/second.json first.json
ln -s "$PWD/folder/a.json" folder/second.json
run "${build[@]}" "$curve" -o first.json
expect_status 0
same folder/a.json
[ -L first.json ] && [ -L folder/second.json ] || fail 'a dangling link was replaced'
expect_files first.json folder
[ "$(ls -A folder | tr '\n' ' ')" = 'a.json second.json ' ] || fail "the folder of the target holds $(ls -A folder)"
rm -r folder first.json

# Names as long as the file system takes, and in a folder of a path as long as the system takes.
for length in 240 250 255; do
  long=$(printf "%${length}s" | tr ' ' n)
  run "${build[@]}" "$curve" -o "$long"
  expect_status 0
  same "$long"
  rm -f "$long"
done
deep=$PWD
while [ ${#deep} -lt 3800 ]; do deep+=/$(printf '%240s' | tr ' ' d); done
mkdir -p "$deep"
deep+=/$(printf "%$((4094 - ${#deep}))s" | tr ' ' n)  # 4095 bytes and the NUL are most
run "${build[@]}" "$curve" -o "$deep"
expect_status 0
same "$deep"
rm -r d*

# Other hard links keep the old file: the name gets a new one.
echo old > a.json
ln a.json b.json
run "${build[@]}" "$curve" -o a.json
same a.json
[ "$(cat b.json)" = old ] || fail 'a file was changed under its other name'
rm b.json

# An existing file outlives a failed run, whatever fails: bad input, eps too small, a full disk.
echo old > a.json
echo '{' > bad.json
run "${build[@]}" "$curve" bad.json -o a.json
refuses bad.json line
run build --method bca --eps 1e-300 "$curve" -o a.json
refuses "$curve" eps
run build --method bca --eps 1e-3 --max-regions 5 "$curve" -o a.json
refuses "$curve" --max-regions
expect_files a.json bad.json
(
  ulimit -f 16
  run "${build[@]}" "$curve" -o a.json
  refuses '*a.json' 'too large'
  [ "$failures" -eq 0 ]
) || failures=$((failures + 1))
(
  ulimit -f 16
  run "${build[@]}" "$curve" -o new.json
  refuses '*new.json' 'too large'
  [ "$failures" -eq 0 ]
) || failures=$((failures + 1))
expect_files a.json bad.json
[ "$(cat a.json)" = old ] || fail 'a failed run changed the file that was there'
rm a.json bad.json

# Devices and pipes are written in place, and so is what the shell has open.
run "${build[@]}" "$curve" -o /dev/null
expect_status 0
expect_silence
[ -c /dev/null ] || fail '/dev/null was replaced'
run "${build[@]}" "$curve" -o /dev/full
refuses /dev/full 'No space'
mkfifo pipe
cat pipe > "$results/piped" &
run "${build[@]}" "$curve" -o pipe
wait $!
same "$results/piped"
[ -p pipe ] || fail 'the pipe was replaced'
rm -f pipe
for path in /dev/stdout /dev/fd/1 /proc/self/fd/1; do
  { echo before; "$tool" "${build[@]}" "$curve" -o $path; echo after; } > "$results/out"
  cmp -s "$results/out" <(echo before; cat "$expected"; echo after) || fail "-o $path replaced what the shell writes to"
done
{ "$tool" "${build[@]}" "$curve" -o /dev/fd/7 && echo after >&7; } 7> "$results/out"
cmp -s "$results/out" <(cat "$expected"; echo after) || fail '-o /dev/fd/7 does not write where the shell goes on'
run "${build[@]}" "$curve" -o /dev/fd/77
refuses /dev/fd/77 'Bad file descriptor'
for arguments in --help -h 'build --help' 'compare -h' 'verify --help' 'stability --help' 'arcs --help'; do
  for closed in no yes; do
    command_line="bounding_arcs $arguments"
    # shellcheck disable=SC2086
    if [ $closed = yes ]; then "$tool" $arguments >&- 2> "$results/err"
    else "$tool" $arguments > /dev/full 2> "$results/err"; fi
    status=$?
    err=$(cat "$results/err")
    refuses 'standard output' 'cannot write'
  done
done
for subcommand in "${build[*]}" "${build[*]} --format svg" 'compare --eps 1e-2 --repeat 1' \
    'verify --method bca --eps 1e-2'; do
  command_line="bounding_arcs $subcommand > /dev/full"
  # shellcheck disable=SC2086
  "$tool" $subcommand "$curve" > /dev/full 2> "$results/err"
  status=$?
  err=$(cat "$results/err")
  refuses 'standard output' 'No space'
done

# What cannot be written.
mkdir directory
for path in directory directory/ . missing/a.json; do
  run "${build[@]}" "$curve" -o $path
  refuses "*${path%/}*" 'cannot write'
  expect_silence
done
touch file
for path in file/a.json file/ missing/; do
  run "${build[@]}" "$curve" -o $path
  refuses $path 'cannot write'
done
ln -s missing/a.json link
run "${build[@]}" "$curve" -o link
refuses link 'No such file'
ln -sf link link
run "${build[@]}" "$curve" -o link
refuses link 'symbolic links'
rm link
run "${build[@]}" "$curve" -o "$(printf '%256s' | tr ' ' n)"
refuses '*nnn' 'too long'
# A file that nobody may write stays, though its folder may be written: the superuser, too, has to say so.
echo old > read_only
chmod 444 read_only
ln -s read_only link
for path in read_only link; do
  run "${build[@]}" "$curve" -o $path
  refuses $path 'read-only'
done
[ "$(cat read_only)" = old ] || fail 'a read-only file was replaced'
rm -f read_only link
expect_files directory file
[ -z "$(ls -A directory)" ] || fail 'something was left in the directory'
if [ "$(id -u)" -ne 0 ]; then  # the superuser may write anywhere
  chmod a-w directory
  run "${build[@]}" "$curve" -o directory/a.json
  refuses directory/a.json 'Permission'
fi

# Nothing is left of what a signal cuts off: neither the file nor a part of it. Sanitizers have SEGV and its like for
# themselves; KILL cannot be caught. A shell that is not interactive ignores INT and QUIT in the background.
ulimit -c 0
write_long() {
  env --default-signal=INT,QUIT \
    "$tool" build --method sfa --eps 1e-10 "$root"/examples/data/*.json -o cut.json 2> /dev/null &
  process=$!
  for _ in {1..2000}; do
    compgen -G '*.part*' > /dev/null && break
    sleep 0.01
  done
}
for signal in TERM HUP INT QUIT ABRT USR1 USR2 PIPE ALRM VTALRM PROF XCPU IO SYS PWR STKFLT RTMIN RTMAX; do
  command_line="bounding_arcs, ended by $signal"
  write_long
  kill -$signal $process
  wait $process 2> /dev/null
  status=$?
  [ "$status" -eq $((128 + $(kill -l $signal))) ] || fail "status $status after signal $signal"
  expect_files directory file
  rm -f cut.json *.part*
done

# A signal that who started the program has ignored does not end it.
trap '' USR1
write_long
kill -USR1 $process
wait $process || fail 'ended by a signal that was to be ignored'
trap - USR1
rm -f cut.json *.part*

# Standard input is -, as a file of its own and among others.
input=$curve run "${build[@]}" -
expect_status 0
sed 's/"name":"a_wrench"/X/' "$expected" | cmp -s - <(sed 's/"name":"[a-z_]*"/X/' "$results/out") ||
  fail 'standard input gives other output than the file'
input=$curve run "${build[@]}" "$root/examples/data/b_angelfish.json" - "$curve"
expect_status 0
[ "$(grep -c '"name":' "$results/out")" -eq 3 ] || fail 'not all of three files came out'
echo '[' > bad.json
input=bad.json run "${build[@]}" -
refuses stdin line
input=/dev/null run "${build[@]}" -
refuses stdin empty
input=. run "${build[@]}" -
refuses stdin directory

# The ending of the file decides on the form, in any case of letters; one that stands for none leaves the default, and
# --format is above it.
arcs=(arcs --eps 0.1 "$curve")
form_of() {
  case $(head -c 200 "$1") in
    '{'*) echo json ;;
    '<svg'*) echo svg ;;
    *SECTION*) echo dxf ;;
    curve,*) echo csv ;;
    *) echo table ;;
  esac
}
for name in a.json=json a.svg=svg a.csv=csv a.dxf=dxf a.txt=table A.DXF=dxf a.b.Svg=svg \
  a.out=table json=table .svg=table; do
  run "${arcs[@]}" -o "${name%=*}"
  expect_status 0
  [ "$(form_of "${name%=*}")" = "${name#*=}" ] || fail "$command_line: wrote $(form_of "${name%=*}")"
  rm "${name%=*}"
done
run "${arcs[@]}" -o a.dxf --format json
[ "$(form_of a.dxf)" = json ] || fail "$command_line: wrote $(form_of a.dxf)"
rm a.dxf
run "${build[@]}" "$curve" -o a.svg
[ "$(form_of a.svg)" = svg ] || fail "$command_line: wrote $(form_of a.svg)"
rm a.svg
# not_there ENDINGS ARGUMENTS: wrong usage, as there is no such form.
not_there() {
  local endings=$1
  shift
  run "$@"
  expect_status 2
  expect_silence
  expect_line "bounding_arcs: --output: expected a name in $endings, found \"${*: -1}\""
}
not_there '.json, .csv or .svg, or --format' "${build[@]}" "$curve" -o a.dxf
not_there '.json or .svg, or --format' arrange "$curve" -o a.dxf
not_there '.json, .csv, .svg or .dxf, or --format' clip "$curve" "$curve" -o a.md
not_there '.html' report "$curve" -o a.json
not_there '.json with --stream, or no known ending' arcs --eps 1 --stream "$curve" -o a.csv
not_there '.csv, .json, .svg or .md, or --format' stability -o a.dxf
for name in json jsonl; do
  echo '{"type":"bezier","degree":1,"control_points":[[0,0],[1,1]]}' > record
  run arcs --eps 1 --stream record -o a.$name
  expect_status 0
  [ "$(form_of a.$name)" = json ] || fail "$command_line: wrote $(form_of a.$name)"
  rm record a.$name
done

# Numbers come out as they were typed, with the fewest digits that read back: each control point of a polygon is where
# two pieces meet.
points='[0.1,0.2],[0.30000000000000004,-1.0000000000000002]'
points+=',[1.7976931348623157e+100,2.2250738585072014e-300],[3.141592653589793,-0.3333333333333333]'
echo "{\"type\":\"bspline\",\"degree\":1,\"knots\":\"uniform\",\"control_points\":[$points]}" > polygon.json
run build --method bca --eps 1e90 polygon.json
expect_status 0
for point in ${points//],[/ }; do
  grep -qF "\"from\":[${point//[\[\]]/}]" "$results/out" || grep -qF "\"to\":[${point//[\[\]]/}]" "$results/out" ||
    fail "the control point $point did not come out as it went in"
done

finish
