// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Diameter and width of a drawing for tolerances so fine that a polygon of low pieces has too many: only pieces that
// may have a say are halved.  They are few, as distances fall with the square of the way from where one is the largest,
// and heights with the square of the length.
//
// A polygon of samples is inside the hull, so that its measures are lower bounds.
//   diameter: two pieces are apart by no more than the ends of their chords and both heights;
//   width: in whatever direction, no more than the pieces' chords and heights reach.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_HULL_PARTS_H
#define BOUNDING_ARCS_LIBRARY_QUERY_HULL_PARTS_H

#include <CGAL/Bounding_arcs_2/query/Work_limit.h>
#include <CGAL/Bounding_arcs_2/tree/Segment_hierarchy.h>
#include "Hull_samples.h"
#include "polygon_measures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Pieces that may be on the hull, halved as they are asked for.
class Hull_parts {
 public:
  struct Part {
    Spiral_piece_2 piece;
    double height;
    bool is_low;  ///< halving tells no more
    bool is_marked = false;
  };

  Hull_parts(const Segment_hierarchy& curves, const Hull_samples& samples)
      : curves_(curves), polygon_(samples.polygon()), error_(samples.error()),
        limit_(most_pieces(curves.number_of_segments())) {
    for (const Spiral_piece_2& p : samples.pieces()) parts_.push_back(part(p));
  }

  [[nodiscard]] const Convex_polygon& polygon() const { return polygon_; }
  [[nodiscard]] std::vector<Part>& parts() { return parts_; }
  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }
  [[nodiscard]] double error() const { return error_; }
  [[nodiscard]] bool is_limited() const { return limit_.is_reached(); }
  [[nodiscard]] Work_limit& limit() { return limit_; }

  /// \return whether there was a marked one that is not low
  [[nodiscard]] bool halve_marked() {
    std::vector<Part> next;
    Convex_polygon points = polygon_;
    for (Part& p : parts_) {
      const bool is_asked = p.is_marked && !p.is_low;
      p.is_marked = false;
      const auto middle = is_asked && limit_.spend() ? halves(curves_, p.piece) : std::optional<Spiral_halves_2>();
      if (!middle) {
        p.is_low = p.is_low || is_asked;
        next.push_back(p);
        continue;
      }
      next.push_back(part(middle->first));
      next.push_back(part(middle->second));
      points.push_back(middle->first.last.point);
    }
    const bool is_changed = next.size() > parts_.size();
    parts_ = std::move(next);
    if (is_changed) polygon_ = convex_polygon(points);
    return is_changed;
  }

 private:
  [[nodiscard]] Part part(const Spiral_piece_2& p) const {
    constexpr double LEAST = 64;  // times the error
    const double height = height_of(curves_.region(p));
    return {p, height, height <= LEAST * curves_.error(p.segment)};
  }

  const Segment_hierarchy& curves_;
  Convex_polygon polygon_;
  double error_;
  std::vector<Part> parts_;
  Work_limit limit_;
};

/// The farthest corners of the polygon, and at least the diameter.
struct Found_diameter {
  Corner_pair pair;
  double upper;
};
/// \return nothing where too many pieces are as far from each other
[[nodiscard]] inline std::optional<Found_diameter> find_diameter(Hull_parts& hull, double tolerance) {
  Work_limit pairs(std::size_t(1) << 24);
  Found_diameter found{};
  do {
    auto& parts = hull.parts();
    if (!pairs.spend(parts.size() * (parts.size() + 1) / 2)) return std::nullopt;
    found.pair = diameter_of(hull.polygon());
    found.upper = found.pair.distance;
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t k = i; k < parts.size(); ++k) {
        const Spiral_piece_2 &p = parts[i].piece, &q = parts[k].piece;
        double square = 0;
        for (const Xy<double>* a : {&p.first.point, &p.last.point})
          for (const Xy<double>* b : {&q.first.point, &q.last.point})
            square = (std::max)(square, dot(*a - *b, *a - *b));
        const double d = std::sqrt(square) + parts[i].height + parts[k].height;
        if (d > found.pair.distance + tolerance) parts[i].is_marked = parts[k].is_marked = true;
        found.upper = (std::max)(found.upper, d);
      }
  } while (hull.halve_marked());
  return found;
}

/// The least width of the polygon, and at least that of the hull in that direction.
struct Found_width {
  Polygon_width width;
  Xy<double> along;  ///< lines that all is between, apart by `upper`
  double upper;
};
class Width_search {
 public:
  Width_search(Hull_parts& hull, double tolerance) : hull_(hull) {
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
    if (p.size() >= 3)
      for_each_antipode(p, [&](std::size_t i, std::size_t j) {
        const Xy<double> edge = p[(i + 1) % p.size()] - p[i];
        const double d = cross(edge, p[j] - p[i]) / euclidean_norm(edge);
        if (d >= edges_[i].width) edges_[i] = {j, d};
      });
    return width_of(p);
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
    for (Hull_parts::Part& p : hull_.parts()) {
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
    for (Hull_parts::Part& q : hull_.parts())
      for (const Xy<double>* end : {&q.piece.first.point, &q.piece.last.point})
        q.is_marked = q.is_marked || std::binary_search(corners.begin(), corners.end(), *end, before);
  }

  Hull_parts& hull_;
  std::vector<Edge> edges_;
  Found_width found_{{}, {1, 0}, std::numeric_limits<double>::infinity()};
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
