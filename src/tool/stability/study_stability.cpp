// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pieces of a study, measured by several threads, block by block, so that few are in memory at a time. What is
// found does not depend on the threads.

#include "study_stability.h"

#include "../Commands.h"

#include <CGAL/Bounding_arcs_2/study/Worst_case_hunt.h>
#include <CGAL/Bounding_arcs_2/study/stability_families.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <tuple>
#include <utility>

namespace bounding_arcs_tool {
namespace {

using namespace CGAL::Bounding_arcs;

// Pieces of a block: few at first, as the worst of those before tells what need not be measured.
constexpr std::size_t FIRST_BLOCK = 4, LARGEST_BLOCK = 256;

// The rows of pieces [begin, begin + rows.size()), each thread taking the next piece; `worst` does not change.
void measure_block(const std::vector<Study_piece>& pieces, const Worst_rows& worst, const Stability_options& options,
                   std::vector<std::vector<Stability_row>>& rows) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr error;
  std::mutex mutex;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < pieces.size(); i = next++) {
        Stability_choice choice = options.choice;
        choice.floor = [&](const Stability_row& row) { return worst.floor(pieces[i], row); };
        rows[i] = stability_rows(pieces[i].spiral, pieces[i].t0, pieces[i].t1, choice);
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      error = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t i = 1; i < options.jobs; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (error) std::rethrow_exception(error);
}

// `next` gives one piece after the other.
std::vector<Stability_row> measure(std::size_t count, const std::function<Study_piece()>& next, bool by_delta,
                                   const std::string& name, const Stability_options& options) {
  Progress_line progress("measuring " + name + ", spirals", Progress_line::Long_work::ANNOUNCED);
  Worst_rows worst(by_delta);
  for (std::size_t done = 0, block = FIRST_BLOCK; done < count; block = std::min(2 * block, LARGEST_BLOCK)) {
    std::vector<Study_piece> pieces;
    while (pieces.size() < block && done + pieces.size() < count) pieces.push_back(next());
    std::vector<std::vector<Stability_row>> rows(pieces.size());
    measure_block(pieces, worst, options, rows);
    for (std::size_t i = 0; i < pieces.size(); ++i) worst.add(pieces[i], rows[i]);
    done += pieces.size();
    progress(done, count);
  }
  return worst.rows();
}

std::vector<Stability_row> measure(const std::vector<Study_piece>& pieces, const std::string& name,
                                   const Stability_options& options) {
  std::size_t i = 0;
  return measure(
      pieces.size(), [&] { return pieces[i++]; }, true, name, options);
}

std::vector<Study_piece> family_of(const std::string& name, const Stability_options& options) {
  if (name == "near-linear") return near_linear_family();
  if (name == "near-circular") return near_circular_family();
  return name == "subdivision" ? subdivision_family() : random_family(options.count, options.seed);
}

std::vector<Stability_row> measure_family(const std::string& name, const Stability_options& options) {
  if (name != "random") return measure(family_of(name, options), name, options);
  Random_spirals spirals(options.seed);
  return measure(
      options.count, [&] { return spirals.next(); }, false, name, options);
}

// Every spiral of a record, or the part that it tells, counted from 0.
void add_pieces(const std::string& file, const Curve_record& record, std::vector<Study_piece>& pieces) {
  const auto add = [&](const Bezier_spiral_2<double>& spiral, double t0, double t1) {
    pieces.push_back({record.delta > 0 ? "own" : "curves", record.delta, spiral, t0, t1});
  };
  for (const Bezier_curve_2<double>& curve : record.bezier_pieces<double>()) {
    if (record.part.empty()) {
      for (const Bezier_spiral_2<double>& spiral : served(file, record.name, [&] { return spiral_segments(curve); }))
        add(spiral, spiral.first(), spiral.last());
      continue;
    }
    const double t0 = record.part[0], t1 = record.part[1];
    const auto spiral = served(file, record.name, [&] { return spiral_holding(curve, t0, t1); });
    if (!spiral)
      throw Input_error(file, "curve \"" + record.name + "\"",
                        "expected a part within one spiral segment, found one beyond it");
    add(*spiral, t0, t1);
  }
}

// Curves without a delta first, then a family of those with one, whose deltas fall as those of others do.
std::vector<Study_piece> pieces_of_curves(const Stability_options& options) {
  std::vector<Study_piece> pieces;
  Reading_words reading = options.reading;
  for (const std::string& file : options.files) {
    const CGAL::Bounding_arcs::Curve_file read = read_told(file, reading);
    reading.keep_unit({name_of_file(file), read.unit_in_mm});
    for (const Curve_record& record : read.curves) add_pieces(name_of_file(file), record, pieces);
  }
  if (!options.curve.empty())
    for (const Curve_record& record : ba::Curve_file::from_text(options.curve, "--curve", "curve").curves)
      add_pieces("--curve", record, pieces);
  std::stable_sort(pieces.begin(), pieces.end(), [](const Study_piece& a, const Study_piece& b) {
    if (a.family != b.family) return a.family < b.family;
    return a.family == "own" && a.delta > b.delta;
  });
  std::map<std::string, std::size_t> sizes;
  for (Study_piece& piece : pieces) {
    piece.number = sizes[piece.family]++;
    if (piece.family == "curves") piece.delta = static_cast<double>(piece.number);
  }
  return pieces;
}

std::optional<double> condition_of(const Figure_conditions& conditions, const std::string& quantity) {
  if (quantity == "normal") return conditions.normal;
  if (quantity == "bisector")
    return conditions.bisector > 0 ? std::optional<double>(conditions.bisector) : std::nullopt;
  if (quantity == "center") return conditions.center;
  if (quantity == "radius") return conditions.radius;
  return quantity == "joint" ? conditions.joint : conditions.thickness;
}

}  // namespace

void add_conditions(std::vector<Stability_row>& rows) {
  std::map<std::tuple<std::string, std::size_t, std::string>, std::optional<Figure_conditions>> known;
  for (Stability_row& row : rows) {
    if (row.quantity == "outside") continue;
    const auto place = known.emplace(std::make_tuple(row.family, row.number, row.method), std::nullopt);
    if (place.second) {
      const auto spiral = spiral_holding(Bezier_curve_2<double>(row.control_points, row.weights), row.t0, row.t1);
      if (spiral) place.first->second = figure_conditions(*spiral, row.t0, row.t1, row.method);
    }
    if (place.first->second) row.condition = condition_of(*place.first->second, row.quantity);
  }
}

std::vector<Stability_row> study_stability(const Stability_options& options) {
  std::vector<Stability_row> rows;
  const auto append = [&](const std::vector<Stability_row>& more) {
    rows.insert(rows.end(), more.begin(), more.end());
  };
  if (!options.files.empty() || !options.curve.empty()) append(measure(pieces_of_curves(options), "curves", options));
  for (const std::string& name : options.families) append(measure_family(name, options));
  return rows;
}

void for_each_delta(const Stability_options& options, std::size_t most,
                    const std::function<void(const std::vector<Study_piece>&)>& use) {
  std::vector<std::vector<Study_piece>> families;
  if (!options.files.empty() || !options.curve.empty()) {
    const auto pieces = pieces_of_curves(options);
    const auto own = std::find_if(pieces.begin(), pieces.end(), [](const auto& p) { return p.family == "own"; });
    families.push_back({pieces.begin(), own});
    families.push_back({own, pieces.end()});
  }
  for (const std::string& name : options.families) families.push_back(family_of(name, options));
  Picked_deltas is_picked;
  for (const std::vector<Study_piece>& family : families) {
    std::vector<std::vector<Study_piece>> groups;  // of one delta each
    std::map<double, std::size_t, std::greater<>> places;
    for (const Study_piece& piece : family) {
      const auto place = places.emplace(piece.delta, groups.size());
      if (place.second) groups.emplace_back();
      groups[place.first->second].push_back(piece);
    }
    for (const auto& [delta, place] : places) {
      const std::vector<Study_piece>& group = groups[place];
      if (!is_picked(group.front().family, delta)) continue;
      std::vector<Study_piece> some;
      const std::size_t size = std::min(most, group.size());
      for (std::size_t i = 0; i < size; ++i) some.push_back(group[i * group.size() / size]);
      use(some);
    }
  }
}

std::vector<Stability_row> hunt_stability(const Stability_options& options) {
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  Worst_case_hunt hunt(options.choice, options.seed);
  if (options.hunt_steps > 0) {
    Progress_line progress("hunting, steps", Progress_line::Long_work::ANNOUNCED);
    for (; hunt.steps() < options.hunt_steps; progress(hunt.steps(), options.hunt_steps)) hunt.step();
    return hunt.worst().rows();
  }
  Progress_line progress("hunting, seconds", Progress_line::Long_work::SILENT);
  for (double gone = 0; gone < options.hunt_seconds; gone = seconds()) {
    hunt.step();
    progress(static_cast<std::size_t>(gone), static_cast<std::size_t>(options.hunt_seconds));
  }
  std::cerr << "bounding_arcs: hunted for " << hunt.steps() << " steps; --hunt-steps " << hunt.steps() << " --seed "
            << options.seed << " finds the same\n";
  return hunt.worst().rows();
}

}  // namespace bounding_arcs_tool
