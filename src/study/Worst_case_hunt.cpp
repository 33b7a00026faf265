// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of study/Worst_case_hunt.h.

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/study/Worst_case_hunt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL::Bounding_arcs {
namespace {

// Random spirals that a climb chooses its start from, and steps without gain after which it ends.
constexpr std::size_t HUNT_STARTS = 60, HUNT_PATIENCE = 240;
constexpr unsigned LARGEST_STEP = 44;  // 2^44 ulp, 2^-8 of a number

using Words = std::vector<std::string>;

[[nodiscard]] Words chosen(const Words& words, const Words& all) { return words.empty() ? all : words; }

// Whether there is such a row: of the methods that are compared there is thickness alone; a BCA has no joints;
// bisectors have the textbook's BCA and bilens, which the filtered kernel does not tell.
[[nodiscard]] bool is_figure(const std::string& method, const std::string& formula, const std::string& kernel,
                             const std::string& quantity) {
  if (method != "bca" && method != "sfa" && method != "bilens")
    return quantity == "thickness" && formula == "textbook" && kernel != "filtered";
  if (quantity == "bisector") return method != "sfa" && formula == "textbook" && kernel != "filtered";
  return method != "bca" || quantity != "joint";
}

[[nodiscard]] std::vector<Stability_choice> figures_of(const Stability_choice& choice) {
  std::vector<Stability_choice> figures;
  for (const std::string& quantity : chosen(choice.quantities, {"center", "radius", "joint", "thickness", "outside"}))
    for (const std::string& method : chosen(choice.methods, {"bca", "sfa", "bilens"}))
      for (const std::string& formula : chosen(choice.formulas, {"textbook", "stable"}))
        for (const std::string& kernel : chosen(choice.kernels, {"float", "double", "long-double", "filtered"}))
          if (is_figure(method, formula, kernel, quantity))
            figures.push_back({{method}, {formula}, {kernel}, {quantity}});
  return figures;
}

}  // namespace

bool Worst_case_hunt::has_figures(const Stability_choice& choice) { return !figures_of(choice).empty(); }

Worst_case_hunt::Worst_case_hunt(const Stability_choice& choice, unsigned seed) : random_(seed), spirals_(seed) {
  for (const Stability_choice& figure : figures_of(choice))
    figures_.push_back(
        [figure](const Study_piece& piece) { return stability_rows(piece.spiral, piece.t0, piece.t1, figure); });
  if (figures_.empty()) throw std::invalid_argument(expected("choice", "at least one figure that there is", "none"));
}

Worst_case_hunt::Worst_case_hunt(Measure measure, std::vector<Study_piece> starts, unsigned seed)
    : figures_{std::move(measure)}, random_(seed), own_starts_(std::move(starts)), spirals_(seed) {}

Study_piece Worst_case_hunt::start() {
  return own_starts_.empty() ? spirals_.next() : own_starts_[random_() % own_starts_.size()];
}

void Worst_case_hunt::step() {
  ++steps_;
  if (starts_ < HUNT_STARTS) {
    ++starts_;
    const std::optional<Place> start = measured(this->start());
    if (start && (!place_ || place_->error < start->error)) place_ = start;
    return;
  }
  if (!place_ || since_gain_ == HUNT_PATIENCE) {
    start_climb();
    return;
  }
  ++since_gain_;
  const std::optional<Study_piece> piece = neighbour(place_->piece);
  const std::optional<Place> next = piece ? measured(*piece) : std::nullopt;
  if (!next || next->error < place_->error) return;
  if (next->error > place_->error) since_gain_ = 0;
  place_ = next;
}

void Worst_case_hunt::start_climb() {
  figure_ = (figure_ + 1) % figures_.size();
  place_.reset();
  starts_ = since_gain_ = 0;
}

auto Worst_case_hunt::measured(Study_piece piece) -> std::optional<Place> {
  const std::vector<Stability_row> rows = figures_[figure_](piece);
  if (rows.empty()) return std::nullopt;
  double error = 0;
  for (const Stability_row& row : rows)
    if (row.quantity.find(", estimated") == std::string::npos) error = (std::max)(error, row.rel_error);
  piece.family = "hunt";
  piece.delta = static_cast<double>(steps_);
  piece.number = steps_;
  worst_.add(piece, rows);
  return Place{std::move(piece), error};
}

// One number of the curve moved, where the piece is one of a spiral segment then.
std::optional<Study_piece> Worst_case_hunt::neighbour(const Study_piece& piece) {
  std::vector<Xy<double>> points = piece.spiral.curve().control_points();
  std::vector<double> weights = piece.spiral.curve().weights();
  double t0 = piece.t0, t1 = piece.t1;
  const std::size_t at = random_() % (2 * points.size() + weights.size() + 2);
  if (at < points.size()) points[at].x = moved(points[at].x);
  else if (at < 2 * points.size()) points[at - points.size()].y = moved(points[at - points.size()].y);
  else if (at < 2 * points.size() + weights.size())
    weights[at - 2 * points.size()] = moved(weights[at - 2 * points.size()]);
  else if (at % 2 == 0) t0 = moved(t0);
  else t1 = moved(t1);
  if (!(t0 >= 0 && t0 < t1 && t1 <= 1)) return std::nullopt;
  try {
    const auto spiral = spiral_holding(Bezier_curve_2<double>(std::move(points), std::move(weights)), t0, t1);
    if (spiral) return Study_piece{piece.family, piece.delta, *spiral, t0, t1, piece.number, piece.placement};
  } catch (const std::invalid_argument&) {  // a curve that is not served
  }
  return std::nullopt;
}

// x moved by 1 to 2^LARGEST_STEP ulp, log-uniformly, up or down.
double Worst_case_hunt::moved(double x) {
  const double step = std::ldexp(1.0, static_cast<int>(random_() % (LARGEST_STEP + 1)));
  const double ulp = std::nextafter(std::fabs(x), std::numeric_limits<double>::infinity()) - std::fabs(x);
  return random_() % 2 == 0 ? x + step * ulp : x - step * ulp;
}

}  // namespace CGAL::Bounding_arcs
