// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Queries beside those of other libraries: time, ratio and how many answers are wrong, all in one run.
// Usage: peers [SECONDS of CPU time that a row takes in each repetition] [PAIRS of cubics]
//
// Time is that of the processor, as the machine may have other work; rows take turns, so that a slow minute meets all,
// and the least of the repetitions counts.  Ours are certified, so that an answer that differs is wrong: by any number
// of points, by more than 1e-9 where it is a distance.

#include "peer.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace bounding_arcs_benchmark {
namespace {

constexpr int REPETITIONS = 7;
constexpr double MOST_ERROR = 1e-9;

struct Task_words {
  const char *title, *unit;
};
constexpr Task_words WORDS[TASKS] = {
    {"closest point on one bundled curve, curve ready", "a point in or around its box"},
    {"intersections of two random cubics, from control points", "a pair in the unit square"},
    {"intersections of two bundled curves, curves ready", "a pair, mean of all 28"},
    {"minimum distance of two disjoint curves, to 1e-12, curves ready", "a pair, mean of 28"},
    {"Hausdorff distance of two curves, to 1e-9, curves ready", "a pair, mean of all 28"},
    {"medial axis to 1e-6, ours from control points, its largest disc compared", "a bundled curve, mean of all eight"}};

std::size_t number_of_cases(const Peer_cases& cases, Task task) {
  if (task == CLOSEST) return cases.closest.size();
  if (task == CUBICS) return cases.cubics.size();
  if (task == AXIS) return cases.bundled;
  return task == DISTANCE ? cases.apart.size() : cases.crossing.size();
}

double cpu_time() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Row {
  Peer peer;
  std::size_t cases;
  std::vector<double> answers = {};
  double seconds = std::numeric_limits<double>::infinity();  // a case

  Row(Peer p, std::size_t all) : peer(std::move(p)), cases((std::min)(all, peer.most_cases)) {}

  void answer_all() {
    for (std::size_t i = 0; i < cases; ++i) answers.push_back(peer.answer(i));
  }
  /// Of random cases the first will do; of pairs of curves each counts as often as any other.
  void measure(double least_seconds) {
    constexpr std::size_t MOST = 2000;
    const std::size_t count = (std::min)(cases, MOST);
    double sum = 0, taken = 0;
    const double start = cpu_time();
    std::size_t rounds = 0;
    for (; taken < least_seconds; taken = cpu_time() - start, ++rounds)
      for (std::size_t i = 0; i < count; ++i) sum += peer.answer(i);
    volatile double kept = sum;
    static_cast<void>(kept);
    seconds = (std::min)(seconds, taken / static_cast<double>(rounds * count));
  }
};

struct Wrong {
  std::size_t count = 0, none = 0;  // none: no answer at all, which counts as wrong, too
  double worst = 0;

  Wrong(const Row& row, const Row& reference, bool is_count) {
    for (std::size_t i = 0; i < row.answers.size(); ++i) {
      const double error = std::fabs(row.answers[i] - reference.answers[i]);
      if (!(error <= (is_count ? 0 : MOST_ERROR))) ++count;
      if (std::isnan(row.answers[i])) ++none;
      else worst = (std::max)(worst, error);
    }
  }
};

void print(const Row& row, const Row& ours) {
  const bool is_count = row.peer.task == CUBICS || row.peer.task == CURVES, is_ours = &row == &ours;
  const Wrong wrong(row, ours, is_count);
  std::printf("  %-28s %10.3f %10.3f %8.2f   %6zu of %-6zu", row.peer.name.c_str(), 1e6 * ours.seconds,
              1e6 * row.seconds, row.seconds / ours.seconds, wrong.count, row.answers.size());
  if (wrong.none > 0) std::printf("  %zu without an answer", wrong.none);
  if (!is_ours && !is_count) std::printf("  worst error %.1e", wrong.worst);
  if (!is_ours && is_count && wrong.count > wrong.none) std::printf("  by up to %.0f", wrong.worst);
  std::printf("\n");
}

Peers all_peers(const Peer_cases& cases) {
  Peers all;
  for (const auto make : {our_peers,
#ifdef BOUNDING_ARCS_LIB2GEOM
                          lib2geom_peers,
#endif
#ifdef BOUNDING_ARCS_SISL
                          sisl_peers,
#endif
#ifdef BOUNDING_ARCS_OCCT
                          occt_peers,
#endif
                          cgal_peers, cgal_bezier_peers, boost_peers, voronoi_peers})
    for (Peer& peer : make(cases)) all.push_back(std::move(peer));
  return all;
}

void run(double seconds, std::size_t pairs) {
  const Peer_cases cases = make_cases(pairs);
  std::vector<Row> rows;
  for (const Peer& peer : all_peers(cases)) rows.emplace_back(peer, number_of_cases(cases, peer.task));
  for (Row& row : rows) row.answer_all();
  for (int k = 0; k < REPETITIONS; ++k)
    for (Row& row : rows) row.measure(seconds);
  std::printf("microseconds of CPU time, the least of %d repetitions; ratio: the peer's time over ours\n", REPETITIONS);
  std::printf("wrong: another number of points, no answer, or a distance that is off by more than 1e-9\n");
  for (int task = 0; task < TASKS; ++task) {
    std::printf("\n%s; %s\n  %-28s %10s %10s %8s   %s\n", WORDS[task].title, WORDS[task].unit, "", "ours", "peer",
                "ratio", "wrong");
    const auto is_of_task = [task](const Row& row) { return row.peer.task == task; };
    const auto ours = std::find_if(rows.begin(), rows.end(), is_of_task);
    for (const Row& row : rows)
      if (is_of_task(row)) print(row, *ours);
  }
}

}  // namespace
}  // namespace bounding_arcs_benchmark

int main(int argc, char** argv) {
  constexpr double SECONDS = 0.1;
  constexpr std::size_t PAIRS = 100000;
  bounding_arcs_benchmark::run(argc > 1 ? std::atof(argv[1]) : SECONDS,
                               argc > 2 ? static_cast<std::size_t>(std::atol(argv[2])) : PAIRS);
  return 0;
}
