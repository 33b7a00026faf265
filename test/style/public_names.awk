# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What users can name: types and functions that headers at the tops of rooms declare, outside of classes and of the
# namespaces internal and filter. A line each: the room, what it is, its name. Overloads are one function, and so are
# specialisations of a class.
# Usage: awk -f public_names.awk HEADERS | sort -u

FNR == 1 {
  depth = 0
  room = FILENAME
  sub(/.*Bounding_arcs_2\//, "", room)
  sub(/\/.*/, "", room)
}
/^namespace / && /\{$/ { hidden[++depth] = (depth > 1 && hidden[depth - 1]) || $2 ~ /internal|filter/; next }
/^\}  \/\/ namespace/ { --depth; next }
depth == 0 || hidden[depth] || !/^[A-Za-z[]/ { next }
{
  code = $0
  sub(/ *\/\/.*/, "", code)
  while (sub(/^template *<[^<>]*(<[^<>]*(<[^<>]*>[^<>]*)*>[^<>]*)*> */, "", code)) {}
  gsub(/\[\[[a-z_]*\]\] */, "", code)
  if (code ~ /^(template|extern|friend|static_assert|struct [A-Za-z_0-9]+;|class [A-Za-z_0-9]+;)/) next
  if (match(code, /^(class|struct|enum|enum class) +[A-Za-z_0-9]+/)) {
    name = substr(code, RSTART, RLENGTH)
    if (substr(code, RLENGTH + 1, 1) == "<") next  # a specialisation
    sub(/.* /, "", name)
    print room, "type", name
  } else if (match(code, /^using +[A-Za-z_0-9]+ +=/)) {
    split(code, word, " ")
    print room, "type", word[2]
  } else if (match(code, /[A-Za-z_0-9:]+\(/)) {
    name = substr(code, RSTART, RLENGTH - 1)
    before = substr(code, 1, RSTART - 1)
    if (before !~ / $/ || before ~ /=/ || name ~ /::|^(operator|decltype|noexcept|alignas)/) next
    print room, "function", name
  }
}
