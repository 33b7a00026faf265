# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Shell functions of the tests of the command-line tool, sourced with the arguments TOOL PROJECT_ROOT of the test.
# Needs bash and coreutils, and Python for two of them.  A test works in an empty directory of its own, which goes away
# at its end.

set -u
export LC_ALL=C
tool=$(realpath "$1")
root=$(realpath "$2")
scratch=$(mktemp -d)
trap 'chmod -R u+w "$scratch"; rm -rf "$scratch"' EXIT
results=$scratch/results  # what the last run printed, apart from the files of the test
directory=$scratch/files
mkdir "$results" "$directory"
cd "$directory" || exit 1
NO_NUMBER='(^|[^a-z_])(nan|inf|infinity)([^a-z_]|$)'
failures=0

fail() {
  printf 'FAILED: %s\n' "$1"
  failures=$((failures + 1))
}

# Ends the test: status 1 if anything failed.
finish() {
  if [ "$failures" -gt 0 ]; then printf '%d checks failed\n' "$failures"; exit 1; fi
  exit 0
}

# run ARGUMENTS: the tool with them; sets status, out and err. Nothing takes longer than 100 s even with sanitizers.
run() {
  command_line="bounding_arcs $*"
  timeout -k 1 100 "$tool" "$@" > "$results/out" 2> "$results/err" < "${input:-/dev/null}"
  status=$?
  err=$(cat "$results/err")
}

# expect_status N: the last run ended so.
expect_status() {
  [ "$status" -eq "$1" ] || fail "$command_line: status $status instead of $1; stderr: ${err:0:300}"
}

# expect_silence: the last run printed nothing on standard output.
expect_silence() {
  [ ! -s "$results/out" ] || fail "$command_line: printed on standard output: $(head -c 200 "$results/out")"
}

# expect_line PATTERN: the last run printed one whole line on standard error, which the glob pattern matches.
expect_line() {
  local lines
  lines=$(wc -l < "$results/err")
  [ "$lines" -eq 1 ] || fail "$command_line: $lines lines on stderr instead of 1: ${err:0:300}"
  # shellcheck disable=SC2053
  [[ $err == $1 ]] || fail "$command_line: stderr is \"${err:0:300}\", which is not like $1"
}

# expect_files NAMES: the directory of the test holds these files and no other, hidden ones included.
expect_files() {
  local found wanted
  found=$(ls -A | sort | tr '\n' ' ')
  wanted=$([ $# -eq 0 ] || printf '%s\n' "$@" | sort | tr '\n' ' ')
  [ "$found" = "$wanted" ] || fail "$command_line: files are $found instead of $wanted"
}

# expect_finite: what the last run printed holds no number that is none.
expect_finite() {
  ! grep -qiE "$NO_NUMBER" "$results/out" || fail "$command_line: $(grep -oiE -m1 ".{0,60}$NO_NUMBER" "$results/out")"
}
