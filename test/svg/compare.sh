#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Holds the reader of SVG files against a browser's: every element that is drawn has the same subpaths of the same
# pieces in the same places, and the picture of all curves is that of the file. Prints for each file the numbers of
# elements, subpaths and pieces, and of pixels with ink in a picture 1000 pixels wide.
# Usage: compare.sh SVG_OUTLINES FILES
#   SVG_OUTLINES  what prints the reader's curves, test/svg_outlines in the build directory
# Status: 0, or 1 if anything differs, or 77 where Chromium is not there.
set -euo pipefail
export LC_ALL=C.UTF-8
parts=$(dirname "${BASH_SOURCE[0]}")
outlines=$1
shift
browser=$(command -v chromium || command -v chromium-browser) || { echo 'no chromium: nothing was compared'; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$outlines" "$@" > "$scratch/curves"
{
  printf '<!DOCTYPE html><meta charset="utf-8"><div id="host" style="width: 300px; height: 150px"></div>'
  printf '<pre id="log"></pre><script>\nconst drawings = [\n'
  for file in "$@"; do
    IFS= read -r curves <&3
    printf '{text: "%s", ...%s},\n' "$(base64 -w0 "$file")" "${curves//<\//<\\/}"
  done 3< "$scratch/curves"
  printf '];\n'
  cat "$parts"/{geometry,outline,expand,picture,compare}.js
  printf '</script>\n'
} > "$scratch/page.html"
timeout -k 1 300 "$browser" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --lang=en-US \
  --disable-background-networking --disable-component-update --disable-sync --user-data-dir="$scratch/profile" \
  --window-size=1200,900 --virtual-time-budget=1000000 --dump-dom "file://$scratch/page.html" \
  > "$scratch/dom" 2> "$scratch/err" < /dev/null || { cat "$scratch/err"; exit 1; }
sed -n '/<pre id="log">/,/^end$/{s/.*<pre id="log">//;s/&lt;/</g;s/&gt;/>/g;s/&amp;/\&/g;p}' "$scratch/dom" \
  > "$scratch/log"
sed '/^end$/d' "$scratch/log"
[ "$(grep -c '^compared: ' "$scratch/log")" -eq $# ] && [ "$(wc -l < "$scratch/log")" -eq $(($# + 1)) ] &&
  grep -qx end "$scratch/log"
