// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is measured: kernels, the bundled curves cut into spirals, and how a build is timed.

#ifndef BOUNDING_ARCS_TEST_BENCHMARK_CURVES_H
#define BOUNDING_ARCS_TEST_BENCHMARK_CURVES_H

#include "Table_reporter.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <benchmark/benchmark.h>

#include <chrono>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace bounding_arcs_benchmark {

namespace ba = CGAL::Bounding_arcs;
template <class LinearKernel>
using Circular =
    CGAL::Circular_kernel_2<LinearKernel, CGAL::Algebraic_kernel_for_circles_2_2<typename LinearKernel::FT>>;
using Double = Circular<CGAL::Simple_cartesian<double>>;
using Filtered = Circular<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Bezier = ba::Bezier_curve_2<double>;
using Spiral = ba::Bezier_spiral_2<double>;

inline const std::vector<Bezier>& bundled_beziers() {
  static const std::vector<Bezier> curves = [] {
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(BOUNDING_ARCS_DATA))
      if (entry.path().extension() == ".json") files.insert(entry.path());
    std::vector<Bezier> all;
    for (const auto& file : files)
      for (const auto& record : ba::read_curve_file(file.string()).curves)
        for (const Bezier& piece : record.bezier_pieces<double>()) all.push_back(piece);
    return all;
  }();
  return curves;
}

inline const std::vector<Spiral>& bundled_spirals() {
  static const std::vector<Spiral> spirals = [] {
    std::vector<Spiral> all;
    for (const Bezier& curve : bundled_beziers())
      for (Spiral& s : ba::spiral_segments(curve)) all.push_back(std::move(s));
    return all;
  }();
  return spirals;
}

inline constexpr int REPETITIONS = 7;

/// Times `make(copy of the spirals)`, copies not counted, and lets `tell` set counters from the last result.
template <class Spirals, class Make, class Tell>
void time_builds(benchmark::State& state, const Spirals& spirals, const Make& make, const Tell& tell) {
  for (auto _ : state) {
    Spirals copy = spirals;
    const auto start = std::chrono::steady_clock::now();
    const auto result = make(std::move(copy));
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    tell(result);
  }
}

/// Registers a benchmark of this name; `reference` names the row that its ratio is to.
/// \param seconds that a repetition takes at least: rows that are compared should take as long as each other, as the
///   mean of a long time is rarely as good as that of a short one where a machine has other work
template <class Run>
void add_row(const std::string& name, const std::string& reference, const Run& run, double seconds = 0.5) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [=](benchmark::State& state) {
                                 tell_row(name);
                                 state.SetLabel(reference);
                                 run(state);
                               })
      ->UseManualTime()
      ->MinTime(seconds)
      ->Repetitions(REPETITIONS);
}

}  // namespace bounding_arcs_benchmark

#endif
