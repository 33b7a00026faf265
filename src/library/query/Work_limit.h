// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Limits of work.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_WORK_LIMIT_H
#define BOUNDING_ARCS_LIBRARY_QUERY_WORK_LIMIT_H

#include <CGAL/Bounding_arcs_2/query/Query_point.h>

#include <cstddef>

namespace CGAL::Bounding_arcs {

/// How much work a search may take. Halving goes on until a bracket is as narrow as doubles tell, which takes some
/// dozens of pieces. Where curves run at one distance for long, it takes the cube root of the resolution, 1e5 of them.
/// Where errors hide the direction of a curve, it would be as many as the error goes into its length. So each search
/// counts its pieces, and ends at a limit with what it knows by then.
class Work_limit {
 public:
  explicit Work_limit(std::size_t most) : left_(most) {}

  /// \return false where not so much is left
  [[nodiscard]] bool spend(std::size_t work = 1) {
    if (left_ < work) {
      left_ = 0;
      is_reached_ = true;
      return false;
    }
    left_ -= work;
    return true;
  }
  [[nodiscard]] bool is_reached() const { return is_reached_; }

 private:
  std::size_t left_;
  bool is_reached_ = false;
};

/// For one point: pieces that are halved.
[[nodiscard]] inline std::size_t work_of_point(std::size_t segments) { return (std::size_t(1) << 19) + 16 * segments; }
/// For two drawings: pairs of pieces, or of boxes, which take some Newton steps.
[[nodiscard]] inline std::size_t work_of_pairs(std::size_t segments) {
  return (std::size_t(1) << 19) + 2048 * segments;
}
/// For points of one drawing and another one: pieces that are halved, and each point counts for some.
[[nodiscard]] inline std::size_t work_of_points(std::size_t segments) {
  return (std::size_t(1) << 21) + 256 * segments;
}
/// For a sum or a hull: pieces that are kept, some 200 bytes each.
[[nodiscard]] inline std::size_t most_pieces(std::size_t segments) { return (std::size_t(1) << 18) + 16 * segments; }

/// The status of a bracket so wide that a tolerance was asked for.
[[nodiscard]] inline Query_status status_of(double width, double tolerance, bool is_limited) {
  if (width <= tolerance) return Query_status::COMPLETE;
  return is_limited ? Query_status::LIMIT_REACHED : Query_status::RESOLUTION_REACHED;
}

}  // namespace CGAL::Bounding_arcs

#endif
