#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Unpacks CGAL's headers of another Debian suite into a directory: nothing is installed, and apt's lists, packages and
# settings stay as they are. Mirrors are the system's own; signatures are verified, as apt always does.
# Usage: fetch_cgal.sh SUITE DIRECTORY
# Prints the directory to give as CGAL_DIR. Status: 0, or 77 where the package cannot be had, which is said on stderr.
set -euo pipefail
suite=$1
mkdir -p "$2"
directory=$(realpath "$2")
unpacked=$directory/unpacked

give_up() {
  echo "CGAL of Debian's $suite cannot be had: $*" >&2
  exit 77
}

if [ ! -e "$unpacked" ]; then
  for command in apt-get dpkg-deb; do command -v $command > /dev/null || give_up "there is no $command"; done
  codename=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
  keys=/usr/share/keyrings/debian-archive-keyring.gpg
  [ -e $keys ] || give_up "there is no $keys"
  # Where the system has its own suite from, whether its lists have been fetched or not.
  apt-get update --print-uris | sed -n "s,^'\(.*\)/dists/$codename/InRelease'.*,\1,p" | sort -u |
    while read -r mirror; do echo "deb [signed-by=$keys] $mirror $suite main"; done > "$directory/sources.list"
  [ -s "$directory/sources.list" ] || give_up "apt has no sources of ${codename:-this system}"
  mkdir -p "$directory/lists/partial" "$directory/cache/archives/partial"
  apt() {
    (cd "$directory" && apt-get -qq -o Dir::Etc::sourcelist="$directory/sources.list" \
      -o Dir::Etc::sourceparts=/dev/null -o Dir::Etc::preferences=/dev/null -o Dir::Etc::preferencesparts=/dev/null \
      -o Dir::State::lists="$directory/lists" -o Dir::Cache="$directory/cache" -o APT::Sandbox::User= \
      -o APT::Update::Error-Mode=any -o Acquire::Languages=none -o Acquire::Retries=1 -o Acquire::http::Timeout=20 \
      "$@" > log 2>&1) || { cat "$directory/log" >&2; give_up "apt-get $*"; }
  }
  apt update
  rm -f "$directory"/libcgal-dev_*.deb
  apt download libcgal-dev
  rm -rf "$directory/lists" "$directory/cache" "$directory/part"
  dpkg-deb -x "$directory"/libcgal-dev_*.deb "$directory/part"
  mv "$directory/part" "$unpacked"
fi
dirname "$(find "$unpacked" -name CGALConfig.cmake)"
