// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The raw offset: arcs at a distance to the left of directed chains, with what goes round their corners, in runs.
//
// An arc's offset has the same end normals, so the same bulge, and its ends are those of the arc moved along them; no
// center is needed.  Where the distance is beyond an arc's radius on its inner side, the offset is inverted: all of it
// is nearer to the chain than the distance.  So is what would join offsets at the inner side of a corner.  There runs
// end.  The chain that an edge is the offset of is on its right; to its left is what is farther than the distance.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_RAW_OFFSET_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_RAW_OFFSET_H

#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>
#include "Source_arcs.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

struct Raw_edge {
  Arc_2 arc;
  std::uint32_t source;  ///< an arc of the sources
  Offset::Kind kind;
  bool is_round;
  bool is_backward;  ///< the source is run backwards: the offset is on its right
  bool is_at_end;    ///< of a join or a cap: it is about the end of the source
  double turn;       ///< with the corner before it
};
/// What a join or a cap covers beside arcs: a convex polygon, clockwise, or a sector of a disc of at most half a
/// circle, whose corners are the center and the ends of its arc, clockwise, too.
struct Raw_shape {
  std::array<Xy<double>, 5> corners;
  std::size_t size;
  double radius;  ///< 0 of a polygon
};
struct Raw_run {
  std::uint32_t begin, end;
  bool is_closed;
};
struct Raw_offset {
  std::vector<Raw_edge> edges;
  std::vector<Raw_run> runs;
  std::vector<Raw_shape> shapes;
  double gap = 0;            ///< how far edges were moved at most so that an end meets its neighbour
  bool has_points = false;   ///< arcs were as far as their centers: edges before and behind may cross again
  bool has_backs = false;    ///< closed curves turn back, within what may be a slit: joins of both sides are there
  bool has_normals = false;  ///< segments along normals are among the edges, which may be covered on both sides
};

/// Whether an edge is what is wanted where curves are offset on one side; caps are on none.
[[nodiscard]] inline bool is_on_side(const Raw_edge& edge, Offset::Side side) {
  return side == Offset::Side::BOTH ||
         (edge.kind != Offset::Kind::CAP && edge.is_backward == (side == Offset::Side::RIGHT));
}

/// A part of an edge.
struct Raw_part {
  std::uint32_t edge;
  Arc_2 arc;
  double u, v;  ///< where on the edge
};
using Raw_loop = std::vector<Raw_part>;

/// The sine of half the turn of an arc from another start, which is half the curvature times the chord; nothing where
/// that is near 1, so that ends do not tell the turn.
[[nodiscard]] inline std::optional<double> half_turn_sine(const Arc_2& arc, const Xy<double>& start) {
  constexpr double MOST = 0.96;
  const double b = arc.bulge, sine = 2 * b / (1 + b * b),
               share = euclidean_norm(arc.to - start) / euclidean_norm(arc.to - arc.from);
  if (!(std::fabs(b) < 1 && std::fabs(sine) <= MOST && std::fabs(share * sine) <= MOST)) return std::nullopt;
  return share * sine;
}
/// The arc of the same curvature from another start that is near; a segment to an arc that is a point, as the offset of
/// a circle by nearly its radius may be.
[[nodiscard]] inline Arc_2 from_another_start(const Arc_2& arc, const Xy<double>& start) {
  if (arc.from == arc.to) return {start, arc.to, 0};
  if (const std::optional<double> sine = half_turn_sine(arc, start))
    return {start, arc.to, *sine / (1 + std::sqrt(1 - *sine * *sine))};
  const double was = euclidean_norm(arc.to - arc.from), is = euclidean_norm(arc.to - start);
  return {start, arc.to, arc.bulge * (is / was)};
}
/// How far that may be from the circle of the arc. The circle turns about the other end, which moves no point by more
/// than twice as much as the start. Where b / L is kept in place of the curvature k = 4 b / ((1 + b^2) L), that changes
/// by less than b^2 times the way, too.
[[nodiscard]] inline double way_off(const Arc_2& arc, const Xy<double>& start) {
  if (arc.from == arc.to) return euclidean_norm(start - arc.from);
  const double square = 1 + arc.bulge * arc.bulge, length = euclidean_norm(arc.to - arc.from);
  return std::fabs(side_of_circle(start, arc)) / (square * length) * 2 +
         (half_turn_sine(arc, start) ? 0 : arc.bulge * arc.bulge * euclidean_norm(start - arc.from));
}

class Raw_builder {
 public:
  /// \param snap gaps up to that are closed without a join
  /// \param is_round all joins and caps are: else what is covered has sides along normals, and these are added
  Raw_builder(const Source_arcs& sources, const Offset::Options& options, double snap, bool is_round)
      : sources_(sources), options_(options), is_round_(is_round), least_snap_(snap), snap_(snap) {}

  /// What is d to the left of a closed curve, or to the right.
  void add_side(const Source_curve& c, bool is_right, double d) {
    path_.clear();
    for (std::uint32_t i = c.begin; i < c.end; ++i)
      path_.push_back(is_right ? directed(c.end - 1 - (i - c.begin), true) : directed(i, false));
    add_path(d, false);
  }
  /// What is d away from an open curve, on both sides.
  void add_band(const Source_curve& c, double d) {
    const Arc_2& first = sources_.arcs[c.begin].arc;
    const bool is_point = c.end == c.begin + 1 && first.from == first.to;
    if (is_point && options_.cap == Offset::Cap::BUTT) return;  // nothing has no length and no caps
    path_.clear();
    for (std::uint32_t i = c.begin; i < c.end; ++i) path_.push_back(directed(i, false));
    for (std::uint32_t i = c.end; i > c.begin; --i) path_.push_back(directed(i - 1, true));
    add_path(d, true);
  }
  [[nodiscard]] Raw_offset& result() { return raw_; }

 private:
  struct Directed {
    Arc_2 arc;
    Xy<double> n0, n1;
    double curvature;
    std::uint32_t source;
    bool is_backward;
  };
  enum class Joint { SMOOTH, JOIN, CAP, BREAK };

  [[nodiscard]] Directed directed(std::uint32_t i, bool is_backward) const {
    const Source_arc& s = sources_.arcs[i];
    const End_normals n = end_normals(s.arc);
    if (!is_backward) return {s.arc, n.n0, n.n1, n.curvature, i, false};
    return {{s.arc.to, s.arc.from, -s.arc.bulge}, -n.n1, -n.n0, -n.curvature, i, true};
  }
  [[nodiscard]] const Directed& before(std::size_t i) const { return path_[i == 0 ? path_.size() - 1 : i - 1]; }
  [[nodiscard]] bool is_inverted(const Directed& a) const { return stretch(a) < 0 && !is_point(a); }
  [[nodiscard]] double stretch(const Directed& a) const { return 1 - a.curvature * d_; }
  [[nodiscard]] bool is_point(const Directed& a) const {
    return std::fabs(stretch(a)) * euclidean_norm(a.arc.to - a.arc.from) <= sources_.room(d_);
  }
  [[nodiscard]] Joint joint(std::size_t i) const {
    if (is_band_ && (i == 0 || i == path_.size() / 2)) return Joint::CAP;
    const Xy<double>&p = before(i).n1, &q = path_[i].n0;
    if (d_ * euclidean_norm(q - p) <= (cross(p, q) < 0 && dot(p, q) > 0 ? least_snap_ : snap_)) return Joint::SMOOTH;
    // Where a curve turns back its legs part by their curvatures; if not even those differ, both sides get a join, of
    // which trimming takes what is wrong.
    const bool is_join = turns_back(i) ? before(i).curvature + path_[i].curvature >= 0 : cross(p, q) < 0;
    return is_join ? Joint::JOIN : Joint::BREAK;
  }
  [[nodiscard]] bool turns_back(std::size_t i) const {
    constexpr double SINE = 0x1p-20;
    const Xy<double>&p = before(i).n1, &q = path_[i].n0;
    return dot(p, q) < 0 && std::fabs(cross(p, q)) < SINE;
  }

  void add_path(double d, bool is_band) {
    d_ = d;
    is_band_ = is_band;
    // Behind an inner corner by the angle a offsets run over each other for d a, and part by d a^2: signs tell of
    // crossings if that is more than rounding.  Where joins are not round no wider gap between normals is let pass.
    // At an outer corner, and where an arc has become a point, nothing crosses: no gap but a share of eps is let pass.
    snap_ = is_round_ ? (std::max)(least_snap_, 2 * std::sqrt(sources_.room(d) * d)) : least_snap_;
    const std::size_t n = path_.size();
    if (n == 0) return;
    std::size_t first = 0;
    while (first < n && joint(first) != Joint::BREAK && !is_inverted(path_[first])) ++first;
    is_whole_ = first == n;
    is_active_ = is_behind_point_ = false;
    run_begin_ = size();
    if (is_whole_) {
      first = 0;
      start_ = offset_start(path_[0]);
      activate(start_);
    }
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = (first + k) % n;
      if (k > 0) pass(i);
      add_edge(path_[i]);
    }
    pass(first);
    if (is_whole_ && size() > run_begin_) {
      if (last_ != start_) connect(start_, path_[0]);
      close(run_begin_);
      if (is_behind_point_) raw_.edges[run_begin_].turn += HALF_CIRCLE;
      raw_.runs.push_back({run_begin_, size(), true});
    } else {
      finish_run();
    }
    for (std::size_t i = 0; !is_round_ && i < n; ++i) add_normals(i);
  }
  // At an inner corner, and beside arcs that are inverted, what is covered ends at a normal unless the next arc covers
  // that.
  void add_normals(std::size_t i) {
    const Joint j = joint(i);
    const Directed &a = before(i), &b = path_[i];
    if (j != Joint::BREAK && !is_inverted(a) && !is_inverted(b)) return;
    const Xy<double>& vertex = b.arc.from;
    const auto add = [&](const Xy<double>& tip) {
      run_begin_ = size();
      emit({vertex, tip, 0}, a, Offset::Kind::JOIN, false, true, HALF_CIRCLE);
      finish_run();
      raw_.has_normals = true;
    };
    const Xy<double> of_a = offset_end(a), of_b = offset_start(b);
    if (!is_beside(of_a, b)) add(of_a);
    if (d_ * euclidean_norm(b.n0 - a.n1) > snap_ && !is_beside(of_b, a)) add(of_b);
  }
  // Whether q is nearer than d to the left of an arc, and so is what is between q and one of its ends.
  [[nodiscard]] bool is_beside(const Xy<double>& q, const Directed& a) const {
    const Xy<double> t0{a.n0.y, -a.n0.x}, t1{a.n1.y, -a.n1.x};
    if (is_inverted(a) || !(dot(t0, q - a.arc.from) > snap_) || !(dot(t1, q - a.arc.to) < -snap_)) return false;
    const double away = signed_distance(q, a.arc);
    return away > 0 && away < d_ - sources_.room(d_);
  }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(raw_.edges.size()); }
  [[nodiscard]] Xy<double> offset_start(const Directed& a) const { return a.arc.from + d_ * a.n0; }
  [[nodiscard]] Xy<double> offset_end(const Directed& a) const { return a.arc.to + d_ * a.n1; }

  void activate(const Xy<double>& p) {
    if (!is_active_) last_ = p;
    is_active_ = true;
  }
  void finish_run() {
    if (size() > run_begin_) raw_.runs.push_back({run_begin_, size(), false});
    run_begin_ = size();
    is_active_ = false;
  }
  void emit(const Arc_2& arc, const Directed& source, Offset::Kind kind, bool is_round, bool is_at_end, double turn) {
    if (std::exchange(is_behind_point_, false)) turn += HALF_CIRCLE;
    raw_.edges.push_back({arc, source.source, kind, is_round, source.is_backward, is_at_end, turn});
    last_ = arc.to;
  }
  // To a point that ought to be the last one.
  void connect(const Xy<double>& p, const Directed& a) {
    if (euclidean_norm(p - last_) > least_snap_) emit({last_, p, 0}, a, Offset::Kind::JOIN, true, false, HALF_CIRCLE);
  }
  void close(std::uint32_t first) {
    Arc_2& arc = raw_.edges.back().arc;
    const Arc_2 back{arc.to, arc.from, -arc.bulge};
    const Xy<double>& start = raw_.edges[first].arc.from;
    if (start == arc.to) return;
    raw_.gap = (std::max)(raw_.gap, way_off(back, start));
    const Arc_2 moved = from_another_start(back, start);
    arc = {moved.to, moved.from, -moved.bulge};
  }
  void add_edge(const Directed& a) {
    if (is_point(a)) {
      raw_.has_points = is_behind_point_ = true;
      return activate(offset_start(a));
    }
    if (is_inverted(a)) return finish_run();
    activate(offset_start(a));
    const Arc_2 arc{offset_start(a), offset_end(a), a.arc.bulge};
    connect(arc.from, a);
    if (last_ != arc.from) raw_.gap = (std::max)(raw_.gap, way_off(arc, last_));
    emit(from_another_start(arc, last_), a, Offset::Kind::CURVE, true, false, 4 * std::fabs(a.arc.bulge));
  }
  // Goes round the start of arc i.
  void pass(std::size_t i) {
    const Joint j = joint(i);
    if (j == Joint::BREAK) return finish_run();
    if (j == Joint::SMOOTH) return;
    raw_.has_backs = raw_.has_backs || (!is_band_ && turns_back(i));
    activate(offset_end(before(i)));
    const Xy<double>&vertex = path_[i].arc.from, end = offset_start(path_[i]);
    if (j == Joint::CAP) add_cap(vertex, before(i), end);
    else add_join(vertex, before(i), path_[i], end);
  }
  void add_round(const Xy<double>& vertex, const Directed& a, const Xy<double>& normal, const Xy<double>& end,
                 Offset::Kind kind) {
    double turn = std::atan2(-cross(a.n1, normal), dot(a.n1, normal));  // to the right
    if (turn < 0) turn += 2 * HALF_CIRCLE;
    const int count = 1 + static_cast<int>(turn / (0.5 * HALF_CIRCLE + 0x1p-20));
    const double bulge = -std::tan(turn / count / 4);
    for (int k = 1; k <= count; ++k) {
      const double c = std::cos(turn * k / count), s = std::sin(turn * k / count);
      const Xy<double> to =
          k == count ? end : vertex + d_ * Xy<double>{c * a.n1.x + s * a.n1.y, c * a.n1.y - s * a.n1.x};
      if (!is_round_) raw_.shapes.push_back({{vertex, last_, to}, 3, d_});
      emit({last_, to, bulge}, a, kind, true, true, turn / count);
    }
  }
  void add_segments(const Xy<double>& vertex, const Directed& a, const std::vector<Xy<double>>& points,
                    Offset::Kind kind) {
    Raw_shape shape{{vertex}, 1, 0};  // clockwise as it is run round
    shape.corners[shape.size++] = last_;
    for (const Xy<double>& p : points) {
      shape.corners[shape.size++] = p;
      emit({last_, p, 0}, a, kind, false, true, HALF_CIRCLE);
    }
    if (!is_round_) raw_.shapes.push_back(shape);
  }
  void add_join(const Xy<double>& vertex, const Directed& a, const Directed& b, const Xy<double>& end) {
    const double c = 1 + dot(a.n1, b.n0), limit = options_.miter_limit;
    if (options_.join == Offset::Join::ROUND) return add_round(vertex, a, b.n0, end, Offset::Kind::JOIN);
    // the tip is sqrt(2 / c) times d away
    if (options_.join == Offset::Join::MITER && 2 <= limit * limit * c)
      return add_segments(vertex, a, {vertex + (d_ / c) * (a.n1 + b.n0), end}, Offset::Kind::JOIN);
    add_segments(vertex, a, {end}, Offset::Kind::JOIN);
  }
  void add_cap(const Xy<double>& vertex, const Directed& a, const Xy<double>& end) {
    if (options_.cap == Offset::Cap::ROUND) return add_round(vertex, a, -a.n1, end, Offset::Kind::CAP);
    const Xy<double> on = d_ * Xy<double>{a.n1.y, -a.n1.x};
    if (options_.cap == Offset::Cap::BUTT) return add_segments(vertex, a, {end}, Offset::Kind::CAP);
    add_segments(vertex, a, {last_ + on, end + on, end}, Offset::Kind::CAP);
  }

  static constexpr double HALF_CIRCLE = 3.1415926535897932;
  const Source_arcs& sources_;
  const Offset::Options& options_;
  bool is_round_;
  double least_snap_, snap_, d_ = 0;
  bool is_band_ = false, is_active_ = false, is_whole_ = false;
  bool is_behind_point_ = false;  // what turned between edges is a point now
  std::vector<Directed> path_;
  Raw_offset raw_;
  std::uint32_t run_begin_ = 0;
  Xy<double> last_, start_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
