// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the subcommands see of the library: curves cut into spirals and hierarchies over them, of any kernel and method,
// with all numbers as doubles.  The templates behind it are compiled once, in hierarchy_*.cpp.

#ifndef BOUNDING_ARCS_TOOL_HIERARCHY_H
#define BOUNDING_ARCS_TOOL_HIERARCHY_H

#include "Curve_file.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

enum class Method { BCA, SFA, BILENS };
enum class Kernel { DOUBLE, FILTERED, EXACT };
enum class Split { MIDPOINT, OPTIMAL };
enum class Status { COMPLETE, RESOLUTION_REACHED, REGION_LIMIT };

/// One arc or segment of a boundary; a segment has radius 0.
struct Output_piece {
  Xy<double> from, to, center;
  double radius = 0;
  bool ccw = true;
};

/// An arc as written in doubles: the segment between its ends where that is no farther from it than its circle of rounded centre and
/// radius is, and where these are not finite.
[[nodiscard]] Output_piece as_written(const Output_piece& arc);

/// One leaf: its place on the curve and its two boundaries, each from C(t0) to C(t1).
struct Output_region {
  std::size_t bezier;
  double t0, t1, thickness;
  bool starts_spiral;  ///< t0 is where a spiral segment starts
  std::vector<Output_piece> inner, outer;
};

/// A region that could not be proven to hold its piece of curve.
struct Unproven_region {
  std::size_t bezier;
  double t0, t1;
  std::string reason;
};

struct Verification {
  std::size_t regions = 0, proven = 0;
  std::size_t slivers = 0;  ///< of the proven ones, with a curvature bound at an end cut past a vertex
  double widening = 0;      ///< of certified regions, the largest
  double widening_ulps = 0; ///< that in units in the last place of the curve's largest coordinate
  std::vector<Unproven_region> failed;
};

struct Hierarchy_size {
  std::size_t regions, arcs, nodes, boxes, bytes;
};

using Progress = std::function<void(std::size_t done, std::size_t all)>;

/// A hierarchy over one curve.
class Curve_hierarchy {
 public:
  virtual ~Curve_hierarchy() = default;
  [[nodiscard]] virtual Status status() const = 0;
  [[nodiscard]] virtual double bound() const = 0;  ///< the largest thickness of a leaf
  [[nodiscard]] virtual Hierarchy_size size() const = 0;
  virtual void for_each_region(const std::function<void(const Output_region&)>& visit) const = 0;
  /// Of the exact regions.
  [[nodiscard]] virtual Verification verify(const Progress& progress) const = 0;
  /// Of certified regions: those in rounded numbers, widened. \throws std::invalid_argument for the exact kernel
  [[nodiscard]] virtual Verification verify_certified(const Progress& progress) const = 0;
};

/// A curve cut into spiral segments.
class Segmented_curve {
 public:
  virtual ~Segmented_curve() = default;
  [[nodiscard]] virtual std::size_t number_of_beziers() const = 0;
  [[nodiscard]] virtual std::size_t number_of_spirals() const = 0;
  /// \param max_regions the most nodes to make, see Build_options
  [[nodiscard]] virtual std::unique_ptr<Curve_hierarchy> build(Method method, Split split, double eps, std::size_t max_regions,
                                                               const Progress& progress) const = 0;
};

/// Cuts the curve for hierarchies over `kernel`: the double kernel bounds the Bezier curves with control points rounded
/// to double, the other two the curves that the file's numbers define exactly.
[[nodiscard]] std::unique_ptr<Segmented_curve> segment(const Curve_record& record, Kernel kernel);

[[nodiscard]] const char* name_of(Method method);
[[nodiscard]] const char* name_of(Kernel kernel);

namespace detail {
[[nodiscard]] std::unique_ptr<Segmented_curve> segment_double(const Curve_record& record);
[[nodiscard]] std::unique_ptr<Segmented_curve> segment_filtered(const Curve_record& record);
[[nodiscard]] std::unique_ptr<Segmented_curve> segment_exact(const Curve_record& record);
}  // namespace detail

}  // namespace bounding_arcs_tool

#endif
