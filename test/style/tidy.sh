#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Runs clang-tidy with the checks of .clang-tidy over all sources of src/ and a program that includes all of the
# library; a warning is a failure. clang-tidy reads CGAL's headers for each source, a quarter of a minute as
# a rule, and for a quarter of an hour in all on two cores. The tests leave it out.
# Usage: tidy.sh [FILES]
#   FILES  sources to look at instead of all, from the top-level directory
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
bash .ci/install.sh .ci/packages.txt
directory=build/tidy
cmake -S . -B "$directory" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DBOUNDING_ARCS_UNITY=OFF \
  -DBOUNDING_ARCS_TBB=ON > /dev/null
if [ $# -eq 0 ]; then
  mapfile -t all < <(find src -name '*.cpp' | sort)
  set -- "${all[@]}" examples/minimal_hierarchy.cpp
fi
printf '%s\n' "$@" | xargs -P "$(nproc)" -n 1 \
  clang-tidy --quiet --extra-arg-before=-std=c++17 -p "$directory" 2> >(grep -v 'warnings generated' >&2)
echo "clang-tidy has nothing to say about $# files."
