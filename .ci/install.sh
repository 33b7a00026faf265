#!/usr/bin/env bash
# Installs the Debian packages that are missing: those that building needs (packages_build.txt, which README names, too)
# and those of the lists named, such as packages.txt, which has what the tests need beside.
set -euo pipefail
packages=$(cat "$(dirname "${BASH_SOURCE[0]}")/packages_build.txt" "$@")
missing=()
while read -r package; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done <<< "$packages"
[ ${#missing[@]} -eq 0 ] && exit 0
echo "Installing: ${missing[*]}"
as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
"${as_root[@]}" apt-get update -q
DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -q --no-install-recommends "${missing[@]}"
