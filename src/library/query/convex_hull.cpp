// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/convex_hull.h.
//
// Diameter and width are those of a polygon of samples, and more by what pieces rise above it.  Only pieces that may
// have a say are halved.  They are few, as distances fall with the square of the way from where one is the largest, and
// heights with the square of the length.
//
// A polygon of samples is inside the hull, so that its measures are lower bounds.
//   diameter: two pieces are apart by no more than the ends of their chords and both heights;
//   width: in whatever direction, no more than the pieces' chords and heights reach.

#include "Hull_chain.h"
#include "Hull_pieces.h"
#include "query_units.h"

#include <CGAL/Bounding_arcs_2/query/convex_hull.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Calls f(i, j) for each edge i, i + 1 with the corner j farthest from it, and for those that j passes on the way: all
/// pairs of corners with parallel lines that the polygon is between are among them.
/// Distances from a line rise and fall along a convex polygon, so j goes round once; where rounding lets it stop an ulp
/// too early, that corner is as far but for rounding.
/// \pre at least three corners
template <class F> static void for_each_antipode(const Convex_polygon& p, const F& f) {
  CGAL_precondition(p.size() >= 3);
  const std::size_t n = p.size();
  std::size_t j = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const Xy<double> edge = p[(i + 1) % n] - p[i];
    f(i, j);
    const auto is_farther = [&](std::size_t k) { return cross(edge, p[(k + 1) % n] - p[k]) > 0; };
    for (std::size_t step = 0; step < n && (j == i || is_farther(j)); ++step) {
      j = (j + 1) % n;
      f(i, j);
    }
  }
}

/// Two corners that are farthest from each other.
struct Corner_pair {
  Xy<double> first, second;
  double distance = 0;
};
[[nodiscard]] static Corner_pair diameter_of(const Convex_polygon& p) {
  Corner_pair best{p.front(), p.front(), 0};
  const auto offer = [&](const Xy<double>& a, const Xy<double>& b) {
    const double d = euclidean_norm(b - a);
    if (d > best.distance) best = {a, b, d};
  };
  if (p.size() == 2) offer(p[0], p[1]);
  if (p.size() < 3) return best;
  for_each_antipode(p, [&](std::size_t i, std::size_t j) {
    offer(p[i], p[j]);
    offer(p[(i + 1) % p.size()], p[j]);
  });
  return best;
}

/// The least distance of two parallel lines with the polygon between them.
struct Polygon_width {
  double width = 0;
  Xy<double> along;  ///< the direction of the lines
};

/// The farthest corners of the polygon, and at least the diameter.
struct Found_diameter {
  Corner_pair pair;
  double upper;
};
[[nodiscard]] static Found_diameter find_diameter(Hull_pieces& hull, double tolerance) {
  Work_limit pairs(std::size_t(1) << 24);
  for (;;) {
    const Corner_pair pair = diameter_of(hull.polygon());
    double upper = pair.distance;
    auto& parts = hull.parts();
    if (!pairs.spend(parts.size() * (parts.size() + 1) / 2)) break;
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t k = i; k < parts.size(); ++k) {
        const Spiral_piece_2 &p = parts[i].piece, &q = parts[k].piece;
        double square = 0;
        for (const Xy<double>* a : {&p.first.point, &p.last.point})
          for (const Xy<double>* b : {&q.first.point, &q.last.point})
            square = (std::max)(square, dot(*a - *b, *a - *b));
        const double heights = parts[i].height + parts[k].height, room = pair.distance - heights;
        if (room > 0 && square <= room * room) continue;
        const double d = std::sqrt(square) + heights;
        if (d > pair.distance + tolerance) parts[i].is_marked = parts[k].is_marked = true;
        upper = (std::max)(upper, d);
      }
    if (!hull.halve_marked()) return {pair, upper};
  }
  // too many pieces are as far from each other: all of them are low
  hull.lower(tolerance / 2);
  const Corner_pair pair = diameter_of(hull.polygon());
  return {pair, pair.distance + 2 * hull.height()};
}

/// The least width of the polygon, and at least that of the hull in that direction.
struct Found_width {
  Polygon_width width;
  Xy<double> along;  ///< lines that all is between, apart by `upper`
  double upper;
};
class Width_search {
 public:
  Width_search(Hull_pieces& hull, double tolerance) : hull_(hull) {
    do {
      const Polygon_width w = look_at_polygon();
      look_along(w.along, tolerance);
      found_.width = w;
      if (found_.upper <= w.width + tolerance) return;
      mark_beside_edges(w.width + (found_.upper - w.width) / 2);
    } while (hull_.halve_marked());
  }
  [[nodiscard]] const Found_width& found() const { return found_; }

 private:
  // An edge with the corner farthest from it.
  struct Edge {
    std::size_t corner;
    double width;
  };

  [[nodiscard]] Polygon_width look_at_polygon() {
    const Convex_polygon& p = hull_.polygon();
    edges_.assign(p.size() < 3 ? 0 : p.size(), {0, 0});
    if (edges_.empty()) return {0, p.size() == 2 ? p[1] - p[0] : Xy<double>{1, 0}};
    const auto side = [&p](std::size_t i) { return p[(i + 1) % p.size()] - p[i]; };
    for_each_antipode(p, [&](std::size_t i, std::size_t j) {
      const double d = cross(side(i), p[j] - p[i]) / euclidean_norm(side(i));
      if (d >= edges_[i].width) edges_[i] = {j, d};
    });
    const auto is_less = [](const Edge& a, const Edge& b) { return a.width < b.width; };
    const auto least = std::min_element(edges_.begin(), edges_.end(), is_less);
    return {least->width, side(static_cast<std::size_t>(least - edges_.begin()))};
  }
  // How far all pieces reach across a direction; those that reach beyond the polygon are marked.
  void look_along(const Xy<double>& along, double tolerance) {
    const double infinity = std::numeric_limits<double>::infinity();
    const Xy<double> n = perp((1 / euclidean_norm(along)) * along);
    double low = infinity, high = -infinity, least = infinity, most = -infinity;
    const Xy<double> origin = hull_.polygon().front();
    for (const Xy<double>& p : hull_.polygon()) {
      low = (std::min)(low, dot(n, p - origin));
      high = (std::max)(high, dot(n, p - origin));
    }
    least = low;
    most = high;
    for (Hull_pieces::Part& p : hull_.parts()) {
      const double a = dot(n, p.piece.first.point - origin), b = dot(n, p.piece.last.point - origin);
      const double bottom = (std::min)(a, b) - p.height, top = (std::max)(a, b) + p.height;
      p.is_marked = p.is_marked || bottom < low - tolerance / 4 || top > high + tolerance / 4;
      least = (std::min)(least, bottom);
      most = (std::max)(most, top);
    }
    if (most - least < found_.upper) {
      found_.upper = most - least;
      found_.along = along;
    }
  }
  // Pieces beside edges that are this wide at most, and beside their farthest corners.
  void mark_beside_edges(double most) {
    const Convex_polygon& p = hull_.polygon();
    std::vector<Xy<double>> corners;
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (edges_[i].width <= most)
        for (const std::size_t k : {i, (i + 1) % p.size(), edges_[i].corner}) corners.push_back(p[k]);
    const auto before = [](const Xy<double>& a, const Xy<double>& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    std::sort(corners.begin(), corners.end(), before);
    for (Hull_pieces::Part& q : hull_.parts())
      for (const Xy<double>* end : {&q.piece.first.point, &q.piece.last.point})
        q.is_marked = q.is_marked || std::binary_search(corners.begin(), corners.end(), *end, before);
  }

  Hull_pieces& hull_;
  std::vector<Edge> edges_;
  Found_width found_{{}, {1, 0}, std::numeric_limits<double>::infinity()};
};

/// Pieces that may be on the hull, to be halved where they matter.
[[nodiscard]] static Hull_pieces rough_hull(const Segment_hierarchy& curves) {
  constexpr double ROUGH = 0x1p-10;  // of the extent
  Hull_pieces hull(curves);
  hull.lower(ROUGH * extent_of(curves));
  return hull;
}

/// Bounds of a measure of the hull between that of its polygon and what pieces reach, both but for the error of
/// samples.
[[nodiscard]] static Measure_bounds measure_bounds(double of_polygon, double most, const Hull_pieces& hull,
                                                   double tolerance) {
  constexpr double POLYGON_ROUNDING = 16 * HALF_ULP;  // of distances: differences, products, norm and quotient
  const double room = POLYGON_ROUNDING * diameter_of(hull.polygon()).distance + 2 * hull.error(),
               lower = (std::max)(0.0, of_polygon - room), upper = most + room;
  return measured(lower, upper, tolerance, hull.is_limited());
}

Convex_hull<> convex_hull(const Bounding_arc_tree_2& curves, double tolerance) {
  check_tolerance(tolerance);
  if (curves.empty()) return {};
  const Unit& unit = curves.unit();
  const Segment_hierarchy& in_unit = curves.in_unit();
  const double asked = unit.tolerance_in(tolerance);
  const Hull_outline outline(in_unit, asked);
  Convex_hull<> hull;
  hull.height = unit.bounds_out(Measure_bounds{0, outline.height()}).upper;
  // pieces that are as high as was asked are within it but for the errors of their ends
  hull.status = status_of(outline.height() - 2 * outline.hull().error(), asked, outline.hull().is_limited());
  const Hull_chain chain(outline.hull());
  for (const Hull_link& l : chain.links())
    hull.pieces.push_back({!l.is_curve, in_unit.place_at(l.from.segment, l.from.t),
                           in_unit.place_at(l.to.segment, l.to.t), unit.out(l.from.point), unit.out(l.to.point)});
  return hull;
}

std::optional<Width_of_drawing<>> width(const Bounding_arc_tree_2& curves, double tolerance) {
  check_tolerance(tolerance);
  if (curves.empty()) return std::nullopt;
  const double asked = curves.unit().tolerance_in(tolerance);
  Hull_pieces hull = rough_hull(curves.in_unit());
  const Width_search search(hull, asked / 2);
  const Found_width& f = search.found();
  return Width_of_drawing<>{curves.unit().bounds_out(measure_bounds(f.width.width, f.upper, hull, asked)),
                            (1 / euclidean_norm(f.along)) * f.along};
}

std::optional<Diameter_of_drawing<>> diameter(const Bounding_arc_tree_2& curves, double tolerance) {
  check_tolerance(tolerance);
  if (curves.empty()) return std::nullopt;
  const Unit& unit = curves.unit();
  const double asked = unit.tolerance_in(tolerance);
  Hull_pieces hull = rough_hull(curves.in_unit());
  const auto [pair, upper] = find_diameter(hull, asked / 2);
  const auto place = [&](const Xy<double>& corner) {  // an end of pieces
    for (const Hull_pieces::Part& p : hull.parts())
      for (const Spiral_sample* s : {&p.piece.first, &p.piece.last})
        if (s->point == corner) return curves.in_unit().place_at(p.piece.segment, s->t);
    return Curve_place{};
  };
  return Diameter_of_drawing<>{unit.bounds_out(measure_bounds(pair.distance, upper, hull, asked)), place(pair.first),
                               place(pair.second), unit.out(pair.first), unit.out(pair.second)};
}

}  // namespace CGAL::Bounding_arcs::internal
