// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arcs over pieces of one spiral segment, for given break points: which they are and how far off.

#ifndef CGAL_BOUNDING_ARCS_2_APPROXIMATION_SPIRAL_ARCS_H
#define CGAL_BOUNDING_ARCS_2_APPROXIMATION_SPIRAL_ARCS_H

#include <CGAL/Bounding_arcs_2/approximation/Chain_arc_2.h>
#include <CGAL/Bounding_arcs_2/approximation/Polynomial_arcs.h>
#include <CGAL/Bounding_arcs_2/approximation/fit_arc.h>
#include <CGAL/Bounding_arcs_2/approximation/cubic_factor.h>
#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/equalize_breaks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs {

/// What a chain of arcs does where two arcs meet inside a smooth piece of the curve.
enum class Continuity {
  POSITION,  ///< meets: one arc a piece, both ends on the curve
  TANGENT    ///< meets with a common tangent: a biarc a piece, with the curve's ends and tangents
};

/// On which side of the curve, seen along it, a chain runs.
enum class Chain_side { BOTH, LEFT, RIGHT };

namespace internal {

/// Break points are parameters s in [0, 1] along the segment; the curve has t = first + s (last - first) there.
class Spiral_arcs {
 public:
  /// \param eps the largest error aimed at: pieces no longer than that need no arc of their own
  /// \param start the point of the segment's start, if known
  Spiral_arcs(const Bezier_spiral_2<double>& spiral, Continuity continuity, Chain_side side, double eps,
              const std::optional<Xy<double>>& start = std::nullopt)
      : spiral_(spiral), continuity_(continuity), side_(side), unit_(spiral.table<double>().unit()), inverse_unit_(1 / unit_),
        curve_(local_polynomial(spiral.table<double>(), spiral.first(), spiral.last())),
        start_(start ? *start : spiral.point(spiral.first())), end_(spiral.point(spiral.last())), tangent0_(curve_.derivative(0)), tangent1_(curve_.derivative(1)) {
    const End_orders orders = spiral.orders(spiral.first(), spiral.last());
    has_closed_form_ = side == Chain_side::BOTH && !curve_.is_rational() && !spiral.is_straight();
    if (orders.start > 1 || orders.end > 1) {
      has_closed_form_ = false;
      const auto shape = spiral.shape<double>(spiral.first(), spiral.last(), {false, false});
      tangent0_ = shape.tangent0;
      tangent1_ = shape.tangent1;
    }
    slack_ = slack();
    constexpr double ABOVE_ROUNDING = 2;  // an error half of which is rounding; below it more arcs bring nothing closer
    eps_ = (std::max)(eps, ABOVE_ROUNDING * slack_);
  }

  /// The largest error to aim at: eps, or more where that is below what coordinates and evaluation lose to rounding.
  [[nodiscard]] double reachable() const { return eps_; }

  /// Break points near those of equal errors, from the slope of curvature at a few places; none where that says little.
  void guess(std::vector<double>& breaks) const {
    breaks.assign({0, 1});
    if (has_closed_form_ && curve_.m.size() == CUBIC) guess_polynomial<CUBIC - 1>(breaks);
  }

  /// Fits every piece and sets its error, the larger of those of its arcs.
  void fit(const std::vector<double>& breaks, std::vector<double>& errors) {
    pieces_.clear();
    pieces_.reserve(breaks.size());
    if (has_closed_form_ && curve_.m.size() == CUBIC) return fit_polynomial<CUBIC - 1>(breaks, errors);
    if (has_closed_form_ && curve_.m.size() == QUADRATIC) return fit_polynomial<QUADRATIC - 1>(breaks, errors);
    End e0 = end_at(breaks.front());
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      const End e1 = end_at(breaks[i + 1]);
      pieces_.push_back(spiral_.is_straight() ? segment(e0, e1, slack_) : fit_piece(e0, e1));
      errors[i] = (std::max)(pieces_.back().arc[0].error, pieces_.back().arc[1].error);
      e0 = e1;
    }
  }

  [[nodiscard]] const Xy<double>& end_point() const { return end_; }

  /// Appends the arcs of the last fit.
  void append_to(std::vector<Chain_arc_2>& arcs) const {
    for (const Piece& p : pieces_)
      for (int i = 0; i < p.count; ++i) arcs.push_back(p.arc[static_cast<std::size_t>(i)]);
  }

 private:
  static constexpr std::size_t QUADRATIC = 3, CUBIC = 4;  // numbers of coefficients

  struct End {
    double s;
    Xy<double> point, tangent;
  };
  struct Piece {
    int count = 1;
    std::array<Chain_arc_2, 2> arc;
  };

  // An end with the curve's Taylor coefficients there, those that the two pieces beside it are made of.
  template <std::size_t N>
  struct Taylor_end {
    End end;
    Taylor<N> taylor;
    Direction direction;
  };

  template <std::size_t N>
  [[nodiscard]] std::array<Xy<double>, N + 1> coefficients() const {
    std::array<Xy<double>, N + 1> c;
    std::copy(curve_.m.begin(), curve_.m.end(), c.begin());
    return c;
  }

  template <std::size_t N>
  void guess_polynomial(std::vector<double>& breaks) const {
    constexpr std::size_t PLACES = 4;
    constexpr double LEAST = 1e-3;  // keeps the shares positive
    const auto curve = coefficients<N>();
    const double cubic = continuity_ == Continuity::TANGENT ? cubic_factor::BIARC : cubic_factor::ARC;
    const double factor = rough_cube_root(cubic * unit_ / eps_);
    std::array<double, PLACES> shares;
    double sum = 0;
    for (std::size_t i = 0; i < PLACES; ++i) {
      const auto c = shifted(curve, (static_cast<double>(i) + 0.5) / PLACES);  // derivatives over factorials
      const double speed = dot(c[1], c[1]), change = 6 * cross(c[1], c[3]) * speed - 12 * cross(c[1], c[2]) * dot(c[1], c[2]);
      shares[i] = factor * rough_cube_root(std::fabs(change) / (speed * std::sqrt(speed))) / PLACES + LEAST;
      sum += shares[i];
    }
    if (!(sum > 1)) return;
    breaks.assign({0, 0.25, 0.5, 0.75, 1});
    redistribute(breaks, std::vector<double>(shares.begin(), shares.end()), static_cast<std::size_t>(std::ceil(sum)));
  }

  template <std::size_t N>
  void fit_polynomial(const std::vector<double>& breaks, std::vector<double>& errors) {
    const auto curve = coefficients<N>();
    const auto make_end = [&](double s) {
      const Taylor<N> taylor(curve, s);
      const Xy<double> point = s == 0 ? start_ : (s == 1 ? end_ : in_plane(taylor.c[0])), tangent = taylor.c[1];
      return Taylor_end<N>{{s, point, tangent}, taylor, {tangent, std::sqrt(dot(tangent, tangent))}};
    };
    auto e0 = make_end(breaks.front());
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      const auto e1 = make_end(breaks[i + 1]);
      pieces_.emplace_back();
      Piece& p = pieces_.back();
      if (continuity_ == Continuity::TANGENT) fit_biarc<N>(p, e0, e1);
      else fit_balanced<N>(p, Taylor<N>(curve, (e0.end.s + e1.end.s) / 2), e0, e1);
      if (!std::isfinite(p.arc[0].error + p.arc[1].error)) p = fit_piece(e0.end, e1.end);
      errors[i] = (std::max)(p.arc[0].error, p.arc[1].error);
      e0 = e1;
    }
  }

  template <std::size_t N>
  void fit_biarc(Piece& p, const Taylor_end<N>& e0, const Taylor_end<N>& e1) const {
    const Direction &d0 = e0.direction, &d1 = e1.direction;
    const double h = e1.end.s - e0.end.s, limit = eps_ * inverse_unit_;
    p.count = 2;
    p.arc[0].error = std::numeric_limits<double>::infinity();
    const double u = joint_parameter<N>(e0.taylor, h, in_units(e1.end.point - e0.end.point),
                                        d0.length * d1.length + dot(d0.tangent, d1.tangent), cross(d0.tangent, d1.tangent));
    if (!(u > 0)) return;
    const double s = e0.end.s + u * h, t = parameter(s);
    const Xy<double> joint = in_plane(curve_(s));
    const Fitted_arc a = tangent_arc<N>(e0.taylor, u * h, in_units(joint - e0.end.point), d0, d1, limit);
    // the second arc backwards: tangents turn round, and so does the bulge
    const Fitted_arc b = tangent_arc<N>(e1.taylor, (u - 1) * h, in_units(joint - e1.end.point), {-d1.tangent, d1.length},
                                        {-d0.tangent, d0.length}, limit);
    p.arc[0] = {e0.end.point, joint, a.bulge, parameter(e0.end.s), t, slack_ + unit_ * a.distance, 0};
    p.arc[1] = {joint, e1.end.point, -b.bulge, t, parameter(e1.end.s), slack_ + unit_ * b.distance, 0};
  }

  template <std::size_t N>
  void fit_balanced(Piece& p, const Taylor<N>& middle, const Taylor_end<N>& e0, const Taylor_end<N>& e1) const {
    const Fitted_arc a = balanced_arc<N>(middle, e1.end.s - e0.end.s, middle.c[0] - e0.taylor.c[0],
                                         in_units(e1.end.point - e0.end.point), e0.direction, e1.direction, eps_ * inverse_unit_);
    p.arc[0] = arc(e0.end, e1.end, a.bulge);
    p.arc[0].error = slack_ + unit_ * a.distance;
  }

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

  // doc/arcs.md: what separates computed end points and computed polynomials from the curve, as lengths of the plane.
  [[nodiscard]] double slack() const {
    constexpr double U = 0x1p-53, ROOT = 1.4142135623730951;
    const double n = spiral_.curve().degree(), h = spiral_.last() - spiral_.first();
    double reach = 0, power = 1, lightest = 1, heaviest = 1;
    for (int k = 0; k < spiral_.curve().degree(); ++k) power *= 1 + 2 * h;
    for (const Xy<double>& v : curve_.m) reach += size_of(v);
    for (const double w : spiral_.curve().weights()) {
      lightest = (std::min)(lightest, w);
      heaviest = (std::max)(heaviest, w);
    }
    const double weights = heaviest / lightest;
    const double growth = spiral_.curve().is_rational() ? 4 * n * weights * weights * power
                                                        : power - 1;
    const double table = ROOT * (6 * n + 8) * U * growth * unit_;
    const double shifts = (8 * n + 16) * weights * U * reach * unit_;
    return 2 * (ROOT * spiral_.point_error() + table) + shifts + 4 * U * spiral_.coordinate_size();
  }

  [[nodiscard]] Chain_arc_2 arc(const End& e0, const End& e1, double bulge) const {
    return {e0.point, e1.point, bulge, parameter(e0.s), parameter(e1.s), 0, 0};
  }

  // Sets the error of an arc over the piece q, seen from the arc's start.
  void measure(Chain_arc_2& a, const End& e0, const End& e1, const Local_polynomial& q) const {
    a.error = slack_ + unit_ * arc_deviation(q, {in_units(a.to - a.from), a.bulge}, e0.tangent, e1.tangent);
  }

  [[nodiscard]] Piece segment(const End& e0, const End& e1, double error) const {
    Piece p;
    p.arc[0] = arc(e0, e1, 0);
    p.arc[0].error = error;
    return p;
  }

  [[nodiscard]] Piece fit_piece(const End& e0, const End& e1) const {
    const Local_polynomial q = curve_.piece(e0.s, e1.s - e0.s);
    const Xy<double> chord = in_units(e1.point - e0.point);
    const double bulge0 = half_angle_tangent(e0.tangent, chord), bulge1 = half_angle_tangent(chord, e1.tangent);
    if (continuity_ == Continuity::TANGENT && !is_one_arc(chord, bulge0, bulge1))
      return side_ == Chain_side::BOTH ? biarc(e0, e1, q, chord) : bilens_side(e0, e1);
    Piece p;
    const double bulge = continuity_ == Continuity::TANGENT ? (bulge0 + bulge1) / 2
                         : side_ == Chain_side::BOTH       ? balanced_bulge(q, chord)
                         : side_ == Chain_side::LEFT       ? (std::min)(bulge0, bulge1)
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

  [[nodiscard]] Piece biarc(const End& e0, const End& e1, const Local_polynomial& q, const Xy<double>& chord) const {
    const auto u = biarc_joint_parameter(q, chord, e0.tangent, e1.tangent);
    if (!u) return without_arc(e0, e1);
    const End joint = end_at(e0.s + *u * (e1.s - e0.s));
    return two_arcs(e0, joint, e1, joint.point);
  }

  // Where no arc is found: curve and chord are both in the box of the end points, whose diagonal is the chord.
  [[nodiscard]] Piece without_arc(const End& e0, const End& e1) const {
    const double error = slack_ + std::hypot(e1.point.x - e0.point.x, e1.point.y - e0.point.y);
    return segment(e0, e1, error <= eps_ ? error : std::numeric_limits<double>::infinity());
  }

  // The arcs that touch the curve at both ends and meet at `joint_point`, the foot of the curve's point at `joint`.
  [[nodiscard]] Piece two_arcs(const End& e0, const End& joint, const End& e1, const Xy<double>& joint_point) const {
    Piece p;
    p.count = 2;
    const Xy<double> chord0 = joint_point - e0.point, chord1 = e1.point - joint_point;
    p.arc[0] = {e0.point, joint_point, half_angle_tangent(e0.tangent, in_units(chord0)), parameter(e0.s), parameter(joint.s), 0, 0};
    p.arc[1] = {joint_point, e1.point, half_angle_tangent(in_units(chord1), e1.tangent), parameter(joint.s), parameter(e1.s), 0, 0};
    measure(p.arc[0], e0, joint, curve_.piece(e0.s, joint.s - e0.s));
    Local_polynomial rest = curve_.piece(joint.s, e1.s - joint.s);
    if (joint_point != joint.point) rest = rest.seen_from(in_units(joint_point - joint.point));
    measure(p.arc[1], joint, e1, rest);
    return checked(p, e0, e1);
  }

  // The inner or outer boundary of the bilens, whichever is on the side asked for.
  [[nodiscard]] Piece bilens_side(const End& e0, const End& e1) const {
    const auto shape = spiral_.shape<double>(parameter(e0.s), parameter(e1.s), {true, false});
    const auto boundary = Bilens::boundary(Chord_frame_2<double>{e0.point, e1.point, shape});
    const bool is_inner = (shape.turn > 0) == (side_ == Chain_side::LEFT);
    const auto& chain = is_inner ? boundary.inner : boundary.outer;
    if (chain.size() < 2) return without_arc(e0, e1);
    const Xy<double> joint = chain[0].to;
    const auto s = foot_parameter(e0, e1, joint, chain[0].support);
    return s ? two_arcs(e0, end_at(*s), e1, joint) : without_arc(e0, e1);
  }

  // The curve's point whose foot is the biarc's joint, on the normal line there.
  [[nodiscard]] std::optional<double> foot_parameter(const End& e0, const End& e1, const Xy<double>& joint,
                                                     const Contact_circle_2<double>& circle) const {
    const Xy<double> along = perp(circle.curvature * (joint - circle.point) - circle.normal), target = in_units(joint - start_);
    double low = e0.s, high = e1.s, s = (low + high) / 2;
    constexpr int STEPS = 60;
    for (int i = 0; i < STEPS; ++i) {
      const double ahead = dot(along, curve_(s) - target);
      (ahead > 0 ? high : low) = s;
      double next = s - ahead / dot(along, curve_.derivative(s));
      if (!(next > low && next < high)) next = (low + high) / 2;
      if (std::fabs(next - s) <= 0x1p-50 * (e1.s - e0.s)) return next;
      s = next;
    }
    return s > e0.s && s < e1.s ? std::optional<double>(s) : std::nullopt;
  }

  const Bezier_spiral_2<double>& spiral_;
  Continuity continuity_;
  Chain_side side_;
  double eps_;
  double unit_, inverse_unit_;  // a power of two
  Local_polynomial curve_;
  Xy<double> start_, end_, tangent0_, tangent1_;
  double slack_ = 0;
  bool has_closed_form_ = false;
  std::vector<Piece> pieces_;
};

}  // namespace internal
}  // namespace CGAL::Bounding_arcs

#endif
