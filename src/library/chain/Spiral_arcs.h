// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arcs over pieces of one spiral segment, for given break points: which they are and how far off.

#ifndef BOUNDING_ARCS_LIBRARY_CHAIN_SPIRAL_ARCS_H
#define BOUNDING_ARCS_LIBRARY_CHAIN_SPIRAL_ARCS_H

#include "arc_deviation.h"

#include <CGAL/Bounding_arcs_2/chain/arc_chain.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include "../tree/equalize_breaks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

// Which arc, and which biarc, to put over a piece of a spiral segment (doc/arcs.md).  What is chosen here only decides
// how close the result is; how close it is, is bounded afterwards by arc_deviation.h.

namespace CGAL::Bounding_arcs::internal {

/// tan(angle / 2) from u to v, positive when v is to the left. \pre the angle is below half a turn
[[nodiscard]] inline double half_angle_tangent(const Xy<double>& u, const Xy<double>& v) {
  return cross(u, v) / (std::sqrt(dot(u, u) * dot(v, v)) + dot(u, v));
}

/// The bulge of the arc over `chord` whose largest distances to the piece q, one on each side, are equal.
/// q leaves the arc over its chord by (a + lambda b) times a constant, a = cross(chord, q), b = (chord - q).q, with
/// lambda the tangent of half the arc's angle; the extremes lie near (1 -+ 1/sqrt(3))/2.
[[nodiscard]] inline double balanced_bulge(const Local_polynomial& q, const Xy<double>& chord) {
  constexpr double FIRST = 0.21132486540518712;
  const Xy<double> p0 = q(FIRST), p1 = q(1 - FIRST);
  const double lambda = -(cross(chord, p0) + cross(chord, p1)) / (dot(chord - p0, p0) + dot(chord - p1, p1));
  return lambda / (1 + std::sqrt(1 + lambda * lambda));
}

/// Where on the piece q to join the two arcs of a biarc that touches `start` and `end` at the piece's ends: a parameter
/// u at which q is a point of the joint circle, from which the chord is seen under half the turn from start to end.
/// \return nothing where none was found
/// \pre q is a piece of a spiral segment, seen from its start
[[nodiscard]] inline std::optional<double> biarc_joint_parameter(const Local_polynomial& q, const Xy<double>& chord,
                                                                 const Xy<double>& start, const Xy<double>& end) {
  const double cosine = std::sqrt(dot(start, start) * dot(end, end)) + dot(start, end), sine = cross(start, end);
  // Newton's method on the mismatch of angles without its roots at both ends, which leaves it nearly linear with its
  // root near 1/2. A step past an end goes half-way there instead.
  constexpr double CLOSE = 0x1p-26;  // the step after one of this size would be below rounding
  constexpr int STEPS = 16;
  double u = 0.5;
  for (int i = 0; i < STEPS; ++i) {
    const Xy<double> p = q(u), d = q.derivative(u);
    const double mismatch = cross(p, chord) * cosine - dot(p, chord - p) * sine;
    const double slope = cross(d, chord) * cosine - dot(d, chord - 2.0 * p) * sine;
    const double step = mismatch / (slope - mismatch * (1 / u - 1 / (1 - u)));
    if (!(std::fabs(step) > CLOSE)) return u - (std::isnan(step) ? 0 : step);
    u = step >= u ? u / 2 : (-step >= 1 - u ? (u + 1) / 2 : u - step);
  }
  return std::nullopt;
}

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

/// An error half of which is rounding: below it more arcs bring nothing closer.
inline constexpr double ABOVE_ROUNDING = 2;

/// What separates computed end points and computed polynomials from the curve, as a length of the plane: doc/arcs.md.
/// \param reach the sum of |coefficients| of the segment, in units of its table
/// \pre the curve is polynomial, or the segment is straight
[[nodiscard]] inline double fitting_slack(const Bezier_spiral_2<double>& spiral, double reach) {
  constexpr double U = HALF_ULP, ROOT = 1.4142135623730951;
  const double ends = 2 * ROOT * spiral.point_error() + 4 * U * spiral.coordinate_size();
  if (spiral.is_straight()) return ends;  // no polynomial has a part in its chord
  const int degree = spiral.curve().degree();
  const double n = degree, h = spiral.last() - spiral.first(), unit = spiral.table<double>().unit();
  double power = 1;
  for (int k = 0; k < degree; ++k) power *= 1 + 2 * h;
  const double table = ROOT * (6 * n + 8) * U * (power - 1) * unit;
  const double shifts = (8 * n + 16) * U * reach * unit;
  return ends + 2 * table + shifts;
}

/// What the weights on a piece [t0, t1] do to rounding.
struct Weight_bounds {
  double growth;  ///< the sum of what the table's terms for the weight are at most, over its least value
  double least;   ///< the least value over that at t0
};

[[nodiscard]] inline Weight_bounds weight_bounds(const std::vector<double>& weights, double t0, double t1) {
  // the Bezier coefficients of the piece, which bound its values; all numbers are positive, so all of their digits hold
  std::vector<double> b = weights;
  const auto degree = b.size() - 1;
  for (std::size_t k = 1; k <= degree; ++k)
    for (std::size_t i = degree; i >= k; --i) b[i] = (1 - t1) * b[i - 1] + t1 * b[i];  // of [0, t1]
  const double ahead = t0 / t1, behind = (t1 - t0) / t1;
  for (std::size_t k = 1; k <= degree; ++k)
    for (std::size_t i = 0; i + k <= degree; ++i) b[i] = behind * b[i] + ahead * b[i + 1];
  const double least = *std::min_element(b.begin(), b.end()), h = t1 - t0;
  std::vector<double> terms = weights;
  for (std::size_t k = 1; k <= degree; ++k)
    for (std::size_t i = 0; i + k <= degree; ++i) terms[i] = (1 - t0 + h) * terms[i] + (t0 + h) * terms[i + 1];
  return {terms[0] / least, least / b[0]};
}

/// \param curve the segment's local polynomial, in units of its table
[[nodiscard]] inline double fitting_slack(const Bezier_spiral_2<double>& spiral,
                                          const internal::Local_polynomial& curve) {
  const double reach = internal::total_size(curve.m);
  if (!curve.is_rational() || spiral.is_straight()) return fitting_slack(spiral, reach);
  constexpr double U = HALF_ULP, ROOT = 1.4142135623730951;
  const double n = spiral.curve().degree(), unit = spiral.table<double>().unit();
  const Weight_bounds weights = weight_bounds(spiral.curve().weights(), spiral.first(), spiral.last());
  double size = 0;  // of the control points, seen from the first
  const auto& points = spiral.curve().control_points();
  for (const Xy<double>& p : points)
    size = (std::max)({size, std::fabs(p.x - points[0].x), std::fabs(p.y - points[0].y)});
  const double table = ROOT * (24 * n + 56) * U * weights.growth * size;
  const double chord = internal::size_of(curve(1));
  double speed = 0;  // along the segment, times the least weight
  for (std::size_t k = 1; k < curve.m.size(); ++k)
    speed += static_cast<double>(k) * (internal::size_of(curve.m[k]) + chord * std::fabs(curve.w[k]));
  const double shifts = (8 * n + 16) * U * (reach + chord * internal::total_size(curve.w)),
               parameters = 4 * U * spiral.last() / (spiral.last() - spiral.first()) * speed;
  return 2 * ROOT * spiral.point_error() + 4 * U * spiral.coordinate_size() + table +
         (shifts + parameters) / weights.least * unit;
}

/// Whether a biarc exceeds eps but hardly would with equal errors, which are near the geometric mean of these.
[[nodiscard]] inline bool is_worth_balancing(double error0, double error1, double eps) {
  constexpr double ROOM = 0.95;
  return (std::max)(error0, error1) > eps && error0 * error1 <= ROOM * eps * eps;
}

/// A point of a spiral segment and a vector along its tangent there.
struct Curve_end {
  double s;
  Xy<double> point, tangent;
};

/// Any segment, any side. Break points are parameters s in [0, 1] along the segment; the curve has
/// t = first + s (last - first) there.
class Spiral_arcs {
 public:
  /// \param eps the largest error aimed at: pieces no longer than that need no arc of their own
  /// \param start the point of the segment's start, if known
  Spiral_arcs(const Bezier_spiral_2<double>& spiral, Arc_chain::Continuity continuity, Arc_chain::Side side, double eps,
              const std::optional<Xy<double>>& start = std::nullopt)
      : spiral_(spiral), continuity_(continuity), side_(side), unit_(spiral.table<double>().unit()),
        inverse_unit_(1 / unit_),
        curve_(internal::local_polynomial(spiral.table<double>(), spiral.first(), spiral.last())),
        start_(start ? *start : spiral.point(spiral.first())), end_(spiral.point(spiral.last())),
        tangent0_(curve_.derivative(0)), tangent1_(curve_.derivative(1)) {
    const End_orders orders = spiral.orders(spiral.first(), spiral.last());
    if (orders.start > 1 || orders.end > 1) {
      const auto shape = spiral.shape<double>(spiral.first(), spiral.last(), {false, false});
      tangent0_ = shape.tangent0;
      tangent1_ = shape.tangent1;
    }
    slack_ = fitting_slack(spiral, curve_);
    eps_ = (std::max)(eps, ABOVE_ROUNDING * slack_);
  }

  /// The largest error to aim at: eps, or more where that is below what coordinates and evaluation lose to rounding.
  [[nodiscard]] double reachable() const { return eps_; }

  /// Fits every piece, appends its arcs and sets its error, the larger of those of its arcs.
  void fit(const std::vector<double>& breaks, std::vector<double>& errors, std::vector<Arc_chain::Arc>& arcs) const {
    End e0 = end_at(breaks.front());
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      const End e1 = end_at(breaks[i + 1]);
      errors[i] = fit(e0, e1, arcs);
      e0 = e1;
    }
  }

  /// Fits the piece between two ends, appends its arcs and returns their larger error.
  double fit(const Curve_end& e0, const Curve_end& e1, std::vector<Arc_chain::Arc>& arcs) const {
    const Piece p = spiral_.is_straight() ? segment(e0, e1, slack_) : fit_piece(e0, e1);
    for (int i = 0; i < p.count; ++i) arcs.push_back(p.arc[static_cast<std::size_t>(i)]);
    return (std::max)(p.arc[0].error, p.arc[1].error);
  }

  /// Balances the errors of a biarc between two ends whose joint is on the curve, appends its arcs and returns the
  /// larger.
  double fit_balanced(const Curve_end& e0, const Curve_end& e1, const Arc_chain::Arc& arc0, const Arc_chain::Arc& arc1,
                      std::vector<Arc_chain::Arc>& arcs) const {
    const Piece p = balanced({2, {arc0, arc1}}, e0, e1);
    arcs.insert(arcs.end(), p.arc.begin(), p.arc.end());
    return (std::max)(p.arc[0].error, p.arc[1].error);
  }

  [[nodiscard]] const Xy<double>& end_point() const { return end_; }

 private:
  using End = Curve_end;
  struct Piece {
    int count = 1;
    std::array<Arc_chain::Arc, 2> arc;
  };

  [[nodiscard]] double parameter(double s) const {
    return s == 1 ? spiral_.last() : spiral_.first() + s * (spiral_.last() - spiral_.first());
  }
  [[nodiscard]] Xy<double> in_plane(const Xy<double>& local) const { return start_ + unit_ * local; }
  [[nodiscard]] Xy<double> in_units(const Xy<double>& vector) const { return inverse_unit_ * vector; }

  [[nodiscard]] End end_at(double s) const {
    if (s == 0) return {s, start_, tangent0_};
    if (s == 1) return {s, end_, tangent1_};
    return {s, in_plane(curve_(s)), curve_.derivative(s)};
  }

  [[nodiscard]] Arc_chain::Arc arc(const End& e0, const End& e1, double bulge) const {
    return {{e0.point, e1.point, bulge}, parameter(e0.s), parameter(e1.s), 0, 0};
  }

  // Sets the error of an arc over the piece q, seen from the arc's start.
  void measure(Arc_chain::Arc& a, const End& e0, const End& e1, const internal::Local_polynomial& q) const {
    a.error = slack_ + unit_ * internal::arc_deviation(q, {in_units(a.to - a.from), a.bulge}, e0.tangent, e1.tangent);
  }

  [[nodiscard]] Piece segment(const End& e0, const End& e1, double error) const {
    Piece p;
    p.arc[0] = arc(e0, e1, 0);
    p.arc[0].error = error;
    return p;
  }

  [[nodiscard]] Piece fit_piece(const End& e0, const End& e1) const {
    const internal::Local_polynomial q = curve_.piece(e0.s, e1.s - e0.s);
    const Xy<double> chord = in_units(e1.point - e0.point);
    const double bulge0 = internal::half_angle_tangent(e0.tangent, chord),
                 bulge1 = internal::half_angle_tangent(chord, e1.tangent);
    if (continuity_ == Arc_chain::Continuity::TANGENT && !is_one_arc(chord, bulge0, bulge1))
      return side_ == Arc_chain::Side::BOTH ? biarc(e0, e1, q, chord) : bilens_side(e0, e1);
    Piece p;
    const double bulge = continuity_ == Arc_chain::Continuity::TANGENT ? (bulge0 + bulge1) / 2
                         : side_ == Arc_chain::Side::BOTH              ? internal::balanced_bulge(q, chord)
                         : side_ == Arc_chain::Side::LEFT              ? (std::min)(bulge0, bulge1)
                                                                       : (std::max)(bulge0, bulge1);
    p.arc[0] = arc(e0, e1, bulge);
    measure(p.arc[0], e0, e1, q);
    return checked(p, e0, e1);
  }

  [[nodiscard]] Piece checked(const Piece& p, const End& e0, const End& e1) const {
    return std::isfinite(p.arc[0].error + p.arc[1].error) ? p : without_arc(e0, e1);
  }

  // Whether one arc has the tangents of both ends, but for what rounding of the end points turns them by.
  [[nodiscard]] bool is_one_arc(const Xy<double>& chord, double bulge0, double bulge1) const {
    return std::fabs(bulge0 - bulge1) * (std::fabs(chord.x) + std::fabs(chord.y)) * unit_ <= slack_;
  }

  [[nodiscard]] Piece biarc(const End& e0, const End& e1, const internal::Local_polynomial& q,
                            const Xy<double>& chord) const {
    const auto u = internal::biarc_joint_parameter(q, chord, e0.tangent, e1.tangent);
    if (!u) return without_arc(e0, e1);
    const End joint = end_at(e0.s + *u * (e1.s - e0.s));
    const Piece p = two_arcs(e0, joint, e1, joint.point);
    return p.count == 2 && is_worth_balancing(p.arc[0].error, p.arc[1].error, eps_) ? balanced(p, e0, e1) : p;
  }

  // The biarc with its joint moved along the circle of all joints, until no error is above eps or they are about equal.
  [[nodiscard]] Piece balanced(const Piece& on_curve, const End& e0, const End& e1) const {
    const Xy<double> chord = e1.point - e0.point, first = on_curve.arc[0].to - e0.point, second = chord - first;
    const double angle0 = std::atan2(cross(chord, first), dot(chord, first));
    const double angle1 = std::atan2(cross(second, chord), dot(second, chord));
    const double turn = angle0 + angle1, sine = std::sin(turn);
    const auto imbalance = [](const Piece& p) { return std::log(p.arc[0].error / p.arc[1].error); };
    const auto largest = [](const Piece& p) { return (std::max)(p.arc[0].error, p.arc[1].error); };
    Piece best = on_curve;
    double move = 0, balance = imbalance(on_curve), slope = -24;  // for a short piece: doc/arcs.md
    constexpr int STEPS = 2;
    for (int i = 0; i < STEPS && largest(best) > eps_; ++i) {
      const double before = move, balance_before = balance;
      move -= balance / slope;  // a share of the turn
      const double length = std::sin(angle1 - move * turn) / sine, angle = angle0 + move * turn;
      const Xy<double> to_joint = (length * std::cos(angle)) * chord + (length * std::sin(angle)) * perp(chord);
      const Xy<double> joint = e0.point + to_joint;
      const Xy<double> along = (2 * dot(e0.tangent, to_joint) / dot(to_joint, to_joint)) * to_joint - e0.tangent;
      const auto s = foot_parameter(e0, e1, joint, along);
      if (!s) break;
      const Piece p = two_arcs(e0, end_at(*s), e1, joint);
      if (p.count != 2) break;
      if (largest(p) < largest(best)) best = p;
      balance = imbalance(p);
      slope = (balance - balance_before) / (move - before);
    }
    return best;
  }

  // Where no arc is found: curve and chord are both in the box of the end points, whose diagonal is the chord.
  [[nodiscard]] Piece without_arc(const End& e0, const End& e1) const {
    const double error = slack_ + stable_norm(e1.point - e0.point);
    return segment(e0, e1, error <= eps_ ? error : std::numeric_limits<double>::infinity());
  }

  // The arcs that touch the curve at both ends and meet at `joint_point`, the foot of the curve's point at `joint`.
  [[nodiscard]] Piece two_arcs(const End& e0, const End& joint, const End& e1, const Xy<double>& joint_point) const {
    Piece p;
    p.count = 2;
    const Xy<double> chord0 = joint_point - e0.point, chord1 = e1.point - joint_point;
    p.arc[0] = {{e0.point, joint_point, internal::half_angle_tangent(e0.tangent, in_units(chord0))},
                parameter(e0.s),
                parameter(joint.s),
                0,
                0};
    p.arc[1] = {{joint_point, e1.point, internal::half_angle_tangent(in_units(chord1), e1.tangent)},
                parameter(joint.s),
                parameter(e1.s),
                0,
                0};
    measure(p.arc[0], e0, joint, curve_.piece(e0.s, joint.s - e0.s));
    internal::Local_polynomial rest = curve_.piece(joint.s, e1.s - joint.s);
    if (joint_point != joint.point) rest = rest.seen_from(in_units(joint_point - joint.point));
    measure(p.arc[1], joint, e1, rest);
    return checked(p, e0, e1);
  }

  // The inner or outer boundary of the bilens, whichever is on the side asked for.
  [[nodiscard]] Piece bilens_side(const End& e0, const End& e1) const {
    const auto shape = spiral_.shape<double>(parameter(e0.s), parameter(e1.s), {true, false});
    const auto boundary = Bilens::boundary(Chord_frame_2<double>{e0.point, e1.point, shape});
    const bool is_inner = (shape.turn > 0) == (side_ == Arc_chain::Side::LEFT);
    const auto& chain = is_inner ? boundary.inner : boundary.outer;
    if (chain.size() < 2) return without_arc(e0, e1);
    const Xy<double> joint = chain[0].to;
    const auto& circle = chain[0].support;
    const auto s = foot_parameter(e0, e1, joint, -perp(circle.normal_at(joint)));
    return s ? two_arcs(e0, end_at(*s), e1, joint) : without_arc(e0, e1);
  }

  // The curve's point whose foot is the biarc's joint, on the normal line there; `along` is a tangent.
  [[nodiscard]] std::optional<double> foot_parameter(const End& e0, const End& e1, const Xy<double>& joint,
                                                     const Xy<double>& along) const {
    const Xy<double> target = in_units(joint - start_);
    double low = e0.s, high = e1.s, s = (low + high) / 2;
    constexpr int STEPS = 60;
    for (int i = 0; i < STEPS; ++i) {
      const double ahead = dot(along, curve_(s) - target), step = ahead / dot(along, curve_.derivative(s)),
                   next = s - step;
      if (std::fabs(step) <= 0x1p-50 * (e1.s - e0.s)) return next;
      (ahead > 0 ? high : low) = s;
      s = next > low && next < high ? next : (low + high) / 2;
    }
    return s > e0.s && s < e1.s ? std::optional<double>(s) : std::nullopt;
  }

  const Bezier_spiral_2<double>& spiral_;
  Arc_chain::Continuity continuity_;
  Arc_chain::Side side_;
  double eps_;
  double unit_, inverse_unit_;  // a power of two
  internal::Local_polynomial curve_;
  Xy<double> start_, end_, tangent0_, tangent1_;
  double slack_ = 0;
};

}  // namespace CGAL::Bounding_arcs

#endif
