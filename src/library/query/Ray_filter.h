// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a ray meets curves, in doubles and pairs of them, certified; rays that touch curves or pass their ends are left
// to exact arithmetic (Ray_search.h, which has the polynomials A, S and W).
//
// Bernstein coefficients of A are halved until their signs vary at most once: then there is one root or none
// (Descartes).  Newton's steps in pairs of doubles end next to it, and A has two signs at an ulp of such pairs before
// and behind.  S / W there, and its slope times that width, bound the distance.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_RAY_FILTER_H
#define BOUNDING_ARCS_LIBRARY_QUERY_RAY_FILTER_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include "../tree/Segment_hierarchy.h"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

}  // namespace CGAL::Bounding_arcs::internal

#endif
