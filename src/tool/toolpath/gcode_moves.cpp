// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode_moves.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <stdexcept>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

constexpr double MM_PER_INCH = 25.4, TURN = 6.283185307179586;
constexpr double LEAST_RADIUS = 0.002;    // mm: LinuxCNC takes smaller ones for none
constexpr double SINGLE = 0x1p24;         // the largest radius: that many numbers single precision tells apart
constexpr double LINE_ERROR = 0.5;        // of lines in place of an arc, in units of the last digit
constexpr double TURN_ERROR = 8;          // of an arc's length, by ends and center; by less than 1 rad: a turn is more
constexpr double MOST_COUNTS = 0x1p50;    // of coordinates, so that sums are exact
constexpr double MOST_LINES = 1'000'000;  // in place of one arc

Xy<double> point_of(const Gcode_place& place) { return {static_cast<double>(place.x), static_cast<double>(place.y)}; }
std::int64_t rounded(double count) {
  if (!(std::fabs(count) <= MOST_COUNTS))
    throw std::invalid_argument("expected coordinates with at most 15 digits, found more; --digits takes fewer");
  return std::llround(count);
}
double sagitta(const Arc_2& arc) { return std::fabs(arc.bulge) / 2 * ba::euclidean_norm(arc.to - arc.from); }

// How far an arc about a rounded center is from another one.
double arc_deviation(const Gcode_setup& setup, const Gcode_place& from, const Gcode_move& move, const Arc_2& part) {
  constexpr double INFINITE = std::numeric_limits<double>::infinity();
  if (part.bulge == 0 || part.from == part.to || (move.motion == 3) != (part.bulge > 0)) return INFINITE;
  const Xy<double> arm{static_cast<double>(-move.i), static_cast<double>(-move.j)};
  const Xy<double> center = point_of(from) - arm, end = point_of(move.to) - center;
  const double first = ba::euclidean_norm(arm), last = ba::euclidean_norm(end), radius = ba::radius(part);
  if (!((std::min)(first, last) >= setup.counts_of_mm(LEAST_RADIUS)) ||
      std::fabs(first - last) > radius_slack(setup, first))
    return INFINITE;
  double turn = std::atan2(cross(arm, end), dot(arm, end));  // of a controller: a whole one where it is none
  if (move.motion == 2) turn = -turn;
  if (turn <= 0) turn += TURN;
  const double missed = std::fabs(turn - std::fabs(2 * part.half_turn()));
  if (missed > 1 || missed * radius > TURN_ERROR) return INFINITE;
  return ba::euclidean_norm(center - ba::center(part)) +
         (std::max)(std::fabs(first - radius), std::fabs(last - radius));
}

class Gcode_maker {
 public:
  explicit Gcode_maker(const Gcode_setup& setup) : setup_(setup) {
    place_.z = safe_ = rounded(setup.counts(setup.safe_height));
    add({0, place_}, {});
  }

  void add(const std::vector<Tool_pass>& passes, std::size_t number) {
    const Tool_pass& pass = passes[number];
    Gcode_place start = place_of(in_counts(setup_, pass.pieces.front()).from);
    start.z = rounded(setup_.counts(pass.height_at(0)));
    go_to(start, number);
    for (std::size_t i = 0; i < pass.pieces.size(); ++i) {
      const Arc_2 piece = in_counts(setup_, pass.pieces[i]);
      place_z_ = rounded(setup_.counts(pass.height_at(i + 1)));
      if (!add_arc(piece, {number, i})) add_lines(piece, {number, i});
    }
  }
  [[nodiscard]] Gcode_program finished() {
    lift({});
    return std::move(program_);
  }

 private:
  [[nodiscard]] Gcode_place place_of(const Xy<double>& p) const { return {rounded(p.x), rounded(p.y), place_z_}; }
  void add(const Gcode_move& move, const Gcode_source& source) {
    program_.moves.push_back(move);
    program_.sources.push_back(source);
    place_ = move.to;
  }
  void lift(const Gcode_source& source) {
    if (place_.z != safe_) add({0, {place_.x, place_.y, safe_}}, source);
  }
  void go_to(const Gcode_place& start, std::size_t pass) {
    if (start.x != place_.x || start.y != place_.y || program_.moves.size() == 1) {
      lift({pass});
      add({0, {start.x, start.y, safe_}}, {pass});
    }
    if (place_ != start) add({1, start}, {pass});
  }

  // Whether an arc is one that is worth it, and was added. The nearest center is taken, else that of those around it
  // with which both radii agree best.
  bool add_arc(const Arc_2& piece, const Gcode_source& source) {
    const double flatness = sagitta(piece);
    if (flatness < LINE_ERROR) return false;
    if (ba::length(piece) < setup_.counts(setup_.shortest_arc) || ba::radius(piece) > SINGLE) return false;
    const Xy<double> center = ba::center(piece);
    const Gcode_place nearest = place_of(center);
    std::optional<Gcode_move> best;
    double least = std::numeric_limits<double>::infinity();
    for (const std::int64_t reach : {0, 1}) {
      for (std::int64_t x = -reach; x <= reach; ++x)
        for (std::int64_t y = -reach; y <= reach; ++y) {
          const Gcode_move move{piece.bulge > 0 ? 3 : 2, place_of(piece.to), nearest.x + x - place_.x,
                                nearest.y + y - place_.y};
          const double error = deviation(setup_, place_, move, piece);
          if (error <= MOVE_ERROR && error < least) {
            least = error;
            best = move;
          }
        }
      if (best) break;
    }
    if (!best) return false;
    add(*best, source);
    ++program_.arcs;
    return true;
  }
  // The height of lines in a height of its share each: an arc has one height.
  void add_lines(const Arc_2& piece, Gcode_source source) {
    constexpr double OF_HALF_CIRCLES =
        1.12;  // the root of pi^2 / 8: n lines of one have more than 1/n^2 of its sagitta
    const double lines = std::ceil(OF_HALF_CIRCLES * std::sqrt(sagitta(piece) / LINE_ERROR));
    if (!(lines <= MOST_LINES))
      throw std::invalid_argument("expected arcs of at most 1000000 lines, found one of more; --digits takes fewer");
    const auto count = static_cast<std::size_t>((std::max)(lines, 1.0));
    if (piece.bulge != 0 && count > 1) ++program_.broken;
    double last = 0;
    for (std::size_t i = 1; i <= count; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(count);
      const Gcode_move move{1, place_of(i == count ? piece.to : ba::point(piece, share))};
      if (move.to == place_) continue;
      source.from = last;
      source.to = last = share;
      add(move, source);
    }
  }

  const Gcode_setup& setup_;
  Gcode_program program_;
  Gcode_place place_;
  std::int64_t safe_ = 0, place_z_ = 0;
};

}  // namespace

double Gcode_setup::counts(double length) const { return length * scale * std::pow(10, digits); }
double Gcode_setup::counts_of_mm(double length) const {
  return length * std::pow(10, digits) / (is_in_inches ? MM_PER_INCH : 1);
}

double radius_slack(const Gcode_setup& setup, double radius) {
  constexpr double ABSOLUTE = 0.002, SHARE = 0.001;  // mm
  return (std::max)(setup.counts_of_mm(ABSOLUTE), SHARE * radius);
}

Arc_2 in_counts(const Gcode_setup& setup, const Arc_2& piece) {
  const double sign = setup.flips ? -1 : 1;
  const auto place = [&](const Xy<double>& p) { return Xy<double>{setup.counts(p.x), sign * setup.counts(p.y)}; };
  return {place(piece.from), place(piece.to), sign * piece.bulge};
}

double deviation(const Gcode_setup& setup, const Gcode_place& from, const Gcode_move& move, const Arc_2& part) {
  const double ends =
      (std::max)(ba::euclidean_norm(point_of(from) - part.from), ba::euclidean_norm(point_of(move.to) - part.to));
  if (move.motion == 1) return ends + sagitta(part);
  return (std::max)(ends, arc_deviation(setup, from, move, part));
}

Gcode_program gcode_program(const std::vector<Tool_pass>& passes, const Gcode_setup& setup) {
  Gcode_maker maker(setup);
  for (std::size_t i = 0; i < passes.size(); ++i) maker.add(passes, i);
  return maker.finished();
}

}  // namespace bounding_arcs_tool
