#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Work that takes more than a second shows that it goes on, on a terminal and nowhere else, and wipes that.
# Usage: test_progress.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

command -v script > /dev/null || finish  # makes a terminal
mkfifo slow.json
line='{"name":"line","type":"bezier","degree":1,"control_points":[[0,0],[3,1]]}'
late() { (sleep "$1"; printf '%s' "$line") > slow.json & }

late 2.3
script -qec "'$tool' arcs slow.json --eps 1 --format csv -o out.csv" /dev/null > seen < /dev/null
wait
grep -q $'\rreading slow.json: 1 s\e\[K\rreading slow.json: 2 s\e\[K\r\e\[K' seen ||
  fail "a terminal sees $(cat -v seen)"
grep -q '^line,' out.csv || fail 'there is no result'

late 1.5
run arcs slow.json --eps 1
wait
expect_status 0
[ -z "$err" ] || fail "$command_line: said $err, where no terminal is"

late 0
script -qec "'$tool' arcs slow.json --eps 1 --format csv -o out.csv" /dev/null > seen < /dev/null
wait
[ ! -s seen ] || fail "what is quick says $(cat -v seen)"

rm -f ./*
finish
