// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of study/Verdict_grid.h.

#include <CGAL/Bounding_arcs_2/number/Bounded_double.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>
#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>
#include <CGAL/Bounding_arcs_2/study/Textbook.h>
#include <CGAL/Bounding_arcs_2/study/Verdict_grid.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <cmath>
#include <utility>

namespace CGAL::Bounding_arcs {
namespace study {

template <class NT> [[nodiscard]] Xy<NT> in(const Xy<double>& p) { return {NT(p.x), NT(p.y)}; }

// The sign of a number that doubles with a bound tell, or rationals.
template <class Number> [[nodiscard]] int filtered_sign(const Number& number) {
  const Bounded_double rounded = number(Bounded_double());
  return internal::is_signed(rounded) ? sign_of(rounded.value()) : sign_of(number(CGAL::Exact_rational()));
}

[[nodiscard]] static int naive_side(const Verdict_arc& arc, const Xy<double>& q) {
  const Xy<double> center = intersection(line_across(arc.p0, arc.tangent), bisector(arc.p0, arc.p1));
  return sign_of(distance(center, arc.p0) - distance(center, q));  // the arc turns left about it
}
template <class NT> [[nodiscard]] Contact_circle_2<NT> circle_of(const Verdict_arc& arc) {
  const Xy<NT> p0 = in<NT>(arc.p0), tangent = in<NT>(arc.tangent), chord = in<NT>(arc.p1) - p0;
  return {p0, dot(chord, chord) * perp(tangent), NT(NT(2) * cross(tangent, chord))};
}
[[nodiscard]] static int our_side(const Verdict_arc& arc, const Xy<double>& q) {
  return filtered_sign([&](const auto& zero) {
    using NT = std::decay_t<decltype(zero)>;
    return circle_of<NT>(arc).side(in<NT>(q));
  });
}

[[nodiscard]] static int naive_contact(const Verdict_circles& c, const Xy<double>& q) {
  return sign_of(distance(c.center, q) - (c.radius + c.other_radius));
}
[[nodiscard]] static int our_contact(const Verdict_circles& c, const Xy<double>& q) {
  return filtered_sign([&](const auto& zero) {
    using NT = std::decay_t<decltype(zero)>;
    const Xy<NT> v = in<NT>(q) - in<NT>(c.center);
    const NT sum = NT(c.radius) + NT(c.other_radius);
    return NT(dot(v, v) - sum * sum);
  });
}

// Where the curve is as high as q is found by bisection; the ray to the right meets nothing else.
[[nodiscard]] static int naive_location(const Bezier_curve_2<double>& curve, const Xy<double>& q) {
  double low = 0, high = 1;
  for (double t = 0.5; t != low && t != high; t = low + (high - low) / 2) (curve.point(t).y < q.y ? low : high) = t;
  return sign_of(q.x - curve.point(high).x);
}
[[nodiscard]] static Drawing_2<double> closed(const Bezier_curve_2<double>& curve) {
  const Xy<double> far{-1, 0.5}, bottom = curve.control_points().front(), top = curve.control_points().back();
  Drawing_2<double> drawing;
  drawing.add({curve, Bezier_curve_2<double>({top, far}), Bezier_curve_2<double>({far, bottom})});
  return drawing;
}

// The middle of a grid has coordinates between 1/2 and 1.
constexpr double STEP = 0x1p-53;

template <class Naive, class Ours>
[[nodiscard]] Verdict_grid grid(std::string name, const Xy<double>& middle, std::size_t size, const Naive& naive,
                                const Ours& ours) {
  const double half = STEP * static_cast<double>(size / 2);
  Verdict_grid grid{std::move(name), middle - Xy<double>{half, half}, size};
  for (std::size_t row = 0; row < size; ++row)
    for (std::size_t column = 0; column < size; ++column) {
      grid.naive.push_back(static_cast<signed char>(naive(grid.point(column, row))));
      grid.ours.push_back(static_cast<signed char>(ours(grid.point(column, row))));
    }
  return grid;
}

}  // namespace study

Xy<double> Verdict_grid::point(std::size_t column, std::size_t row) const {
  return corner + study::STEP * Xy<double>{static_cast<double>(column), static_cast<double>(row)};
}

std::size_t Verdict_grid::differences() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) count += naive[i] == ours[i] ? 0u : 1u;
  return count;
}

std::vector<Verdict_grid> verdict_grids(std::size_t size) {
  using namespace study;
  const Verdict_arc arc;
  const Verdict_circles circles;
  const Bezier_curve_2<double> curve = verdict_curve();
  const Bounding_arc_tree_2 hierarchy(closed(curve));
  const Point_location_2 location(hierarchy);
  const auto our_location = [&](const Xy<double>& q) {
    const Bounded_side side = location.locate(q);
    return side == ON_BOUNDARY ? 0 : (side == ON_BOUNDED_SIDE ? -1 : 1);
  };
  // Points of the curves, rounded.
  const Xy<double> direction{0.8, 0.6};
  const Xy<double> on_arc = [&] {
    Xy<double> low{0.6, 0.5}, high{0.6, 0.7};  // right of the arc and left of it
    while (high.y - low.y > STEP) {
      const Xy<double> middle{low.x, low.y + (high.y - low.y) / 2};
      (our_side(arc, middle) < 0 ? low : high) = middle;
    }
    return high;
  }();
  return {grid(
              "side of arc", on_arc, size, [&](const auto& q) { return naive_side(arc, q); },
              [&](const auto& q) { return our_side(arc, q); }),
          grid(
              "tangency", circles.center + (circles.radius + circles.other_radius) * direction, size,
              [&](const auto& q) { return naive_contact(circles, q); },
              [&](const auto& q) { return our_contact(circles, q); }),
          grid(
              "point location", curve.point(0.55), size, [&](const auto& q) { return naive_location(curve, q); },
              our_location)};
}

}  // namespace CGAL::Bounding_arcs
