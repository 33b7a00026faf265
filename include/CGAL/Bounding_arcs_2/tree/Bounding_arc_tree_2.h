// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hierarchy that all algorithms descend: a drawing and its spiral segments, in the unit that suits its coordinates.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_BOUNDING_ARC_TREE_2_H
#define CGAL_BOUNDING_ARCS_2_TREE_BOUNDING_ARC_TREE_2_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/curve/Unit.h>

#include <CGAL/Bbox_2.h>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// How searches answer what doubles leave open.
enum class Decisions {
  EXACT,  ///< by exact arithmetic: every verdict is right
  DOUBLE  ///< not at all: a verdict may be `undecided`, within its bracket
};

class Segment_hierarchy;  // src/library/tree/Segment_hierarchy.h

/// The tree that all algorithms descend: the spiral segments of a drawing's curves, cut once, under boxes. What is
/// below a segment, pieces in bounding circular arcs, is made as a search goes there.
/// \code
/// const Bounding_arc_tree_2 tree(drawing);
/// const auto found = closest_point(tree, {1, 1});      // query/closest_point.h
/// const auto paths = offset(tree, -0.1, 1e-4).chains;  // offset/Offset_source_2.h
/// \endcode
/// Copies are cheap: they share segments. Points of any kernel are asked about. Regions of other kinds, kept to a
/// tolerance and over any kernel, are a Region_hierarchy_2 of it.
class Bounding_arc_tree_2 {
 public:
  /// Makes the tree of a drawing.
  /// \param decisions how questions are answered that doubles leave open
  /// \throws std::invalid_argument for curves out of the ranges of check_served and check_queried
  /// \complexity n log n in the number of Bezier pieces, a few microseconds each
  explicit Bounding_arc_tree_2(Drawing_2<double> drawing, Decisions decisions = Decisions::EXACT)
      : Bounding_arc_tree_2(std::make_shared<const Drawing_2<double>>(std::move(drawing)), decisions) {}
  /// Makes the tree of a drawing that others may share.
  explicit Bounding_arc_tree_2(std::shared_ptr<const Drawing_2<double>> drawing,
                               Decisions decisions = Decisions::EXACT);
  /// Takes curves over exact numbers, which need not be doubles. Searches are in doubles and count their rounding in
  /// bounds; what they leave open is decided by the numbers as they are.
  explicit Bounding_arc_tree_2(const Drawing_2<Exact_rational>& drawing, Decisions decisions = Decisions::EXACT);
  /// Takes curves over any other numbers that a rational number stands for exactly.
  template <class NT>
  explicit Bounding_arc_tree_2(const Drawing_2<NT>& drawing, Decisions decisions = Decisions::EXACT)
      : Bounding_arc_tree_2(converted<Exact_rational>(drawing), decisions) {}
  /// Makes a tree of one curve.
  template <class NT>
  explicit Bounding_arc_tree_2(const Bezier_curve_2<NT>& curve, Decisions decisions = Decisions::EXACT)
      : Bounding_arc_tree_2(drawing_of(curve), decisions) {}
  template <class NT>
  explicit Bounding_arc_tree_2(const B_spline_curve_2<NT>& curve, Decisions decisions = Decisions::EXACT)
      : Bounding_arc_tree_2(drawing_of(curve), decisions) {}

  /// Refuses curves without a drawing, which would not say whether they are a chain.
  template <class Curve> explicit Bounding_arc_tree_2(const std::vector<Curve>&, Decisions = Decisions::EXACT) {
    static_assert(std::is_void_v<Curve>,
                  "A tree takes a Drawing_2: add each curve to one, or all of them at once if they are a chain");
  }

  /// Puts other curves in the place of curves first, ..., last - 1, after a control point was moved, say. These alone
  /// are cut, but for trees of exact numbers and those whose unit is or becomes another one. Copies of the tree keep
  /// theirs.
  /// \throws std::out_of_range unless first <= last <= the number of curves, and as the constructor; the tree is then
  ///   as it was
  /// \complexity as that of a tree of these curves, and the logarithm of the number of segments; linear in that number,
  ///   without a cut, where there are more or fewer segments than before, or a copy shares them
  void replace(std::size_t first, std::size_t last, Drawing_2<double> curves);

  /// Tells whether segments of a Bezier piece share the sample between them bit for bit, and are in the boxes over
  /// them.
  /// \complexity linear in the segments
  [[nodiscard]] bool is_valid() const;

  /// The curves, rounded to doubles where they had other numbers.
  [[nodiscard]] const Drawing_2<double>& drawing() const;
  /// A Bezier piece of a curve as it is.
  [[nodiscard]] Bezier_curve_2<Exact_rational> exact_bezier(std::size_t curve, std::size_t bezier) const;
  /// The curves as they are.
  [[nodiscard]] Drawing_2<Exact_rational> exact_drawing() const;
  [[nodiscard]] bool empty() const;
  [[nodiscard]] Decisions decisions() const;
  /// How far the exact curves are from the rounded ones; 0 of doubles.
  [[nodiscard]] double rounding() const;
  /// A box of all curves; CGAL::Bbox_2(), which holds no point, where there are none.
  [[nodiscard]] CGAL::Bbox_2 box() const;

  /// 1 for a drawing whose largest coordinate is between 2^-40 and 2^41.
  [[nodiscard]] const Unit& unit() const { return unit_; }
  /// The segments in that unit, for the library's own.
  [[nodiscard]] const Segment_hierarchy& in_unit() const { return *segments_; }
  /// The segments in another unit. \complexity linear in their number, without a cut as a rule; none for the same unit
  [[nodiscard]] std::shared_ptr<const Segment_hierarchy> in_unit(const Unit& unit) const;

 private:
  template <template <class> class Curve, class NT>
  [[nodiscard]] static Drawing_2<NT> drawing_of(const Curve<NT>& curve) {
    Drawing_2<NT> drawing;
    drawing.add(curve);
    return drawing;
  }
  [[nodiscard]] std::shared_ptr<Segment_hierarchy> made_in(const Unit& unit, const Drawing_2<Exact_rational>* exact,
                                                           Decisions decisions) const;

  Unit unit_;
  std::shared_ptr<const Drawing_2<double>> given_;  // where the drawing is scaled
  std::shared_ptr<Segment_hierarchy> segments_;
};

}  // namespace CGAL::Bounding_arcs

#endif
