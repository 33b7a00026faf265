#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What is not served ends in one sentence that names the cure.
# Usage: compile_fail.sh SOURCE_DIRECTORY COMPILER
set -euo pipefail
cd "$1"
compiler=$2
try() { "$compiler" -frounding-math -fsyntax-only -I include "$@" 2>&1; }
! said=$(try -std=c++17 test/consumer/compile_fail.cpp) || { echo 'it compiles'; exit 1; }
for sentence in 'number type with square roots' 'A tree takes a Drawing_2' 'takes traits of regions' \
  'make a Region_hierarchy_2 of them'; do
  [[ $said == *"$sentence"* ]] || { printf 'not said: %s\n%s\n' "$sentence" "$said"; exit 1; }
done
! said=$(echo '#include <CGAL/Bounding_arcs_2.h>' | try -std=c++14 -x c++ -) || { echo 'it compiles as C++14'; exit 1; }
[[ $said == *'needs C++17'* ]] && [ "$(grep -c 'error' <<< "$said")" -le 2 ] || { echo "as C++14: $said"; exit 1; }
