#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fuzzes the readers and what is made of curves, with Clang's libFuzzer under sanitizers: two targets at a time, each
# from its seeds and past findings.
# Usage: run.sh [--seed NUMBER] [SECONDS [TARGETS]]
#   --seed   goes the same way at each run, until sources change; another way without it
#   SECONDS  of a processor, for all targets together; 120 without it
#   TARGETS  some of those in targets.h; all without it
# What is found stays in build/fuzz-findings/, as a file to put into test/fuzz/findings/ when it is mended.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
seed=0  # one that the fuzzer chooses
if [ "${1:-}" = --seed ]; then
  seed=$2
  shift 2
fi
seconds=${1:-120}
[ $# -eq 0 ] || shift
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=(json svg dxf stream build arcs query offset medial_axis)
if ! clang++ -fsanitize=fuzzer,address -x c++ -o /dev/null - 2> /dev/null \
    <<< 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }'; then
  echo 'test/fuzz/run.sh: left out: there is no Clang with libFuzzer'
  exit 0
fi
bash test/run.sh --plain --sanitize --fuzz
fuzzer=$PWD/build/plain/sanitize/test/fuzz
corpora=$(mktemp -d)
trap 'rm -rf "$corpora"' EXIT
mkdir -p build/fuzz-findings
for target in "${targets[@]}"; do
  mkdir "$corpora/$target"
  find test/fuzz/seeds test/fuzz/findings -name "$target-*" -exec cp {} "$corpora/$target" \;
done
# One target on its corpus; the last lines of what it says, all where it has found something.
fuzz() {
  local log=$3/$1.log
  if FUZZ_TARGET=$1 "$fuzzer" "$3/$1" -max_total_time="$2" -seed="$seed" -timeout=20 -rss_limit_mb=1500 -max_len=4096 \
    -artifact_prefix="build/fuzz-findings/$1-" > "$log" 2>&1; then
    echo "$1: $(grep -c '' <(find "$3/$1" -type f)) inputs, $(tail -n 1 "$log")"
  else
    cat "$log"
    echo "$1: FAILED"
    return 1
  fi
}
export -f fuzz
# what is freed is soon used again, so that the limit is for what targets take
export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=0:quarantine_size_mb=32
export fuzzer seed UBSAN_OPTIONS=print_stacktrace=1
each=$(((seconds + ${#targets[@]} - 1) / ${#targets[@]}))
printf '%s\n' "${targets[@]}" | xargs -P 2 -I TARGET bash -c 'fuzz TARGET "$1" "$2"' fuzz "$each" "$corpora"
