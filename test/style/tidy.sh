#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Runs clang-tidy with the checks of .clang-tidy over the tool's sources and a program that includes all of the library;
# a warning is a failure. It takes minutes, as clang-tidy reads CGAL's headers, too, so that the tests leave it out.
# Usage: tidy.sh [FILES]
#   FILES  sources to look at instead of all, from the top-level directory
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
bash .ci/install.sh .ci/packages.txt
directory=build/tidy
cmake -S . -B "$directory" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DBOUNDING_ARCS_TBB=ON > /dev/null
[ $# -gt 0 ] || set -- src/*.cpp src/input/*.cpp examples/minimal_hierarchy.cpp
printf '%s\n' "$@" | xargs -P "$(nproc)" -n 1 \
  clang-tidy --quiet --extra-arg-before=-std=c++17 -p "$directory" 2> >(grep -v 'warnings generated' >&2)
echo "clang-tidy has nothing to say about $# files."
