# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What Doxygen reads instead of the sources, so that these stay as people read them.
# Usage: awk -f doc/manual.awk FILE, from the top directory of the repository
#
# Headers: the comment on top describes the file, and what is in a folder is a group. Comments of classes and functions
# are those that Doxygen reads, right above these.
# Programs of examples: their comment on top, and below it, by Doxygen, the program and what it prints.
# Pages: a heading is an anchor under the name that links have for it on a web page; links to files become references to
# what the manual has of them, or mere text; names of classes in code are links; a comment `<!-- \command ... -->` is
# that command.

{ line[NR] = $0 }

END {
  name = FILENAME
  sub(/.*\//, "", name)
  if (name ~ /\.md$/) page()
  else if (name ~ /\.cpp$/) example()
  else if (name ~ /\.h$/) header()
  else while (++i <= NR) print line[i]
}

# Plain text, in which Doxygen would see marks.
function escaped(text) {
  gsub(/[<>&#*\\@]/, "\\\\&", text)
  return text
}

# Sets `first` and `last`, the lines of the comment on top; three of the licence and an empty one are above it.
function find_comment() {
  first = 5
  for (last = first; line[last + 1] ~ /^\/\//;) ++last
}

# Sets scope_of[X] of each class X that is directly in a namespace.
function find_classes(    command, text, scope) {
  command = "find include -name '*.h' -not -path '*/internal/*' | sort | " \
            "xargs grep -hE '^(namespace .* \\{$|\\}  // namespace|(template <.*> )?(class|struct) [A-Z])'"
  while ((command | getline text) > 0) {
    if (text ~ /^namespace/) {
      text = substr(text, 11, length(text) - 12) "::"
      scope = text ~ /^CGAL/ ? text : scope text
    } else if (text ~ /^\}/) {
      sub(/[A-Za-z_]+::$/, "", scope)
    } else {
      sub(/^(template <.*> )?(class|struct) /, "", text)
      sub(/[^A-Za-z0-9_].*/, "", text)
      if (!(text in scope_of) && scope !~ /internal/) scope_of[text] = scope
    }
  }
  close(command)
}

function example(    i) {
  find_comment()
  print "/** \\example " name "\n\\details"
  for (i = first; i <= last; ++i) print escaped(substr(line[i], 4))
  sub(/cpp$/, "expected.txt", name)
  print "\n\\par It prints\n\\verbinclude " name "\n*/"
}

# ---- Headers ----

# Folders are groups, but traits have one of their own, and so has what reads files.
function group_of(    folder) {
  if (name ~ /traits_2\.h$/) return "traits"
  if (name == "Curve_file.h") return "readers"
  folder = FILENAME
  if (!sub(/.*\/Bounding_arcs_2\//, "", folder)) return folder ~ /concepts\// ? "concepts" : "library"
  sub(/\/.*/, "", folder)
  return folder
}

# The comment on top as one for Doxygen; what is set in, formulas and pictures, keeps its shape.
function describe_top(    i, text, is_set) {
  for (i = first; i <= last; ++i) {
    text = substr(line[i], 3)
    if (!is_set && text ~ /^   /) {
      is_set = 1
      line[i - 1] = (line[i - 1] == "///" ? "" : line[i - 1] "\n") "/// ~~~{.unparsed}"
    } else if (is_set && text !~ /^(  |$)/) {
      is_set = 0
      line[i - 1] = line[i - 1] "\n/// ~~~\n///"
    }
    line[i] = "///" (is_set ? text : escaped(text))
  }
  if (is_set) line[last] = line[last] "\n/// ~~~"
}

function header(    i, group) {
  find_comment()
  group = group_of()
  line[3] = "/// \\file"
  line[4] = "/// \\ingroup " group
  describe_top()
  for (i = last + 1; i <= NR; ++i) {
    if (line[i] ~ /^namespace CGAL::Bounding_arcs.*\{$/)
      line[i] = line[i] " /** \\addtogroup " group " */ /** @{ */"
    else if (line[i] ~ /^\}  \/\/ namespace CGAL::Bounding_arcs/) line[i] = "/** @} */ " line[i]
  }
  if (group == "concepts") find_classes()  # which these do not see, being in no namespace
  for (i = 1; i <= NR; ++i) print group == "concepts" ? classes_linked(line[i]) : line[i]
}

# A line whose comment links the names of classes.
function classes_linked(text,    result, word) {
  if (!match(text, /\/\/\//)) return text
  result = substr(text, 1, RSTART + 2)
  text = substr(text, RSTART + 3)
  while (match(text, /[A-Za-z0-9_]+/)) {
    word = substr(text, RSTART, RLENGTH)
    result = result substr(text, 1, RSTART - 1) (word in scope_of ? "@ref " scope_of[word] word " \"" word "\"" : word)
    text = substr(text, RSTART + RLENGTH)
  }
  return result text
}

# ---- Pages ----

# The name of a heading in links, that of web pages of repositories.
function slug(text) {
  text = tolower(text)
  gsub(/[][`(),.:;'"\/*+=!?]/, "", text)
  gsub(/ /, "-", text)
  return text
}

function page_name(path) {
  sub(/.*\//, "", path)
  sub(/\.md$/, "", path)
  return "page_" tolower(path)
}

# A link for Doxygen.
function reference(text, target, command,    anchor) {
  gsub(/\n/, " ", text)
  if (target ~ /^[a-z]+:/) return "[" text "](" target ")"
  if (match(target, /#/)) {
    anchor = "--" substr(target, RSTART + 1)
    target = substr(target, 1, RSTART - 1)
  }
  if (target == "") target = FILENAME
  if (target ~ /\.md$/ && target !~ /data\//)
    return (anchor == "" ? command : "@ref ") page_name(target) anchor " \"" text "\""
  if (target !~ /(examples\/.*\.cpp|concepts\/.*\.h|include\/.*\.h)$/ || target ~ /internal/) return text
  if (target ~ /concepts/) sub(/\.h$/, "", target)
  sub(/.*(examples|include|concepts)\//, "", target)
  gsub(/`/, "", text)
  return "@ref " target " \"" text "\""
}

# Text outside of code blocks, with its links.
function linked(text,    result, link, middle) {
  while (match(text, /!?\[[^]]*\]\([^) ]*\)/)) {
    link = substr(text, RSTART, RLENGTH)
    result = result substr(text, 1, RSTART - 1)
    text = substr(text, RSTART + RLENGTH)
    middle = index(link, "](")
    if (link ~ /^!/) sub(/\([^)]*\//, "(", link)
    else link = reference(substr(link, 2, middle - 2), substr(link, middle + 2, length(link) - middle - 2),
                          is_contents && result ~ /\n\* $/ ? "@subpage " : "@ref ")
    result = result link
  }
  return result text
}

# Code spans: classes are links, and double marks let Doxygen read past apostrophes.
function spans(text,    result, code, word, stem) {
  while (match(text, /`[^`]+`/)) {
    result = result substr(text, 1, RSTART - 1)
    code = substr(text, RSTART + 1, RLENGTH - 2)
    text = substr(text, RSTART + RLENGTH)
    word = match(code, /^([a-z]+::)?[A-Z][A-Za-z0-9_]*(::[A-Za-z0-9_]+)*/) ? substr(code, 1, RLENGTH) : ""
    stem = word
    sub(/^[a-z]+::/, "", stem)
    sub(/::.*/, "", stem)
    if (stem in scope_of) {
      result = result "<code>@ref " scope_of[stem] stem " \"" word "\"</code>"
      code = substr(code, length(word) + 1)
    }
    if (code != "") result = result "``" code "``"
  }
  return result text
}

# Prints the lines begin, ..., end - 1, which are no code.
function prose(begin, end,    i, text, title, marks) {
  for (i = begin; i < end; ++i) {
    if (match(line[i], /^#+ /)) {
      marks = RLENGTH
      title = substr(line[i], marks + 1)
      line[i] = line[i] " {#" page_name(FILENAME) (marks == 2 ? "" : "--" slug(title)) "}"
    } else if (line[i] ~ /^<!-- \\.* -->$/) {
      line[i] = substr(line[i], 6, length(line[i]) - 9)
    }
    text = text line[i] "\n"
  }
  printf "%s", spans(linked(text))
}

function page(    i, begin, fenced) {
  find_classes()
  is_contents = name == "index.md"  # the order of its links is that of the pages
  if (name == "README.md") line[1] = "# README"
  begin = 1
  for (i = 1; i <= NR; ++i) {
    if (!fenced && line[i] ~ /^(```|    )/) prose(begin, i)
    if (line[i] ~ /^```/) fenced = !fenced
    else if (!fenced && line[i] !~ /^    /) continue
    if (i >= begin) print line[i]
    begin = i + 1
  }
  prose(begin, NR + 1)
}
