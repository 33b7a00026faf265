// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Trims a raw offset whose edges touch, end on each other or lie on each other.
//
//   edges --contacts--> parts between knots --both sides asked--> boundary parts --by angle--> loops
//
// Whatever comes within a reach of each other is one knot: crossings, ends, touchings.  Parts between the same two
// knots that stay as near are one part.  A point next to a part on either side tells whether the part bounds what is
// covered. So it does not matter which edges there are beyond those that bound it, nor which way they run. The reach is
// a small share of eps, and far more than rounding.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_TOLERANT_TRIMMER_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_TOLERANT_TRIMMER_H

#include "Raw_offset.h"

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include "../arc/arc_crossings.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

// Points, of which those within a reach of each other are one: a knot, with the place of the one that came first.
// Squares as wide as the reach are knots, and one with their neighbours where those have points, too.

namespace CGAL::Bounding_arcs::internal {

class Knots {
 public:
  explicit Knots(double reach) : reach_(reach) {}

  std::uint32_t add(const Xy<double>& p) {
    points_.push_back(p);
    return static_cast<std::uint32_t>(points_.size() - 1);
  }
  /// Joins the points to knots; to be called when all are there.
  void join() {
    boost::disjoint_sets_with_storage<> sets(points_.size());
    std::vector<Cell> cells;
    for (std::uint32_t i = 0; i < points_.size(); ++i)
      cells.push_back({std::floor(points_[i].x / reach_), std::floor(points_[i].y / reach_), i});
    std::sort(cells.begin(), cells.end());
    for (auto c = cells.begin(); c != cells.end(); ++c) {
      if (c != cells.begin() && !(*(c - 1) < *c)) {
        sets.union_set((c - 1)->point, c->point);
        continue;
      }
      for (const Cell& beside :
           {Cell{c->x, c->y + 1, 0}, {c->x + 1, c->y - 1, 0}, {c->x + 1, c->y, 0}, {c->x + 1, c->y + 1, 0}}) {
        const auto found = std::lower_bound(c, cells.end(), beside);
        if (found != cells.end() && !(beside < *found)) sets.union_set(c->point, found->point);
      }
    }
    knot_.resize(points_.size());
    std::vector<std::uint32_t> first(points_.size(), NONE);  // of each set
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      std::uint32_t& of_set = first[sets.find_set(i)];
      knot_[i] = of_set = (std::min)(of_set, i);
      moved_ = (std::max)(moved_, euclidean_norm(points_[i] - points_[knot_[i]]));
    }
  }
  /// The knot of a point, which is a number below size().
  [[nodiscard]] std::uint32_t of(std::uint32_t point) const { return knot_[point]; }
  [[nodiscard]] const Xy<double>& place(std::uint32_t knot) const { return points_[knot]; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  /// How far a point is from the place of its knot at most.
  [[nodiscard]] double moved() const { return moved_; }

 private:
  struct Cell {
    double x, y;
    std::uint32_t point;
    friend bool operator<(const Cell& a, const Cell& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }
  };

  static constexpr std::uint32_t NONE = (std::numeric_limits<std::uint32_t>::max)();

  double reach_, moved_ = 0;
  std::vector<Xy<double>> points_;
  std::vector<std::uint32_t> knot_;
};

}  // namespace CGAL::Bounding_arcs::internal

// Where two arcs come within a reach of each other, as far as that is needed to cut them into parts that lie on each
// other, from end to end, or do not touch but at their ends: crossings, ends of one next to the other, and touchings.

namespace CGAL::Bounding_arcs {

/// A place on each of two arcs, as Moebius parameters, no farther from each other than the reach.
struct Arc_contact {
  double u, v;
};
/// The places in which two arcs are within reach of each other.
struct Arc_contacts {
  Arc_contact at[7];
  int count = 0;
};

[[nodiscard]] inline double clamped_parameter(const Arc_2& arc, const Xy<double>& q) {
  return (std::min)((std::max)(moebius_parameter(arc, q), 0.0), 1.0);
}

/// \param room what rounding may move points by, at most the reach
[[nodiscard]] inline Arc_contacts contacts(const Arc_2& e, const Arc_2& f, double room, double reach) {
  Arc_contacts result;
  const auto add = [&](double u, double v) { result.at[result.count++] = {u, v}; };
  const auto is_near = [reach](const Xy<double>& q, const Arc_2& arc) {
    return std::fabs(signed_distance(q, arc)) <= reach;
  };
  if (is_near(f.from, e)) add(clamped_parameter(e, f.from), 0);
  if (is_near(f.to, e)) add(clamped_parameter(e, f.to), 1);
  if (is_near(e.from, f)) add(0, clamped_parameter(f, e.from));
  if (is_near(e.to, f)) add(1, clamped_parameter(f, e.to));
  const Arc_crossings found = crossings(e, f, room);
  for (int k = 0; k < found.count; ++k) add(found.at[k].u, found.at[k].v);
  // Where both are nearest to each other without a crossing, side(q(v)) |g|^2 has nearly a double zero.  On one circle
  // no place is nearest.
  const Side_along s = side_along(e, f);
  const double bend = s.c0 - 2 * s.c1 + s.c2, v = (s.c0 - s.c1) / bend;
  const double flat = (1 + e.bulge * e.bulge) * euclidean_norm(e.to - e.from) * reach / 2;
  const bool is_one_circle = std::fabs(s.c0) <= flat && std::fabs(s.c1) <= flat && std::fabs(s.c2) <= flat;
  if (found.count == 0 && !is_one_circle && v > 0 && v < 1) {
    const Xy<double> q = moebius_point(f, v);
    if (is_near(q, e)) add(clamped_parameter(e, q), v);
  }
  return result;
}

}  // namespace CGAL::Bounding_arcs

namespace CGAL::Bounding_arcs::internal {

/// \tparam Covers bool(point): whether it is covered
template <class Covers> class Tolerant_trimmer {
 public:
  /// Shares of eps to take for the reach, in turn, as any of them may be that of a gap; first no more than rounding
  /// asks for, which closes no gaps.
  static constexpr std::array<double, 5> REACHES{0, 0x1p-7, 0x1p-8, 0x1p-6, 0x1p-5};

  /// \param room what rounding may move points by, at most a 64th of the reach
  /// \param side of parts that lie on each other those on that one are taken, where there are some
  Tolerant_trimmer(const Raw_offset& raw, const Covers& covers, double room, double reach,
                   Offset::Side side = Offset::Side::BOTH)
      : raw_(raw), covers_(covers), room_(room), reach_(reach), aside_(reach / 8), side_(side), knots_(reach) {}

  /// \return whether boundary parts make loops
  bool trim() {
    find_parts();
    choose_parts();
    return link();
  }
  [[nodiscard]] const std::vector<Raw_loop>& loops() const { return loops_; }
  /// Where boundary parts do not make loops, after trim() was false.
  [[nodiscard]] const Xy<double>& unresolved() const { return unresolved_; }
  /// Whether there are parts that do not bound what is covered.
  [[nodiscard]] bool leaves_out() const { return leaves_out_; }
  /// How far points of the loops may be from the boundary.
  [[nodiscard]] double error() const { return 2 * knots_.moved() + thickness_ + aside_; }

 private:
  struct Cut {
    Xy<double> at;
    std::uint32_t point;
    double u;
  };
  /// A part of an edge from one knot to another; in bundles the lower knot is first.
  struct Part {
    std::uint32_t from, to, edge;
    double u, v;
  };
  struct Ray {  // of a boundary part at a knot
    std::uint32_t knot;
    double angle;
    bool leaves;
    std::uint32_t part;
  };

  void find_parts() {
    const std::size_t n = raw_.edges.size();
    std::vector<std::uint32_t> begins;
    for (const Raw_run& run : raw_.runs) begins.push_back(run.begin);
    begins.push_back(static_cast<std::uint32_t>(n));
    const auto arc_of = [&](std::uint32_t i) -> const Arc_2& { return raw_.edges[i].arc; };
    const Arc_blocks blocks(
        begins, arc_of, [&](std::uint32_t i) { return raw_.edges[i].turn; }, reach_);
    std::vector<std::vector<Cut>> cuts(n);
    const auto cut = [&](std::uint32_t edge, double u) {
      const Xy<double> p = moebius_point(arc_of(edge), u);
      cuts[edge].push_back({p, knots_.add(p), u});
    };
    for (std::uint32_t i = 0; i < n; ++i) {
      cut(i, 0);
      cut(i, 1);
    }
    blocks.for_each_pair([&](std::uint32_t i, std::uint32_t j) {
      const Arc_contacts found = contacts(arc_of(i), arc_of(j), room_, reach_);
      for (int k = 0; k < found.count; ++k) {
        if (found.at[k].u > 0 && found.at[k].u < 1) cut(i, found.at[k].u);
        if (found.at[k].v > 0 && found.at[k].v < 1) cut(j, found.at[k].v);
      }
      return true;
    });
    // Edges that lie on each other are cut where any of them is.
    const auto cut_as = [&](std::uint32_t i, std::uint32_t j) {
      for (std::size_t k = 0; k < cuts[i].size(); ++k) {
        const Xy<double> p = cuts[i][k].at;
        const auto is_there = [&](const Cut& c) { return euclidean_norm(c.at - p) <= reach_; };
        if (std::fabs(signed_distance(p, arc_of(j))) > reach_) continue;
        if (std::none_of(cuts[j].begin(), cuts[j].end(), is_there)) cut(j, clamped_parameter(arc_of(j), p));
      }
    };
    blocks.for_each_pair([&](std::uint32_t i, std::uint32_t j) {
      cut_as(i, j);
      cut_as(j, i);
      return true;
    });
    knots_.join();
    for (std::uint32_t e = 0; e < n; ++e) {
      std::sort(cuts[e].begin(), cuts[e].end(), [](const Cut& a, const Cut& b) { return a.u < b.u; });
      for (std::size_t i = 0; i + 1 < cuts[e].size(); ++i) {
        const Cut &a = cuts[e][i], &b = cuts[e][i + 1];
        const std::uint32_t p = knots_.of(a.point), q = knots_.of(b.point);
        if (p < q) bundles_.push_back({p, q, e, a.u, b.u});
        if (q < p) bundles_.push_back({q, p, e, b.u, a.u});
      }
    }
    const auto rank = [this](const Part& p) {
      return std::make_tuple(p.from, p.to, !is_on_side(raw_.edges[p.edge], side_), p.edge, p.u);
    };
    std::sort(bundles_.begin(), bundles_.end(), [&](const Part& a, const Part& b) { return rank(a) < rank(b); });
  }

  [[nodiscard]] Arc_2 arc_of(const Part& p) const {
    const Arc_2& arc = raw_.edges[p.edge].arc;
    const Arc_2 part{moebius_point(arc, p.u), moebius_point(arc, p.v),
                     p.u < p.v ? bulge_between(arc, p.u, p.v) : -bulge_between(arc, p.v, p.u)};
    const Xy<double>&from = knots_.place(p.from), &to = knots_.place(p.to);
    const double was = euclidean_norm(part.to - part.from);
    return {from, to, was > 0 ? part.bulge * (euclidean_norm(to - from) / was) : 0};
  }

  void choose_parts() {
    std::vector<bool> is_done(bundles_.size(), false);
    for (std::size_t i = 0; i < bundles_.size(); ++i) {
      if (is_done[i]) continue;
      const Part& p = bundles_[i];
      const Arc_2& whole = raw_.edges[p.edge].arc;
      const double middle = (p.u + p.v) / 2;
      const Xy<double> at = moebius_point(whole, middle);
      const Xy<double> left = (p.u < p.v ? 1.0 : -1.0) * normal_at(at, whole);
      double low = 0, high = 0;  // how far others are to the left
      for (std::size_t j = i + 1; j < bundles_.size() && are_between_same(p, bundles_[j]); ++j) {
        const Part& q = bundles_[j];
        const Xy<double> near = nearest_point(at, raw_.edges[q.edge].arc);
        constexpr double WIDE = 4;
        if (is_done[j] || euclidean_norm(near - at) > WIDE * reach_) continue;
        is_done[j] = true;
        low = (std::min)(low, dot(left, near - at));
        high = (std::max)(high, dot(left, near - at));
      }
      thickness_ = (std::max)(thickness_, high - low);
      const bool is_left = covers_(at + (high + aside_) * left), is_right = covers_(at + (low - aside_) * left);
      if (is_left == is_right) {
        leaves_out_ = true;
        continue;
      }
      boundary_.push_back(is_right ? p : Part{p.to, p.from, p.edge, p.v, p.u});
    }
  }
  [[nodiscard]] static bool are_between_same(const Part& p, const Part& q) { return p.from == q.from && p.to == q.to; }

  // What is not covered is to the left: at a knot the part goes on that is next to it clockwise from where one came.
  bool link() {
    std::vector<Ray> rays;
    std::vector<Arc_2> arcs;
    std::vector<double> radius(knots_.size(), HUGE_VAL);  // in which no part at a knot ends
    for (const Part& p : boundary_) {
      arcs.push_back(arc_of(p));
      const double half = euclidean_norm(arcs.back().to - arcs.back().from) / 2;
      for (const std::uint32_t k : {p.from, p.to}) radius[k] = (std::min)(radius[k], half);
    }
    const auto add = [&](std::uint32_t knot, bool leaves, std::uint32_t part) {
      const Arc_2& arc = arcs[part];
      const double share = radius[knot] / euclidean_norm(arc.to - arc.from);
      const Xy<double> way = moebius_point(arc, leaves ? share : 1 - share) - knots_.place(knot);
      rays.push_back({knot, std::atan2(way.y, way.x), leaves, part});
    };
    for (std::uint32_t p = 0; p < boundary_.size(); ++p) {
      add(boundary_[p].from, true, p);
      add(boundary_[p].to, false, p);
    }
    are_met_.assign(knots_.size(), false);
    std::sort(rays.begin(), rays.end(),
              [](const Ray& a, const Ray& b) { return a.knot != b.knot ? a.knot < b.knot : a.angle > b.angle; });
    std::vector<std::uint32_t> next(boundary_.size());
    for (std::size_t begin = 0, end = 0; begin < rays.size(); begin = end) {
      while (end < rays.size() && rays[end].knot == rays[begin].knot) ++end;
      if (end - begin > 2) are_met_[rays[begin].knot] = true;
      for (std::size_t k = begin; k < end; ++k) {
        const Ray &a = rays[k], &b = rays[k + 1 == end ? begin : k + 1];
        if (a.leaves == b.leaves) {
          unresolved_ = knots_.place(a.knot);
          return false;
        }
        if (b.leaves) next[a.part] = b.part;
      }
    }
    make_loops(next);
    return true;
  }
  void make_loops(const std::vector<std::uint32_t>& next) {
    std::vector<bool> is_used(boundary_.size(), false);
    for (std::uint32_t first = 0; first < boundary_.size(); ++first) {
      if (is_used[first]) continue;
      std::vector<Part> parts;
      for (std::uint32_t p = first; !is_used[p]; p = next[p]) {
        is_used[p] = true;
        parts.push_back(boundary_[p]);
      }
      loops_.push_back(joined(std::move(parts)));
    }
  }
  // Parts of an edge that follow each other are one, but at knots where loops touch.
  [[nodiscard]] Raw_loop joined(std::vector<Part> parts) const {
    const auto goes_on = [this](const Part& a, const Part& b) {
      return a.edge == b.edge && a.v == b.u && a.to == b.from && !are_met_[a.to];
    };
    std::size_t first = 0;  // behind an end, where there is one
    while (first < parts.size() && goes_on(parts[first == 0 ? parts.size() - 1 : first - 1], parts[first])) ++first;
    if (first < parts.size())
      std::rotate(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(first), parts.end());
    std::vector<Part> whole;
    for (const Part& p : parts) {
      if (whole.empty() || !goes_on(whole.back(), p) || whole.back().from == p.to) {
        whole.push_back(p);
      } else {
        whole.back().to = p.to;
        whole.back().v = p.v;
      }
    }
    Raw_loop loop;
    for (const Part& p : whole) loop.push_back({p.edge, arc_of(p), p.u, p.v});
    return loop;
  }

  const Raw_offset& raw_;
  const Covers& covers_;
  double room_, reach_, aside_, thickness_ = 0;
  Offset::Side side_;
  bool leaves_out_ = false;
  Knots knots_;
  std::vector<Part> bundles_, boundary_;
  std::vector<bool> are_met_;  // knots of more than two boundary parts
  std::vector<Raw_loop> loops_;
  Xy<double> unresolved_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
