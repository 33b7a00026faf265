// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs of conics, those of Arr_conic_traits_2 among them, as rational quadratic Bezier curves.
//
//          c        F(x, y) = r x^2 + s y^2 + t x y + u x + v y + w is half of G(q, q), G the symmetric form that
//         / \       belongs to it.  c is the pole of the chord: G(p, c) = G(q, c) = 0, the tangents at both ends meet
//        /-"-\      in it.  With weights 1, b, 1 the curve has the points P = (1 - t)^2 p + 2 t (1 - t) b c + t^2 q
//        over
//       /     \     their weight, so G(P, P) = 2 t^2 (1 - t)^2 (G(p, q) + 2 b^2 G(c, c)) is 0 if that last factor is.
//      p       q
//
// What is left of an ellipse is cut a quarter after its start, seen from where it is a circle, as long as b < 1/2:
// after the third of a circle. Beyond its half the pole is on the other side.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_CONIC_BEZIERS_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_CONIC_BEZIERS_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/number/convert.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/number/number_types.h>
#include <CGAL/Bounding_arcs_2/number/points_of_kernel.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <optional>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The conic r x^2 + s y^2 + t x y + u x + v y + w = 0.
template <class NT> struct Conic_equation {
  NT r, s, t, u, v, w;

  /// Returns the gradient of the equation's left side.
  [[nodiscard]] Xy<NT> gradient(const Xy<NT>& p) const {
    return {NT(NT(2) * r * p.x + t * p.y + u), NT(NT(2) * s * p.y + t * p.x + v)};
  }
  /// G(p, q), twice F where both are one point.
  [[nodiscard]] NT form(const Xy<NT>& p, const Xy<NT>& q) const {
    return NT(dot(gradient(p), q) + u * p.x + v * p.y + NT(2) * w);
  }
  [[nodiscard]] bool is_ellipse() const { return t * t < NT(4) * r * s; }
  /// \pre it is an ellipse
  [[nodiscard]] Xy<NT> center() const {
    CGAL_precondition(is_ellipse());
    const NT d = NT(4) * r * s - t * t;
    return {NT((t * v - NT(2) * s * u) / d), NT((t * u - NT(2) * r * v) / d)};
  }
  /// The point of an ellipse from its center along d. \throws std::invalid_argument if there is none
  [[nodiscard]] Xy<NT> point_along(const Xy<NT>& d) const {
    const Xy<NT> z = center();
    const NT below = -form(z, z), rise = NT(2) * (r * d.x * d.x + s * d.y * d.y + t * d.x * d.y);
    if (!(below * rise > NT(0)))
      throw std::invalid_argument(expected("conic", "a point along each end of the arc", "none"));
    return z + square_root(NT(below / rise)) * d;
  }
};

namespace internal {
/// The corner and the weight of the arc from p to q, or nothing if it is too long for one curve.
template <class NT> struct Conic_corner {
  Xy<NT> point;
  NT weight;
};
/// \throws std::invalid_argument if p and q are not the ends of such an arc
template <class NT>
[[nodiscard]] std::optional<Conic_corner<NT>> conic_corner(const Conic_equation<NT>& conic, const Xy<NT>& p,
                                                           const Xy<NT>& q, bool ccw) {
  const Xy<NT> at_p = conic.gradient(p), at_q = conic.gradient(q), chord = q - p;
  const NT turn = cross(at_p, at_q);
  if (turn != NT(0)) {
    const Xy<NT> c = p + NT(dot(at_q, chord) / turn) * perp(at_p);
    const NT height = cross(chord, c - p), rise = conic.form(c, c);
    if (rise == NT(0)) throw std::invalid_argument(expected("conic", "one curve", "two lines"));
    const NT square = -conic.form(p, q) / (NT(2) * rise);
    const bool is_on_side = ccw ? height < NT(0) : height > NT(0);
    if (is_on_side && (conic.is_ellipse() ? !(NT(4) * square < NT(1)) : square > NT(0)))
      return Conic_corner<NT>{c, square_root(square)};
  }
  if (!conic.is_ellipse())
    throw std::invalid_argument(expected("p, q", "ends on one branch of the conic", "ends on two"));
  return std::nullopt;
}
}  // namespace internal

/// The arc of a conic from p to q, both on it; equal ends are the whole ellipse.
/// \tparam NT with square roots: CORE::Expr, or a floating type, whose roundings then show
/// \param ccw whether it turns left
/// \return one to four curves whose ends meet bit for bit
/// \throws std::invalid_argument if p and q are seen not to be on one branch of it, or it has no points
/// \guarantee over CORE::Expr control points and weights are rounded once. So the curve is within 4 u times their
///   largest coordinate of the conic: 2 u of the points, and of the weight. The weight moves points by at most a
///   quarter of its own relative error times the distance of the corner from the chord
template <class NT>
[[nodiscard]] std::vector<Bezier_curve_2<double>> conic_beziers(const Conic_equation<NT>& conic, const Xy<NT>& p,
                                                                const Xy<NT>& q, bool ccw) {
  std::vector<Bezier_curve_2<double>> curves;
  Xy<NT> start = p;
  const auto add = [&](const std::optional<internal::Conic_corner<NT>>& corner, const Xy<NT>& end) {
    if (!corner) throw std::invalid_argument(expected("p, q", "ends on the conic", "one beside it"));
    curves.push_back(
        Bezier_curve_2<double>({convert<double>(start), convert<double>(corner->point), convert<double>(end)},
                               {1, convert<double>(corner->weight), 1}));
    start = end;
  };
  if (const auto whole = internal::conic_corner(conic, p, q, ccw)) {
    add(whole, q);
    return curves;
  }
  const Xy<NT> outward = NT(conic.r > NT(0) ? 1 : -1) * conic.gradient(p), twice_center = NT(2) * conic.center();
  const Xy<NT> quarter = conic.point_along(NT(ccw ? 1 : -1) * perp(outward));
  for (const Xy<NT>& end : {quarter, twice_center - p, twice_center - quarter}) {
    add(internal::conic_corner(conic, start, end, ccw), end);
    if (const auto rest = internal::conic_corner(conic, start, q, ccw)) {
      add(rest, q);
      break;
    }
  }
  return curves;
}

/// A curve of Arr_conic_traits_2, x-monotone or not; a segment is a curve of degree 1.
/// \guarantee as above
template <class Arc> [[nodiscard]] std::vector<Bezier_curve_2<double>> conic_beziers(const Arc& arc) {
  using NT = std::decay_t<decltype(arc.source().x())>;
  if (arc.orientation() == CGAL::COLLINEAR)
    return {Bezier_curve_2<double>(
        {internal::point_of_kernel<double>(arc.source()), internal::point_of_kernel<double>(arc.target())})};
  const Conic_equation<NT> conic{NT(arc.r()), NT(arc.s()), NT(arc.t()), NT(arc.u()), NT(arc.v()), NT(arc.w())};
  const bool ccw = arc.orientation() == CGAL::COUNTERCLOCKWISE;
  if (arc.is_full_conic()) {
    const Xy<NT> start = conic.point_along({NT(1), NT(0)});
    return conic_beziers(conic, start, start, ccw);
  }
  return conic_beziers(conic, Xy<NT>{arc.source().x(), arc.source().y()}, Xy<NT>{arc.target().x(), arc.target().y()},
                       ccw);
}

}  // namespace CGAL::Bounding_arcs

#endif
