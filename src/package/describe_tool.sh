#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The tool's manual page, or the completion of its words for bash, made of what its --help says.
# Usage: describe_tool.sh man|completion TOOL
set -euo pipefail
form=$1 tool=$2

# The subcommands of a command, one a line.
subcommands() {
  "$tool" "$@" --help | awk '/^Subcommands:/ { on = 1; next } /^$/ { on = 0 } on && /^  [a-z]/ { print $1 }'
}

# All commands, "" first, those of two words behind their first.
commands=('')
while read -r command; do
  commands+=("$command")
  while read -r second; do [ -z "$second" ] || commands+=("$command $second"); done <<< "$(subcommands "$command")"
done <<< "$(subcommands)"

manual() {
  local about version command
  about=$("$tool" --help | head -1)
  version=$("$tool" --version)
  printf '.TH BOUNDING_ARCS 1 "" "%s" "User Commands"\n' "$version"
  printf '.SH NAME\nbounding_arcs \\- %s\n' "$(sed 's/^./\L&/; s/:.*//' <<< "$about")"
  for command in "${commands[@]}"; do
    # shellcheck disable=SC2086
    "$tool" $command --help | awk -v command="$command" '
      function text(line) {
        gsub(/\\/, "\\e", line)
        gsub(/-/, "\\-", line)
        if (line ~ /^[.\x27]/) line = "\\&" line
        return line
      }
      NR == 1 { about = $0; next }
      /^Usage: / {
        print command == "" ? ".SH SYNOPSIS" : ".SH BOUNDING_ARCS " toupper(command)
        print ".B " text(substr($0, 8))
        print command == "" ? ".SH DESCRIPTION" : ".P"
        print text(about)
        next
      }
      /^(Positionals|Options|Subcommands):$/ { print ".SS " substr($0, 1, length($0) - 1); listing = 1; next }
      /^$/ { if (listing) listing = 0; else if (raw) print ""; next }
      listing && /^  [^ ]/ {
        at = match($0, /[^ ]  +/)
        print ".TP\n.B " text(substr($0, 3, at ? RSTART - 2 : length($0)))
        if (at) print text(substr($0, RSTART + RLENGTH))
        next
      }
      listing { sub(/^ +/, ""); print text($0); next }
      !raw { print ".P\n.nf"; raw = 1 }
      { print text($0) }
      END { if (raw) print ".fi" }'
  done
}

completion() {
  cat << 'END'
# Completion of the words of bounding_arcs, for bash.
_bounding_arcs() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command= words= w
  for w in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case "$command $w" in
END
  local command
  for command in "${commands[@]:1}"; do
    case $command in
      *\ *) printf '      "%s") command="%s" ;;\n' "$command" "$command" ;;
      *) printf '      " %s") command=%s ;;\n' "$command" "$command" ;;
    esac
  done
  printf '    esac\n  done\n  case "$command $before" in\n'
  for command in "${commands[@]}"; do
    # shellcheck disable=SC2086
    "$tool" $command --help | sed -nE 's/^  (-o,)?(--[a-z-]+) TEXT[^{]*\{([a-z,-]+)\}.*/\2 \3/p' |
      while read -r option values; do
        printf '    "%s %s") words="%s" ;;\n' "$command" "$option" "${values//,/ }"
      done
  done
  printf '    *) case "$command" in\n'
  for command in "${commands[@]}"; do
    # shellcheck disable=SC2086
    words=$({ subcommands $command; "$tool" $command --help | sed -nE 's/^  (-[a-z],)?(--[a-z-]+).*/\2/p'; } |
      tr '\n' ' ')
    printf '      "%s") words="%s" ;;\n' "$command" "${words% }"
  done
  cat << 'END'
    esac ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -o default -F _bounding_arcs bounding_arcs
END
}

case $form in
  man) manual ;;
  completion) completion ;;
  *) exit 2 ;;
esac
