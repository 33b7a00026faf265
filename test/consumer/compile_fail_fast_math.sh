#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# number/strict_math.h refuses options that void error bounds, and nothing else.
# Usage: compile_fail_fast_math.sh SOURCE_DIRECTORY COMPILERS...
set -euo pipefail
cd "$1"
shift
compiler=
try() { "$compiler" -std=c++17 -fsyntax-only -I include "$@" test/consumer/compile_fail_fast_math.cpp 2>&1; }
# refused REASON OPTIONS..: does not compile, for that reason.
refused() {
  local reason=$1 said
  shift
  ! said=$(try "$@") || { echo "$compiler compiles with $*"; exit 1; }
  [[ $said == *"$reason"* ]] || { printf '%s refuses %s for another reason:\n%s\n' "$compiler" "$*" "$said"; exit 1; }
}
accepted() { try "$@" || { echo "$compiler does not compile with $*"; exit 1; }; }

told='-ffp-contract=off -DBOUNDING_ARCS_NO_CONTRACTION'
for compiler in "$@"; do
  accepted $told
  accepted $told -O3
  refused '-ffast-math' $told -ffast-math
  refused '-ffast-math' $told -Ofast
  refused '-ffinite-math-only' $told -ffinite-math-only
  machine=$("$compiler" -dumpmachine)
  [[ $machine == x86_64* ]] || continue
  accepted
  accepted $told -mfma
  if [[ $("$compiler" --version) == *clang* ]]; then
    accepted -mfma
    # contracted nowhere, although Clang does so by default
    code=$("$compiler" -std=c++17 -O2 -mfma -I include -S -o - -x c++ - <<< '
      #include <CGAL/Bounding_arcs_2/number/Xy.h>
      double f(CGAL::Bounding_arcs::Xy<double> p, CGAL::Bounding_arcs::Xy<double> q) { return cross(p, q); }')
    [[ $code == *mulsd* ]] || { echo "$compiler does not multiply"; exit 1; }
    [[ $code != *vfm* ]] || { echo "$compiler contracts"; exit 1; }
  else
    accepted -mfma  # nothing is contracted without optimisation
    refused 'BOUNDING_ARCS_NO_CONTRACTION' -mfma -O2
    refused '-fno-signed-zeros' $told -fno-signed-zeros
    refused '-fno-signed-zeros' $told -fsingle-precision-constant
  fi
done
