// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Outlines as people have them: closed shapes that touch, cross and have junctions, cut into entities, shuffled,
// reversed, their ends moved. What is joined is the shapes, or the place is told; offsets and axes are theirs.

#include "cases.h"

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/curve/join_curves.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/signed_distance.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace test_loose_outlines {
namespace {

using namespace CGAL::Bounding_arcs;
using bounding_arcs_test::cases;
using Piece = Bezier_curve_2<double>;
using Shape = std::vector<Piece>;
using Point = Xy<double>;

double distance(const Point& p, const Point& q) { return std::hypot(p.x - q.x, p.y - q.y); }
Point unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

// Closed shapes, where three of their pieces or more end, and lines that end there and nowhere else.
struct Loose_outlines {
  std::vector<Shape> shapes;
  std::vector<Point> shared;
  Shape tails;
};

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : random_(seed) {}

  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  std::size_t below(std::size_t n) { return random_() % n; }
  bool coin() { return below(2) == 0; }

  // A line, an arc of a circle or of an ellipse, or a cubic.
  Piece piece(const Point& p, const Point& q) {
    const Point middle = 0.5 * (p + q), across = perp(q - p);
    const double rise = number(0.05, 0.3);
    switch (below(4)) {
      case 0:
        return Piece({p, q});
      case 1:  // the tangents meet at a height of rise chords
        return Piece({p, middle - rise * across, q}, {1, 0.5 / std::hypot(0.5, rise), 1});
      case 2:
        return Piece({p, middle - rise * across + number(-0.1, 0.1) * (q - p), q}, {1, number(0.4, 0.95), 1});
      default:
        return Piece(
            {p, p + number(0.2, 0.4) * (q - p) - rise * across, q - number(0.2, 0.4) * (q - p) - rise * across, q});
    }
  }
  Shape shape(const Point& center) {
    std::vector<Point> corners;
    const std::size_t count = 3 + below(6);
    for (std::size_t k = 0; k < count; ++k)
      corners.push_back(center + number(0.7, 1.3) * unit(2 * PI * (k + number(0, 0.5)) / count));
    Shape result;
    for (std::size_t k = 0; k < count; ++k) result.push_back(piece(corners[k], corners[(k + 1) % count]));
    return result;
  }
  // Cuts a piece in its inner part; where that is.
  Point cut(Shape& shape, std::size_t i) {
    const auto [head, tail] = shape[i].split(number(0.3, 0.7));
    const Point place = head.control_points().back();
    shape[i] = head;
    shape.insert(shape.begin() + static_cast<std::ptrdiff_t>(i) + 1, tail);
    return place;
  }
  // A shape through places of another one: with a corner there, or smooth.
  Shape shape_through(const Point& p, const Point& q) {
    const Point along = q - p, out = p - number(0.4, 0.8) * perp(along), in = q + number(0.4, 0.8) * perp(along);
    const std::vector<Point> corners{p, in, q, out};
    Shape result;
    std::vector<Point> directions;  // at p and q
    for (int k = 0; k < 2; ++k) directions.push_back(unit(number(0, 2 * PI)));
    const bool is_smooth = coin();
    for (std::size_t k = 0; k < 4; ++k) {
      const Point &a = corners[k], &b = corners[(k + 1) % 4];
      const double length = distance(a, b) / 3;
      const Point start = a + (k % 2 == 0 ? length * directions[k / 2] : 1 / 3. * (b - a)),
                  end = b - (k % 2 == 1 ? length * directions[(k + 1) / 2 % 2] : 1 / 3. * (b - a));
      result.push_back(is_smooth ? Piece({a, start, end, b}) : piece(a, b));
    }
    return result;
  }

  Loose_outlines outlines() {
    Loose_outlines made;
    const std::size_t count = 1 + below(3);
    for (std::size_t i = 0; i < count; ++i) made.shapes.push_back(shape({8.0 * i, 0}));
    const std::size_t kind = below(4);
    Shape& first = made.shapes.front();
    if (kind == 1) {  // crossed or touched at two places
      const std::size_t i = below(first.size() - 1);
      const Point q = cut(first, first.size() - 1), p = cut(first, i);
      made.shared = {p, q};
      made.shapes.push_back(shape_through(p, q));
    } else if (kind == 2) {  // a corner in common
      const Point p = first[below(first.size())].control_points().front();
      Shape other = shape(p);
      const Point by = p - other.front().control_points().front();
      for (Piece& piece : other) {
        std::vector<Point> points = piece.control_points();
        for (Point& point : points) point = point == other.front().control_points().front() ? p : point + by;
        piece = Piece(std::move(points), piece.weights());
      }
      other.front() = with_end(other.front(), false, p);
      other.back() = with_end(other.back(), true, p);
      for (std::size_t k = 1; k < other.size(); ++k)
        other[k] = with_end(other[k], false, other[k - 1].control_points().back());
      made.shared = {p};
      made.shapes.push_back(std::move(other));
    } else if (kind == 3) {  // a junction, in a piece or at a corner
      const Point p = coin() ? cut(first, below(first.size())) : first.front().control_points().front();
      made.shared = {p};
      made.tails.push_back(Piece({p, p + number(2, 3) * unit(number(0, 2 * PI))}));
    }
    return made;
  }

  // The entities, each with the number of its shape, or none for a tail.
  Drawing_2<double> entities(const Loose_outlines& made, double eps, std::vector<std::size_t>& shape_of) {
    std::vector<std::pair<Piece, std::size_t>> all;
    // Of ends at one place all are moved or none: those that are the same would go first.
    if (below(8) == 0) eps = 0;
    for (std::size_t i = 0; i < made.shapes.size(); ++i)
      for (const Piece& piece : made.shapes[i]) all.emplace_back(moved(piece, eps / 2), i);
    for (const Piece& piece : made.tails) all.emplace_back(moved(piece, eps / 2), made.shapes.size());
    std::shuffle(all.begin(), all.end(), random_);
    Drawing_2<double> drawing;
    for (const auto& [piece, shape] : all) {
      drawing.add(coin() ? piece : piece.reversed());
      shape_of.push_back(shape);
    }
    return drawing;
  }

 private:
  static constexpr double PI = 3.14159265358979323846;

  static Piece with_end(const Piece& piece, bool is_last, const Point& p) {
    std::vector<Point> points = piece.control_points();
    (is_last ? points.back() : points.front()) = p;
    return Piece(std::move(points), piece.weights());
  }
  Piece moved(const Piece& piece, double most) {
    std::vector<Point> points = piece.control_points();
    for (Point* end : {&points.front(), &points.back()}) *end = *end + number(0, most) * unit(number(0, 2 * PI));
    return Piece(std::move(points), piece.weights());
  }

  std::mt19937_64 random_;
};

// Places of a curve that are far from the distance at which they are said to be.
template <class Places> void expect_at_distance(const Bounding_arc_tree_2& tree, const Places& places, double allowed) {
  for (const auto& [place, wanted] : places) {
    const double found = closest_point(tree, place)->distance.upper;
    ASSERT_NEAR(found, wanted, allowed) << "at (" << place.x << ", " << place.y << ")";
  }
}

std::vector<std::pair<Point, double>> places_of(const Offset& offset) {
  std::vector<std::pair<Point, double>> places;
  for (const Offset::Chain& chain : offset.chains)
    for (const Offset::Piece& piece : chain.pieces)
      for (const double t : {0.0, 0.5}) places.emplace_back(point(piece.arc, t), std::fabs(offset.distance));
  return places;
}
std::vector<std::pair<Point, double>> places_of(const Medial_axis_2& axis) {
  std::vector<std::pair<Point, double>> places;
  for (const Medial_axis_2::Edge& edge : axis.edges)
    for (const Medial_axis_2::Sample& sample : edge.samples) places.emplace_back(sample.center, sample.radius);
  return places;
}

TEST(LooseOutlines, AreTheShapesOrTheAmbiguousPlaceIsTold) {
  constexpr double EPS = 1e-4;
  std::size_t ambiguous = 0, drawings = 0, shared = 0, axes = 0;
  for (int seed = 1; seed <= cases(400); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Generator generator(static_cast<std::uint64_t>(seed));
    const Loose_outlines made = generator.outlines();
    std::vector<std::size_t> shape_of;
    const Drawing_2<double> loose = generator.entities(made, EPS, shape_of);
    const Joined_curves joined = join_curves(loose, EPS);
    ASSERT_LE(joined.moved, EPS);
    ++drawings;
    shared += made.shared.empty() ? 0 : 1;
    for (const Point& told : joined.crowded)
      ASSERT_TRUE(std::any_of(made.shared.begin(), made.shared.end(),
                              [&](const Point& p) { return distance(p, told) <= EPS; }));
    if (!joined.crowded.empty()) {
      ++ambiguous;
      continue;
    }
    Drawing_2<double> closed, original;
    for (std::size_t k = 0; k < joined.parts.size(); ++k) {
      std::set<std::size_t> shapes;
      for (const Joined_curves::Part& part : joined.parts[k]) shapes.insert(shape_of[part.curve]);
      ASSERT_EQ(shapes.size(), 1u) << "parts of two shapes are joined";
      const std::size_t shape = *shapes.begin();
      if (shape == made.shapes.size()) continue;
      ASSERT_TRUE(joined.drawing.curves()[k].is_closed);
      ASSERT_EQ(joined.parts[k].size(), made.shapes[shape].size());
      closed.add(joined.drawing.curves()[k].beziers);
    }
    ASSERT_EQ(closed.curves().size(), made.shapes.size());
    for (const Shape& shape : made.shapes) original.add(shape);
    const Bounding_arc_tree_2 of_closed(closed), of_original(original);
    Offset::Options options;
    options.rule = Fill_rule::EVEN_ODD;
    constexpr double OFFSET_EPS = EPS / 8, ALLOWED = EPS / 2 + 2 * OFFSET_EPS;
    for (const double d : {-0.1, 0.2}) {
      const Offset a = offset(of_closed, d, OFFSET_EPS, options), b = offset(of_original, d, OFFSET_EPS, options);
      expect_at_distance(of_original, places_of(a), ALLOWED);
      expect_at_distance(of_closed, places_of(b), ALLOWED);
      for (const auto& [place, wanted] : places_of(a))
        ASSERT_EQ(signed_distance(of_original, place, options.rule)->side == CGAL::ON_BOUNDED_SIDE, d < 0);
    }
    if (seed % 10 != 0) continue;
    ++axes;
    Medial_axis_2::Options axis_options;
    axis_options.rule = options.rule;
    const Medial_axis_2 a = medial_axis(of_closed, OFFSET_EPS, axis_options),
                        b = medial_axis(of_original, OFFSET_EPS, axis_options);
    expect_at_distance(of_original, places_of(a), ALLOWED);
    expect_at_distance(of_closed, places_of(b), ALLOWED);
    if (HasFailure()) return;
  }
  std::cout << drawings << " drawings, " << shared << " with shared ends: " << ambiguous << " ambiguous, told; " << axes
            << " axes\n";
  EXPECT_LE(ambiguous, shared / 4) << "little is left to people";
}

}  // namespace
}  // namespace test_loose_outlines
