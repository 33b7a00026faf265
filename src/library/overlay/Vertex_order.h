// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order of edges round a vertex, counterclockwise.
//
// Directions in doubles tell it where they are apart by more than their errors; of those that are not, ways are
// compared exactly (Exact_curve.h).

#ifndef BOUNDING_ARCS_LIBRARY_OVERLAY_VERTEX_ORDER_H
#define BOUNDING_ARCS_LIBRARY_OVERLAY_VERTEX_ORDER_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include <CGAL/FPU.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include "Cut_curves.h"

#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// An end of an edge.
struct Edge_end {
  std::uint32_t edge = 0;
  bool is_start = true;
};

class Vertex_order {
 public:
  explicit Vertex_order(const Cut_curves& cut) : cut_(cut), curves_(cut.curves()) {}

  /// Sorts ends at one vertex counterclockwise. \pre no two are of one class
  /// \return false where that is not decided
  [[nodiscard]] bool sort(std::vector<Edge_end>& ends);

 private:
  struct Way {
    Edge_end end;
    double angle, error;
  };

  [[nodiscard]] Way way_of(const Edge_end& end) const;
  [[nodiscard]] Exact_way exact_way_of(const Edge_end& end) const;
  [[nodiscard]] static bool are_close(const Way& p, const Way& q, bool is_past_turn);
  void sort_exactly(std::vector<Way>::iterator first, std::vector<Way>::iterator last) const;
  [[nodiscard]] Bezier_span span_at(const Edge_end& end) const;

  const Cut_curves& cut_;
  const Segment_hierarchy& curves_;
  static constexpr double PI = 3.141592653589793;
  std::vector<Way> ways_;
};

inline bool Vertex_order::sort(std::vector<Edge_end>& ends) {
  ways_.clear();
  for (const Edge_end& e : ends) ways_.push_back(way_of(e));
  std::sort(ways_.begin(), ways_.end(), [](const Way& p, const Way& q) { return p.angle < q.angle; });
  const std::size_t n = ways_.size();
  // One whose direction is open, as at a cusp, may be anywhere.
  const bool are_certain = std::all_of(ways_.begin(), ways_.end(), [](const Way& w) { return w.error < PI; });
  std::size_t first = are_certain ? 0 : n;  // behind a gap
  while (first < n && are_close(ways_[(first + n - 1) % n], ways_[first], first == 0)) ++first;
  const bool is_exact = curves_.decisions() == Decisions::EXACT;
  if (first == n) {
    if (!is_exact) return false;
    sort_exactly(ways_.begin(), ways_.end());
  } else {
    std::rotate(ways_.begin(), ways_.begin() + static_cast<std::ptrdiff_t>(first), ways_.end());
    for (std::size_t i = 0; i < n;) {
      std::size_t j = i + 1;
      while (j < n && are_close(ways_[j - 1], ways_[j], j == n - first)) ++j;
      if (j - i > 1) {
        if (!is_exact) return false;
        sort_exactly(ways_.begin() + static_cast<std::ptrdiff_t>(i), ways_.begin() + static_cast<std::ptrdiff_t>(j));
      }
      i = j;
    }
  }
  for (std::size_t i = 0; i < n; ++i) ends[i] = ways_[i].end;
  return true;
}

// The part of the edge on the Bezier piece at its end.
inline Bezier_span Vertex_order::span_at(const Edge_end& end) const {
  const std::vector<Bezier_span> spans = cut_.spans_of(end.edge);
  return end.is_start ? spans.front() : spans.back();
}

inline Vertex_order::Way Vertex_order::way_of(const Edge_end& end) const {
  const Bezier_span span = span_at(end);
  const Bracket& range = end.is_start ? span.from : span.to;
  const Bezier_evaluator& curve = curves_.evaluator(span.bezier);
  const double t = range.middle(), rounding = curves_.rounding(span.bezier);
  const Curve_jet jet = curve(t);
  const Jet_errors errors = curve.errors_at(t, jet);
  const double error = errors.first + curve.first_change(rounding, errors.first) +
                       range.width() * (curve.second_bound() + curve.second_change(rounding));
  const double speed = euclidean_norm(jet.first);
  constexpr double CERTAIN = 4, ROUNDING = 16 * HALF_ULP;
  const Xy<double> way = end.is_start ? jet.first : Xy<double>{-jet.first.x, -jet.first.y};
  // the sine of the angle between it and the true one is at most error / speed, a quarter
  const bool is_certain = speed > CERTAIN * error;
  return {end, std::atan2(way.y, way.x), is_certain ? 2 * error / speed + ROUNDING : PI};
}

// Whether doubles do not tell q from p, the one before it.
inline bool Vertex_order::are_close(const Way& p, const Way& q, bool is_past_turn) {
  constexpr double TURN = 6.283185307179586;
  return q.angle - p.angle + (is_past_turn ? TURN : 0) <= p.error + q.error;
}
inline Exact_way Vertex_order::exact_way_of(const Edge_end& end) const {
  const Bezier_span span = span_at(end);
  const Exact_parameter &from = cut_.start_of(span), &to = cut_.end_of(span);
  Exact_curve& curve = cut_.places().curve(curves_, span.bezier);
  return end.is_start ? exact_way(curve, from, to) : exact_way(curve, to, from);
}

// Ways by sector from the first one's, and within a sector by which is above.  Those that are close in directions are
// within less than half a turn; all of them are in order from anywhere.
inline void Vertex_order::sort_exactly(std::vector<Way>::iterator first, std::vector<Way>::iterator last) const {
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  struct Exact {
    Edge_end end;
    Exact_way way;
    int sector;
  };
  std::vector<Exact> exact;
  for (auto w = first; w != last; ++w) {
    Exact_way way = exact_way_of(w->end);
    const int sector = way.sector();
    exact.push_back({w->end, std::move(way), sector});
  }
  constexpr int SECTORS = 8, HALF = 4;
  const bool is_whole_turn = first == ways_.begin() && last == ways_.end();
  int start = 0;  // all sectors are less than half a turn from it on
  if (!is_whole_turn)
    for (const Exact& e : exact) {
      const auto is_behind = [&](const Exact& o) { return (o.sector - e.sector + SECTORS) % SECTORS < HALF; };
      if (std::all_of(exact.begin(), exact.end(), is_behind)) start = e.sector;
    }
  const auto is_before = [&](const Exact& p, const Exact& q) {
    const int a = (p.sector - start + SECTORS) % SECTORS, b = (q.sector - start + SECTORS) % SECTORS;
    return a != b ? a < b : is_counterclockwise_of(q.way, p.way);
  };
  for (std::size_t i = 1; i < exact.size(); ++i)  // few of them: by insertion
    for (std::size_t k = i; k > 0 && is_before(exact[k], exact[k - 1]); --k) std::swap(exact[k], exact[k - 1]);
  for (const Exact& e : exact) first++->end = e.end;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
