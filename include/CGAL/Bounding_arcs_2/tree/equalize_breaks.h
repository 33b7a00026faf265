// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The leaves of segments that are cut where all regions are about as thick as eps allows: breaks, one more a segment
// than it has leaves.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_EQUALIZE_BREAKS_H
#define CGAL_BOUNDING_ARCS_2_TREE_EQUALIZE_BREAKS_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include <CGAL/Bounding_arcs_2/tree/Region_node.h>
#include <CGAL/Bounding_arcs_2/tree/Spiral_grid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

// The fewest pieces of an interval with a measure of each at most eps, for measures that fall with the cube of a
// piece's length (thickness of regions, distance from arcs): break points where the cumulative cube root of the measure
// takes equal steps.

namespace CGAL::Bounding_arcs {

/// Break points b[0] < ... < b[n] and, for each piece [b[i], b[i+1]], its measure.
struct Measured_breaks {
  std::vector<double> breaks, measures;
  bool is_limit_far = false;  ///< it was given up as shares tell that many more pieces than the limit are needed
  /// Room to work in, kept so that one object can serve many intervals.
  std::vector<double> roots, inverse_roots, secants, slopes, other_breaks;
};

/// The cube root of x, 0 <= x <= 2^700, within 1e-4 of itself, several times as fast as std::cbrt: a third of the
/// exponent and one step of Halley's method. For shares only; 0 gives a number near 0.
[[nodiscard]] inline double rough_cube_root(double x) {
  constexpr std::uint64_t BIAS = 0x2a9f7893782da1ceULL;  // two thirds of the bits of 1, less what evens the error out
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits = bits / 3 + BIAS;
  double r;
  std::memcpy(&r, &bits, sizeof r);
  const double cube = r * r * r;
  return r * (cube + 2 * x) / (2 * cube + x);
}

/// Moves the breaks to `count` pieces of equal share of the sum of `roots`, the cube roots of the measures of pieces.
/// Parameters are a monotone cubic function of the cumulative sum (Fritsch and Butland 1984).
inline void redistribute(Measured_breaks& result, std::size_t count) {
  const std::vector<double>&breaks = result.breaks, &roots = result.roots;
  const std::size_t n = roots.size();
  std::vector<double>&inverses = result.inverse_roots, &secants = result.secants, &slopes = result.slopes;
  inverses.resize(n);
  secants.resize(n);  // of the parameter over the sum
  slopes.resize(n + 1);
  for (std::size_t i = 0; i < n; ++i) inverses[i] = 1 / roots[i];
  for (std::size_t i = 0; i < n; ++i) secants[i] = (breaks[i + 1] - breaks[i]) * inverses[i];
  for (std::size_t i = 1; i < n; ++i) {  // the mean of both secants, weighed, of their inverses
    const double w0 = 2 * roots[i] + roots[i - 1], w1 = roots[i] + 2 * roots[i - 1], before = secants[i - 1],
                 after = secants[i];
    slopes[i] = before > 0 && after > 0 ? (w0 + w1) * before * after / (w0 * after + w1 * before) : 0;
  }
  const auto end_slope = [&](std::size_t outer, std::size_t inner) {
    const double all = roots[outer] + roots[inner];
    const double s = ((all + roots[outer]) * secants[outer] - roots[outer] * secants[inner]) / all;
    return std::clamp(s, 0.0, 3 * secants[outer]);
  };
  slopes.front() = n == 1 ? secants[0] : end_slope(0, 1);
  slopes.back() = n == 1 ? secants[0] : end_slope(n - 1, n - 2);
  double sum = 0;
  for (const double r : roots) sum += r;
  std::vector<double>& moved = result.other_breaks;
  moved.resize(count + 1);
  moved.front() = breaks.front();
  moved.back() = breaks.back();
  const double share = sum / static_cast<double>(count);
  double before = 0;  // the sum up to break i
  std::size_t i = 0;
  for (std::size_t j = 1; j < count; ++j) {
    const double target = share * static_cast<double>(j);
    while (i + 1 < n && before + roots[i] < target) {
      before += roots[i];
      ++i;
    }
    const double x = std::clamp((target - before) * inverses[i], 0.0, 1.0), y = 1 - x;
    moved[j] = breaks[i] * y * y * (1 + 2 * x) + breaks[i + 1] * x * x * (1 + 2 * y) +
               roots[i] * x * y * (slopes[i] * y - slopes[i + 1] * x);
  }
  result.breaks.swap(moved);
}

/// Places breaks in [result.breaks.front(), result.breaks.back()] so that no measure exceeds eps.
/// \param result on entry its breaks are a first guess, at least the two ends
/// \param evaluate void(const std::vector<double>& breaks, std::vector<double>& measures): sets measures, one a piece,
///   none negative; infinity where a piece is too long to be measured. The last call is for the breaks returned
/// \param limit the most pieces
/// \return whether every measure is at most eps: otherwise the limit or the spacing of doubles stands against it
/// \guarantee the measures are those of `evaluate`; that no fewer pieces would do is a heuristic: the count is within
///   one of the sum of (measure / eps)^(1/3) for near-equal measures, but for ROOM
/// \complexity two to three evaluations a piece of the result
template <class Evaluate>
bool equalize_breaks(Measured_breaks& result, double eps, std::size_t limit, const Evaluate& evaluate) {
  constexpr double ROOM = 1.004;    // share kept free for what measures differ after one correction; saves a correction
  constexpr double UNMEASURED = 4;  // pieces taken for one that could not be measured
  constexpr double MOST = 0x1p700;  // of eps: beyond, measures tell no shares, and powers of them are no doubles
  constexpr int ROUNDS = 8, TRIES = 3;  // in all, and for one count
  constexpr std::size_t GROWTH = 8;     // from one round to the next: more would place breaks from too few samples
  constexpr std::size_t MANY = 4096;    // pieces whose shares tell how many are needed to far less than FAR
  constexpr double FAR = 2;             // of the limit
  std::vector<double>&breaks = result.breaks, &measures = result.measures, &roots = result.roots;
  std::vector<double> best;
  std::size_t failed = 0;
  int tries = 0;
  result.is_limit_far = false;
  for (int round = 0;; ++round) {
    const std::size_t n = breaks.size() - 1;
    measures.resize(n);
    evaluate(breaks, measures);
    const bool within = *std::max_element(measures.begin(), measures.end()) <= eps;
    if (within && (n == 1 || n == failed + 1)) return true;
    if (n > limit) return within;
    roots.resize(n);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      roots[i] = std::isfinite(measures[i]) ? rough_cube_root((std::min)(measures[i] / eps, MOST)) : UNMEASURED;
      sum += roots[i];
    }
    if (!within && n >= MANY && sum > FAR * static_cast<double>(limit)) {
      result.is_limit_far = true;
      return false;
    }
    std::size_t count =
        static_cast<std::size_t>(std::clamp(std::ceil(sum * ROOM), 1.0, static_cast<double>(limit) + 1));
    if (within) {
      if (count >= n || round >= ROUNDS) return true;
      best = breaks;
    } else {
      tries = n == count ? tries + 1 : 0;
      if (tries >= TRIES) {
        failed = (std::max)(failed, n);
        tries = 0;
      }
      count = (std::max)(count, failed + 1);
    }
    if (round >= ROUNDS) break;
    if (!best.empty() && count >= best.size() - 1) break;
    const double least = 1e-3 * sum / static_cast<double>(n);  // keeps secants finite where the measure vanishes
    for (double& r : roots) r = (std::max)(r, least);
    redistribute(result, (std::min)(count, GROWTH * n));
  }
  if (!best.empty()) {
    breaks = best;
    measures.resize(breaks.size() - 1);
    evaluate(breaks, measures);
    return true;
  }
  // Where cube roots are no guide, halving is.
  for (;;) {
    std::vector<double> halved;
    bool is_stuck = false, within = true;
    for (std::size_t i = 0; i < measures.size(); ++i) {
      halved.push_back(breaks[i]);
      if (measures[i] <= eps) continue;
      within = false;
      const double middle = breaks[i] + (breaks[i + 1] - breaks[i]) / 2;
      if (breaks[i] < middle && middle < breaks[i + 1]) halved.push_back(middle);
      else is_stuck = true;
    }
    if (within || is_stuck || halved.size() > limit) return within;
    halved.push_back(breaks.back());
    breaks.swap(halved);
    measures.resize(breaks.size() - 1);
    evaluate(breaks, measures);
  }
}

namespace internal {

/// The leaves of equalised segments, by the parameters in which they end.
class Equalized_leaves {
 public:
  [[nodiscard]] std::size_t number_of_leaves() const { return breaks_.size() - bounds_.size(); }
  [[nodiscard]] std::size_t number_of_nodes() const { return 2 * number_of_leaves() - bounds_.size(); }
  /// An upper bound of the thickness of the leaves of each segment.
  [[nodiscard]] const std::vector<double>& bounds() const { return bounds_; }
  [[nodiscard]] std::size_t bytes() const {
    return (breaks_.capacity() + bounds_.capacity()) * sizeof(double) + first_.capacity() * sizeof(std::size_t);
  }

  /// Segments are equalised one by one.
  template <class Decider, class Spiral> void look_ahead(Decider&, const Spiral*, std::size_t, double) const {}
  /// Appends a segment's leaves. \return false if there would be more than `limit` nodes
  template <class Decider, class Spiral>
  [[nodiscard]] bool add(Decider& decide, const Spiral& spiral, double eps, std::size_t limit,
                         Decision_counts& counts) {
    guess(spiral);
    equalize_breaks(cut_, eps, limit, [&](const std::vector<double>& breaks, std::vector<double>& measures) {
      decide.measure(spiral, eps, breaks, measures, counts);
    });
    if (cut_.is_limit_far) return false;
    bounds_.push_back(*std::max_element(cut_.measures.begin(), cut_.measures.end()));
    breaks_.insert(breaks_.end(), cut_.breaks.begin(), cut_.breaks.end());
    first_.push_back(breaks_.size());
    return number_of_nodes() <= limit;
  }
  /// Appends the leaves of segments first, ..., last - 1 of another.
  void append(const Equalized_leaves& other, std::size_t first, std::size_t last) {
    const std::size_t begin = breaks_.size() - other.first_[first];  // modulo 2^64, as it may be negative
    const auto at = [](const std::vector<double>& v, std::size_t i) {
      return v.begin() + static_cast<std::ptrdiff_t>(i);
    };
    breaks_.insert(breaks_.end(), at(other.breaks_, other.first_[first]), at(other.breaks_, other.first_[last]));
    bounds_.insert(bounds_.end(), at(other.bounds_, first), at(other.bounds_, last));
    for (std::size_t i = first; i < last; ++i) first_.push_back(other.first_[i + 1] + begin);
  }
  template <class ConcurrencyTag> void append_all(const std::vector<Equalized_leaves>& others) {
    for (const Equalized_leaves& other : others) append(other, 0, other.bounds_.size());
  }
  template <class ConcurrencyTag> void complete() {}

  [[nodiscard]] Node_handle root(std::uint32_t spiral) const {
    return handle(0, spiral, first_[spiral], first_[spiral + 1] - first_[spiral] - 1);
  }
  template <class Visit> void for_each_half(const Node_handle& h, const Visit& visit) const {
    const auto leaves = static_cast<std::size_t>(h.place), left = (leaves + 1) / 2;
    visit(handle(h.level + 1, h.spiral, h.index, left));
    visit(handle(h.level + 1, h.spiral, h.index + left, leaves - left));
  }
  [[nodiscard]] std::size_t number_of_leaves(std::size_t spiral) const {
    return first_[spiral + 1] - first_[spiral] - 1;
  }
  /// Writes the parameters in which the leaves of a segment end.
  void write_ends(std::size_t spiral, double* ends) const {
    std::copy(&breaks_[first_[spiral] + 1], &breaks_[first_[spiral]] + number_of_leaves(spiral) + 1, ends);
  }
  [[nodiscard]] double begin(const Node_handle& h) const { return breaks_[h.index]; }
  [[nodiscard]] double end(const Node_handle& h) const { return breaks_[h.index + static_cast<std::size_t>(h.place)]; }

 private:
  [[nodiscard]] static Node_handle handle(int level, std::uint32_t spiral, std::size_t first, std::size_t leaves) {
    return {true, leaves == 1, level, spiral, first, leaves};
  }
  template <class Spiral> void guess(const Spiral& spiral) {
    constexpr int LEVEL = 3;  // of the equal pieces that a segment is first cut into
    const Spiral_grid grid(spiral.first(), spiral.last());
    const int level = grid.levels() > LEVEL ? LEVEL : 0;
    cut_.breaks.clear();
    for (std::uint64_t i = 0; i <= std::uint64_t(1) << level; ++i) cut_.breaks.push_back(grid.parameter(level, i));
  }

  std::vector<double> breaks_, bounds_;
  std::vector<std::size_t> first_{0};  // of each segment, in breaks_, and the number of breaks
  Measured_breaks cut_;                // room to work in
};

}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
