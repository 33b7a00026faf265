#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Every message that the library, the readers and the tool throw or print as an error is in messages.txt, and says what
# was expected and what was found. Kinds of messages that need not say so are in that file, too, each with its reason.
# Usage: messages.sh [--fix]
#   --fix  writes the list again, and keeps the kinds
set -eu
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export LC_ALL=C.UTF-8
list=test/style/messages.txt
status=0

refuse() {
  [ -n "$2" ] || return 0
  printf '%s\n%s\n' "$1" "$2"
  status=1
}

mapfile -t sources < <(find include src/library src/study src/input src/tool -name '*.h' -o -name '*.cpp' | sort)
messages=$(awk -f test/style/messages.awk "${sources[@]}" | sort -u)
[ "$(wc -l <<< "$messages")" -gt 100 ] || { echo 'Hardly a message was found in the sources'; exit 1; }

# Kinds are the lines "! EXPRESSION # reason" on top of the list.
kinds=$(sed -n 's/^! \(.*\) # .*/\1/p' "$list")
[ "${1:-}" != --fix ] || printf '%s\n' "$(grep '^[#!]' "$list")" "$messages" > "$list"
refuse 'Kinds without a reason:' "$(grep '^!' "$list" | grep -vE '^! .+ # .{10}')"
refuse 'In the sources (>) or in the list (<) only; bash test/style/messages.sh --fix writes the list again:' \
  "$(diff <(grep -v '^[#!]' "$list" | sort -u) <(echo "$messages") | grep '^[<>]')"
refuse 'Messages that do not say what was expected and what was found:' \
  "$(grep -vE 'expected .*(found|not )' <<< "$messages" | grep -vE "${kinds//$'\n'/|}")"
refuse 'Kinds of which there is no message:' \
  "$(while IFS= read -r kind; do grep -qE "$kind" <<< "$messages" || echo "$kind"; done <<< "$kinds")"
exit $status
