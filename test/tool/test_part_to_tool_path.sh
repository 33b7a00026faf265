#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The recipe of doc/tool.md: its script prints what the page shows, block by block, and each picture of the page is one
# that the script makes, with the same title.
# Usage: test_part_to_tool_path.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

run arcs "$root/examples/data/mount/mount.dxf" --eps 1
if [[ $err == *'without dxflib'* ]]; then finish; fi

bash "$root/examples/part_to_tool_path.sh" "$tool" . > "$results/printed" 2>&1 ||
  fail "the script ends with $?: $(tail -n 3 "$results/printed")"
page=$results/page
awk '/^## / { is_recipe = /^## From a part to tool paths$/ } is_recipe' "$root/doc/tool.md" > "$page"
awk '/^```/ { in_code = !in_code; next } in_code' "$page" > "$results/shown"
[ -s "$results/shown" ] || fail 'doc/tool.md shows nothing'
diff "$results/shown" "$results/printed" > "$results/diff" ||
  fail "doc/tool.md (<) shows something else than the script prints (>): $(head -c 900 "$results/diff")"

# Coordinates in the pictures of the page are rounded.
told() { grep -oE '<title>[^<]*' "$1"; }
pictures=$(sed -n 's/^!\[.*](images\/mount_\(.*\)\.svg)$/\1/p' "$page")
for name in $pictures; do
  if [ ! -e "$name.svg" ]; then fail "the script makes no $name.svg"; continue; fi
  [ "$(told "$name.svg")" = "$(told "$root/doc/images/mount_$name.svg")" ] ||
    fail "doc/images/mount_$name.svg is another picture; bash doc/make_pictures.sh makes it again"
done
for name in *.svg; do
  grep -qx "${name%.svg}" <<< "$pictures" || fail "$name is not in doc/tool.md"
done

rm -f ./*
finish
