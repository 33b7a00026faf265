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

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_HULL_CHAIN_H
#define BOUNDING_ARCS_LIBRARY_QUERY_HULL_CHAIN_H

#include "Hull_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
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
  explicit Hull_chain(const Hull_pieces& hull) : curves_(hull.curves()), parts_(hull.parts()) {
    const Convex_polygon& p = hull.polygon();
    list_ends();
    if (p.size() == 1) {
      const Hull_point only = end_at(ends_.front());
      links_.push_back({true, only, only});
    }
    for (std::size_t i = 0; p.size() > 1 && i < p.size(); ++i) links_.push_back(link(p[i], p[(i + 1) % p.size()]));
    of_samples_ = links_;
    for (Hull_link& l : links_)
      if (!l.is_curve) sharpen(l);
    settle();
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
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
      ends_.push_back({parts_[i].piece.first.point, i, false});
      ends_.push_back({parts_[i].piece.last.point, i, true});
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
    const Spiral_piece_2& p = parts_[e.piece].piece;
    return {p.segment, e.is_last ? p.last.t : p.first.t, e.point};
  }

  [[nodiscard]] Hull_link link(const Xy<double>& u, const Xy<double>& v) const {
    Hull_link result;
    double most = 0;  // of several pieces over an edge the one that is farthest out
    for_each_end(u, [&](const End& e) {
      const Spiral_piece_2& p = parts_[e.piece].piece;
      result.from = result.is_curve ? result.from : end_at(e);
      if (!((e.is_last ? p.first : p.last).point == v)) return;
      const double bulge = (e.is_last ? -1 : 1) * parts_[e.piece].fat.arc.bulge;
      if ((bulge < 0 && !curves_.is_straight(p.segment)) || (result.is_curve && !(bulge > most))) return;
      most = bulge;
      result.is_curve = true;
      result.from = end_at(e);
      result.to = end_at({v, e.piece, !e.is_last});
    });
    if (!result.is_curve) for_each_end(v, [&](const End& e) { result.to = end_at(e); });
    return result;
  }

  // Where a line touches is on a piece beside the sample that is farthest.
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
  // The point farthest along n on the pieces that have a sample in p, or `best` where none is farther.
  [[nodiscard]] Hull_point farthest(const Xy<double>& p, const Hull_point& best, const Xy<double>& n) const {
    Hull_point result = best;
    for_each_end(p, [&](const End& e) {
      const Hull_point q = farthest(parts_[e.piece].piece, n);
      if (dot(n, q.point - result.point) > 0) result = q;
    });
    return result;
  }
  // C'.n changes its sign once at most, as tangents turn by 90 degrees at most.
  [[nodiscard]] Hull_point farthest(const Spiral_piece_2& piece, const Xy<double>& n) const {
    const std::uint32_t segment = piece.segment;
    const Bezier_evaluator& curve = curves_.evaluator(curves_.bezier_of(segment));
    const Hull_point first{segment, piece.first.t, piece.first.point}, last{segment, piece.last.t, piece.last.point};
    const bool is_last_farther = dot(n, last.point - first.point) > 0;
    if (curves_.is_straight(segment) || !(dot(n, piece.first.tangent) > 0 && dot(n, piece.last.tangent) < 0))
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

  // Where curves run together, what touches is not told by doubles, and the ends of bitangents may be moved past each
  // other: then samples are as good, which make a convex chain.
  void settle() {
    const std::size_t count = links_.size();
    std::vector<char> is_of_samples(count, 0);
    std::vector<std::size_t> open(count);
    std::iota(open.begin(), open.end(), std::size_t(0));
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      if (is_forward(i)) continue;
      for (std::size_t k : {i + count - 1, i, i + 1}) {
        k %= count;
        if (is_of_samples[k] != 0) continue;
        is_of_samples[k] = 1;
        links_[k] = of_samples_[k];
        for (const std::size_t beside : {k + count - 1, k, k + 1}) open.push_back(beside % count);
      }
    }
  }
  // Whether a link and the ways to it from the one before and from it to the one behind go on in its direction.
  [[nodiscard]] bool is_forward(std::size_t i) const {
    const Hull_link &sample = of_samples_[i], l = with_ends(i);
    const auto goes_on = [&](const Hull_point& p, const Hull_point& q) {
      return dot(Xy<double>(q.point - p.point), Xy<double>(sample.to.point - sample.from.point)) >= 0;
    };
    if (l.is_curve && (l.to.t - l.from.t) * (sample.to.t - sample.from.t) < 0) return false;
    if (!l.is_curve && !goes_on(l.from, l.to)) return false;
    const std::size_t count = links_.size(), before = (i + count - 1) % count;
    const Hull_link& p = with_ends(before);
    const Xy<double> way = sample.to.point - of_samples_[before].from.point;
    const auto goes_round = [&](const Xy<double>& from, const Xy<double>& to) {
      return dot(way, Xy<double>(to - from)) >= 0;
    };
    if (p.to.segment == l.from.segment) return goes_round(p.to.point, l.from.point);
    return goes_round(p.to.point, sample.from.point) && goes_round(sample.from.point, l.from.point);
  }
  // A part of a curve from and to the ends of bitangents that are on it.
  [[nodiscard]] Hull_link with_ends(std::size_t i) const {
    Hull_link l = links_[i];
    const std::size_t count = links_.size();
    const Hull_link &before = links_[(i + count - 1) % count], &next = links_[(i + 1) % count];
    if (!l.is_curve || count == 1) return l;
    if (!before.is_curve && before.to.segment == l.from.segment) l.from = before.to;
    if (!next.is_curve && next.from.segment == l.to.segment) l.to = next.from;
    return l;
  }

  // What is between two links that do not meet is a part of a segment, or of two that meet in the sample between.
  void join() {
    std::vector<Hull_link> chain;
    const std::size_t count = links_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Hull_link l = with_ends(i);
      const Hull_point &a = l.to, b = with_ends((i + 1) % count).from;
      append(chain, l);
      if (!(a.point == b.point)) bridge(chain, a, of_samples_[i].to.point, b);
    }
    if (chain.size() > 1 && is_continued(chain.back(), chain.front())) {
      chain.front().from = chain.back().from;
      chain.pop_back();
    }
    links_ = std::move(chain);
  }
  void bridge(std::vector<Hull_link>& chain, const Hull_point& a, const Xy<double>& sample, const Hull_point& b) const {
    if (a.segment == b.segment) return append(chain, {true, a, b});
    Hull_point at_a = a, at_b = b;
    for_each_end(sample, [&](const End& e) {
      const Hull_point p = end_at(e);
      if (p.segment == a.segment) at_a = p;
      if (p.segment == b.segment) at_b = p;
    });
    if (!(a.point == at_a.point)) append(chain, {true, a, at_a});
    if (!(b.point == at_b.point)) append(chain, {true, at_b, b});
  }
  [[nodiscard]] bool is_continued(const Hull_link& a, const Hull_link& b) const {
    if (!a.is_curve || !b.is_curve || curves_.bezier_of(a.to.segment) != curves_.bezier_of(b.from.segment))
      return false;
    return a.to.t == b.from.t && (a.to.t - a.from.t) * (b.to.t - b.from.t) > 0;
  }
  void append(std::vector<Hull_link>& chain, const Hull_link& l) const {
    if (!chain.empty() && is_continued(chain.back(), l)) chain.back().to = l.to;
    else chain.push_back(l);
  }

  const Segment_hierarchy& curves_;
  const std::vector<Hull_pieces::Part>& parts_;
  std::vector<End> ends_;
  std::vector<Hull_link> links_, of_samples_;  // the latter before ends of bitangents are moved
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
