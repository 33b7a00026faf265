#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Bounding Arcs laid out as a package of CGAL's: all that a package has is there, its pages name what there is, and an
# example and the test build by CGAL's create_single_source_cgal_program and print what they should.
# Usage: cgal_package.sh SOURCE BUILD COMPILER SCRATCH [EXAMPLES]
#   BUILD     a build directory of SOURCE in which the library is built, by COMPILER
#   SCRATCH   a directory that is emptied first
#   EXAMPLES  names of examples to build; own_region as a rule, and all are all
set -euo pipefail
source=$(realpath "$1") build=$(realpath "$2") compiler=$3 examples=${5:-own_region}
rm -rf "$4"
mkdir -p "$4"
scratch=$(realpath "$4")
unset CMAKE_BUILD_TYPE CMAKE_PREFIX_PATH CMAKE_CXX_COMPILER_LAUNCHER CXXFLAGS DESTDIR

fail() {
  echo "FAILED: $*"
  exit 1
}
quietly() { "$@" > "$scratch/log" 2>&1 || { cat "$scratch/log"; fail "$*"; }; }

quietly cmake --install "$build" --component cgal_package --prefix "$scratch"
cd "$scratch/Bounding_arcs_2"
for file in package_info/Bounding_arcs_2/{copyright,description.txt,license.txt,long_description.txt,maintainer} \
  package_info/Bounding_arcs_2/dependencies include/CGAL/Bounding_arcs_2.h src/Bounding_arcs_2/library/arc/Arc_2.cpp \
  doc/Bounding_arcs_2/{Bounding_arcs_2.txt,PackageDescription.txt,dependencies,examples.txt,Doxyfile.in} \
  doc/Bounding_arcs_2/{bounding_arcs_2.bib,fig/bounding_arcs_2.svg} {examples,test}/Bounding_arcs_2/CMakeLists.txt; do
  [ -s "$file" ] || fail "not in the package: $file"
done

# Concepts have their group and models, each of which is a class in the headers or of an example.
pages=doc/Bounding_arcs_2
for concept in "$pages"/Concepts/*.h; do
  grep -q '\\ingroup PkgBoundingArcs2Concepts' "$concept" || fail "$concept is in no group"
  grep -q '\\cgalHasModel `' "$concept" || [[ $concept == *BoundableCurve_2.h ]] || fail "$concept has no model"
  name=$(basename "$concept" .h)
  grep -q "^- \`$name\`" "$pages/PackageDescription.txt" || fail "$name is not among the reference pages"
done
declared=$(grep -rhoE '(class|struct|using) [A-Z][A-Za-z_0-9]*' include | sed 's/.* //' | sort -u)
functions=$(grep -rhoE '[a-z_]+\(' include | tr -d '(' | sort -u)
while read -r name; do
  grep -qx "$name" <<< "$declared" || fail "no header declares $name, which the pages name"
done < <(grep -rhoE 'CGAL::Bounding_arcs::[A-Z][A-Za-z_0-9]*' "$pages" | sed 's/.*:://' | sort -u)
while read -r name; do
  grep -qx "$name" <<< "$functions" || fail "no header declares $name(), which the pages name"
done < <(grep -rhoE 'CGAL::Bounding_arcs::[a-z_]+\(\)' "$pages" | sed 's/.*:://; s/()//' | sort -u)

# What the manual includes, cites and shows is there.
while read -r name; do [ -e "examples/$name" ] || fail "no example $name"; done \
  < <(sed -nE 's/^\\(cgalExample\{|example )([^}]*)\}?$/\2/p' "$pages"/*.txt)
while read -r key; do grep -q "^@.*{$key,$" "$pages/bounding_arcs_2.bib" || fail "no entry $key"; done \
  < <(grep -ohE '\\cgalCite\{[^}]*' "$pages"/*.txt | sed 's/.*{//')
while read -r figure; do [ -s "$pages/fig/$figure" ] || fail "no figure $figure"; done \
  < <(sed -nE 's/^\\cgalFigureBegin\{[A-Za-z0-9]*,(.*)\}$/\1/p' "$pages"/*.txt | tr ',' '\n')

# build DIRECTORY TARGETS: as whoever unpacks the package builds it.
build() {
  local directory=$1
  shift
  quietly cmake -S "$directory/Bounding_arcs_2" -B "$scratch/$directory" -DCMAKE_CXX_COMPILER="$compiler" \
    -DBounding_arcs_DIR="$build"
  quietly cmake --build "$scratch/$directory" --target "$@"
}
[ "$examples" != all ] || examples=$(cd examples/Bounding_arcs_2 && basename -s .cpp -- *.cpp)
# shellcheck disable=SC2086
build examples $examples
for example in $examples; do
  diff "$source/examples/$example.expected.txt" <("$scratch/examples/$example") || fail "$example prints another thing"
done
build test test_regions
[ "$("$scratch/test/test_regions")" = 'done' ] || fail 'test_regions'
