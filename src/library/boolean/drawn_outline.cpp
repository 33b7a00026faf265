// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts as curves and outlines as drawings, of boolean/boolean_operations.h and boolean/clip.h.
//
//   parts -> curves in doubles, and how far these are from the parts -> without slivers -> drawing
//
// Slivers are what rounding does not tell from nothing.
// Curves that were rounded run along what they were made of and cross it several times. Between the crossings are
// slivers, and at each crossing an outline changes from one curve to the other. Combined again and again, both
// multiply. So a part that is within rounding
//   - of a point is left out,
//   - of the part before it, which it goes back along, is left out with that,
//   - of the curve that the chain left and comes back to is a part of that curve, as is a whole way of parts.
// Rounding is here what a bound tells of cutting the very parts that are compared; parts that are not cut are not
// rounded. How well the place of a crossing is known does not count: where curves meet at a small angle that is far
// more, and what is there is real.

#include "rounded_curves.h"

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/boolean/clip.h>
#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

/// A part with its curve in doubles.
struct Drawn_part {
  Outline_2::Part part;
  Bezier_curve_2<double> curve;
  double error = 0;     ///< how far the curve is from the part, point by point
  double rounding = 0;  ///< what of it rounding alone may make, of any of the given parts that it stands for
  double replaced = 0;  ///< how far the part is from parts in whose place it stands
};

[[nodiscard]] bool are_of_one_curve(const Outline_2::Part& a, const Outline_2::Part& b) {
  return a.operand == b.operand && a.curve == b.curve && a.is_reversed == b.is_reversed;
}
[[nodiscard]] double length_of_controls(const Bezier_curve_2<double>& curve) {
  const auto& p = curve.control_points();
  double length = 0;
  for (std::size_t i = 1; i < p.size(); ++i) length += stable_norm(p[i] - p[i - 1]);
  return length;
}

class Chain_drawer {
 public:
  explicit Chain_drawer(const std::vector<const Bounding_arc_tree_2*>& trees) : trees_(trees) {
    for (const Bounding_arc_tree_2* tree : trees) roundings_.push_back(tree->rounding());
  }

  /// Draws a new chain as it is.
  void start(const std::vector<Outline_2::Part>& chain) {
    parts_.clear();
    left_out_ = 0;
    // an end that is that of a piece is exact for its neighbour, too, if no number was rounded there
    const auto is_of = [&](const Outline_2::Part& neighbour, bool Exact_ends::*end) {
      return roundings_[neighbour.operand] == 0 && given_ends(neighbour).*end;
    };
    for (std::size_t i = 0, n = chain.size(); i < n; ++i) {
      Exact_ends exact = given_ends(chain[i]);
      exact.start = exact.start || is_of(chain[(i + n - 1) % n], &Exact_ends::end);
      exact.end = exact.end || is_of(chain[(i + 1) % n], &Exact_ends::start);
      parts_.push_back(drawn(chain[i], exact));
    }
  }
  /// Leaves out what rounding does not tell from nothing, maybe all.
  /// \complexity linear in the number of parts for drawings as they are
  void drop_slivers() {
    std::deque<Drawn_part> given;
    given.swap(parts_);
    for (Drawn_part& d : given) put(std::move(d));
    close();
    if (!parts_.empty() && bounds_nothing()) parts_.clear();
  }
  [[nodiscard]] const std::deque<Drawn_part>& parts() const { return parts_; }
  /// How far the curves are from the parts given, and how far apart the sides were of what was left out.
  [[nodiscard]] double moved() const {
    double moved = left_out_;
    for (const Drawn_part& d : parts_)
      moved = (std::max)(moved, d.replaced > 0 ? (d.error + d.replaced) * UP : d.error);
    return moved;
  }

 private:
  [[nodiscard]] const Bezier_curve_2<double>& piece_of(const Outline_2::Part& part) const {
    return trees_.at(part.operand)->drawing().curves()[part.curve].beziers[part.bezier];
  }
  // The ends of a part that are those of its piece.
  [[nodiscard]] Exact_ends given_ends(const Outline_2::Part& part) const {
    const auto& points = piece_of(part).control_points();
    const auto is_given = [&](const Bracket& t, const Xy<double>& p) {
      return is_end_of_piece(t) && p == (t.lower == 0 ? points.front() : points.back());
    };
    return {is_given(part.from, part.start), is_given(part.to, part.end)};
  }
  [[nodiscard]] Drawn_part drawn(const Outline_2::Part& part, const Exact_ends& exact) const {
    const Bezier_curve_2<double>& piece = piece_of(part);
    const Part_errors errors = errors_of_part(piece, part, exact);
    const double rounding = roundings_[part.operand];
    return {part, curve_of_part(piece, part), (errors.all + rounding) * UP, (errors.of_cutting + rounding) * UP, 0};
  }
  void redraw(Drawn_part& drawn, const Outline_2::Part& part) const {
    Drawn_part now = this->drawn(part, given_ends(part));
    now.rounding = drawn.rounding;
    now.replaced = drawn.replaced;
    drawn = std::move(now);
  }
  void start_at(Drawn_part& drawn, const Xy<double>& p) const {
    if (drawn.part.start == p) return;
    Outline_2::Part part = drawn.part;
    part.start = p;
    redraw(drawn, part);
  }
  void put(Drawn_part d) {
    if (!parts_.empty()) start_at(d, parts_.back().part.end);
    const double size = farthest(d.curve, d.part.start);
    if (size <= d.rounding) return leave_out(size + d.error + d.replaced);
    parts_.push_back(std::move(d));
    reduce();
  }
  /// \param apart how far apart its sides are
  void leave_out(double apart) { left_out_ = (std::max)(left_out_, apart * UP); }
  // The chain may start within what goes along another part: its first parts are put behind the last ones, and back if
  // that was of no use.
  void close() {
    std::size_t turned = 0;
    while (!parts_.empty()) {
      start_at(parts_.front(), parts_.back().part.end);
      if (turned == 2 || parts_.size() <= turned + 1) break;
      parts_.push_back(std::move(parts_.front()));
      parts_.pop_front();
      ++turned;
      if (reduce()) turned = 0;
    }
    for (; turned > 0; --turned) {
      parts_.push_front(std::move(parts_.back()));
      parts_.pop_back();
    }
  }
  /// \return whether there was anything to leave out
  bool reduce() {
    bool is_less = false;
    while (goes_on() || goes_back() || comes_back()) is_less = true;
    return is_less;
  }
  // The last part goes on where the one before it ends, or but for a part that was left out.
  [[nodiscard]] bool goes_on() {
    if (parts_.size() < 2) return false;
    Drawn_part &a = parts_[parts_.size() - 2], &b = parts_.back();
    if (!are_of_one_curve(a.part, b.part) || a.part.bezier != b.part.bezier) return false;
    const Bracket &from = a.part.to, &to = b.part.from;
    double replaced = 0;
    if (from.lower != to.lower || from.upper != to.upper) {
      if (a.part.is_reversed ? to.lower > from.upper : from.lower > to.upper) return false;
      Outline_2::Part gap = a.part;
      gap.from = from, gap.start = a.part.end;
      gap.to = to, gap.end = b.part.start;
      const Drawn_part between = drawn(gap, given_ends(gap));
      replaced = (farthest(between.curve, a.part.end) + between.error) * UP;
      if (!(replaced <= 2 * (a.rounding + b.rounding))) return false;
    }
    Outline_2::Part both = a.part;
    both.to = b.part.to;
    both.end = b.part.end;
    a.rounding = (std::max)(a.rounding, b.rounding);
    a.replaced = (std::max)({a.replaced, b.replaced, replaced});
    redraw(a, both);
    parts_.pop_back();
    return true;
  }
  // The last part goes back along the one before it, or along its end; or it starts by going back along all of that.
  [[nodiscard]] bool goes_back() {
    if (parts_.size() < 2) return false;
    Drawn_part &a = parts_[parts_.size() - 2], &b = parts_.back();
    const auto &p = a.curve.control_points(), &q = b.curve.control_points();
    if (dot(p.back() - p[p.size() - 2], q[1] - q[0]) > 0) return false;
    const double most = a.rounding + b.rounding;
    const Bezier_curve_2<double> back = a.curve.reversed();
    if (stable_norm(a.part.start - b.part.end) <= most) {
      const double distance = distance_bound(back, b.curve);
      if (!(distance <= most)) return false;
      leave_out(distance + a.error + a.replaced + b.error + b.replaced);
      parts_.pop_back();
      parts_.pop_back();
      return true;
    }
    const bool is_longer = length_of_controls(a.curve) < length_of_controls(b.curve);  // b is
    const Bezier_curve_2<double>&longer = is_longer ? b.curve : back, &shorter = is_longer ? back : b.curve;
    const Xy<double>& end = shorter.control_points().back();
    const double t = parameter_near(longer, end);
    if (t == 0 || t == 1 || !(stable_norm(longer.point(t) - end) <= most)) return false;
    const double distance = (distance_bound(longer.split(t).first, shorter) + cutting_error(longer)) * UP;
    if (!(distance <= most)) return false;
    leave_out(distance + a.error + a.replaced + b.error + b.replaced);
    Drawn_part& rest = is_longer ? b : a;
    Outline_2::Part part = rest.part;
    const double from = part.from.middle(), to = part.to.middle(), at = from + (is_longer ? t : 1 - t) * (to - from);
    (is_longer ? part.from : part.to) = {at, at};
    (is_longer ? part.start : part.end) = end;
    redraw(rest, part);
    parts_.erase(parts_.end() - (is_longer ? 2 : 1));
    return true;
  }
  // The last part is of a curve that the chain left, and went along. The way that it went is replaced by that of the
  // curve.
  [[nodiscard]] bool comes_back() {
    if (parts_.size() < 3) return false;
    double rounding = 0, replaced = 0;
    std::vector<Bezier_curve_2<double>> way, along;
    std::size_t first = parts_.size() - 2;
    for (; !are_of_one_curve(parts_[first].part, parts_.back().part); --first) {
      if (first == 0 || first + 2 + MOST_PARTS == parts_.size()) return false;
      rounding = (std::max)(rounding, parts_[first].rounding);
      replaced = (std::max)(replaced, parts_[first].error + parts_[first].replaced);
    }
    if (first + 2 == parts_.size()) return false;
    std::vector<Drawn_part> between;
    double error = 0;
    for (const Outline_2::Part& part : parts_between(parts_[first].part, parts_.back().part)) {
      between.push_back(drawn(part, given_ends(part)));
      rounding = (std::max)(rounding, between.back().rounding);
      error = (std::max)(error, between.back().error);
      along.push_back(between.back().curve);
    }
    if (between.empty()) return false;
    for (std::size_t i = first + 1; i + 1 < parts_.size(); ++i) way.push_back(parts_[i].curve);
    const double most = 2 * rounding, distance = distance_bound(along, way, most);
    if (!(distance <= most)) return false;
    Drawn_part last = std::move(parts_.back());
    parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(first) + 1, parts_.end());
    for (Drawn_part& d : between) {
      d.replaced = (replaced + distance + error) * UP;
      start_at(d, parts_.back().part.end);
      parts_.push_back(std::move(d));
      static_cast<void>(goes_on());
    }
    start_at(last, parts_.back().part.end);
    parts_.push_back(std::move(last));
    return true;
  }
  // All of it is on one line, or within rounding of one.
  [[nodiscard]] bool bounds_nothing() {
    using Point = Exact_predicates_inexact_constructions_kernel::Point_2;
    const auto farthest_from = [this](const Xy<double>& from) {
      Xy<double> far = from;
      double most = 0;
      for (const Drawn_part& d : parts_)
        for (const Xy<double>& p : d.curve.control_points())
          if (const double distance = stable_norm(p - from); distance > most) most = distance, far = p;
      return far;
    };
    const Xy<double> far = farthest_from(parts_.front().part.start), end = farthest_from(far);
    double rounding = 0, error = 0;
    for (const Drawn_part& d : parts_) {
      rounding = (std::max)(rounding, d.rounding);
      error = (std::max)(error, d.error + d.replaced);
    }
    const Point a(far.x, far.y), b(end.x, end.y);
    double width = 0;
    bool is_on_line = true;
    for (const Drawn_part& d : parts_) {
      const auto is_on = [&](const Xy<double>& p) { return CGAL::collinear(a, b, Point(p.x, p.y)); };
      const auto& points = d.curve.control_points();
      is_on_line = is_on_line && std::all_of(points.begin(), points.end(), is_on);
      if (is_on_line) continue;
      width = (std::max)(width, distance_from_segment(d.curve, far, end));
      if (!(width <= rounding)) return false;
    }
    leave_out(2 * (width + error));
    return true;
  }
  // The parts of a curve between two of its parts: none if that are too many, or if the second one is not behind.
  [[nodiscard]] std::vector<Outline_2::Part> parts_between(const Outline_2::Part& a, const Outline_2::Part& b) const {
    const auto& beziers = trees_[a.operand]->drawing().curves()[a.curve].beziers;
    const std::size_t n = beziers.size(),
                      steps = (a.is_reversed ? a.bezier + n - b.bezier : b.bezier + n - a.bezier) % n;
    if (steps > MOST_PARTS) return {};
    if (steps == 0 && !(a.is_reversed ? b.from.upper < a.to.lower : a.to.upper < b.from.lower)) return {};
    const double first = a.is_reversed ? 1 : 0, last = 1 - first;
    std::vector<Outline_2::Part> parts;
    for (std::size_t i = 0; i <= steps; ++i) {
      Outline_2::Part part = a;
      part.bezier = static_cast<std::uint32_t>((a.is_reversed ? a.bezier + n - i : a.bezier + i) % n);
      const auto& points = beziers[part.bezier].control_points();
      part.from = i == 0 ? a.to : Bracket{first, first};
      part.start = i == 0 ? a.end : (a.is_reversed ? points.back() : points.front());
      part.to = i == steps ? b.from : Bracket{last, last};
      part.end = i == steps ? b.start : (a.is_reversed ? points.front() : points.back());
      const bool is_nothing =
          is_end_of_piece(part.from) && part.from.lower == part.to.lower && is_end_of_piece(part.to);
      if (!is_nothing) parts.push_back(part);
    }
    return parts;
  }

  static constexpr std::size_t MOST_PARTS = 8;  // that the chain goes along another curve, or else it is left there

  const std::vector<const Bounding_arc_tree_2*>& trees_;
  std::vector<double> roundings_;  // by tree
  std::deque<Drawn_part> parts_;
  double left_out_ = 0;  // the largest distance between sides
};

void add_chain(std::vector<Bezier_curve_2<double>> chain, Drawing_2<double>& drawing) {
  const std::string number = std::to_string(drawing.curves().size() + 1);
  drawing.add(std::move(chain), "outline " + number);
}

}  // namespace

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

Bezier_curve_2<double> Clipped_2::Part::cut_from(const Drawing_2<double>& drawing) const {
  return internal::curve_of_part(drawing.curves()[curve].beziers[bezier],
                                 {0, curve, bezier, from, to, false, start, end});
}

Outline_2::Drawn drawn_outline(const std::vector<const Bounding_arc_tree_2*>& trees, const Outline_2& outline,
                               const Outline_2::Drawn::Options& options) {
  Outline_2::Drawn result;
  result.outline.status = outline.status;
  result.outline.undecided = outline.undecided;
  internal::Chain_drawer drawer(trees);
  std::vector<std::optional<std::size_t>> numbers;  // of the chains given among those drawn
  for (const Outline_2::Chain& given : outline.chains) {
    drawer.start(given.parts);
    if (options.drops_slivers) drawer.drop_slivers();
    result.moved = (std::max)(result.moved, drawer.moved());
    numbers.push_back(std::nullopt);
    if (drawer.parts().empty()) continue;
    Outline_2::Chain chain{{}, given.is_ccw, std::nullopt};
    std::vector<Bezier_curve_2<double>> curves;
    for (const internal::Drawn_part& drawn : drawer.parts()) {
      curves.push_back(drawn.curve);
      chain.parts.push_back(drawn.part);
    }
    numbers.back() = result.outline.chains.size();
    result.outline.chains.push_back(std::move(chain));
    internal::add_chain(std::move(curves), result.drawing);
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!numbers[i]) continue;
    std::optional<std::size_t> parent = outline.chains[i].parent;
    while (parent && !numbers[*parent]) parent = outline.chains[*parent].parent;
    if (parent) result.outline.chains[*numbers[i]].parent = numbers[*parent];
  }
  return result;
}

}  // namespace CGAL::Bounding_arcs
