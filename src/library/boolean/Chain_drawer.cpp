// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of Chain_drawer.h.

#include "Chain_drawer.h"
#include "curve_distance.h"
#include "rounded_part.h"

#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

namespace {

[[nodiscard]] bool are_of_one_piece(const Outline_2::Part& a, const Outline_2::Part& b) {
  return a.operand == b.operand && a.curve == b.curve && a.bezier == b.bezier && a.is_reversed == b.is_reversed;
}
/// What is between two parts of one piece, of which the second one is behind the first one.
[[nodiscard]] Outline_2::Part part_between(const Outline_2::Part& a, const Outline_2::Part& b) {
  Outline_2::Part part = a;
  part.from = a.to;
  part.to = b.from;
  part.start = a.end;
  part.end = b.start;
  return part;
}

[[nodiscard]] double length_of_controls(const Bezier_curve_2<double>& curve) {
  const auto& p = curve.control_points();
  double length = 0;
  for (std::size_t i = 1; i < p.size(); ++i) length += stable_norm(p[i] - p[i - 1]);
  return length;
}

[[nodiscard]] double parameter_of(const Outline_2::Part& part, double t) {
  const double from = part.from.middle(), to = part.to.middle();
  return from + t * (to - from);
}

}  // namespace

Chain_drawer::Chain_drawer(const std::vector<const Bounding_arc_tree_2*>& trees) : trees_(trees) {
  for (const Bounding_arc_tree_2* tree : trees) roundings_.push_back(tree->rounding());
}

void Chain_drawer::start(const std::vector<Outline_2::Part>& chain) {
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

double Chain_drawer::moved() const {
  double moved = left_out_;
  for (const Drawn_part& d : parts_) moved = (std::max)(moved, d.replaced > 0 ? (d.error + d.replaced) * UP : d.error);
  return moved;
}

const Bezier_curve_2<double>& Chain_drawer::piece_of(const Outline_2::Part& part) const {
  return trees_.at(part.operand)->drawing().curves()[part.curve].beziers[part.bezier];
}

// The ends of a part that are those of its piece.
Exact_ends Chain_drawer::given_ends(const Outline_2::Part& part) const {
  const auto& points = piece_of(part).control_points();
  const auto is_given = [&](const Bracket& t, const Xy<double>& p) {
    return is_end_of_piece(t) && p == (t.lower == 0 ? points.front() : points.back());
  };
  return {is_given(part.from, part.start), is_given(part.to, part.end)};
}

Drawn_part Chain_drawer::drawn(const Outline_2::Part& part, const Exact_ends& exact) const {
  const Bezier_curve_2<double>& piece = piece_of(part);
  const double error = (error_of_part(piece, part, exact) + roundings_[part.operand]) * UP;
  const double rounding = (rounding_of_part(piece, part, exact) + roundings_[part.operand]) * UP;
  return {part, curve_of_part(piece, part.from, part.to, part.is_reversed, part.start, part.end), error, rounding, 0};
}

void Chain_drawer::redraw(Drawn_part& drawn, const Outline_2::Part& part) const {
  Drawn_part now = this->drawn(part, given_ends(part));
  now.rounding = drawn.rounding;
  now.replaced = drawn.replaced;
  drawn = std::move(now);
}

void Chain_drawer::start_at(Drawn_part& drawn, const Xy<double>& p) const {
  if (drawn.part.start == p) return;
  Outline_2::Part part = drawn.part;
  part.start = p;
  redraw(drawn, part);
}

void Chain_drawer::drop_slivers() {
  std::deque<Drawn_part> given;
  given.swap(parts_);
  for (Drawn_part& d : given) put(std::move(d));
  close();
  if (!parts_.empty() && bounds_nothing()) parts_.clear();
}

void Chain_drawer::put(Drawn_part d) {
  if (!parts_.empty()) start_at(d, parts_.back().part.end);
  const double size = farthest(d.curve, d.part.start);
  if (size <= d.rounding) {
    left_out_ = (std::max)(left_out_, (size + d.error + d.replaced) * UP);
    return;
  }
  parts_.push_back(std::move(d));
  while (is_reduced()) {
  }
}

// The chain may start within what goes along another part: its first parts are put behind the last ones, and back if
// that was of no use.
void Chain_drawer::close() {
  std::size_t turned = 0;
  while (!parts_.empty()) {
    start_at(parts_.front(), parts_.back().part.end);
    if (turned == 2 || parts_.size() <= turned + 1) break;
    parts_.push_back(std::move(parts_.front()));
    parts_.pop_front();
    ++turned;
    if (!is_reduced()) continue;
    while (is_reduced()) {
    }
    turned = 0;
  }
  for (; turned > 0; --turned) {
    parts_.push_front(std::move(parts_.back()));
    parts_.pop_back();
  }
}

bool Chain_drawer::is_reduced() { return goes_on() || goes_back() || comes_back(); }

void Chain_drawer::join(std::size_t first, double replaced) {
  Drawn_part& one = parts_[first];
  Outline_2::Part part = one.part;
  part.to = parts_.back().part.to;
  part.end = parts_.back().part.end;
  for (std::size_t i = first; i < parts_.size(); ++i) {
    one.rounding = (std::max)(one.rounding, parts_[i].rounding);
    replaced = (std::max)(replaced, parts_[i].replaced);
  }
  one.replaced = replaced;
  redraw(one, part);
  parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(first) + 1, parts_.end());
}

// The last part goes on where the one before it ends, or but for a part that was left out.
bool Chain_drawer::goes_on() {
  if (parts_.size() < 2) return false;
  const Drawn_part &a = parts_[parts_.size() - 2], &b = parts_.back();
  if (!are_of_one_piece(a.part, b.part)) return false;
  const Bracket &from = a.part.to, &to = b.part.from;
  double replaced = 0;
  if (from.lower != to.lower || from.upper != to.upper) {
    if (a.part.is_reversed ? to.lower > from.upper : from.lower > to.upper) return false;
    const Outline_2::Part gap = part_between(a.part, b.part);
    const Drawn_part between = drawn(gap, given_ends(gap));
    replaced = (farthest(between.curve, a.part.end) + between.error) * UP;
    if (!(replaced <= 2 * (a.rounding + b.rounding))) return false;
  }
  join(parts_.size() - 2, replaced);
  return true;
}

// The last part goes back along the one before it, or along its end; or it starts by going back along all of that.
bool Chain_drawer::goes_back() {
  if (parts_.size() < 2) return false;
  Drawn_part &a = parts_[parts_.size() - 2], &b = parts_.back();
  const auto &p = a.curve.control_points(), &q = b.curve.control_points();
  if (dot(p.back() - p[p.size() - 2], q[1] - q[0]) > 0) return false;
  const double most = a.rounding + b.rounding;
  const Bezier_curve_2<double> back = a.curve.reversed();
  const auto leave_out = [&](double distance) {
    left_out_ = (std::max)(left_out_, (distance + a.error + a.replaced + b.error + b.replaced) * UP);
  };
  if (stable_norm(a.part.start - b.part.end) <= most) {
    const double distance = distance_bound(back, b.curve);
    if (!(distance <= most)) return false;
    leave_out(distance);
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
  leave_out(distance);
  Outline_2::Part part = is_longer ? b.part : a.part;
  const double at = parameter_of(part, is_longer ? t : 1 - t);
  if (is_longer) {
    part.from = {at, at};
    part.start = end;
    redraw(b, part);
    parts_.erase(parts_.end() - 2);
  } else {
    part.to = {at, at};
    part.end = end;
    redraw(a, part);
    parts_.pop_back();
  }
  return true;
}

// The last part is of a piece that the chain left, and went along. What it went is no longer than the piece.
bool Chain_drawer::comes_back() {
  if (parts_.size() < 3) return false;
  const Drawn_part& last = parts_.back();
  if (is_end_of_piece(last.part.from)) return false;  // nothing of the piece is before
  const double longest = 2 * length_of_controls(piece_of(last.part));
  double length = 0, rounding = 0, replaced = 0;
  std::size_t first = parts_.size() - 2;
  for (; !are_of_one_piece(parts_[first].part, last.part); --first) {
    const Drawn_part& d = parts_[first];
    length += length_of_controls(d.curve);
    rounding = (std::max)(rounding, d.rounding);
    replaced = (std::max)(replaced, d.error + d.replaced);
    if (first == 0 || length > longest) return false;
  }
  if (first + 2 == parts_.size()) return false;
  const Outline_2::Part &from = parts_[first].part, &to = last.part;
  if (!(from.is_reversed ? to.from.upper < from.to.lower : from.to.upper < to.from.lower)) return false;
  const Outline_2::Part along = part_between(from, to);
  const Drawn_part between = drawn(along, given_ends(along));
  std::vector<Bezier_curve_2<double>> way;
  for (std::size_t i = first + 1; i + 1 < parts_.size(); ++i) way.push_back(parts_[i].curve);
  const double most = rounding + between.rounding, distance = distance_bound(between.curve, way, most);
  if (!(distance <= most)) return false;
  join(first, (replaced + distance + between.error) * UP);
  return true;
}

// All of it is on one line, or within rounding of one.
bool Chain_drawer::bounds_nothing() {
  using Point = Exact_predicates_inexact_constructions_kernel::Point_2;
  double rounding = 0, error = 0, size = 0;
  const Xy<double> start = parts_.front().part.start;
  Xy<double> far = start, end = start;
  for (const Drawn_part& d : parts_) {
    rounding = (std::max)(rounding, d.rounding);
    error = (std::max)(error, d.error + d.replaced);
    for (const Xy<double>& p : d.curve.control_points())
      if (const double distance = stable_norm(p - start); distance > size) {
        size = distance;
        far = p;
      }
  }
  size = 0;
  for (const Drawn_part& d : parts_)
    for (const Xy<double>& p : d.curve.control_points())
      if (const double distance = stable_norm(p - far); distance > size) {
        size = distance;
        end = p;
      }
  const Point a(far.x, far.y), b(end.x, end.y);
  double width = 0;
  bool is_on_line = true;
  for (const Drawn_part& d : parts_) {
    for (const Xy<double>& p : d.curve.control_points())
      is_on_line = is_on_line && CGAL::collinear(a, b, Point(p.x, p.y));
    if (!is_on_line) width = (std::max)(width, distance_from_segment(d.curve, far, end));
    if (!is_on_line && !(width <= rounding)) return false;
  }
  left_out_ = (std::max)(left_out_, 2 * (width + error) * UP);
  return true;
}

}  // namespace CGAL::Bounding_arcs::internal
