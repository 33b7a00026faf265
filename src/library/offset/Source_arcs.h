// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The chains of arcs of some curves of a drawing, with their normals, and what is asked of them: whether something is
// nearer than a distance, how often closed ones run round a point, and whether any two cross.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_SOURCE_ARCS_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_SOURCE_ARCS_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include "../arc/arc_crossings.h"
#include "../query/Area_sum.h"
#include "Arc_boxes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Unit normals to the left, at both ends of an arc. They take as much memory as the arc, and a square root.
struct End_normals {
  Xy<double> n0, n1;
  double curvature;
};
[[nodiscard]] inline End_normals end_normals(const Arc_2& arc) {
  const Xy<double> chord = arc.to - arc.from;
  const double length = stable_norm(chord);
  if (!(length > 0)) return {{0, 1}, {0, 1}, 0};  // of a point, which is a band of no length
  const Xy<double> m = moebius_turn(arc), along = (1 / length) * chord, across = perp(along);
  return {m.x * across + m.y * along, m.x * across - m.y * along, 2 * m.y / length};
}

struct Source_arc {
  Arc_2 arc;
  std::uint32_t curve, bezier;  ///< of the drawing
  double t0, t1;                ///< t0 > t1 where an outline runs the other way
  std::uint32_t chain;          ///< of the curves here
};
struct Source_curve {
  std::uint32_t begin, end;  ///< its arcs; none of a curve that is a point
  bool is_closed;
  bool is_speck;  ///< a closed one that rounding makes a point
  Xy<double> start;
  double eps;   ///< its own tolerance, at most that of the offset: less where it is small or thin
  double area;  ///< that it runs round, if closed
  CGAL::Bbox_2 box;
};

/// Half of how wide a closed curve is across, about: its area over its extents.
[[nodiscard]] inline double thickness(const Source_curve& c) {
  const double extents = c.box.xmax() - c.box.xmin() + (c.box.ymax() - c.box.ymin());
  return extents > 0 ? std::fabs(c.area) / extents : 0;
}
/// Whether a curve is so thin that its tolerance decides which way it runs.
[[nodiscard]] inline bool is_thin(const Source_curve& c) { return c.is_closed && thickness(c) <= c.eps; }

/// The area between an arc and its chord, negative to the right.
[[nodiscard]] inline double area_of_cap(const Arc_2& arc) {
  return dot(arc.to - arc.from, arc.to - arc.from) * lens_share(arc.bulge);
}

class Source_arcs {
 public:
  std::vector<Source_arc> arcs;
  std::vector<Source_curve> curves;
  double size = 0;  ///< the largest |coordinate|

  /// Appends an arc to the last curve.
  void add(const Arc_2& arc, std::uint32_t curve, std::uint32_t bezier, double t0, double t1) {
    for (const Xy<double>& p : {arc.from, arc.to}) size = (std::max)({size, std::fabs(p.x), std::fabs(p.y)});
    if (arc.from == arc.to) return;
    arcs.push_back({arc, curve, bezier, t0, t1, last_curve()});
    Source_curve& c = curves.back();
    c.area += cross(arc.from - c.start, arc.to - c.start) / 2 + area_of_cap(arc);
    c.box += box_about(arc);
  }
  /// Moves the end of the last arc a little.
  void move_end(const Xy<double>& end) { arcs.back().arc.to = end; }
  /// Begins a curve.
  void begin_curve(bool is_closed, const Xy<double>& start) {
    const auto begin = static_cast<std::uint32_t>(arcs.size());
    curves.push_back({begin, begin, is_closed, false, start, 0, 0, {start.x, start.y, start.x, start.y}});
  }
  /// Ends the last curve, whose arcs are right within an error.  Whether what a closed curve runs round is there moves
  /// an offset by its distance, so that nothing is done within a tolerance which that may vanish in.
  void end_curve(double eps, double error) {
    constexpr double OF_EXTENT = 0x1p-6, OF_THICKNESS = 0x1p-4, ROOMS = 64;
    Source_curve& c = curves.back();
    c.end = static_cast<std::uint32_t>(arcs.size());
    c.eps = eps;
    if (!c.is_closed) return;
    c.eps = (std::min)(eps, OF_EXTENT * (std::max)(c.box.xmax() - c.box.xmin(), c.box.ymax() - c.box.ymin()));
    const double thick = thickness(c);
    if (error <= OF_THICKNESS * thick && ROOMS * room(0) <= thick) c.eps = (std::min)(c.eps, OF_THICKNESS * thick);
  }
  /// Makes the last curve, which has no arcs, one of a point: a band of no length.
  /// \param is_rounded whether rounding made it one
  void add_point(std::uint32_t curve, bool is_rounded) {
    Source_curve& c = curves.back();
    c.is_speck = c.is_closed && is_rounded;
    c.is_closed = false;
    size = (std::max)({size, std::fabs(c.start.x), std::fabs(c.start.y)});
    arcs.push_back({{c.start, c.start, 0}, curve, 0, 0, 1, last_curve()});
  }
  /// Appends a curve of others.
  void add_copy(const Source_arcs& others, const Source_curve& c) {
    const auto begin = static_cast<std::uint32_t>(arcs.size());
    arcs.insert(arcs.end(), others.arcs.begin() + c.begin, others.arcs.begin() + c.end);
    curves.push_back(c);
    curves.back().begin = begin;
    curves.back().end = static_cast<std::uint32_t>(arcs.size());
    for (std::uint32_t i = begin; i < arcs.size(); ++i) arcs[i].chain = last_curve();
    size = (std::max)(size, others.size);
  }
  /// Takes the last curve away.
  void remove_last() {
    arcs.resize(curves.back().begin);
    curves.pop_back();
  }
  /// Lets the last curve run the other way.
  void reverse_last() {
    Source_curve& c = curves.back();
    std::reverse(arcs.begin() + c.begin, arcs.begin() + c.end);
    for (std::uint32_t i = c.begin; i < c.end; ++i) {
      Source_arc& s = arcs[i];
      s = {{s.arc.to, s.arc.from, -s.arc.bulge}, s.curve, s.bezier, s.t1, s.t0, s.chain};
    }
    c.area = -c.area;
  }
  /// Completes the curves; to be called when all arcs are there.
  void finish() {
    std::vector<std::uint32_t> begins;
    for (const Source_curve& c : curves) begins.push_back(c.begin);
    begins.push_back(static_cast<std::uint32_t>(arcs.size()));
    const std::vector<double> turn = turns();
    blocks_ = Arc_blocks(
        begins, [&](std::uint32_t i) -> const Arc_2& { return arcs[i].arc; }, [&](std::uint32_t i) { return turn[i]; });
    for (std::uint32_t i = 0; i < curves.size(); ++i) {
      const Source_curve& c = curves[i];
      if (!c.is_closed) continue;
      closed_.push_back(i);
      rings_.add(c.end - c.begin, [&](std::size_t k) -> const Arc_2& { return arcs[c.begin + k].arc; });
    }
    rings_.finish();
    const double slack = room(0);
    is_simple_ = blocks_.for_each_pair([&](std::uint32_t i, std::uint32_t j) {
      const Arc_2 &e = arcs[i].arc, &f = arcs[j].arc;
      if (are_neighbours(i, j)) {
        if (e.to == f.from && meet_again(e, f, slack)) return false;
        return f.to != e.from || !meet_again(f, e, slack);
      }
      const Arc_crossings c = crossings(e, f, slack);
      return c.count == 0 && !c.is_doubtful;
    });
    blocks_.drop_boxes_of_arcs();
  }
  [[nodiscard]] const Arc_blocks& blocks() const { return blocks_; }
  /// The least tolerance of a curve: what is done within a part of it loses none of them.
  [[nodiscard]] double least_eps() const {
    double eps = HUGE_VAL;
    for (const Source_curve& c : curves) eps = (std::min)(eps, c.eps);
    return eps;
  }
  /// What rounding may move computed points and distances by, up to some times a distance as large as d.
  [[nodiscard]] double room(double d) const {
    constexpr double ROUNDINGS = 64 * HALF_ULP;
    return ROUNDINGS * (size + std::fabs(d));
  }

  static constexpr std::uint32_t NONE = static_cast<std::uint32_t>(-1);
  /// How often the closed curves run round x, all of them but one.
  [[nodiscard]] int winding(const Xy<double>& x, std::uint32_t left_out = NONE) const {
    int sum = 0;
    rings_.for_each_about(x, [&](std::size_t ring) {
      const std::uint32_t begin = curves[closed_[ring]].begin;
      if (closed_[ring] == left_out) return;
      sum += rings_.winding(ring, x, [&](std::size_t k) -> const Arc_2& { return arcs[begin + k].arc; });
    });
    return sum;
  }
  /// How often all curves run round the points to the right of one that meets no other, and one time more to its left.
  [[nodiscard]] int winding_to_the_right(const Source_curve& c) const {
    return (c.area > 0 ? 0 : -1) + winding(c.start, static_cast<std::uint32_t>(&c - curves.data()));
  }
  /// Whether no two arcs have a common point but neighbours the one in which they meet; may be false where they nearly
  /// do.
  [[nodiscard]] bool is_simple() const { return is_simple_; }

  /// What each arc turns by, with the corner before it.
  [[nodiscard]] std::vector<double> turns() const {
    constexpr double HALF_CIRCLE = 3.1415926535897932, OF_SINE = HALF_CIRCLE / 2;  // x <= sin x * pi / 2
    std::vector<double> turns;
    turns.reserve(arcs.size());
    Xy<double> before;  // the normal at the end of the arc before
    for (std::uint32_t i = 0; i < arcs.size(); ++i) {
      const End_normals normals = end_normals(arcs[i].arc);
      turns.push_back(4 * std::fabs(arcs[i].arc.bulge));
      if (i > 0 && arcs[i - 1].chain == arcs[i].chain)
        turns.back() += dot(before, normals.n0) > 0 ? OF_SINE * std::fabs(cross(before, normals.n0)) : HALF_CIRCLE;
      before = normals.n1;
    }
    return turns;
  }

 private:
  [[nodiscard]] std::uint32_t last_curve() const { return static_cast<std::uint32_t>(curves.size() - 1); }
  [[nodiscard]] bool are_neighbours(std::uint32_t i, std::uint32_t j) const {
    if (arcs[i].chain != arcs[j].chain) return false;
    return arcs[i].arc.to == arcs[j].arc.from || arcs[j].arc.to == arcs[i].arc.from;
  }

  Arc_blocks blocks_;
  Arc_rings rings_;                    // of closed curves
  std::vector<std::uint32_t> closed_;  // the curve of each ring
  bool is_simple_ = true;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
