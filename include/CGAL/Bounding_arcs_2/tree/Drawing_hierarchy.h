// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawings as compiled searches take them.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_DRAWING_HIERARCHY_H
#define CGAL_BOUNDING_ARCS_2_TREE_DRAWING_HIERARCHY_H

#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/curve/converted_drawing.h>
#include <CGAL/Bounding_arcs_2/curve/queried_range.h>
#include <CGAL/Bounding_arcs_2/curve/served_range.h>
#include <CGAL/Bounding_arcs_2/tree/Segment_hierarchy.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// \param largest of a coordinate
/// \throws std::invalid_argument for curves out of the ranges of check_served and check_queried
inline void check_curves(const Drawing_2<double>& drawing, double largest) {
  for (const auto& curve : drawing.curves())
    for (const Bezier_curve_2<double>& piece : curve.beziers) {
      check_served(piece);
      check_queried(piece, largest);
    }
}

/// A drawing with its hierarchy of segments in the drawing's unit (Unit.h). It is what the compiled searches of all
/// queries take. They go in and out by the unit; what is between sees numbers near 1 only.
class Drawing_hierarchy {
 public:
  /// \throws std::invalid_argument for curves out of the ranges of check_served and check_queried
  explicit Drawing_hierarchy(std::shared_ptr<const Drawing_2<double>> drawing, Decisions decisions = Decisions::EXACT);
  explicit Drawing_hierarchy(Drawing_2<double> drawing, Decisions decisions = Decisions::EXACT)
      : Drawing_hierarchy(std::make_shared<const Drawing_2<double>>(std::move(drawing)), decisions) {}
  /// Takes curves over numbers that need not be doubles.
  explicit Drawing_hierarchy(const Drawing_2<Exact_rational>& drawing, Decisions decisions = Decisions::EXACT);

  /// The curves, rounded to doubles where they had other numbers.
  [[nodiscard]] const Drawing_2<double>& drawing() const { return given_ ? *given_ : segments_->drawing(); }
  [[nodiscard]] bool empty() const { return segments_->empty(); }
  /// How far the exact curves are from the rounded ones; 0 of doubles.
  [[nodiscard]] double rounding() const;
  /// A box of all curves.
  [[nodiscard]] CGAL::Bbox_2 box() const;

  /// 1 for a drawing whose largest coordinate is between 2^-40 and 2^41.
  [[nodiscard]] const Unit& unit() const { return unit_; }
  /// The segments in that unit.
  [[nodiscard]] const Segment_hierarchy& in_unit() const { return *segments_; }
  /// Leaves the curves alone. \pre no copy of this one is asked for segments any more
  void drop_segments() { segments_->drop_segments(); }
  /// The segments in another unit. \complexity as that of the constructor, but for the same unit
  [[nodiscard]] std::shared_ptr<const Segment_hierarchy> in_unit(const Unit& unit) const;

 private:
  [[nodiscard]] std::shared_ptr<Segment_hierarchy> made_in(const Unit& unit, const Drawing_2<Exact_rational>* exact,
                                                           Decisions decisions) const;

  Unit unit_;
  std::shared_ptr<const Drawing_2<double>> given_;  // where the drawing is scaled
  std::shared_ptr<Segment_hierarchy> segments_;
};

/// Two drawings in the unit of the larger one.
class Common_unit {
 public:
  Common_unit(const Drawing_hierarchy& a, const Drawing_hierarchy& b)
      : unit_((std::max)(a.unit(), b.unit())), a_(a.in_unit(unit_)), b_(b.in_unit(unit_)) {}

  [[nodiscard]] const Unit& unit() const { return unit_; }
  [[nodiscard]] const Segment_hierarchy& a() const { return *a_; }
  [[nodiscard]] const Segment_hierarchy& b() const { return *b_; }

 private:
  Unit unit_;
  std::shared_ptr<const Segment_hierarchy> a_, b_;
};

}  // namespace CGAL::Bounding_arcs

#endif
