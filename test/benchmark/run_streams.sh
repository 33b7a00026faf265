#!/bin/bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A long stream, as doc/streams.md tells of it: memory while it runs, then the same records by GNU parallel whose
# workers are killed, and by Open MPI where a rank is; and speed beside the library's own. Fails unless all results are
# those of one process, byte for byte, and memory stays what it was.
# Usage: run_streams.sh [--install] NUMBER SCALE DRAWING...
#   --install  installs GNU parallel and Open MPI first; what is not installed is left out
#   NUMBER     of records, outlines of the drawings again and again; 10^6 of glyphs are 1 GB, and their arcs 14 GB
#   SCALE      of the drawings, so that arcs within 1 are wanted: an em to 1000
# In the folder WORK, or a new one in TMPDIR that is removed: records, and results of MPI. BUILD_DIR has the programs,
# if they are there already.
set -euo pipefail
root="$(cd "$(dirname "$0")/../.." && pwd)"
if [ "${1:-}" = --install ]; then
  shift
  bash "$root/.ci/install.sh" "$root/test/benchmark/packages_streams.txt"
fi
[ $# -ge 3 ] || { sed -n 's/^# Usage: /usage: /p' "$0" >&2; exit 2; }
number=$1
build="${BUILD_DIR:-$root/build/benchmark}"
if [ -z "${BUILD_DIR:-}" ]; then
  bash "$root/.ci/install.sh" "$root/.ci/packages_benchmark.txt"
  cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DBOUNDING_ARCS_BENCHMARKS=ON -DBOUNDING_ARCS_EXAMPLES=OFF \
    > /dev/null
  cmake --build "$build" --parallel "$(nproc)" --target bounding_arcs glyph_records stream_library > /dev/null
fi
tool=$(readlink -f "$build/src/tool/bounding_arcs")
export tool PARALLEL_SHELL=/bin/bash TIMEFORMAT='  %U s of processor time, %R s'
if [ -z "${WORK:-}" ]; then
  WORK=$(mktemp -d)
  trap 'rm -rf "$WORK"' EXIT
fi
mkdir -p "$WORK/workers"
"$build/test/benchmark/glyph_records" "$number" "${@:2}" > "$WORK/records"
cd "$WORK"
head -n $((number / 10)) records > tenth
echo "$number records, $(stat -c %s records) bytes"

# as_worker ARGUMENTS: answers under a process id that is known.
as_worker() {
  : > "workers/$BASHPID"
  exec "$tool" arcs --eps 1 --stream "$@"
}
export -f as_worker

# kill_some TIMES SECONDS: kills the worker that began last, each so many seconds.
kill_some() {
  : > killed
  for ((i = 0; i < $1; ++i)); do
    sleep "$2"
    worker=$(find workers -type f -printf '%T@ %f\n' | sort -n | tail -n 1 | cut -d ' ' -f 2)
    [ "$(readlink "/proc/$worker/exe")" = "$tool" ] && kill -9 "$worker" && echo "$worker" >> killed
  done 2> /dev/null || true
}

# expect_sum WHAT FILE  of results on standard input, which have the sum in the file
expect_sum() {
  [ "$(sha256sum)" = "$(cat "$2")" ] || { echo "$1: not the results of one process" >&2; exit 1; }
  echo "$1: the results of one process"
}

# one_process RECORDS JOBS  leaves the sum of the results in the file sum, and tells memory. With several threads up to
# 4 MiB of results wait for those of a thread that gets no processor, and one has up to 4 MiB of them itself.
one_process() {
  mkfifo results
  sha256sum < results > sum & sums=$!
  "$tool" arcs --eps 1 --stream --jobs "$2" "$1" > results & stream=$!
  while sed -n 's/^VmRSS:[^0-9]*\([0-9]*\).*/\1/p' "/proc/$stream/status" 2> /dev/null | grep .; do sleep 0.5; done \
    > memory
  wait $stream $sums
  rm results
  awk -v jobs="$2" '{ all[NR] = $1 }
    END { for (i = 1; i <= NR; ++i) { part = int(4 * (i - 1) / NR); if (all[i] > most[part]) most[part] = all[i] }
          printf "  most memory in the quarters of the time: %d, %d, %d, %d kB\n", most[0], most[1], most[2], most[3]
          if (most[3] > 1.1 * most[0] + 1024 + 8192 * (jobs - 1)) { print "memory grows"; exit 1 } }' memory
}

# by_parallel RECORDS SUM KILLS HOW...  with so many workers killed at most
by_parallel() {
  kill_some "$3" "$(awk -v n="$(wc -l < "$1")" 'BEGIN { print n < 300000 ? 2 : n / 150000 }')" & killer=$!
  time parallel "${@:4}" --keep-order --block 1M --retries 9 --joblog log as_worker - < "$1" 2> said |
    expect_sum "parallel ${*:4}" "$2"
  kill $killer 2> /dev/null || true
  wait $killer || true
  echo "  workers: $(($(wc -l < log) - 1)), killed: $(wc -l < killed)"
  rm -f workers/*
}

echo 'one process:'
time one_process records 1
cp sum sum.records
echo 'one thread and two, a tenth of the records:'
time one_process tenth 1
cp sum sum.tenth
time one_process tenth 2
cmp sum sum.tenth
if parallel --version 2> /dev/null | grep -q GNU; then
  by_parallel records sum.records 20 --pipe
  # It gives nothing to a worker that it tries again with --pipepart (GNU parallel 20221122): doc/streams.md
  by_parallel tenth sum.tenth 0 --pipepart -a tenth
fi
if command -v mpirun > /dev/null; then
  split -n l/4 -d -a 2 records part.
  ranks() {
    # shellcheck disable=SC2016
    mpirun -n 4 --oversubscribe --allow-run-as-root bash -c 'n=$(printf %02d "$OMPI_COMM_WORLD_RANK")
      [ -e result.$n ] || as_worker part.$n -o result.$n'
  }
  kill_some 1 "$(awk -v n="$number" 'BEGIN { print n < 100000 ? 1 : n / 100000 }')" & killer=$!
  ranks 2> said || echo "Open MPI: a rank was killed, and $(find . -name 'result.*' | wc -l) of 4 results are there"
  wait $killer
  time ranks
  cat result.?? | expect_sum 'Open MPI' sum.records
  rm result.?? part.??
fi

# The best of three runs in turn, as other programs disturb all of them: the library's arcs and regions in memory,
# those written by a program that calls the library, and the stream.
echo 'speed, of 20000 records, seconds of processor time:'
head -n 20000 records > first
library=$build/test/benchmark/stream_library
seconds() { { TIMEFORMAT=%U; time "$@" < first > /dev/null 2> /dev/null; } 2>&1; }
for what in arcs bca sfa bilens; do
  command=(arcs)
  [ $what = arcs ] || command=(build --method $what)
  for _ in 1 2 3; do
    echo "$(seconds "$library" $what 1) $(seconds "$library" $what 1 --print)" \
      "$(seconds "$tool" "${command[@]}" --eps 1 --stream -)"
  done | awk -v what=$what '
    { for (i = 1; i <= 3; ++i) if (NR == 1 || $i < least[i]) least[i] = $i }
    END { printf "  %-6s library %.2f, written %.2f, stream %.2f: %.0f %% of memory, %.0f %% of text\n", what, least[1],
          least[2], least[3], 100 * least[1] / least[3], 100 * least[2] / least[3] }'
done
