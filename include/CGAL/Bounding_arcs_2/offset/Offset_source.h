// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A drawing made ready for offsets: its curves as chains of arcs, which are what is offset, at any number of distances.
//
//   drawing -> arcs within 3/4 eps -> raw offsets with joins -> crossings -> parts -> loops
//
// Arcs have three quarters of the tolerance. Gaps that are closed without a join have 1/256 of it. An eighth is kept
// for distances that are moved a little, where parts of the offset touch in a way that rounding does not tell apart;
// see doc/offset.md.

#ifndef CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_SOURCE_H
#define CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_SOURCE_H

#include <CGAL/Bounding_arcs_2/chain/Chain_arc_2.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_job.h>
#include <CGAL/Bounding_arcs_2/offset/internal/Source_arcs.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A drawing made ready for offsets: its curves as chains of arcs, which are what is offset, at any number of
/// distances.
class Offset_source {
 public:
  /// \throws std::invalid_argument for an eps that is not positive and a miter limit below 1, as arc_chain, and for
  ///   curves out of the range of check_queried
  explicit Offset_source(const Drawing_2<double>& drawing, const Offset_job& job = {});

  /// Offset again what an offset is, or other closed chains of arcs: curve i is chain i, whose arcs are taken as they
  /// are, so that no error is added.
  /// \param chains which run round what they enclose as the fill rule has it; those that are not closed are curves
  Offset_source(const std::vector<Offset_chain>& chains, const Offset_job& job);

  /// Makes the offset as Offset_source_2::at does.
  [[nodiscard]] Offset at(double d) const;
  /// The offsets at several distances, in their order: a pocket's tool paths.
  [[nodiscard]] std::vector<Offset> at(const std::vector<double>& distances) const;

  /// Makes the outline as Offset_source_2::outline does.
  [[nodiscard]] Offset outline() const;

  /// Returns the numbers of closed curves that bound nothing: the fill rule fills both of their sides, or neither.
  /// Offsets inwards leave them out.
  [[nodiscard]] std::vector<std::uint32_t> left_out() const;

  [[nodiscard]] std::size_t number_of_arcs() const { return all_.arcs.size(); }

 private:
  struct Lazy_outline;

  void add_drawing(const Drawing_2<double>& drawing);
  void add_curves(const Drawing_2<double>& drawing, std::size_t first, std::size_t last);
  void add_curve(std::vector<Chain_arc_2> arcs, const std::vector<Bezier_spiral_2<double>>& spirals,
                 std::uint32_t curve, bool is_closed, const Xy<double>& start);
  void add_arcs(const std::vector<Chain_arc_2>& arcs, const std::vector<Bezier_spiral_2<double>>& spirals,
                std::uint32_t curve, bool is_closed, const Xy<double>& start, double eps);
  void part_closed_and_open();
  [[nodiscard]] const internal::Source_arcs& closed() const { return has_both_ ? closed_ : all_; }
  [[nodiscard]] const Lazy_outline& filled() const;
  [[nodiscard]] Offset unmoved(const internal::Source_arcs& sources, double error) const;
  [[nodiscard]] Offset in_unit_at(double d, double error) const;
  [[nodiscard]] Offset out(Offset offset) const;
  void finish_status(Offset& offset) const;

  [[nodiscard]] Offset_job checked(Offset_job job) const;

  Unit unit_;  // of all that follows
  Offset_job job_;
  internal::Source_arcs all_, closed_, open_;  // the last two only where there are both
  bool has_both_ = false, has_closed_ = false;
  std::shared_ptr<Lazy_outline> filled_;  // not needed for d > 0
  double chain_error_ = 0;
  bool is_resolved_ = true;
};

/// The offset of a drawing at one distance, see Offset_source::at.
[[nodiscard]] Offset offset_curves(const Drawing_2<double>& drawing, double d, const Offset_job& job = {});

}  // namespace CGAL::Bounding_arcs

#endif
