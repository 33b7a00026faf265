#!/usr/bin/env bash
# Usage: check_output.sh PROGRAM EXPECTED: runs the program and compares what it prints.
set -euo pipefail
"$1" | diff "$2" -
