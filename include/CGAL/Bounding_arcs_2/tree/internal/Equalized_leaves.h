// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The leaves of segments that are cut where all regions are about as thick as eps allows: breaks, one more a segment
// than it has leaves.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_EQUALIZED_LEAVES_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_EQUALIZED_LEAVES_H

#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include <CGAL/Bounding_arcs_2/tree/Region_node.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Break points b[0] < ... < b[n] and, for each piece [b[i], b[i+1]], its measure.
struct Measured_breaks {
  std::vector<double> breaks, measures;
  bool is_limit_far = false;  ///< it was given up as shares tell that many more pieces than the limit are needed
  /// Room to work in, kept so that one object can serve many intervals.
  std::vector<double> roots, inverse_roots, secants, slopes, other_breaks;
};

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
    return add(spiral.first(), spiral.last(), eps, limit,
               [&](const std::vector<double>& breaks, std::vector<double>& measures) {
                 decide.measure(spiral, eps, breaks, measures, counts);
               });
  }
  /// Appends the leaves of segments first, ..., last - 1 of another.
  void append(const Equalized_leaves& other, std::size_t first, std::size_t last);
  template <class ConcurrencyTag> void append_all(const std::vector<Equalized_leaves>& others) {
    for (const Equalized_leaves& other : others) append(other, 0, other.bounds_.size());
  }
  void complete() {}

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
  using Measure = std::function<void(const std::vector<double>& breaks, std::vector<double>& measures)>;
  [[nodiscard]] bool add(double first, double last, double eps, std::size_t limit, const Measure& measure);

  std::vector<double> breaks_, bounds_;
  std::vector<std::size_t> first_{0};  // of each segment, in breaks_, and the number of breaks
  Measured_breaks cut_;                // room to work in
};

}  // namespace internal
}  // namespace CGAL::Bounding_arcs

#endif
