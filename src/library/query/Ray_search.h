// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a ray meets curves: boxes and fat arcs leave out what it misses, exact arithmetic finds what it meets.
//
// With the direction d, A = sum w cross(d, P - q) B vanishes where a Bezier piece meets the line, and there
// S / W = (sum w dot(d, P - q) B) / (sum w B) is |d| times the distance, negative behind q.  Roots of A are isolated,
// S / W is bounded by coefficients over what isolates them, and both are refined until questions are answered.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_RAY_SEARCH_H
#define BOUNDING_ARCS_LIBRARY_QUERY_RAY_SEARCH_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include "../polynomial/Real_root.h"
#include "../tree/Segment_hierarchy.h"
#include "exact_intersections.h"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

struct Filtered_hit {
  std::uint32_t segment;
  double t;
  Bracket distance;
};

/// Where a ray meets curves, in doubles and pairs of them, certified; rays that touch curves or pass their ends are
/// left to exact arithmetic.
///
/// Bernstein coefficients of A are halved until their signs vary at most once: then there is one root or none
/// (Descartes).  Newton's steps in pairs of doubles end next to it, and A has two signs at an ulp of such pairs before
/// and behind.  S / W there, and its slope times that width, bound the distance.
class Ray_filter {
  template <class NT> using Coefficients = boost::container::small_vector<NT, 4>;

 public:
  /// \param direction has a coordinate of about 1
  Ray_filter(const Segment_hierarchy& curves, const Xy<double>& q, const Xy<double>& direction)
      : curves_(curves), q_(q), dx_(direction.x), dy_(direction.y), length_(sqrt(dx_ * dx_ + dy_ * dy_)) {}

  /// \param segments one of each Bezier piece
  /// \return all hits in order, or nothing where that takes exact arithmetic
  [[nodiscard]] std::optional<std::vector<Filtered_hit>> hits(const std::vector<std::uint32_t>& segments) {
    for (const std::uint32_t s : segments)
      if (!look_at(s)) return std::nullopt;
    std::sort(hits_.begin(), hits_.end(),
              [](const Filtered_hit& a, const Filtered_hit& b) { return a.distance.lower < b.distance.lower; });
    for (std::size_t i = 1; i < hits_.size(); ++i)
      if (!(hits_[i - 1].distance.upper < hits_[i].distance.lower)) return std::nullopt;
    return std::move(hits_);
  }

 private:
  // A, S and W of a Bezier piece.
  struct Polynomials {
    Coefficients<Double_double> across, along, weight;
  };

  [[nodiscard]] bool look_at(std::uint32_t segment) {
    const std::uint32_t number = curves_.bezier_of(segment);
    if (curves_.rounding(number) != 0) return false;
    const Bezier_curve_2<double>& curve = curves_.bezier(number);
    Polynomials p;
    Coefficients<double> rough;
    double error = 0;
    for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
      const Xy<double>& c = curve.control_points()[i];
      const Double_double x = Double_double::two_sum(c.x, -q_.x), y = Double_double::two_sum(c.y, -q_.y),
                          w = curve.weight(static_cast<int>(i));
      p.across.push_back(w * (dx_ * y - dy_ * x));
      p.along.push_back(w * (dx_ * x + dy_ * y));
      p.weight.push_back(w);
      rough.push_back(p.across.back().hi);
      error = (std::max)(error, (std::fabs(p.across.back().lo) + p.across.back().err) * Double_double::INFLATION);
    }
    return isolate(p, rough, {0, 1}, error, segment, 0);
  }

  // The coefficients of A over a range of parameters, each within an error: those without a sign may have either.
  [[nodiscard]] bool isolate(const Polynomials& p, const Coefficients<double>& a, const Bracket& range, double error,
                             std::uint32_t segment, int depth) {
    const auto sign = [&](double x) { return x > error ? 1 : (x < -error ? -1 : 0); };
    int last = sign(a.front()), most = 0;
    if (last == 0 || sign(a.back()) == 0) return false;
    for (const double x : a) {
      if (sign(x) == last) continue;
      ++most;
      last = -last;
    }
    if (most == 0) return true;
    if (most == 1) return add(p, range, sign(a.front()), segment);
    constexpr int MOST_DEPTH = 40;
    if (depth == MOST_DEPTH) return false;
    Coefficients<double> left, right = a;
    double size = 0;
    for (const double x : a) size = (std::max)(size, std::fabs(x));
    for (std::size_t k = a.size(); k-- > 0;) {
      left.push_back(right.front());
      for (std::size_t i = 0; i < k; ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
    }
    // means round by u of the largest coefficient
    const double next_error = (error + static_cast<double>(a.size()) * HALF_ULP * size) * Double_double::INFLATION;
    const double middle = range.lower + (range.upper - range.lower) / 2;
    return isolate(p, left, {range.lower, middle}, next_error, segment, depth + 1) &&
           isolate(p, right, {middle, range.upper}, next_error, segment, depth + 1);
  }

  template <class NT> [[nodiscard]] static NT value(const Coefficients<Double_double>& c, const NT& t) {
    Coefficients<NT> b;
    const NT s = NT(1) - t;
    for (const Double_double& x : c)
      if constexpr (std::is_same_v<NT, double>) b.push_back(x.hi);
      else b.push_back(x);
    for (std::size_t k = b.size(); k-- > 1;)
      for (std::size_t i = 0; i < k; ++i) b[i] = s * b[i] + t * b[i + 1];
    return b.front();
  }
  // The largest difference of neighbours, times the degree: at least the slope in [0, 1].
  [[nodiscard]] static double steepest(const Coefficients<Double_double>& c) {
    double most = 0;
    for (std::size_t i = 1; i < c.size(); ++i) most = (std::max)(most, (c[i] - c[i - 1]).size());
    return most * static_cast<double>(c.size() - 1) * Double_double::INFLATION;
  }
  [[nodiscard]] static double slope(const Coefficients<Double_double>& c, double t) {
    Coefficients<Double_double> d;
    for (std::size_t i = 1; i < c.size(); ++i) d.push_back(static_cast<double>(c.size() - 1) * (c[i].hi - c[i - 1].hi));
    return value<double>(d, t);
  }

  // The one root in a range before which A has a sign.
  [[nodiscard]] bool add(const Polynomials& p, const Bracket& range, int sign_before, std::uint32_t segment) {
    double low = range.lower, high = range.upper, t = low + (high - low) / 2;
    constexpr int MOST_STEPS = 100, LAST_STEPS = 2;
    for (int step = 0; step < MOST_STEPS && low < t && t < high; ++step) {
      const double a = value<double>(p.across, t);
      ((a > 0 ? 1 : -1) == sign_before ? low : high) = t;
      const double next = t - a / slope(p.across, t);
      if (std::fabs(next - t) <= 0x1p-50 * t) break;
      // Newton, but every third step halves
      t = step % 3 != 2 && low < next && next < high ? next : low + (high - low) / 2;
    }
    const double rise = slope(p.across, t);
    Double_double root = t, a;
    for (int step = 0; step < LAST_STEPS; ++step) {
      a = value<Double_double>(p.across, root);
      root = Double_double::two_sum(root.hi, root.lo - a.hi / rise);
    }
    a = value<Double_double>(p.across, root);
    const double beside = 2 * a.size() / std::fabs(rise) + 0x1p-104;
    const Double_double before = root - Double_double(beside), behind = root + Double_double(beside);
    if (!(before.hi > range.lower && behind.hi < range.upper)) return false;
    if (value<Double_double>(p.across, before).sign() != sign_before ||
        value<Double_double>(p.across, behind).sign() != -sign_before)
      return false;
    return add_at(p, root, beside * Double_double::INFLATION, segment);
  }

  // At a root within `beside` of a parameter.
  [[nodiscard]] bool add_at(const Polynomials& p, const Double_double& root, double beside, std::uint32_t segment) {
    double largest = 0, least_weight = p.weight.front().hi;
    for (const Double_double& x : p.along) largest = (std::max)(largest, x.size());
    for (const Double_double& w : p.weight) least_weight = (std::min)(least_weight, w.hi);
    Double_double way = value<Double_double>(p.along, root) / value<Double_double>(p.weight, root);
    // |(S / W)'| <= |S'| / W + |S / W| |W'| / W
    way.err += 2 * beside * (steepest(p.along) + largest / least_weight * steepest(p.weight)) / least_weight;
    const Double_double distance = way / length_;
    if (!distance.sign()) return false;
    if (distance.hi < 0) return true;
    constexpr double SHARP = 0x1p-56;
    if (!(distance.err <= SHARP * distance.hi)) return false;
    hits_.push_back({segment, root.hi, {-(-distance).upper(), distance.upper()}});
    return true;
  }

  const Segment_hierarchy& curves_;
  Xy<double> q_;
  Double_double dx_, dy_, length_;
  std::vector<Filtered_hit> hits_;
};

/// The polynomials of one Bezier piece.
struct Ray_piece {
  Exact_polynomial along, weight;
  std::uint32_t segment;  ///< one of its segments
};
/// Bounds of an exact number.
struct Exact_bracket {
  Exact_rational low, high;
};
struct Exact_hit {
  std::shared_ptr<const Ray_piece> piece;
  Real_root t;        ///< of across, or of what tells one of the places on a piece along the ray
  Exact_bracket way;  ///< of S / W
  bool is_along = false;
};

class Ray_search {
 public:
  Ray_search(const Segment_hierarchy& curves, const Asked_point& q, const Asked_point& direction)
      : curves_(curves), q_(q.point), direction_(scaled(direction.point)), exact_q_(q.exactly()),
        exact_direction_(direction.exactly()) {
    const auto is_met = [this](const Box_tree::Node& node, std::size_t k) { return may_meet(node.box(k)); };
    for_each_item(curves_.boxes(), is_met, [this](const Box_tree::Node& node, std::size_t k) {
      if (may_meet(curves_.region(node.child[k]))) segments_.push_back(node.child[k]);
      return true;
    });
    const auto is_same = [this](std::uint32_t a, std::uint32_t b) {
      return curves_.bezier_of(a) == curves_.bezier_of(b);
    };
    std::sort(segments_.begin(), segments_.end());
    segments_.erase(std::unique(segments_.begin(), segments_.end(), is_same), segments_.end());
  }

  /// One of each Bezier piece that the ray may meet.
  [[nodiscard]] const std::vector<std::uint32_t>& segments() const { return segments_; }
  /// Hits in order.
  [[nodiscard]] std::vector<Exact_hit> search() {
    for (const std::uint32_t s : segments_) add_hits(s);
    std::stable_sort(hits_.begin(), hits_.end(), is_before);
    for (Exact_hit& hit : hits_) sharpen(hit);
    return std::move(hits_);
  }

  /// Scales a vector by a power of two to a size of about 1, for doubles; what gets lost of a small coordinate is
  /// nothing beside `room`.
  [[nodiscard]] static Xy<double> scaled(const Xy<double>& v) {
    const int exponent = std::ilogb((std::max)(std::fabs(v.x), std::fabs(v.y)));
    return {std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent)};
  }

 private:
  // Sums of two products, each factor a difference: 6 u of what they are at most, and 2 u for a start and a direction
  // that are rounded.
  [[nodiscard]] bool may_meet(const CGAL::Bbox_2& box) const {
    const Xy<double> center{box.xmin() / 2 + box.xmax() / 2, box.ymin() / 2 + box.ymax() / 2};
    const double wide = (box.xmax() - box.xmin()) / 2, high = (box.ymax() - box.ymin()) / 2;
    const Xy<double> way = center - q_;
    const double dx = std::fabs(direction_.x), dy = std::fabs(direction_.y);
    const double size = (std::max)({std::fabs(box.xmin()), std::fabs(box.xmax()), std::fabs(box.ymin()),
                                    std::fabs(box.ymax()), std::fabs(q_.x), std::fabs(q_.y)});
    const double room = 32 * HALF_ULP * (dx + dy) * size;
    return std::fabs(cross(direction_, way)) <= dx * high + dy * wide + room &&
           dot(direction_, way) + dx * wide + dy * high + room >= 0;
  }
  // The chord's ends on one side of the line by more than arc and radius are high.
  [[nodiscard]] bool may_meet(const Fat_arc_2& fat) const {
    const double a = cross(direction_, fat.arc.from - q_), b = cross(direction_, fat.arc.to - q_);
    const Xy<double> chord = fat.arc.to - fat.arc.from, way = fat.arc.from - q_;
    const double size = std::fabs(way.x) + std::fabs(way.y) + std::fabs(q_.x) + std::fabs(q_.y) + std::fabs(chord.x) +
                        std::fabs(chord.y);
    const double high = 0.5 * std::fabs(fat.arc.bulge) * euclidean_norm(chord) + fat.radius;
    const double room = euclidean_norm(direction_) * (high * ROUNDED_UP<8> + 32 * HALF_ULP * size);
    return (std::min)(a, b) <= room && (std::max)(a, b) >= -room;
  }

  void add_hits(std::uint32_t segment) {
    const Segment_hierarchy::Exact_bezier curve = curves_.exact_bezier(curves_.bezier_of(segment));
    Exact_polynomial::Coefficients across, along, weight;
    for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
      const Exact_point way = curve.control_points()[i] - exact_q_;
      weight.push_back(curve.weight(static_cast<int>(i)));
      across.push_back(Exact_rational(weight.back() * cross(exact_direction_, way)));
      along.push_back(Exact_rational(weight.back() * dot(exact_direction_, way)));
    }
    const Exact_polynomial a(across), s(along), w(weight);
    const auto piece = std::make_shared<const Ray_piece>(Ray_piece{s, w, segment});
    if (add_roots(a, piece, false)) return;
    // ends, where it turns back and, where that is on it, the ray's start
    add_roots(Exact_polynomial(Exact_polynomial::Coefficients{0, 1, 0}), piece, true);
    add_roots(s.derivative() * w - s * w.derivative(), piece, true);
    add_roots(s, piece, true);
  }

  // Returns whether the polynomial is not zero.
  bool add_roots(const Exact_polynomial& of, const std::shared_ptr<const Ray_piece>& piece, bool is_along) {
    const Univariate p = to_powers(of);
    if (p.is_zero()) return false;
    for (const Real_root& t : unit_roots(p)) {
      if (t.is_dyadic() && t.lower() == 1 && has_next(piece->segment)) continue;  // the next one has it at its start
      Exact_hit hit{piece, t, {}, is_along};
      refine_to(hit, 60);
      if (is_ahead(hit)) hits_.push_back(hit);
    }
    return true;
  }
  [[nodiscard]] bool has_next(std::uint32_t segment) const {
    const Segment_place place = curves_.place(segment);
    const auto& curve = curves_.drawing().curves()[place.curve];
    return curve.is_closed || place.bezier + 1 < curve.beziers.size();
  }

  // Bounds of a polynomial over the interval of a root: its coefficients there.
  [[nodiscard]] static Exact_bracket values_over(const Exact_polynomial& p, const Real_root& t) {
    const Exact_rational low = t.lower(), high = t.upper();
    if (t.is_dyadic()) return {p(low), p(low)};
    const Exact_polynomial part = p.restricted(low, Exact_rational(1 - low), high, Exact_rational(1 - high));
    Exact_bracket v{part.coefficient(0), part.coefficient(0)};
    for (int i = 1; i <= part.degree(); ++i) {
      const Exact_rational x = part.coefficient(i);
      v = {(std::min)(v.low, x), (std::max)(v.high, x)};
    }
    return v;
  }
  // t to 2^-bits.
  static void refine_to(Exact_hit& hit, int bits) {
    hit.t.refine_to(bits);
    const Exact_bracket s = values_over(hit.piece->along, hit.t), w = values_over(hit.piece->weight, hit.t);
    const Exact_rational quotients[] = {s.low / w.low, s.low / w.high, s.high / w.low, s.high / w.high};
    hit.way = {*std::min_element(quotients, quotients + 4), *std::max_element(quotients, quotients + 4)};
  }

  // Whether S >= 0.  Where it may be either, q is on the curve or more bits tell.
  [[nodiscard]] static bool is_ahead(Exact_hit& hit) {
    if (hit.way.low >= 0) return true;
    if (hit.way.high < 0) return false;
    const bool is_start = !hit.is_along && hit.t.is_root_of(to_powers(hit.piece->along));
    for (int bits = 120; !is_start && bits < MOST_BITS && hit.way.low < 0 && hit.way.high >= 0; bits *= 2)
      refine_to(hit, bits);
    if (is_start || (hit.way.low < 0 && hit.way.high >= 0)) hit.way = {0, 0};
    return hit.way.low >= 0;
  }

  // Only ties are left when so many bits of t are alike.
  static constexpr int MOST_BITS = 1000;
  [[nodiscard]] static bool is_before(const Exact_hit& first, const Exact_hit& second) {
    if (first.way.high < second.way.low) return true;
    if (second.way.high <= first.way.low) return false;
    Exact_hit a = first, b = second;
    for (int bits = 120; bits < MOST_BITS && !(is_settled(a) && is_settled(b)); bits *= 2) {
      for (Exact_hit* hit : {&a, &b})
        if (!is_settled(*hit)) refine_to(*hit, bits);
      if (a.way.high < b.way.low) return true;
      if (b.way.high <= a.way.low) return false;
    }
    return a.way.high < b.way.low;
  }
  [[nodiscard]] static bool is_settled(const Exact_hit& hit) { return hit.way.low == hit.way.high; }

  // The distance to about a double.
  static void sharpen(Exact_hit& hit) {
    const Exact_rational share(0x1p-54);
    for (int bits = 120; bits < MOST_BITS && hit.way.high - hit.way.low > share * hit.way.high; bits *= 2)
      refine_to(hit, bits);
  }

  const Segment_hierarchy& curves_;
  Xy<double> q_, direction_;  // the latter scaled
  Exact_point exact_q_, exact_direction_;
  std::vector<std::uint32_t> segments_;
  std::vector<Exact_hit> hits_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
