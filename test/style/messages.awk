# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Prints what sources throw or say on standard error, a line each: the file, ": " and the message, with … for what is
# put in. A statement counts that throws, fails, refuses or writes to std::cerr, or that makes a text of such a form:
# "expected …", "--option: …". Arguments are parted by ": ", those of expected(argument, what, found) by its words.

BEGIN {
  OPEN = "\001"; CLOSE = "\002"  # around what literals hold
  TEXT = OPEN "[^" CLOSE "]*expected |" OPEN "--[a-z-]+(, --[a-z-]+)*: |snprintf\\(text"
  STARTER = "(^|[^A-Za-z_0-9:.>])(throw |return (refuse|fail)\\(|[A-Za-z_.>-]*(fail|refuse|throw_invalid)\\(|" \
    "(ba::)?Input_error\\(|CLI::ValidationError\\(|tell\\(|std::cerr *<<|CGAL_precondition_msg\\()"
  # calls whose arguments are the message
  CALL = "^(std::(string|invalid_argument|logic_error|runtime_error|out_of_range)|(ba::)?Input_error|Svg_error|" \
    "CLI::ValidationError|CGAL_precondition_msg|snprintf|tell|[A-Za-z_.>-]*(fail|refuse|throw_invalid))\\("
}

FNR == 1 && NR > 1 { finish() }
FNR == 1 { file = FILENAME; text = "" }
{ text = text $0 "\n" }
END { finish() }

# Comments are left out, literals are marked, and what is between ";", "{" and "}" is looked at.
function finish(    statement, c) {
  while (match(text, /\/\/|\/\*|R"\(|["';{}]/)) {
    statement = statement substr(text, 1, RSTART - 1)
    c = substr(text, RSTART, RLENGTH)
    text = substr(text, RSTART + RLENGTH)
    if (c == "//") sub(/^[^\n]*/, "", text)
    else if (c == "/*") text = substr(text, index(text, "*/") + 2)
    else if (c == "R\"(") statement = statement literal(index(text, ")\"") - 1)
    else if (c == "\"") { match(text, /^([^"\\]|\\.)*/); statement = statement literal(RLENGTH) }
    else if (c == "'" && match(text, /^(\\[^']*|[^'\\])'/)) text = "0" substr(text, RLENGTH + 1)
    else if (c != "'") { look_at(statement); statement = "" }
  }
}
function literal(length_of,    found) {
  found = substr(text, 1, length_of)
  text = substr(text, length_of + 1)
  sub(/^\)?"/, "", text)
  gsub(/\\n/, "", found)
  gsub(/\\"/, "\"", found)
  return OPEN found CLOSE
}

function look_at(s,    message) {
  gsub(/[ \n]+/, " ", s)
  if (s ~ /^ ?#/ || index(s, OPEN) == 0) return
  gsub(CLOSE " ?" OPEN, "", s)  # literals next to each other are one
  s = with_words(s)
  if (match(s, STARTER)) s = substr(s, RSTART)
  else if (s !~ TEXT) return
  else if (match(s, /return |snprintf/)) s = substr(s, RSTART)
  message = shown(s)
  if (message ~ /[A-Za-z][A-Za-z]/) print file ": " message
}

# Puts the message in the place of the call that makes it: expected(argument, what, found), or without the first one
# or two of these, which others know; Usage_error(argument, what, found); check_above_zero(argument, number).
function with_words(s,    is_number, n, part, message) {
  while (match(s, /(^|[^A-Za-z_0-9>])(expected|Usage_error|check_above_zero)\(/)) {
    is_number = substr(s, RSTART, RLENGTH) ~ /check/
    rest = substr(s, RSTART + RLENGTH)
    s = substr(s, 1, RSTART + RLENGTH - 1)
    sub(/(expected|Usage_error|check_above_zero)\($/, "", s)
    n = 0
    do part[++n] = next_argument(); while (!is_last && rest != "")
    if (is_number) message = part[1] ": expected a number above 0, found …"
    else if (n == 1) message = "expected " part[1] ", found …"
    else message = (n > 2 ? part[1] ": " : "") "expected " part[n - 1] ", found " part[n]
    s = s OPEN message CLOSE rest
  }
  return s
}
# Takes an argument off the rest, and shows it.
function next_argument(    argument) {
  argument = taken(rest)
  is_last = substr(rest, length_taken + 1, 1) == ")"
  rest = substr(rest, length_taken + 2)
  return shown(argument)
}

# The text up to the "," or ")" that ends an argument; its length is length_taken.
function taken(s,    i, c, depth) {
  depth = 0
  for (i = 1; i <= length(s); ++i) {
    c = substr(s, i, 1)
    if (c == OPEN) i += index(substr(s, i), CLOSE) - 1
    else if (c == "(" || c == "[") ++depth
    else if (depth == 0 && (c == "," || c == ")")) break
    else if (c == ")" || c == "]") --depth
  }
  length_taken = i - 1
  return substr(s, 1, length_taken)
}

# Literals as they are, and … for all else; " / " is between those of which one is taken.
function shown(s,    result, c, n) {
  result = ""
  sub("^[^A-Za-z_" OPEN "]*(throw |return )?", "", s)
  while (s != "") {
    c = substr(s, 1, 1)
    if (c == OPEN) {
      n = index(s, CLOSE)
      result = result substr(s, 2, n - 2)
      s = substr(s, n + 1)
    } else if (c == ",") {
      result = result ": "
      s = substr(s, 2)
    } else if (match(s, CALL) || match(s, /^std::cerr *<< */)) {
      s = substr(s, RLENGTH + 1)
    } else if (match(s, /^[A-Za-z_0-9][A-Za-z_0-9:.]*/)) {
      s = without_arguments(substr(s, RLENGTH + 1))
      result = result "…"
    } else {
      if (s ~ /^: / && result ~ /[^… ]$/) result = result " / "
      s = substr(s, 2)
    }
  }
  gsub(/…(…)+/, "…", result)
  gsub(/^[ :]+|[ :]+$/, "", result)
  return result
}
# What is behind the arguments of a call.
function without_arguments(s,    c) {
  while (s ~ /^(\(|\[)/) {
    c = ","
    for (s = substr(s, 2); c == ","; s = substr(s, length_taken + 2)) {
      taken(s)
      c = substr(s, length_taken + 1, 1)
    }
  }
  return s
}
