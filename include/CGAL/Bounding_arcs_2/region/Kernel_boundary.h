// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A region's boundary as Circular_arc_2 and Line_arc_2 of a circular kernel.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_KERNEL_BOUNDARY_H
#define CGAL_BOUNDING_ARCS_2_REGION_KERNEL_BOUNDARY_H

#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>
#include <vector>

namespace CGAL::Bounding_arcs {

// Boundary pieces of floating numbers as circles, and what that costs.

namespace internal {
/// A boundary piece of floating numbers as center and squared radius in the same numbers, or as the segment between its
/// ends, and how far that is from the piece. A circle of radius r misses its ends by about u r, a segment its arc by
/// c^2 / (8 r): where the arc is so flat that the latter is less, the segment is what holds the curve.
template <class FT> struct Rounded_arc_2 {
  Xy<FT> center;         ///< of an arc
  FT squared_radius{0};  ///< of an arc
  double deviation = 0;  ///< at least the Hausdorff distance from the piece; infinity where its numbers are not finite
  bool is_segment = true;
};
}  // namespace internal

/// A piece in double-doubles, seen from its start, with 2^exponent as unit of length.
///   the arc over the chord   from, apex, to   through both ends, with the bulge that the support has in the mean
///   the support              2 n.(p - q) - k |p - q|^2 = 0, which may miss the ends by what was rounded
template <class FT> class Seen_piece {
 public:
  using Number = Double_double;
  using Point = Xy<Number>;

  Seen_piece(const Boundary_piece_2<FT>& piece, int exponent) : exponent_(exponent), origin_(scaled(piece.from)) {
    to_ = seen(piece.to);
    point_ = seen(piece.support.point);
    const Xy<FT>& n = piece.support.normal;
    const int normal_exponent = exponent_of((std::max)(std::fabs(n.x), std::fabs(n.y)));
    normal_ = {scaled(n.x, normal_exponent), scaled(n.y, normal_exponent)};
    curvature_ = scaled(piece.support.curvature, normal_exponent - exponent);
    bulge_ = (bulge_at(Point()) - bulge_at(to_)) / 2;
    const Number half(0.5);
    apex_ = half * to_ - Number(bulge_ / 2) * perp(to_);
  }

  /// The exponent of a unit near the largest of some lengths.
  template <class T> [[nodiscard]] static int exponent_of(T largest) {
    return largest > 0 && std::isfinite(largest) ? std::ilogb(largest) : 0;
  }
  [[nodiscard]] Point seen(const Xy<FT>& p) const { return scaled(p) - origin_; }
  [[nodiscard]] Number scaled_square(const FT& x) const { return scaled(x, 2 * exponent_); }

  /// The arc has a bulge that bounds hold for: it turns by at most 254 degrees.  Else its ends are as near to each
  /// other as rounding brings them.
  [[nodiscard]] bool is_arc() const { return std::fabs(bulge_) <= 2; }
  [[nodiscard]] double bulge() const { return bulge_; }
  [[nodiscard]] double chord() const { return upper_length(to_); }
  [[nodiscard]] const Point& to() const { return to_; }

  /// An upper bound of |f| on the arc, f(p) = a |p|^2 + an affine function: along the arc, from 0 to 1 by s, with w the
  /// cosine of half its turning, (1 - s(1-s) 2(1-w)) f is (1-2s) ((1-s) f(from) - s f(to)) + 2 (1+w) s (1-s) f(apex).
  template <class F> [[nodiscard]] double largest_on_arc(const F& f) const {
    constexpr double END = 1.25;  // the most that (1-2s) / (1 - s(1-s) 2(1-w)) takes for bulges up to 2
    return upper(f(apex_)) + END * largest_at_ends(f);
  }
  template <class F> [[nodiscard]] double largest_at_ends(const F& f) const {
    return (std::max)(upper(f(Point())), upper(f(to_)));
  }

  /// An upper bound of the distance from the support of a point where `side` is at most so large.
  [[nodiscard]] double distance_from_support(double side) const {
    const Number square = dot(normal_, normal_);
    const double n = std::sqrt((std::max)(square.hi - std::fabs(square.lo) - square.err, 0.0));
    const double root = std::sqrt((std::max)(0.0, 1 - ROOM * upper(curvature_) * side / (n * n)));
    return ROOM * side / (n * (1 + root));
  }
  [[nodiscard]] Number side(const Point& p) const {
    const Point v = p - point_;
    return Number(2) * dot(normal_, v) - curvature_ * dot(v, v);
  }

  /// A length in units of the plane, with room for the few roundings that it comes from.
  [[nodiscard]] double in_plane(double length) const { return std::ldexp(ROOM * length, exponent_); }

  [[nodiscard]] static double upper(const Number& x) { return ROOM * x.size(); }

 private:
  using Wide = std::common_type_t<FT, double>;
  static constexpr double ROOM = 1 + 0x1p-40;

  // x / 2^exponent; long double has no more bits than two doubles.
  [[nodiscard]] static Number scaled(const FT& x, int exponent) {
    const Wide y = std::ldexp(Wide(x), -exponent);
    const double high = static_cast<double>(y);
    return Number::two_sum(high, static_cast<double>(y - Wide(high)));
  }
  [[nodiscard]] Point scaled(const Xy<FT>& p) const { return {scaled(p.x, exponent_), scaled(p.y, exponent_)}; }

  [[nodiscard]] static double upper_length(const Point& v) {
    return ROOM * stable_norm(Xy<double>{upper(v.x), upper(v.y)});
  }

  // tan of half the angle from the support's tangent at an end to the chord.
  [[nodiscard]] double bulge_at(const Point& end) const {
    const Point n = normal_ - curvature_ * (end - point_);
    const Xy<double> t{n.y.hi, -n.x.hi}, c{to_.x.hi, to_.y.hi};
    return cross(t, c) / (stable_norm(t) * stable_norm(c) + dot(t, c));
  }

  int exponent_;
  Point origin_, to_, point_, normal_, apex_;
  Number curvature_;
  double bulge_;
};

/// The larger coordinate of q - p.
template <class FT> [[nodiscard]] FT reach(const Xy<FT>& p, const Xy<FT>& q) {
  return (std::max)(std::fabs(q.x - p.x), std::fabs(q.y - p.y));
}

namespace internal {
/// The length by which a piece's support and the arc or segment through the piece's ends differ, and how far the
/// segment is from the arc.
struct Support_deviation {
  double of_support = 0, sagitta = 0;
};
/// \guarantee upper bounds, of floating pieces
template <class FT> [[nodiscard]] Support_deviation support_deviation(const Boundary_piece_2<FT>& piece) {
  if (piece.support.normal == Xy<FT>()) return {};  // a point
  const FT size = (std::max)(reach(piece.from, piece.to), reach(piece.from, piece.support.point));
  const Seen_piece<FT> seen(piece, Seen_piece<FT>::exponent_of(size));
  const auto side = [&](const Xy<Double_double>& p) { return seen.side(p); };
  const double at_ends = seen.in_plane(seen.distance_from_support(seen.largest_at_ends(side)));
  if (piece.is_segment()) return {at_ends, 0};
  // ends as near as rounding brings them: no point of half a circle is farther from both than they are from each other
  const double chord = seen.in_plane(seen.chord());
  if (!seen.is_arc()) return {at_ends, 2 * (chord + 2 * at_ends)};
  return {seen.in_plane(seen.distance_from_support(seen.largest_on_arc(side))), std::fabs(seen.bulge()) * chord / 2};
}

/// A circle about `center` that the ends lie nearest to, and at least its distance from the arc through the ends;
/// infinity where the kernel's arc of that circle would not run as the piece does.
template <class FT> [[nodiscard]] Rounded_arc_2<FT> rounded_circle(const Boundary_piece_2<FT>& piece) {
  constexpr double INFINITE = std::numeric_limits<double>::infinity();
  Rounded_arc_2<FT> arc{piece.support.center(), FT(0), INFINITE, false};
  const FT radius = reach(piece.from, arc.center);
  if (!std::isfinite(radius)) return arc;
  const int exponent = Seen_piece<FT>::exponent_of((std::max)(radius, reach(piece.from, piece.to)));
  const Seen_piece<FT> seen(piece, exponent);
  const auto center = seen.seen(arc.center);
  const auto square = [&](const Xy<Double_double>& p) { return dot(p - center, p - center); };
  const Double_double mean = Double_double(0.5) * (square({}) + square(seen.to()));
  using Wide = std::common_type_t<FT, double>;
  arc.squared_radius = static_cast<FT>(std::ldexp(Wide(mean.hi) + Wide(mean.lo), 2 * exponent));
  if (!(arc.squared_radius > 0) || !std::isfinite(arc.squared_radius) || !seen.is_arc()) return arc;
  const Double_double r2 = seen.scaled_square(arc.squared_radius);
  const double off = seen.largest_on_arc([&](const Xy<Double_double>& p) { return square(p) - r2; });
  const double distance = off / (std::sqrt(r2.hi) + std::sqrt((std::max)(0.0, r2.hi - off)));
  // Seen from the center the arc must turn the way the circle is run through. Flat arcs do where the center is on the
  // inner side of the chord, others where the center is near their own.
  constexpr double FLAT = 0.5, NEAR = 0.125;
  const bool ccw = piece.is_ccw();
  const auto inner = cross(seen.to(), center).sign();
  const bool turns =
      std::fabs(seen.bulge()) <= FLAT ? inner && *inner == (ccw ? 1 : -1) : distance < NEAR * std::sqrt(r2.hi);
  if (turns && ccw == (seen.bulge() > 0)) arc.deviation = seen.in_plane(distance);
  return arc;
}

/// The arc with center and squared radius in floating numbers that stands for a boundary piece, or the segment from its
/// start to its end where the arc would miss them by more than 4 ulp of their coordinates and the segment is nearer.
/// \guarantee certified: the deviation is at least the Hausdorff distance between that arc or segment and the piece,
///   whether this is taken for the part of its support between the ends or for the arc through the ends with the
///   support's bulge
/// \complexity some hundred operations in double-doubles
template <class FT> [[nodiscard]] Rounded_arc_2<FT> rounded_arc(const Boundary_piece_2<FT>& piece) {
  static_assert(std::is_floating_point_v<FT>, "exact arcs are not rounded");
  constexpr int ULPS = 4;
  const auto stated = [](double d) { return d >= 0 ? d : std::numeric_limits<double>::infinity(); };  // not so for NaN
  const Support_deviation off = support_deviation(piece);
  Rounded_arc_2<FT> segment;
  segment.deviation = stated(off.of_support + off.sagitta);
  if (piece.is_segment()) return segment;
  Rounded_arc_2<FT> arc = rounded_circle(piece);
  const FT size = (std::max)(reach({}, piece.from), reach({}, piece.to));
  const FT ulp = size > 0 ? std::ldexp(std::numeric_limits<FT>::epsilon(), std::ilogb(size)) : FT(0);
  const double allowed = ULPS * static_cast<double>(ulp);
  const bool is_near = arc.deviation <= allowed || arc.deviation <= off.sagitta;
  if (!is_near || !std::isfinite(arc.deviation)) return segment;
  arc.deviation = stated(arc.deviation + off.of_support);
  return arc;
}
}  // namespace internal

/// A tangent segment whose end points are algebraic and whose supporting line is not rational, so that a rational
/// kernel has no Line_arc_2 for it.
template <class CircularKernel> struct Algebraic_segment_2 {
  typename CircularKernel::Circular_arc_point_2 source, target;
};

/// One boundary piece in the kernel's types. Circular_arc_2 always runs counterclockwise; `reversed` is true when the
/// boundary runs through it from target to source.
/// Over floating numbers an arc's circle does not pass through its source and target, and an arc too flat for a circle
/// in these numbers is a Line_arc_2: `deviation` tells what either makes out.
template <class CircularKernel> struct Kernel_piece_2 {
  std::variant<typename CircularKernel::Circular_arc_2, typename CircularKernel::Line_arc_2,
               Algebraic_segment_2<CircularKernel>>
      curve;
  bool reversed = false;
  /// An upper bound of the Hausdorff distance between `curve`, a Line_arc_2 taken for the segment from its source to
  /// its target, and the piece of the Region_boundary_2 that it stands for. It is 0 over exact number types. Over
  /// floating ones it is some ulp of the coordinates, but it grows with the radius r, like u r, up to about sqrt(u)
  /// times the chord (2^-26 of it over double). Flatter arcs are segments, and nearer again.
  double deviation = 0;
};

/// A region's boundary in pieces of the kernel, from the start of the curve piece to its end.
template <class CircularKernel> struct Kernel_boundary_2 { std::vector<Kernel_piece_2<CircularKernel>> inner, outer; };

namespace internal {
/// A point as the kernel has it.
template <class CK, class FT> [[nodiscard]] typename CK::Point_2 kernel_point(const Xy<FT>& p) {
  return typename CK::Point_2(p.x, p.y);
}

/// A circle as the kernel has it. \pre not a line
template <class CK, class FT>
[[nodiscard]] typename CK::Circle_2 kernel_circle(const Contact_circle_2<FT>& c,
                                                  CGAL::Orientation orientation = CGAL::COUNTERCLOCKWISE) {
  return typename CK::Circle_2(kernel_point<CK>(c.center()), c.squared_radius(), orientation);
}

/// The arc of a circle from source to target in the direction given, as the kernel's counterclockwise arc.
template <class CK>
[[nodiscard]] Kernel_piece_2<CK> kernel_arc(const typename CK::Circle_2& circle,
                                            const typename CK::Circular_arc_point_2& source,
                                            const typename CK::Circular_arc_point_2& target, bool ccw) {
  using Arc = typename CK::Circular_arc_2;
  return ccw ? Kernel_piece_2<CK>{Arc(circle, source, target), false}
             : Kernel_piece_2<CK>{Arc(circle, target, source), true};
}
}  // namespace internal

/// A piece of a boundary as the kernel has it, with its deviation.
template <class CK, class FT> [[nodiscard]] Kernel_piece_2<CK> kernel_piece(const Boundary_piece_2<FT>& p) {
  using Arc_point = typename CK::Circular_arc_point_2;
  const auto from = internal::kernel_point<CK>(p.from), to = internal::kernel_point<CK>(p.to);
  const auto segment = [&](double deviation) {
    return Kernel_piece_2<CK>{typename CK::Line_arc_2(from, to), false, deviation};
  };
  if constexpr (std::is_floating_point_v<FT>) {
    const internal::Rounded_arc_2<FT> r = internal::rounded_arc(p);
    if (r.is_segment) return segment(r.deviation);
    auto piece = internal::kernel_arc<CK>(typename CK::Circle_2(internal::kernel_point<CK>(r.center), r.squared_radius),
                                          Arc_point(from), Arc_point(to), p.is_ccw());
    piece.deviation = r.deviation;
    return piece;
  } else if (p.is_segment()) {
    return segment(0);
  } else {
    return internal::kernel_arc<CK>(internal::kernel_circle<CK>(p.support), Arc_point(from), Arc_point(to), p.is_ccw());
  }
}

namespace internal {
/// A chain, a range of Boundary_piece_2, in pieces of the kernel.
template <class CK, class Chain> [[nodiscard]] std::vector<Kernel_piece_2<CK>> kernel_chain(const Chain& chain) {
  std::vector<Kernel_piece_2<CK>> pieces;
  for (const auto& p : chain) pieces.push_back(kernel_piece<CK>(p));
  return pieces;
}
}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
