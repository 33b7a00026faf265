// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The boundary of a convex hull as parts of spiral segments and bitangents, from the polygon of samples.
//
// An edge of the polygon that joins the ends of a low piece which turns left stands for that piece, every other edge
// for a bitangent.  A bitangent's ends are found in turns: the direction from one to the other tells the point of each
// side that is farthest to the right, and that the next direction.  A point that is off by h along its curve is off by
// h^2 across it, so that errors are squared each time.
//
//      v <- - - - - u       inside is to the left of u -> v; what is farthest to the right there are the points in
//      |   inside   |       which the line touches, or corners that it passes
//      ...        ...

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_HULL_CHAIN_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_HULL_CHAIN_H

#include <CGAL/Bounding_arcs_2/internal/query/Hull_samples.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A point of a spiral segment.
struct Hull_point {
  std::uint32_t segment = 0;
  double t = 0;
  Xy<double> point;
};
/// A part of a segment, or a bitangent between points of any two.
struct Hull_link {
  bool is_curve = false;
  Hull_point from, to;
};

class Hull_chain {
 public:
  Hull_chain(const Curve_index_2& index, const Hull_samples& samples) : index_(index), samples_(samples) {
    list_ends();
    const Convex_polygon& p = samples.polygon();
    if (p.size() == 1) {
      const Hull_point only = end_at(ends_.front());
      links_.push_back({true, only, only});
    }
    for (std::size_t i = 0; p.size() > 1 && i < p.size(); ++i) links_.push_back(link(p[i], p[(i + 1) % p.size()]));
    for (Hull_link& l : links_)
      if (!l.is_curve) sharpen(l);
    join();
  }

  [[nodiscard]] const std::vector<Hull_link>& links() const { return links_; }

 private:
  struct End {
    Xy<double> point;
    std::uint32_t piece;
    bool is_last;
  };
  [[nodiscard]] static std::tuple<double, double> key(const Xy<double>& p) { return {p.x, p.y}; }

  void list_ends() {
    for (std::uint32_t i = 0; i < samples_.pieces().size(); ++i) {
      ends_.push_back({samples_.pieces()[i].first.point, i, false});
      ends_.push_back({samples_.pieces()[i].last.point, i, true});
    }
    std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) {
      return std::tuple(key(a.point), a.piece, a.is_last) < std::tuple(key(b.point), b.piece, b.is_last);
    });
  }
  // Calls f for the ends of pieces in a point.
  template <class F> void for_each_end(const Xy<double>& p, const F& f) const {
    const auto before = [](const End& a, const Xy<double>& b) { return key(a.point) < key(b); };
    for (auto i = std::lower_bound(ends_.begin(), ends_.end(), p, before); i != ends_.end() && i->point == p; ++i)
      f(*i);
  }
  [[nodiscard]] Hull_point end_at(const End& e) const {
    const Spiral_piece_2& p = samples_.pieces()[e.piece];
    return {p.segment, e.is_last ? p.last.t : p.first.t, e.point};
  }

  [[nodiscard]] Hull_link link(const Xy<double>& u, const Xy<double>& v) const {
    Hull_link result;
    for_each_end(u, [&](const End& e) {
      const Spiral_piece_2& p = samples_.pieces()[e.piece];
      result.from = result.is_curve ? result.from : end_at(e);
      if (result.is_curve || !((e.is_last ? p.first : p.last).point == v)) return;
      const double bulge = (e.is_last ? -1 : 1) * index_.fat(p).arc.bulge;
      if (bulge < 0 && !index_.is_straight(p.segment)) return;
      result.is_curve = true;
      result.from = end_at(e);
      result.to = end_at({v, e.piece, !e.is_last});
    });
    if (!result.is_curve) for_each_end(v, [&](const End& e) { result.to = end_at(e); });
    return result;
  }

  void sharpen(Hull_link& l) const {
    constexpr int MOST_TURNS = 12;  // each squares the error; straight sides end at once
    const Xy<double> u = l.from.point, v = l.to.point;
    for (int turn = 0; turn < MOST_TURNS; ++turn) {
      const Xy<double> way = l.to.point - l.from.point, right{way.y, -way.x};
      const Hull_point from = farthest(u, l.from, right), to = farthest(v, l.to, right);
      const bool is_done = from.point == l.from.point && to.point == l.to.point;
      l.from = from;
      l.to = to;
      if (is_done) return;
    }
  }
  // Of the segments that have a sample in p.
  [[nodiscard]] Hull_point farthest(const Xy<double>& p, const Hull_point& best, const Xy<double>& n) const {
    Hull_point result = best;
    for_each_end(p, [&](const End& e) {
      const Hull_point q = farthest(samples_.pieces()[e.piece].segment, n);
      if (dot(n, q.point - result.point) > 0) result = q;
    });
    return result;
  }
  // C'.n changes its sign once at most, as tangents turn by 90 degrees at most.
  [[nodiscard]] Hull_point farthest(std::uint32_t segment, const Xy<double>& n) const {
    const Spiral_piece_2& piece = index_.piece(segment);
    const Bezier_evaluator& curve = index_.evaluator(index_.bezier_of(segment));
    const Hull_point first{segment, piece.first.t, piece.first.point}, last{segment, piece.last.t, piece.last.point};
    const bool is_last_farther = dot(n, last.point - first.point) > 0;
    if (index_.is_straight(segment) || !(dot(n, piece.first.tangent) > 0 && dot(n, piece.last.tangent) < 0))
      return is_last_farther ? last : first;
    double low = piece.first.t, high = piece.last.t, t = low + (high - low) / 2;
    constexpr int MOST_STEPS = 100;
    for (int step = 0; step < MOST_STEPS && low < t && t < high; ++step) {
      const Curve_jet jet = curve(t);
      const double rise = dot(n, jet.first), change = dot(n, jet.second);
      (rise > 0 ? low : high) = t;
      const double next = t - rise / change;
      // Newton, but every third step halves
      t = step % 3 != 2 && low < next && next < high ? next : low + (high - low) / 2;
    }
    return {segment, t, curve(t).point};
  }

  // What is between two links that do not meet is a part of a segment, or of two where their joint is between.
  void join() {
    std::vector<Hull_link> chain;
    const std::size_t count = links_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Hull_link& l = links_[i];
      const Hull_link& next = links_[(i + 1) % count];
      Hull_link part = l;
      if (l.is_curve && count > 1) {  // its ends are moved to those of bitangents beside it, if they are on it
        const Hull_link& before = links_[(i + count - 1) % count];
        if (!before.is_curve && before.to.segment == l.from.segment) part.from = before.to;
        if (!next.is_curve && next.from.segment == l.to.segment) part.to = next.from;
      }
      append(chain, part);
      if (l.is_curve == next.is_curve && l.is_curve) continue;
      const Hull_point &a = part.to, &b = next.is_curve && next.from.segment == part.to.segment ? a : next.from;
      if (!(a.point == b.point)) bridge(chain, a, b);
    }
    if (chain.size() > 1 && is_continued(chain.back(), chain.front())) {
      chain.front().from = chain.back().from;
      chain.pop_back();
    }
    links_ = std::move(chain);
  }
  // Along one segment, or to the end of one that is the beginning of the other.
  void bridge(std::vector<Hull_link>& chain, const Hull_point& a, const Hull_point& b) const {
    if (a.segment == b.segment) return append(chain, {true, a, b});
    const auto ends = [&](std::uint32_t s) {
      const Spiral_piece_2& p = index_.piece(s);
      return std::array<Hull_point, 2>{Hull_point{s, p.first.t, p.first.point}, Hull_point{s, p.last.t, p.last.point}};
    };
    for (const Hull_point& x : ends(a.segment))
      for (const Hull_point& y : ends(b.segment)) {
        if (!(x.point == y.point)) continue;
        if (!(a.point == x.point)) append(chain, {true, a, x});
        if (!(b.point == y.point)) append(chain, {true, y, b});
        return;
      }
    append(chain, {false, a, b});  // some roundings apart
  }
  [[nodiscard]] bool is_continued(const Hull_link& a, const Hull_link& b) const {
    if (!a.is_curve || !b.is_curve || index_.bezier_of(a.to.segment) != index_.bezier_of(b.from.segment)) return false;
    return a.to.t == b.from.t && (a.to.t - a.from.t) * (b.to.t - b.from.t) > 0;
  }
  void append(std::vector<Hull_link>& chain, const Hull_link& l) const {
    if (!chain.empty() && is_continued(chain.back(), l)) chain.back().to = l.to;
    else chain.push_back(l);
  }

  const Curve_index_2& index_;
  const Hull_samples& samples_;
  std::vector<End> ends_;
  std::vector<Hull_link> links_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
