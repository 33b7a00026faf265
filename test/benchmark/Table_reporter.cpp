// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Table_reporter.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>

namespace bounding_arcs_benchmark {
namespace {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace

void tell_row(const std::string& name) {
  if (isatty(STDERR_FILENO) != 0) std::fprintf(stderr, "\r\33[K%s", name.c_str());
}

bool Table_reporter::ReportContext(const Context& context) {
  std::printf("processor %s, %d cores at %.1f GHz; load %.1f\ncompiler %s, flags %s\n", processor().c_str(),
              context.cpu_info.num_cpus, context.cpu_info.cycles_per_second / 1e9,
              context.cpu_info.load_avg.empty() ? 0.0 : context.cpu_info.load_avg.front(), BOUNDING_ARCS_COMPILER,
              BOUNDING_ARCS_FLAGS);
  std::printf("times are the least of the repetitions; ratio: time per region over that of the row named\n\n");
  std::printf("%-58s %10s %12s %10s %8s  %s\n", "", "regions", "ns/region", "bytes/reg", "ratio", "to");
  return true;
}

void Table_reporter::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
    const auto counter = [&](const char* name) {
      const auto found = run.counters.find(name);
      return found == run.counters.end() ? 0.0 : found->second.value;
    };
    const double seconds = run.real_accumulated_time / static_cast<double>(run.iterations);
    const std::string& name = run.run_name.function_name;
    const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.name == name; });
    if (row != rows_.end()) row->seconds = (std::min)(row->seconds, seconds);
    else
      rows_.push_back(
          {run.family_index, name, run.report_label, seconds, counter(REGIONS), counter(BYTES), counter(PEAK)});
  }
}

void Table_reporter::Finalize() {
  tell_row("");
  std::sort(rows_.begin(), rows_.end(), [](const Row& a, const Row& b) { return a.place < b.place; });
  for (const Row& row : rows_) {
    const double each = 1e9 * row.seconds / row.regions;
    std::printf("%-58s %10.0f %12.2f", row.name.c_str(), row.regions, each);
    if (row.bytes > 0) std::printf(" %10.1f", row.bytes / row.regions);
    else std::printf(" %10s", "");
    const auto reference =
        std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.name == row.reference; });
    if (reference != rows_.end())
      std::printf(" %8.3f  %s", each * reference->regions / (1e9 * reference->seconds), row.reference.c_str());
    if (reference != rows_.end() && reference->regions != row.regions)
      std::printf("  (%.3f in all)", row.seconds / reference->seconds);
    if (row.peak > 0) std::printf("  (peak %.1f bytes a node)", row.peak / (2 * row.regions));
    std::printf("\n");
  }
}

}  // namespace bounding_arcs_benchmark
