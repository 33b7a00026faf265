// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How thick a shape is at a point: the diameter of the largest disc in it that covers the point (Hildebrand, Ruegsegger
// 1997), which is one of the axis.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_LOCAL_THICKNESS_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_LOCAL_THICKNESS_H

#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Local thickness for many points: the diameter of the largest disc of an axis that covers a point.
/// \code
/// const Local_thickness_2 thickness(medial_axis(closed, 1e-4));
/// std::cout << thickness({0.1, 0}) << '\n';
/// \endcode
class Local_thickness_2 {
 public:
  /// \complexity n log n in the samples
  explicit Local_thickness_2(const Medial_axis_2& axis);

  /// \return 0 where no disc covers the point
  /// \guarantee the diameter of the largest covering disc of those that lie linearly between two samples. It is within
  ///   2 axis.eps of the axis's own, but where a point is as near as axis.eps to the rim of a disc. There discs that
  ///   grow by axis.eps may cover it or not
  /// \complexity about logarithmic in the samples where few discs cover the point
  [[nodiscard]] double operator()(const Xy<double>& q) const;

 private:
  struct Disc {
    Xy<double> center;
    double radius;
    [[nodiscard]] bool covers(const Xy<double>& q) const { return euclidean_norm(q - center) <= radius; }
  };
  struct Step {
    Disc from, to;
  };
  struct Node {
    double x_low, x_high, y_low, y_high, most;  // of all discs; the largest radius
  };

  void make(std::size_t node, std::size_t begin, std::size_t end);
  [[nodiscard]] static double radius(const Step& step, const Xy<double>& q);
  void look_at(std::size_t node, std::size_t begin, std::size_t end, const Xy<double>& q, double& best) const;

  internal::Unit unit_;  // of all that follows
  std::vector<Step> steps_;
  std::vector<Node> nodes_;  // the root is 1, the halves of i are 2 i and 2 i + 1
};

}  // namespace CGAL::Bounding_arcs

#endif
