// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which region should a hierarchy have?  How fast regions of a kind become thin, and what searches cost over them: for
// closest points, common points, the least distance and the Hausdorff distance, each the same code over all eight
// kinds.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_SEARCH_STUDY_H
#define CGAL_BOUNDING_ARCS_2_STUDY_SEARCH_STUDY_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>
#include <CGAL/Bounding_arcs_2/region/Fat_arc_2.h>
#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The library's three, and those to compare them with.
enum class Region_kind { BCA, SFA, BILENS, FAT_ARC, FAT_BIARC, BOX, ORIENTED_BOX, HULL };

/// A piece's size, the distance of its ends, and the thickness of its region.
struct Piece_size {
  double size, thickness;
};

/// The pieces of parameters t to t + width, halved `count` times less one, the longest first: thickness in 128 bits of
/// the exact piece, so that no rounding shows however short pieces are.
/// \tparam Spiral Bezier_spiral_2, of which t + width has to be a parameter
template <class Construction, class Spiral>
[[nodiscard]] std::vector<Piece_size> piece_sizes(const Construction& construction, const Spiral& spiral, double t,
                                                  double width, int count) {
  using Exact = typename Spiral::Exact_number_type;
  constexpr mpfr_prec_t BITS = 128;
  std::vector<Piece_size> sizes;
  for (; count > 0; --count, width /= 2) {
    const auto shape = spiral.template shape<Exact>(t, t + width, shape_parts<Construction>());
    const double unit = CGAL::to_double(shape.unit), x = CGAL::to_double(shape.chord.x),
                 y = CGAL::to_double(shape.chord.y);
    if (const auto thickness = thickness_enclosure(construction, shape, BITS))
      sizes.push_back({unit * stable_norm(Xy<double>{x, y}), thickness->middle()});
  }
  return sizes;
}

/// The slope of the line of least squares through the logarithms. \pre two sizes at least, thicknesses above 0
[[nodiscard]] inline double convergence_order(const std::vector<Piece_size>& sizes) {
  CGAL_precondition(sizes.size() >= 2);
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const Piece_size& s : sizes) {
    const double u = std::log(s.size), v = std::log(s.thickness);
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  const double n = static_cast<double>(sizes.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

/// What is asked: closest points of `curves` to all points; common points and Hausdorff distance of `curves` and
/// `crossing`; the least distance of `curves` and `apart`.
struct Search_tasks {
  Drawing_2<double> curves, crossing, apart;
  std::vector<Xy<double>> points;
  double eps = 1e-6;  ///< of both distances, and of closest points by regions alone, in units of the coordinates
};

/// The cost of one kind of task, all together.
struct Search_cost {
  double seconds = 0;       ///< the shortest of the repetitions
  std::size_t regions = 0;  ///< regions that were asked for, kept or made
};

/// What came out with one kind of region. Lengths are in units of the coordinates.
struct Search_report {
  Search_cost closest, intersections, distance, hausdorff;
  Search_cost descent;             ///< closest points by regions alone, to eps
  Search_cost regions;             ///< making those of all segments of `curves`
  std::size_t bytes = 0;           ///< that they take
  std::vector<Bracket> distances;  ///< of the points in their order, twice; the least, the Hausdorff distance
  Intersections_2<> common;        ///< of `curves` and `crossing`
};

/// \param repeat how often times are taken
/// \throws std::invalid_argument for curves out of the ranges of served_range.h, and where a drawing is
///   empty
/// \guarantee brackets are certified for BCA; those of the other kinds are as far as their room for rounding is
///   (regions_in_hand.h)
[[nodiscard]] Search_report search_report(Region_kind kind, const Search_tasks& tasks, std::size_t repeat = 1);

/// The curve turned by a quarter about the middle of its box and moved by a share of it, which crosses it as a rule;
/// the same curve moved to the right of it by its size; points on a lattice over twice the box.
/// \param points in a row of the lattice
[[nodiscard]] Search_tasks search_tasks(const Drawing_2<double>& curves, std::size_t points, double eps);

/// Whether two kinds came to the same: brackets that have a common number, and as many common points and overlaps, at
/// parameters that agree.
[[nodiscard]] bool have_same_answers(const Search_report& a, const Search_report& b);

}  // namespace CGAL::Bounding_arcs

#endif
