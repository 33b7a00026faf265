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
template <class Curve> class Jet_spiral_2;

/// The tree that all algorithms descend. Make one of a drawing, once, and ask it as often as you like.
/// \code
/// const Bounding_arc_tree_2 tree(drawing);
/// const auto found = closest_point(tree, {1, 1});      // query/closest_point.h
/// const auto paths = offset(tree, -0.1, 1e-4).chains;  // offset/Offset_source_2.h
/// \endcode
/// A tree has the spiral segments of the drawing's curves, under boxes. Nothing is stored below a segment: a search
/// that goes there halves the segment, and has each half in bounding circular arcs. So a tree has no tolerance; each
/// question brings its own. Points of any kernel may be asked about.
///
/// Doubles may leave a verdict open, such as whether curves touch. With Decisions::EXACT, the default, exact arithmetic
/// then decides. With Decisions::DOUBLE the answer is `undecided`; take it if your program can use that answer.
/// Distances and measures are brackets in both cases, and hold the true number.
///
/// After an edit call replace(), which cuts only the new curves. Copies are cheap, as they share segments: copy a tree
/// to keep it as it is while you edit the other one.
///
/// Take a Region_hierarchy_2 of the tree where you want the regions themselves, of any kind and over any kernel.
class Bounding_arc_tree_2 {
 public:
  /// Makes the tree of a drawing.
  /// \param decisions how questions are answered that doubles leave open
  /// \throws std::invalid_argument for curves out of the ranges of served_range.h
  /// \complexity n log n in the number of Bezier pieces, a few microseconds each
  explicit Bounding_arc_tree_2(Drawing_2<double> drawing, Decisions decisions = Decisions::EXACT)
      : Bounding_arc_tree_2(std::make_shared<const Drawing_2<double>>(std::move(drawing)), decisions) {}
  /// Makes the tree of a drawing that others may share.
  explicit Bounding_arc_tree_2(std::shared_ptr<const Drawing_2<double>> drawing,
                               Decisions decisions = Decisions::EXACT);
  /// Takes curves over exact numbers, which need not be doubles. Searches run in doubles, and their bounds count the
  /// rounding of the numbers. Verdicts that searches leave open are decided by the exact numbers.
  explicit Bounding_arc_tree_2(const Drawing_2<Exact_rational>& drawing, Decisions decisions = Decisions::EXACT);
  /// Takes curves over any other numbers that a rational number stands for exactly.
  template <class NT>
  explicit Bounding_arc_tree_2(const Drawing_2<NT>& drawing, Decisions decisions = Decisions::EXACT)
      : Bounding_arc_tree_2(drawing.template over<Exact_rational>(), decisions) {}
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
  /// Refuses segments of curves of one's own.
  template <class Curve>
  explicit Bounding_arc_tree_2(const std::vector<Jet_spiral_2<Curve>>&, Decisions = Decisions::EXACT) {
    static_assert(std::is_void_v<Curve>,
                  "Curves of one's own have regions, closest points and chains: make a Region_hierarchy_2 of them");
  }

  /// Puts other curves in the place of curves first, ..., last - 1, after a control point was moved, say. Only the new
  /// curves are cut. All curves are cut again in a tree of exact numbers, and where the unit of the drawing is not 1 or
  /// changes. Copies of the tree keep the old curves.
  /// \throws std::out_of_range unless first <= last <= the number of curves, and as the constructor; the tree is then
  ///   as it was
  /// \complexity that of a tree of the new curves, and the logarithm of the number of segments. The number itself, but
  ///   no cut, where the number of segments changes, or where a copy shares the segments
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
  [[nodiscard]] const internal::Unit& unit() const { return unit_; }
  /// The segments in that unit, for the library's own.
  [[nodiscard]] const Segment_hierarchy& in_unit() const { return *segments_; }
  /// The segments in another unit. \complexity linear in their number, without a cut as a rule; none for the same unit
  [[nodiscard]] std::shared_ptr<const Segment_hierarchy> in_unit(const internal::Unit& unit) const;

 private:
  template <template <class> class Curve, class NT>
  [[nodiscard]] static Drawing_2<NT> drawing_of(const Curve<NT>& curve) {
    Drawing_2<NT> drawing;
    drawing.add(curve);
    return drawing;
  }
  [[nodiscard]] std::shared_ptr<Segment_hierarchy> made_in(const internal::Unit& unit,
                                                           const Drawing_2<Exact_rational>* exact,
                                                           Decisions decisions) const;

  internal::Unit unit_;
  std::shared_ptr<const Drawing_2<double>> given_;  // where the drawing is scaled
  std::shared_ptr<Segment_hierarchy> segments_;
};

}  // namespace CGAL::Bounding_arcs

#endif
