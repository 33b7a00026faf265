// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offsets of drawings by Clipper, which knows polygons only: for comparison, and slow.
//
//   curves -> polylines -> bands of short stretches, with round ends -> their union, two and two -> with what is
//   filled, or taken from it
//
// The band of a polyline is the union of those of its stretches, which Clipper makes without the trouble that it has
// with long ones, whose raw offsets cross themselves as the square of their length.

#ifndef BOUNDING_ARCS_TEST_BENCHMARK_POLYGON_OFFSET_H
#define BOUNDING_ARCS_TEST_BENCHMARK_POLYGON_OFFSET_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>

#include <polyclipping/clipper.hpp>

#include <cstddef>
#include <vector>

namespace bounding_arcs_benchmark {

namespace ba = CGAL::Bounding_arcs;

/// What closed curves make, and what open ones do where both do not see each other.
struct Polygon_regions {
  ClipperLib::Paths of_closed, of_open;
};

/// Coordinates as Clipper has them: integers, whose products fit in 64 bits.
struct Clipper_grid {
  ba::Xy<double> center;
  double unit;  ///< of a drawing 2 wide about 1.5e-9
  [[nodiscard]] ClipperLib::IntPoint operator()(const ba::Xy<double>& p) const;
};
/// \param room how far coordinates may be beyond the control points
[[nodiscard]] Clipper_grid clipper_grid(const ba::Drawing_2<double>& drawing, double room);

class Polygon_offset {
 public:
  /// \param error that of the polylines and of round joins, together less than 13/8 of it
  /// \param thin loops of what is filled that are narrower bound nothing
  Polygon_offset(const ba::Drawing_2<double>& drawing, const Clipper_grid& grid, ba::Fill_rule rule, double error,
                 double thin);

  /// The region of an offset as Offset_source_2::at has it, all round. Where d > 0, all is of closed curves.
  [[nodiscard]] Polygon_regions at(double d);
  /// How far points of its boundary may be from the true one's distance.
  [[nodiscard]] double error() const;

 private:
  [[nodiscard]] ClipperLib::Paths band(const ClipperLib::Paths& lines, double d);

  Clipper_grid grid_;
  ClipperLib::PolyFillType rule_;
  double error_;                               ///< of polylines
  ClipperLib::Paths closed_, open_, outline_;  ///< polylines; those of closed curves and outlines end where they begin
  std::size_t levels_ = 0;                     ///< of unions
};

/// In units of the grid.
[[nodiscard]] double length_of(const ClipperLib::Paths& loops);
[[nodiscard]] double area_of(const ClipperLib::Paths& loops);

}  // namespace bounding_arcs_benchmark

#endif
