// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prints what was measured as one table: the least time of the repetitions, per region, and its ratio to the row's
// reference, a row measured in the same run.

#ifndef BOUNDING_ARCS_TEST_TABLE_REPORTER_H
#define BOUNDING_ARCS_TEST_TABLE_REPORTER_H

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>
#include <vector>

namespace bounding_arcs_benchmark {

/// Names of the counters that a benchmark sets.
inline constexpr const char* REGIONS = "regions";
inline constexpr const char* BYTES = "bytes";  ///< kept by the result
inline constexpr const char* PEAK = "peak";    ///< of memory taken while building

/// Says on a terminal's last line what is being measured: the table comes when all is.
void tell_row(const std::string& name);

class Table_reporter : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

 private:
  struct Row {
    std::int64_t place;  // among the rows as they were registered
    std::string name, reference;
    double seconds, regions, bytes, peak;
  };
  std::vector<Row> rows_;
};

}  // namespace bounding_arcs_benchmark

#endif
