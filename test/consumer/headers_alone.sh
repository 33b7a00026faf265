#!/usr/bin/env bash
# Usage: headers_alone.sh COMPILER INCLUDE_DIRECTORY
# Each header that CGAL/Bounding_arcs_2.h names, and each that it does not reach, compiles by itself: it includes what
# it uses. In all others the test of style looks at each name (test/style/includes.awk), as it does in sources. They are
# compiled in chains, each header behind one that it includes anyway, so that it sees what it includes and nothing else;
# by themselves all of them would take six times as long. As many chains at a time as there are cores.
set -euo pipefail
cd "$2"
export compiler=$1 options='-std=c++17 -frounding-math -Werror -I .'
# Headers that take long to read and that many others include: they are read once for all of these. Each stands before
# those that it includes.
bases='tree/Bounding_arc_tree_2.h query/Query_point.h
  spiral/Bezier_spiral_2.h region/thickness_bound.h number/Root_number.h
  number/Mpfr_interval.h number/Exact_number.h number/convert.h number/number_types.h
  region/variant.h arc/Arc_2.h curve/Drawing_2.h curve/served_range.h
  curve/Bezier_curve_2.h'
bases=$(printf 'CGAL/Bounding_arcs_2/%s ' $bases)
bases=${bases% }
export bases
scratch=$(mktemp -d)
export scratch
trap 'rm -rf "$scratch"' EXIT
headers=$(find CGAL -name '*.h' -not -path '*/internal/*' | LC_ALL=C sort)

awk -F '[<>]' '/^#include <CGAL\/Bounding_arcs_2\// { print FILENAME, $2 }' $headers | tsort > /dev/null ||
  { echo 'the headers above include each other'; exit 1; }

# A chain a line, those that include the most first; with below=1 a line for each base.
chains() {
  awk -F '[<>]' '
    FNR == 1 { headers[++count] = FILENAME; is_code = 0 }
    /^namespace/ { is_code = 1 }  # what is included below it is not seen by what is above
    /^#include <CGAL\/Bounding_arcs_2\// && !is_code { includes[FILENAME] = includes[FILENAME] " " $2 }
    # Notes that a header includes what another one does, at any depth.
    function note(header, other,   list, i, n) {
      n = split(includes[other], list, " ")
      for (i = 1; i <= n; ++i)
        if (list[i] != header && !((header, list[i]) in sees)) {
          sees[header, list[i]] = 1
          ++seen[header]
          note(header, list[i])
        }
    }
    END {
      for (i = 1; i <= count; ++i) note(headers[i], headers[i])
      n_bases = split(ENVIRON["bases"], bases, " ")
      for (i = 1; i <= count; ++i) {
        above[headers[i]] = "-"
        for (k = n_bases; k >= 1; --k)
          if (headers[i] == bases[k] || (headers[i], bases[k]) in sees) above[headers[i]] = bases[k]
      }
      if (ENVIRON["below"]) {  # a line for each base, from the last on: the base that it is read behind
        for (i = n_bases; i >= 1; --i) {
          behind = "-"
          for (k = n_bases; k > i; --k)
            if ((bases[i], bases[k]) in sees) behind = bases[k]
          print behind, bases[i]
        }
        exit
      }
      for (size = 0; size <= count; ++size)
        for (i = 1; i <= count; ++i) {
          if (seen[headers[i]] + 0 != size) continue
          best = 0
          for (k = 1; k <= n; ++k)
            if ((headers[i], last[k]) in sees && above[headers[i]] == above[last[k]] &&
                (best == 0 || seen[last[k]] > seen[last[best]])) best = k
          if (best == 0) best = ++n
          chain[best] = chain[best] " " headers[i]
          last[best] = headers[i]
        }
      for (size = count; size >= 0; --size)
        for (k = 1; k <= n; ++k)
          if (seen[last[k]] + 0 == size) print above[last[k]] chain[k]
    }' $headers
}
# Usage: check BASE HEADERS; BASE is the first of the bases that they include, - if there is none.
check() {
  local before=()
  [ "$1" = - ] || before=(-include "$scratch/$1")
  shift
  printf '#include <%s>\n' "$@" | "$compiler" $options -fsyntax-only "${before[@]}" -x c++ - ||
    { echo "does not compile alone, this or one before it: ${*: -1}"; return 1; }
}
export -f check

all=$(chains)
in_chains=$(cut -d ' ' -f 2- <<< "$all" | tr -s ' ' '\n' | sed '/^$/d' | LC_ALL=C sort)
[ "$in_chains" = "$headers" ] || { echo 'a header is in no chain'; exit 1; }
# Clang reads a base behind another one, and instantiates templates where they are read once, instead of in each header
# that includes them.
at_once= is_clang=
[[ $("$compiler" --version) != *clang* ]] || is_clang=1 at_once=-fpch-instantiate-templates
below=1 chains | while read -r behind base; do
  mkdir -p "$(dirname "$scratch/$base")"
  echo "#include <$base>" > "$scratch/$base"
  before=()
  [ -z "$is_clang" ] || [ "$behind" = - ] || before=(-include "$scratch/$behind")
  "$compiler" $options $at_once "${before[@]}" -x c++-header "$scratch/$base" -o "$scratch/$base.gch"
done
reached=$("$compiler" $options -MM -x c++ CGAL/Bounding_arcs_2.h | tr -s ' \\' '\n')
named=$(sed -n 's/^#include <\(.*\)>/\1/p' CGAL/Bounding_arcs_2.h)
awk -v reached="$reached" -v named="$named" '
  BEGIN {
    for (n = split(reached, list); n > 0; --n) is_left_out[list[n]] = 1
    for (n = split(named, list); n > 0; --n) delete is_left_out[list[n]]
  }
  {
    line = $1
    for (i = 2; i <= NF; ++i) if (!($i in is_left_out)) line = line " " $i
    if (line != $1) print line
  }' <<< "$all" | xargs -P "$(nproc)" -L 1 bash -c 'check "$@"' check
