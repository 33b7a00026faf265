// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/shapes.h.

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/query/shapes.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace shapes {

/// A point of the shapes.
using Exact_point = Xy<Exact_rational>;
/// A piece of the shapes.
using Exact_bezier = Bezier_curve_2<Exact_rational>;

/// \throws std::invalid_argument for a point that is not finite
[[nodiscard]] static Exact_point exact(const char* argument, const Asked_point& asked) {
  const Xy<double>& p = asked.point;
  if (!std::isfinite(p.x) || !std::isfinite(p.y))
    throw std::invalid_argument(expected(argument, "finite coordinates", p));
  return asked.exactly();
}
/// A drawing of one curve.
[[nodiscard]] static Drawing_2<Exact_rational> one(std::vector<Exact_bezier> chain) {
  Drawing_2<Exact_rational> drawing;
  drawing.add(std::move(chain));
  return drawing;
}
// A multiple of the direction that is longer than the way from p to any point of the box.
[[nodiscard]] static Exact_point far_along(const Bounding_arc_tree_2& curves, const Exact_point& p,
                                           const Asked_point& direction) {
  const Exact_point d = exact("direction", direction);
  if (d == Exact_point{Exact_rational(0), Exact_rational(0)})
    throw std::invalid_argument(expected("direction", "a vector other than (0, 0)", direction.point));
  Exact_rational way = curves.unit().exactly_out(Exact_rational(1));
  if (!curves.empty()) {
    const CGAL::Bbox_2 box = curves.box();
    for (const double x : {box.xmin(), box.xmax()}) way += CGAL::abs(Exact_rational(Exact_rational(x) - p.x));
    for (const double y : {box.ymin(), box.ymax()}) way += CGAL::abs(Exact_rational(Exact_rational(y) - p.y));
  }
  const Exact_rational longer = (std::max)(Exact_rational(CGAL::abs(d.x)), Exact_rational(CGAL::abs(d.y)));
  return Exact_rational(2 * way / longer) * d;
}
// Half an arc between two points, with the point where the tangents meet: weights 1, 1, 1 + b^2, since the square of
// the middle weight over the product of the others is the squared cosine of half the angle at the center.
[[nodiscard]] static Exact_bezier half_arc(const Exact_point& from, const Exact_point& corner, const Exact_point& to,
                                           const Exact_rational& b) {
  return Exact_bezier({from, corner, to}, {Exact_rational(1), Exact_rational(1), Exact_rational(1 + b * b)});
}

}  // namespace shapes

Drawing_2<Exact_rational> segment_drawing(const Asked_point& from, const Asked_point& to) {
  return shapes::one({shapes::Exact_bezier({shapes::exact("from", from), shapes::exact("to", to)})});
}

Drawing_2<Exact_rational> ray_drawing(const Bounding_arc_tree_2& curves, const Asked_point& from,
                                      const Asked_point& direction) {
  const shapes::Exact_point p = shapes::exact("from", from);
  return shapes::one({shapes::Exact_bezier({p, p + shapes::far_along(curves, p, direction)})});
}

Drawing_2<Exact_rational> line_drawing(const Bounding_arc_tree_2& curves, const Asked_point& through,
                                       const Asked_point& direction) {
  const shapes::Exact_point p = shapes::exact("through", through), d = shapes::far_along(curves, p, direction);
  return shapes::one({shapes::Exact_bezier({p - d, p + d})});
}

Drawing_2<Exact_rational> circle_drawing(const Asked_point& center, double radius) {
  if (!(radius > 0) || !std::isfinite(radius))
    throw std::invalid_argument(expected("radius", "a finite number above 0", radius));
  const shapes::Exact_point c = shapes::exact("center", center);
  const Exact_rational r(radius);
  std::vector<shapes::Exact_bezier> quarters;
  shapes::Exact_point u{r, Exact_rational(0)};
  for (int i = 0; i < 4; ++i) {
    const shapes::Exact_point v = perp(u);
    quarters.push_back(shapes::half_arc(c + u, c + u + v, c + v, Exact_rational(1)));
    u = v;
  }
  return shapes::one(std::move(quarters));
}

// With a bulge b the middle is at -b/2 perp(D) from the middle of the chord D, and tangents in an end and in the middle
// meet where that from the end reaches the middle's height, after (1 - b^2) / 4 of D.
Drawing_2<Exact_rational> arc_drawing(const Arc_2& arc) {
  if (!(std::fabs(arc.bulge) <= 1)) throw std::invalid_argument(expected("bulge", "a number from -1 to 1", arc.bulge));
  const shapes::Exact_point from = shapes::exact("from", arc.from), to = shapes::exact("to", arc.to), chord = to - from;
  const Exact_rational b(arc.bulge), half(0.5);
  const shapes::Exact_point height = Exact_rational(-half * b) * perp(chord),
                            along = Exact_rational((1 - b * b) / 4) * chord;
  const shapes::Exact_point middle = from + half * chord + height;
  return shapes::one(
      {shapes::half_arc(from, from + along + height, middle, b), shapes::half_arc(middle, to - along + height, to, b)});
}

}  // namespace CGAL::Bounding_arcs
