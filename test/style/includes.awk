# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Names of this project that a file of src/ uses and that no header which it includes declares. Such a file compiles
# only beside one that includes the header, as it does in a unity build. What is looked at is words, so it takes half a
# second for all files: types and constants, functions where they are called, and all that is called by its namespace.
# A name that a file declares itself, as a variable or member, is taken to be that. Names of other libraries and
# members of classes are left to compilers (test/consumer/sources_alone.sh).
# Usage: awk -f includes.awk FILES
#   FILES  all headers and sources of include/ and src/, from the top-level directory

# A line without comments and literals.
function code_of(line) {
  gsub(/\\./, "", line)
  gsub(/"[^"]*"/, "", line)
  gsub(/'[^']'/, "", line)
  sub(/\/\/.*/, "", line)
  return line
}

# The path of the file that FILE includes by LINE; of no use for what is not of this project.
function included(file, line,    part, path, count, kept, i) {
  if (match(line, /<[^>]*>/)) return "include/" substr(line, RSTART + 1, RLENGTH - 2)
  match(line, /"[^"]*"/)
  path = substr(line, RSTART + 1, RLENGTH - 2)
  sub(/[^\/]*$/, "", file)
  if (!(file path in given) && "src/tool/" path in given) return "src/tool/" path  # which is on the include path
  count = split(file path, part, "/")
  for (i = 1; i <= count; ++i)
    if (part[i] == "..") --kept
    else part[++kept] = part[i]
  path = part[1]
  for (i = 2; i <= kept; ++i) path = path "/" part[i]
  return path
}

# The name that a line declares outside of all classes: such lines begin in the first column. A class that is only
# named there is not declared, as most uses need what is in it.
function declared(code) {
  while (sub(/^template *<[^<>]*(<[^<>]*(<[^<>]*>[^<>]*)*>[^<>]*)*> */, "", code)) {}
  gsub(/\[\[[a-z_]*\]\] */, "", code)
  if (code ~ /^(class|struct) +[A-Za-z_0-9]+;/) return ""
  if (code ~ /^(namespace|return|static_assert|extern|explicit|public|private)([^A-Za-z_0-9]|$)/) return ""
  if (match(code, /^(class|struct|enum|enum class|union|using) +[A-Za-z_0-9:]+/)) {
    code = substr(code, RSTART, RLENGTH)
    sub(/.*[ :]/, "", code)
    return code
  }
  if (!match(code, /[A-Za-z_][A-Za-z_0-9]*(\(| = |\{|\[)/)) return ""
  code = substr(code, RSTART, RLENGTH)
  sub(/[^A-Za-z_0-9].*/, "", code)
  return code ~ /^(decltype|noexcept|alignas|operator|sizeof|if|for|while)$/ ? "" : code
}

# What a line declares anywhere: types behind their keyword, variables and functions behind a type, and a word alone.
function note_local(code,    name, before, is_declared) {
  if (match(code, /^ *[A-Z_0-9]+,?$/)) { gsub(/[ ,]/, "", code); is_local[FILENAME, code] }
  while (match(code, /[A-Za-z0-9_>&*\]] +[&*]*[A-Za-z_][A-Za-z_0-9]*/)) {
    name = substr(code, RSTART + 1, RLENGTH - 1)
    sub(/^[ &*]+/, "", name)
    before = substr(code, 1, RSTART)
    if (name ~ /^[A-Z].*[a-z]/) is_declared = before ~ /(^|[^A-Za-z_0-9])(class|struct|enum|union|using|typename)$/
    else is_declared = before !~ /(^|[^A-Za-z_0-9])(return|new|else|case|throw)$/
    if (is_declared) is_local[FILENAME, name]
    code = substr(code, RSTART + RLENGTH - length(name))
  }
}

function visit(file,    list, count, i) {
  if (file in seen || !(file in given)) return
  seen[file]
  count = split(includes[file], list, "\n")
  for (i = 1; i < count; ++i) visit(list[i])
}

# Whether a use of a name, between what is before and behind it, is one of this project's.
function is_use(file, name, before, behind) {
  if (before ~ /::$/) return before ~ /(^|[^A-Za-z_0-9])(ba|internal|filter|Bounding_arcs)::$/
  if (before ~ /(\.|->)$/ || (file, name) in is_local || is_member(name)) return 0
  return name ~ /^[A-Z]/ || behind ~ /^ *[(<]/
}

# Whether a class that is seen may have a type of that name.
function is_member(name,    header) {
  if (name !~ /^[A-Z]/) return 0
  for (header in seen)
    if ((header, name) in is_local) return 1
  return 0
}

function check(file,    line, count, l, code, name, before, at, n, i, told) {
  split("", seen)
  visit(file)
  count = split(lines[file], line, "\n")
  for (l = 1; l <= count; ++l)
    for (code = line[l]; match(code, /[A-Za-z_][A-Za-z_0-9]*/);) {
      name = substr(code, RSTART, RLENGTH)
      before = before_name(line[l], code)
      code = substr(code, RSTART + RLENGTH)
      if (!(name in headers) || name in told || (file, name) in is_own || !is_use(file, name, before, code)) continue
      told[name] = 1
      n = split(headers[name], at, "\n")
      for (i = 1; i < n && !(at[i] in seen);) ++i
      if (i == n) print file ":" l ": " name ", which " at[1] " declares"
    }
}
# What of a line is before the name that REST has at RSTART.
function before_name(whole, rest) { return substr(whole, 1, length(whole) - length(rest) + RSTART - 1) }

BEGIN { for (i = 1; i < ARGC; ++i) given[ARGV[i]] }
/^#include/ { includes[FILENAME] = includes[FILENAME] included(FILENAME, $0) "\n" }
{
  code = /^#/ ? "" : code_of($0)
  lines[FILENAME] = lines[FILENAME] code "\n"
  note_local(code)
  name = /^#define/ ? $2 : code ~ /^[A-Za-z\[]/ ? declared(code) : ""
  sub(/\(.*/, "", name)
  if (name != "" && FILENAME ~ /\.h$/) headers[name] = headers[name] FILENAME "\n"
  else if (name != "") is_own[FILENAME, name]
}
END { for (i = 1; i < ARGC; ++i) if (ARGV[i] ~ /^src\//) check(ARGV[i]) }
