// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/convex_hull.h.

#include "Hull_chain.h"
#include "Hull_outline.h"
#include "Hull_samples.h"
#include "polygon_measures.h"
#include "query_units.h"

#include <CGAL/Bounding_arcs_2/query/convex_hull.h>
#include "../tree/Segment_hierarchy.h"
#include "Work_limit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

// Diameter and width of a drawing for tolerances so fine that a polygon of low pieces has too many: only pieces that
// may have a say are halved.  They are few, as distances fall with the square of the way from where one is the largest,
// and heights with the square of the length.
//
// A polygon of samples is inside the hull, so that its measures are lower bounds.
//   diameter: two pieces are apart by no more than the ends of their chords and both heights;
//   width: in whatever direction, no more than the pieces' chords and heights reach.

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

/// What the distances of a polygon's corners and lines are rounded by: differences, products, norm and quotient.
constexpr double POLYGON_ROUNDING = 16 * HALF_ULP;

/// Makes parts of the hull, whose pieces are halved where they matter.
[[nodiscard]] static Hull_parts hull_parts(const Segment_hierarchy& curves) {
  constexpr double ROUGH = 0x1p-10;  // of the extent
  return {curves, Hull_samples(curves, ROUGH * extent_of(curves))};
}

/// Bounds of a measure of the hull that is between that of a polygon of samples and one so much larger.
[[nodiscard]] static Measure_bounds measure_bounds(double of_polygon, double more, double extent, double error,
                                                   double tolerance, bool is_limited) {
  const double room = POLYGON_ROUNDING * extent, lower = (std::max)(0.0, of_polygon - 2 * error - room),
               upper = of_polygon + more + room;
  return {lower, upper, status_of(upper - lower, tolerance, is_limited)};
}
/// Bounds a measure by samples: such a measure grows by at most twice as much as the hull is widened by.
[[nodiscard]] static Measure_bounds measure_bounds(double of_polygon, const Hull_samples& samples, double tolerance) {
  return measure_bounds(of_polygon, 2 * (samples.height() + samples.error()), diameter_of(samples.polygon()).distance,
                        samples.error(), tolerance, samples.is_limited());
}
/// Bounds a measure by parts, which reach no farther than `most` but for the error of their ends.
[[nodiscard]] static Measure_bounds measure_bounds(double of_polygon, double most, const Hull_parts& parts,
                                                   double tolerance) {
  return measure_bounds(of_polygon, (most - of_polygon) + 2 * parts.error(), diameter_of(parts.polygon()).distance,
                        parts.error(), tolerance, parts.is_limited());
}

/// \param samples, tolerance in the curves's unit
template <class Samples>
[[nodiscard]] Convex_hull<> hull_of(const Bounding_arc_tree_2& curves, const Samples& samples, double tolerance) {
  const Unit& unit = curves.unit();
  Convex_hull<> hull;
  hull.height = unit.bounds_out(Measure_bounds{0, samples.height()}).upper;
  // pieces that are as high as was asked are within it but for the errors of their ends
  hull.status = status_of(samples.height() - 2 * samples.error(), tolerance, samples.is_limited());
  const Hull_chain chain(curves.in_unit(), samples.polygon(), samples.pieces());
  for (const Hull_link& l : chain.links())
    hull.pieces.push_back({l.is_curve ? Hull_piece_kind::CURVE : Hull_piece_kind::BITANGENT,
                           curves.in_unit().place_at(l.from.segment, l.from.t),
                           curves.in_unit().place_at(l.to.segment, l.to.t), unit.out(l.from.point),
                           unit.out(l.to.point)});
  return hull;
}

[[nodiscard]] static Width_of_drawing<> width_by_samples(const Segment_hierarchy& curves, double tolerance) {
  const Hull_samples samples(curves, tolerance / 4);
  const Polygon_width w = width_of(samples.polygon());
  return {measure_bounds(w.width, samples, tolerance), (1 / euclidean_norm(w.along)) * w.along};
}
[[nodiscard]] static Width_of_drawing<> width_by_parts(const Segment_hierarchy& curves, double tolerance) {
  Hull_parts parts = hull_parts(curves);
  const Width_search search(parts, tolerance / 2);
  const Found_width& f = search.found();
  return {measure_bounds(f.width.width, f.upper, parts, tolerance), (1 / euclidean_norm(f.along)) * f.along};
}

// Corners are ends of pieces.
[[nodiscard]] static Curve_place place_of_sample(const Segment_hierarchy& curves, const Spiral_piece_2& piece,
                                                 const Xy<double>& p, const Curve_place& other) {
  for (const Spiral_sample* s : {&piece.first, &piece.last})
    if (s->point == p) return curves.place_at(piece.segment, s->t);
  return other;
}
[[nodiscard]] static Diameter_of_drawing<> diameter_by_samples(const Segment_hierarchy& curves, double tolerance) {
  const Hull_samples samples(curves, tolerance / 4);
  const Corner_pair pair = diameter_of(samples.polygon());
  const auto place = [&](const Xy<double>& p) {
    Curve_place found{};
    for (auto i = samples.pieces().rbegin(); i != samples.pieces().rend(); ++i)
      found = place_of_sample(curves, *i, p, found);
    return found;
  };
  return {measure_bounds(pair.distance, samples, tolerance), place(pair.first), place(pair.second), pair.first,
          pair.second};
}
/// \return nothing where too many pieces are as far from each other
[[nodiscard]] static std::optional<Diameter_of_drawing<>> diameter_by_parts(const Segment_hierarchy& curves,
                                                                            double tolerance) {
  Hull_parts parts = hull_parts(curves);
  const auto found = find_diameter(parts, tolerance / 2);
  if (!found) return std::nullopt;
  const auto& [pair, upper] = *found;
  const auto place = [&](const Xy<double>& p) {
    Curve_place at{};
    for (const Hull_parts::Part& part : parts.parts()) at = place_of_sample(curves, part.piece, p, at);
    return at;
  };
  return Diameter_of_drawing<>{measure_bounds(pair.distance, upper, parts, tolerance), place(pair.first),
                               place(pair.second), pair.first, pair.second};
}

Convex_hull<> convex_hull(const Bounding_arc_tree_2& curves, double tolerance) {
  check_tolerance(tolerance);
  if (curves.empty()) return {};
  const double asked = curves.unit().tolerance_in(tolerance);
  if (is_fine(curves.in_unit(), asked)) return hull_of(curves, Hull_outline(curves.in_unit(), asked), asked);
  return hull_of(curves, Hull_samples(curves.in_unit(), asked), asked);
}

std::optional<Width_of_drawing<>> width(const Bounding_arc_tree_2& curves, double tolerance) {
  check_tolerance(tolerance);
  if (curves.empty()) return std::nullopt;
  const double asked = curves.unit().tolerance_in(tolerance);
  const Segment_hierarchy& in_unit = curves.in_unit();
  Width_of_drawing<> found =
      is_fine(in_unit, asked) ? width_by_parts(in_unit, asked) : width_by_samples(in_unit, asked);
  found.width = curves.unit().bounds_out(found.width);
  return found;
}

std::optional<Diameter_of_drawing<>> diameter(const Bounding_arc_tree_2& curves, double tolerance) {
  check_tolerance(tolerance);
  if (curves.empty()) return std::nullopt;
  const Unit& unit = curves.unit();
  const double asked = unit.tolerance_in(tolerance);
  const Segment_hierarchy& in_unit = curves.in_unit();
  std::optional<Diameter_of_drawing<>> found;
  if (is_fine(in_unit, asked)) found = diameter_by_parts(in_unit, asked);
  if (!found) found = diameter_by_samples(in_unit, asked);
  found->diameter = unit.bounds_out(found->diameter);
  found->first_point = unit.out(found->first_point), found->second_point = unit.out(found->second_point);
  return found;
}

}  // namespace CGAL::Bounding_arcs::internal
