// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the subcommands see of the library: curves cut into spirals and hierarchies over them, of any kernel and method,
// with all numbers as doubles.  The templates behind it are compiled once, in hierarchy_*.cpp.

#ifndef BOUNDING_ARCS_TOOL_HIERARCHY_H
#define BOUNDING_ARCS_TOOL_HIERARCHY_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/study/Search_study.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

using CGAL::Bounding_arcs::Arc_2;
using CGAL::Bounding_arcs::Bezier_curve_2;
using CGAL::Bounding_arcs::Curve_record;
using CGAL::Bounding_arcs::Input_error;
using CGAL::Bounding_arcs::read_curve_file;
using CGAL::Bounding_arcs::Xy;

/// The library's three methods, and those to compare them with, which have hierarchies over the double kernel only.
using Method = CGAL::Bounding_arcs::Region_kind;
[[nodiscard]] inline bool is_yardstick(Method method) { return method > Method::BILENS; }
enum class Kernel { DOUBLE, FILTERED, EXACT };
enum class Split { MIDPOINT, OPTIMAL };
enum class Status { COMPLETE, RESOLUTION_REACHED, REGION_LIMIT };

struct Output_circle {
  Xy<double> center;
  double radius;
};

/// The circle of an arc in doubles, where these do not miss its ends by more than 4 ulp of the coordinates.
[[nodiscard]] std::optional<Output_circle> circle_of(const Arc_2& arc);

/// One side of a region, as a rule one or two pieces.
using Output_chain = boost::container::small_vector<Arc_2, 2>;

/// One leaf: its place on the curve and its two boundaries, each from C(t0) to C(t1).
struct Output_region {
  std::size_t bezier;
  double t0, t1, thickness;
  bool starts_spiral;  ///< t0 is where a spiral segment starts
  Output_chain inner, outer;
  std::optional<double> widening = {};  ///< of certified regions: the exact curve is this near, infinite if unknown
};

/// Whether no point of the outer boundary as written is proven to be farther from the inner one than the thickness and,
/// for the rounding, 8 ulp of the coordinates and twice what ends may be off.
[[nodiscard]] bool has_written_thickness(const Output_region& region, double end_error);

/// A region that could not be proven to hold its piece of curve.
struct Unproven_region {
  std::size_t bezier;
  double t0, t1;
  std::string reason;
};

struct Verification {
  std::size_t regions = 0, proven = 0;
  std::size_t slivers = 0;   ///< of the proven ones, but for the rounding of a cut at an end
  double slack = 0;          ///< the largest distance from its region of points of a sliver
  double widening = 0;       ///< of certified regions that are proven, the largest
  double widening_ulps = 0;  ///< that in units in the last place of the curve's largest coordinate
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
  /// The regions of leaves and of all nodes above them, each node before those below it, in curve order. Levels count
  /// from 0, the region of a whole spiral segment.
  virtual void for_each_node(const std::function<void(std::size_t level, const Output_region&)>& visit) const = 0;
  /// Visits certified regions, each with a widening; where that of the method's region would be large it is a BCA, of
  /// parts of the leaf where that of all of it is thicker than eps.
  /// \throws std::invalid_argument where no such part is thin enough, or more parts are needed than regions are allowed
  /// \throws std::logic_error, as verify_certified does, for yardsticks, which have no certified regions
  virtual void for_each_certified_region(const std::function<void(const Output_region&)>& visit) const = 0;
  /// Makes the arcs of all leaf regions, and keeps them until they are made again.
  virtual void make_arcs() = 0;
  /// Proves the exact regions.
  [[nodiscard]] virtual Verification verify(const Progress& progress) const = 0;
  /// Proves certified regions: those in rounded numbers, as they are written, widened.
  [[nodiscard]] virtual Verification verify_certified(const Progress& progress) const = 0;
};

/// The exponent p of thickness = c size^p by least squares, over pieces of sizes between the two given.
struct Fitted_order {
  double order, smallest, largest;
};

/// A curve cut into spiral segments.
class Segmented_curve {
 public:
  virtual ~Segmented_curve() = default;
  [[nodiscard]] virtual std::size_t number_of_beziers() const = 0;
  [[nodiscard]] virtual std::size_t number_of_spirals() const = 0;
  /// \param max_regions the most nodes to make, see Build_options
  /// \throws std::invalid_argument for a yardstick over curves of another kernel than double
  [[nodiscard]] virtual std::unique_ptr<Curve_hierarchy> build(Method method, Split split, double eps,
                                                               std::size_t max_regions,
                                                               const Progress& progress) const = 0;
  /// Fits the order of a method at the middle of each spiral segment that is no line or arc, from exact pieces so short
  /// that no more than the first term of thickness counts.
  /// \throws std::invalid_argument over curves of another kernel than double
  [[nodiscard]] virtual std::vector<Fitted_order> orders(Method method) const = 0;
};

/// Cuts the curve for hierarchies over `kernel`: the double kernel bounds the Bezier curves with control points rounded
/// to double, the other two the curves that the file's numbers define exactly.
[[nodiscard]] std::unique_ptr<Segmented_curve> segment(const Curve_record& record, Kernel kernel);

[[nodiscard]] const char* name_of(Method method);
[[nodiscard]] const std::vector<Method>& all_methods();
[[nodiscard]] const char* name_of(Kernel kernel);

namespace detail {
[[nodiscard]] std::unique_ptr<Segmented_curve> segment_double(const Curve_record& record);
[[nodiscard]] std::unique_ptr<Segmented_curve> segment_filtered(const Curve_record& record);
[[nodiscard]] std::unique_ptr<Segmented_curve> segment_exact(const Curve_record& record);
}  // namespace detail

}  // namespace bounding_arcs_tool

#endif
