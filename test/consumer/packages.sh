#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds and runs the consumers: projects that link Bounding Arcs installed, and through a library that one of these has
# installed; with Bounding Arcs fetched or as a subdirectory, which is the same to the compiler, a library is compiled.
# Their build type is empty, and has to stay so.
# Usage: packages.sh SOURCE BUILD COMPILER OTHER SCRATCH
#   BUILD     a build directory of SOURCE in which everything is built, by COMPILER; this gets installed
#   OTHER     another compiler, or the same
#   SCRATCH   a directory that is emptied first
set -euo pipefail
source=$(realpath "$1") build=$(realpath "$2") compiler=$3 other=$4
rm -rf "$5"
mkdir -p "$5"
scratch=$(realpath "$5")
consumers=$source/test/consumer
# As in a shell where nothing is set for CMake.
unset CMAKE_BUILD_TYPE CMAKE_PREFIX_PATH CMAKE_CXX_COMPILER_LAUNCHER CXXFLAGS DESTDIR

fail() {
  echo "FAILED: $*"
  exit 1
}

# quietly COMMAND: shows what it printed only if it fails.
quietly() { "$@" > "$scratch/log" 2>&1 || { cat "$scratch/log"; fail "$*"; }; }

# configure NAME OPTIONS: configures a consumer, and looks at what that left behind.
configure() {
  local name=$1
  shift
  echo "consumer: $name"
  quietly cmake -S "$consumers/$name" -B "$scratch/$name" -DCMAKE_CXX_COMPILER="$compiler" \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "$@"
  grep -qx 'CMAKE_BUILD_TYPE:STRING=' "$scratch/$name/CMakeCache.txt" || fail "$name: the build type was set"
  ! grep '^CCACHE_PROGRAM' "$scratch/$name/CMakeCache.txt" || fail "$name: a compiler launcher was sought"
}

# consume NAME OPTIONS: configures, builds and runs a consumer.
consume() {
  configure "$@"
  local name=$1
  quietly cmake --build "$scratch/$name" --parallel 2
  [ "$("$scratch/$name/consumer")" = '31 regions' ] || fail "$name: the program printed something else"
}

# carries NAME FLAG: the options of the library came to the consumer's own sources.
carries() {
  grep 'consumer_regions\.dir' "$scratch/$1/compile_commands.json" | grep -qe "$2" || fail "$1: compiled without $2"
}

# An installed package works where it has been moved to, too, and names no directory that it was made in.
quietly cmake --install "$build" --prefix "$scratch/unpacked"
[ -x "$scratch/unpacked/bin/bounding_arcs" ] || fail 'the tool was not installed'
"$scratch/unpacked/bin/bounding_arcs" --help > /dev/null

# Where something is not built nothing is installed.
sed 's/bounding_arcs\.1"/unbuilt.1"/' "$build/src/package/cmake_install.cmake" > "$scratch/unbuilt.cmake"
! cmake -DCMAKE_INSTALL_PREFIX="$scratch/half" -P "$scratch/unbuilt.cmake" > "$scratch/log" 2>&1 ||
  fail 'unbuilt: a manual page that is not there was installed'
grep -q 'nothing is installed' "$scratch/log" || { cat "$scratch/log"; fail 'unbuilt: refused for another reason'; }
[ ! -e "$scratch/half" ] || fail 'unbuilt: half of a package was installed'

# The manual page and the completion name every subcommand and option.
manual=$scratch/unpacked/share/man/man1/bounding_arcs.1
completion=$scratch/unpacked/share/bash-completion/completions/bounding_arcs
[ -s "$manual" ] && [ -s "$completion" ] || fail 'the manual page or the completion was not installed'
# completes WORDS TYPED: what comes after these words, for what is typed so far.
completes() (
  # shellcheck disable=SC1090
  . "$completion"
  COMP_WORDS=(bounding_arcs $1 "$2") COMP_CWORD=$(($(wc -w <<< "$1") + 1))
  _bounding_arcs
  echo "${COMPREPLY[*]}"
)
known=$("$scratch/unpacked/bin/bounding_arcs" --help |
  awk '/^Subcommands:/ { on = 1; next } on && !NF { exit } on { print $1 }')
grep -qx medial-axis <<< "$known" || fail 'the subcommands are not found in the help'
for command in $known 'query hull'; do
  # shellcheck disable=SC2086
  options=$("$scratch/unpacked/bin/bounding_arcs" $command --help | sed -nE 's/^  (-[a-z],)?(--[a-z-]+).*/\2/p' | sort)
  [ "$options" = "$(completes "$command" -- | tr ' ' '\n' | sort)" ] || fail "completion: options of $command"
  part=$(sed -n "/^.SH BOUNDING_ARCS ${command^^}$/,/^.SH/p" "$manual" | sed 's/\\-/-/g')
  for option in $options; do
    grep -qe "^.B .*$option" <<< "$part" || fail "the manual says nothing of $command $option"
  done
done
[ "$(completes '' co)" = compare ] || fail 'completion: subcommands'
[ "$(completes 'query hull file.svg --format' c)" = csv ] || fail 'completion: values'
quietly groff -man -Tutf8 -ww -z "$manual"
[ ! -s "$scratch/log" ] || { cat "$scratch/log"; fail 'the manual page is not well-formed'; }

mkdir "$scratch/moved"
mv "$scratch/unpacked" "$scratch/moved/prefix"
package=$(dirname "$(find "$scratch/moved/prefix" -name Bounding_arcsConfig.cmake)")
! grep -rF -e "$source" -e "$build" -e "$scratch" "$package" || fail 'the package names a directory'
consume installed -DCMAKE_PREFIX_PATH="$scratch/moved/prefix"
grep -q "^Bounding_arcs_DIR:PATH=$package$" "$scratch/installed/CMakeCache.txt" || fail 'another package was found'
carries installed -ffp-contract=off
counts='1 curve, a_wrench: 28 Bezier pieces, 75 spiral segments, 121 regions'
[ "$("$scratch/installed/drawing" "$source/examples/data/a_wrench.json")" = "$counts" ] ||
  fail 'installed: the readers gave another drawing'

# The laboratory is a component of its own: a researcher's program links it, and the library does not contain it.
[ "$("$scratch/installed/own_formula")" = "$(cat "$source/examples/own_formula.expected.txt")" ] ||
  fail 'installed: the study printed something else'
symbols=$(nm --demangle "$(find "$scratch/moved/prefix" -name libBounding_arcs.a)")
grep -q 'convex_hull' <<< "$symbols" || fail 'the library has no symbols'
! grep -E 'stability_rows|search_report|CGAL::Bounding_arcs::study::' <<< "$symbols" ||
  fail 'the library contains studies'

# Without CMake, by what pkg-config tells: README's program as it is printed there, which prints what README says. This
# is the other compiler's turn.
block() { awk -v kind="$1" '/^```/ { if (on) exit; on = found && $0 == "```" kind; next } on
                            /^## A complete program/ { found = 1 }' "$source/README.md"; }
block cpp > "$scratch/readme.cpp"
tells() { PKG_CONFIG_PATH=$(dirname "$(find "$scratch/moved/prefix" -name bounding_arcs.pc)") pkg-config "$@"; }
echo 'consumer: pkg-config, the program in README.md'
for flag in -ffp-contract=off -DBOUNDING_ARCS_NO_CONTRACTION -frounding-math -lBounding_arcs; do
  grep -qe "$flag" <<< "$(tells --cflags --libs bounding_arcs)" || fail "pkg-config does not tell $flag"
done
# shellcheck disable=SC2046
quietly "$other" -std=c++17 "$scratch/readme.cpp" -o "$scratch/readme" $(tells --cflags --libs bounding_arcs_readers)
printed=$(sed -n '/^It prints/,/^This is/p' "$source/README.md" | sed -n '/^```$/,/^```$/p' | grep -v '^```$')
cp "$source/examples/data/d_rabbit.json" "$scratch"
[ "$(cd "$scratch" && ./readme)" = "$printed" ] ||
  fail 'the program in README.md prints something else'
# Programs of the manual's pages compile, as one source: each in a namespace of its own.
awk '
  FNR == 1 { in_code = 0 }
  /^```/ {
    if (in_code && text ~ /int main\(\)/) {
      includes = includes own
      programs = programs "namespace page_" ++count " {\n" text "}\n"
    }
    in_code = $0 == "```cpp"
    own = text = ""
    next
  }
  in_code && /^#include/ { own = own $0 "\n"; next }
  in_code { text = text $0 "\n" }
  END { printf "%s%s// %d programs\n", includes, programs, count }' "$source"/doc/*.md > "$scratch/pages.cpp"
[ "$(grep -c '^namespace page_' "$scratch/pages.cpp")" -ge 10 ] || fail 'pages have fewer programs'
# shellcheck disable=SC2046
quietly "$other" -std=c++17 -fsyntax-only -Wno-return-type "$scratch/pages.cpp" $(tells --cflags bounding_arcs)
echo '#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>' > "$scratch/reader.cpp"
grep -qe -lBounding_arcs_study <<< "$(tells --libs bounding_arcs_study)" || fail 'pkg-config does not tell the study'
# shellcheck disable=SC2046
quietly "$other" -std=c++17 -fsyntax-only "$scratch/reader.cpp" $(tells --cflags bounding_arcs_readers)
[ "$(tells --modversion bounding_arcs)" = "$("$scratch/moved/prefix/bin/bounding_arcs" --version | sed 's/.* //')" ] ||
  fail 'pkg-config tells another version'

# Where the laboratory was not installed that is said.
config=$package/Bounding_arcsConfig.cmake
cp "$config" "$scratch/config"
sed -i 's/^set(Bounding_arcs_study_FOUND TRUE)/set(Bounding_arcs_study_FOUND FALSE)/' "$config"
! cmake -S "$consumers/installed" -B "$scratch/refused_study" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_PREFIX_PATH="$scratch/moved/prefix" > "$scratch/log" 2>&1 || fail 'refused: a study was found'
grep -q 'without its component study' "$scratch/log" || { cat "$scratch/log"; fail 'refused: for another reason'; }
cp "$scratch/config" "$config"

# What the consumer has installed passes Bounding Arcs on.
quietly cmake --install "$scratch/installed" --prefix "$scratch/installed-prefix"
consume exported "-DCMAKE_PREFIX_PATH=$scratch/moved/prefix;$scratch/installed-prefix"

# Within another project nothing is installed but what that project installs. TBB is not looked for. The
# library is not compiled once more: it is made by the same CMakeLists.txt as in a build of its own.
for name in subdirectory fetch_content; do
  configure "$name" -DBOUNDING_ARCS_SOURCE="$source" -DCMAKE_OPTIMIZE_DEPENDENCIES=ON
  carries "$name" -ffp-contract=off
  ! grep '^TBB_DIR' "$scratch/$name/CMakeCache.txt" || fail "$name: TBB was sought though not asked for"
  ! grep '^BUILD_TESTING' "$scratch/$name/CMakeCache.txt" || fail "$name: tests were switched on or off"
  grep -qx 'BOUNDING_ARCS_INSTALL:BOOL=OFF' "$scratch/$name/CMakeCache.txt" || fail "$name: would be installed"
done
commands() {  # in any order, which is CMake's; some generators name files from the build directory on
  sed -n -e "s,$scratch/$1/$2,LIBRARY,g" -e "s, $2/, LIBRARY/,g" -e "s,$scratch/$1,CONSUMER,g" -e '/"command"/p' \
    "$scratch/$1/compile_commands.json" | sort
}
diff <(commands subdirectory bounding_arcs) <(commands fetch_content _deps/bounding_arcs-build) ||
  fail 'a subdirectory would be compiled otherwise than what is fetched'
quietly cmake --build "$scratch/fetch_content" --target consumer_regions
quietly cmake --install "$scratch/fetch_content" --prefix "$scratch/fetch_content-prefix"
[ ! -e "$scratch/fetch_content-prefix/include" ] || fail 'Bounding Arcs was installed though not asked for'
[ -e "$scratch/fetch_content-prefix/lib/cmake/Consumer_regions" ] ||
  fail 'the project above could not export its library'

# The package of that build would be without the readers. Such a package says so where they are asked for, and is found
# where they are not.
without='set(Bounding_arcs_readers_FOUND FALSE)'
grep -qxF "$without" "$(find "$scratch/fetch_content" -name Bounding_arcsConfig.cmake)" ||
  fail 'fetch_content: the package would have readers'
sed -i "s/^set(Bounding_arcs_readers_FOUND TRUE)/$without/" "$package/Bounding_arcsConfig.cmake"
! cmake -S "$consumers/installed" -B "$scratch/refused" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_PREFIX_PATH="$scratch/moved/prefix" > "$scratch/log" 2>&1 || fail 'refused: readers were found'
grep -q 'without its component readers' "$scratch/log" || { cat "$scratch/log"; fail 'refused: for another reason'; }
rm -r "$scratch/installed"
configure installed -DCMAKE_PREFIX_PATH="$scratch/moved/prefix" -DCONSUMER_READERS=OFF
