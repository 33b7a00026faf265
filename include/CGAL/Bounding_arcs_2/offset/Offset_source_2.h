// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offsets of the curves of a tree, at one distance or at many.  Chains of arcs are what is offset.
//
//   segments -> arcs within 3/4 eps -> raw offsets with joins -> crossings -> parts -> loops
//
// Arcs have three quarters of the tolerance. Gaps that are closed without a join have 1/256 of it. An eighth is kept
// for distances that are moved a little, where parts of the offset touch in a way that rounding does not tell apart;
// see doc/offset.md.

#ifndef CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_SOURCE_2_H
#define CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_SOURCE_2_H

#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace internal {
class Offset_sources;  // src/library/offset/Offset_sources.h
}  // namespace internal

/// Curves made ready for offsets at any number of distances. Take it for a series, such as the insets of a pocket: the
/// curves become chains of arcs only once. For a single distance offset() is shorter.
/// \code
/// const Offset_source_2 source(closed, 1e-4);
/// const Offset outside = source.at(0.1);
/// const std::vector<Offset> paths = source.at(std::vector<double>{-0.1, -0.2, -0.3});
/// \endcode
/// Distances above 0 grow what closed curves enclose, distances below 0 shrink it. Open curves get a band on both
/// sides. Offset::Options has joins, caps, sides and the fill rule. Time grows with the third root of 1 / eps, so a
/// small eps is cheap. insets() of offset_series.h goes on until nothing is left, and offset_bracket() has two offsets
/// that certainly lie inside and outside of the true one.
class Offset_source_2 {
 public:
  /// \param eps how far a point's distance may be from |d|, in units of the coordinates, positive
  /// \throws std::invalid_argument for an eps that is not positive and a miter limit below 1, as arc_chain, and for
  ///   curves out of the range of queries
  Offset_source_2(const Bounding_arc_tree_2& tree, double eps, const Offset::Options& options = {});

  /// Offsets again what an offset is, or other closed chains of arcs: curve i is chain i, whose arcs are taken as they
  /// are, so that no error is added.
  /// \param chains which run round what they enclose as the fill rule has it; those that are not closed are curves
  Offset_source_2(const std::vector<Offset::Chain>& chains, double eps, const Offset::Options& options = {});

  /// Returns the offset at a signed distance. d > 0 is the boundary of what closed curves enclose with all points as
  /// near to any curve as d. d < 0 is the boundary of the points that are enclosed by at least |d|, all round. What of
  /// a closed curve runs inside of what others enclose, or the curve itself, does not count there. Open curves get the
  /// boundary of the points within |d|. With `side` closed curves do, too, and that side of it is returned. Where d <
  /// 0, or with a side, open and closed curves do not see each other. d = 0 gives the chains of the closed curves as
  /// they are; see outline().
  /// \throws std::invalid_argument for a distance that is no number, or above LARGEST_QUERIED or some 2^100 times the
  ///   coordinates, and for an offset with coordinates above LARGEST_QUERIED
  /// \guarantee certified: points of round pieces are within `error` of |d| from the curves that were offset, where d <
  ///   0 from outline(). The topology is that of such an offset, a heuristic at places where it changes within eps
  /// \complexity (n + c) log n for n arcs, which are eps^(-1/3) many, and c crossings of raw offsets
  [[nodiscard]] Offset at(double d) const;
  /// Returns the offsets at several distances, in their order: a pocket's tool paths.
  [[nodiscard]] std::vector<Offset> at(const std::vector<double>& distances) const;

  /// Returns the boundary of what closed curves enclose, as the fill rule has it: chains that do not cross,
  /// counter-clockwise round regions and clockwise round holes.  What is offset where d < 0.
  /// \return no chains where `status` is UNRESOLVED
  /// \guarantee the chains are within `error` of the curves. Gaps and strips between curves that are narrower than eps
  ///   / 8 may be closed where curves cross. No closed curve is lost that is small or thin beside eps, down to about
  ///   2^-40 of the largest coordinate
  [[nodiscard]] Offset outline() const;

  /// Returns the numbers of closed curves that bound nothing: the fill rule fills both of their sides, or neither.
  /// Offsets inwards leave them out.
  [[nodiscard]] std::vector<std::uint32_t> left_out() const;

  [[nodiscard]] std::size_t number_of_arcs() const;

 private:
  std::shared_ptr<const internal::Offset_sources> sources_;  // copies share it
};

/// Returns the offset of a tree's curves at one distance, see Offset_source_2::at.
/// \param eps how far a point's distance may be from |d|, in units of the coordinates, positive
[[nodiscard]] inline Offset offset(const Bounding_arc_tree_2& tree, double d, double eps,
                                   const Offset::Options& options = {}) {
  return Offset_source_2(tree, eps, options).at(d);
}

}  // namespace CGAL::Bounding_arcs

#endif
