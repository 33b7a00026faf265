// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Regions in hand of a segment's pieces: of all leaves (Region_columns.h), or of single nodes (Region_reader.h). They
// are made in batches where there are formulas and a local curve, and what these leave open one by one, in
// src/library/tree.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_SEGMENT_REGIONS_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_SEGMENT_REGIONS_H

#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/number/number_types.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>
#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Piece_filter.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs {

struct Region_columns;

namespace internal {

/// How far the exact curve may be from regions that are made one by one. Each coordinate of both ends errs by
/// `point_error` and half an ulp. Bulges and joints move arcs by less than that, and so do cuts that are rounded
/// (src/library/tree/batch/Arc_points.h has the terms). Coordinates of spirals are largest at their ends.
template <class Spiral> [[nodiscard]] double widening_of_single_regions(const Spiral& spiral) {
  constexpr double OF_ENDS = 2, OF_BULGES = 1, OF_CUTS = 1;
  double size = 0;
  for (const double t : {spiral.first(), spiral.last()}) {
    const Xy<double> p = spiral.template point<double>(t);
    size = (std::max)({size, std::fabs(p.x), std::fabs(p.y)});
  }
  return (OF_ENDS + OF_BULGES + OF_CUTS) * (spiral.point_error() + ulp_of(size) / 2) + spiral.cut_error();
}

/// What regions in hand are made from: segments, and how the region of one piece is made by itself. It refers to a
/// tree's construction and segments.
struct Region_source {
  struct Ends {
    double first, last;
  };

  filter::Method method = filter::Method::NONE;
  Build_options::Instruction_set set;
  bool has_joints;
  const std::vector<Bezier_spiral_2<double>>* served = nullptr;  ///< the segments, where batches serve them
  std::size_t size;
  std::function<Ends(std::size_t segment)> ends;
  std::function<double(std::size_t segment)> widening;  ///< of regions that are made one by one
  std::function<Xy<double>(std::size_t segment, double t)> point;
  std::function<Arc_region_2(std::size_t segment, double t0, double t1, const Xy<double>& from, const Xy<double>& to)>
      region;

  template <class Construction, class Spiral>
  Region_source(const Construction& construction, const std::vector<Spiral>& spirals,
                Build_options::Instruction_set registers)
      : set(registers), has_joints(!std::is_same_v<Construction, Bca>), size(spirals.size()),
        ends([&spirals](std::size_t i) {
          return Ends{spirals[i].first(), spirals[i].last()};
        }),
        widening([&spirals](std::size_t i) { return widening_of_single_regions(spirals[i]); }),
        point([&spirals](std::size_t i, double t) { return spirals[i].template point<double>(t); }),
        region([&](std::size_t i, double t0, double t1, const Xy<double>& from, const Xy<double>& to) {
          return arc_region(construction, spirals[i], t0, t1, from, to);
        }) {
    if constexpr (std::is_same_v<Spiral, Bezier_spiral_2<double>>) {
      method = filter::METHOD<Construction>;
      if (method != filter::Method::NONE && set != Build_options::Instruction_set::NONE) served = &spirals;
    }
  }
};

/// Makes the regions of some pieces of one segment after the other.
class Segment_regions {
 public:
  static constexpr std::size_t PADDING = 8;  ///< rows that are worked in behind those that are wanted

  explicit Segment_regions(const Region_source& source);
  Segment_regions(const Segment_regions& other);
  Segment_regions(Segment_regions&&) noexcept;
  Segment_regions& operator=(Segment_regions other) noexcept;
  ~Segment_regions();

  /// Room for so many rows, of which the last PADDING are only worked in.
  void resize(Region_columns& to, std::size_t size) const;
  /// \param is_whole it is asked for the whole segment as one piece alone
  void open(std::size_t segment, bool is_whole = false);
  /// Sets rows row, ..., row + count - 1 and the points behind them, from the parameters that they have.
  /// \return how far the exact curve may be from these regions \pre a segment was opened
  double make(Region_columns& to, std::size_t row, std::size_t count) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Makes all rows, of which the first one of each segment is known.
/// \param write_ends writes the parameters in which the leaves of a segment end
void make_rows(const Region_source& source, const std::function<void(std::size_t segment, double* ends)>& write_ends,
               Region_columns& to);

}  // namespace internal
}  // namespace CGAL::Bounding_arcs

#endif
