// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A drawing made ready for queries: its spiral segments, each with its fat arc, under a tree of boxes.  What is below a
// segment is made as a query goes there: a sample in the middle gives two pieces with fat arcs of their own.
//
// Everything is in doubles with bounds of what that misses.  Where numbers of the drawing are no doubles, the index is
// over rounded curves and its error bounds count the rounding; exact_bezier() has the curves as they are, for questions
// that doubles leave open.
//
// A drawing whose largest coordinate is far from 1 is searched in a unit of its own (internal/Unit.h): what the index
// has of segments and pieces is in that unit, the drawing and its box are not.  A query goes in and out by it.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_CURVE_INDEX_2_H
#define CGAL_BOUNDING_ARCS_2_QUERY_CURVE_INDEX_2_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/internal/Exact_number.h>
#include <CGAL/Bounding_arcs_2/internal/Unit.h>
#include <CGAL/Bounding_arcs_2/internal/query/Bezier_evaluator.h>
#include <CGAL/Bounding_arcs_2/internal/query/Box_tree.h>
#include <CGAL/Bounding_arcs_2/query/Fat_arc_2.h>
#include <CGAL/Bounding_arcs_2/query/queried_range.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>
#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>
#include <CGAL/Bounding_arcs_2/tree/box_of_piece.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// How an index answers what doubles leave open.
enum class Query_decisions {
  EXACT,  ///< by exact arithmetic: every verdict is right
  DOUBLE  ///< not at all: a verdict may be `undecided`, within its bracket
};

class Curve_index_2 {
 public:
  using Exact_bezier = Bezier_curve_2<Exact_rational>;

  /// \throws std::invalid_argument for curves out of the ranges of check_served and check_queried
  /// \complexity n log n in the number of Bezier pieces, a few microseconds each; with a unit() that is
  ///   not 1 twice the memory
  explicit Curve_index_2(Drawing_2<double> drawing, Query_decisions decisions = Query_decisions::EXACT)
      : drawing_(std::move(drawing)), decisions_(decisions) {
    build(nullptr);  // of which a program with other exact numbers than the library's has none: it does not link
  }
  /// The same over numbers that need not be doubles.
  explicit Curve_index_2(const Drawing_2<Exact_rational>& drawing, Query_decisions decisions = Query_decisions::EXACT);

  /// The curves, rounded to doubles where they had other numbers.
  [[nodiscard]] const Drawing_2<double>& drawing() const { return drawing_; }
  [[nodiscard]] Query_decisions decisions() const { return decisions_; }
  [[nodiscard]] bool empty() const { return segments_.empty(); }
  /// A box of all curves.
  [[nodiscard]] CGAL::Bbox_2 box() const;

  /// The unit of all that follows: 1 for a drawing whose largest coordinate is between 2^-40 and 2^41.
  [[nodiscard]] const internal::Unit& unit() const { return unit_; }
  /// An index of the drawing in that unit, this one where nothing is scaled.
  [[nodiscard]] const Curve_index_2& in_unit() const { return in_unit_ ? *in_unit_ : *this; }
  /// One of the drawing in another unit. \complexity as that of the constructor
  [[nodiscard]] std::shared_ptr<const Curve_index_2> made_in(const internal::Unit& unit) const;

  /// Segments in the order of their curves, each whole; those that are a point are among them.
  [[nodiscard]] std::size_t number_of_segments() const { return segments_.size(); }
  [[nodiscard]] const Spiral_piece_2& piece(std::uint32_t segment) const { return segments_[segment].piece; }
  [[nodiscard]] const Fat_arc_2& fat(std::uint32_t segment) const { return segments_[segment].fat; }
  [[nodiscard]] const Segment_place& place(std::uint32_t segment) const { return segments_[segment].place; }
  [[nodiscard]] bool is_straight(std::uint32_t segment) const { return segments_[segment].is_straight; }
  /// Bezier pieces of all curves, numbered through.
  [[nodiscard]] std::uint32_t bezier_of(std::uint32_t segment) const { return segments_[segment].bezier; }
  [[nodiscard]] std::size_t number_of_beziers() const { return evaluators_.size(); }
  [[nodiscard]] std::uint32_t number_of_bezier(std::size_t curve, std::size_t bezier) const {
    return first_bezier_[curve] + static_cast<std::uint32_t>(bezier);
  }
  /// The curve that such a piece is of. \complexity logarithmic in the number of curves
  [[nodiscard]] std::size_t curve_of_bezier(std::uint32_t number) const {
    const auto after = std::upper_bound(first_bezier_.begin(), first_bezier_.end(), number);
    return static_cast<std::size_t>(after - first_bezier_.begin()) - 1;
  }
  [[nodiscard]] const internal::Bezier_evaluator& evaluator(std::uint32_t bezier) const { return evaluators_[bezier]; }
  /// As the index has it, rounded where its numbers were no doubles.
  [[nodiscard]] const Bezier_curve_2<double>& bezier(std::uint32_t number) const;
  [[nodiscard]] Exact_bezier exact_bezier(std::uint32_t bezier) const;

  /// How far computed points of a segment may be from those of the exact curve at the same parameter, and pieces of it
  /// from the true region's: rounding of evaluation, of the curve and of cuts.
  [[nodiscard]] double error(std::uint32_t segment) const { return segments_[segment].error; }
  /// How far exact control points are from the rounded ones.
  [[nodiscard]] double rounding(std::uint32_t bezier) const { return roundings_.empty() ? 0 : roundings_[bezier]; }

  /// The sample at a parameter inside a segment.
  [[nodiscard]] Spiral_sample sample(std::uint32_t segment, double t) const {
    const Segment& s = segments_[segment];
    const internal::Curve_jet jet = evaluators_[s.bezier](t);
    if (!s.is_straight) return sample_of(s.bezier, t, jet);
    Spiral_sample sample = s.piece.first;  // derivatives have no direction where a line turns back
    sample.t = t;
    sample.point = jet.point;
    return sample;
  }
  [[nodiscard]] Fat_arc_2 fat(const Spiral_piece_2& piece) const { return fat_arc(piece, error(piece.segment)); }
  [[nodiscard]] CGAL::Bbox_2 box(const Spiral_piece_2& piece) const {
    const Xy<double>&p = piece.first.point, &q = piece.last.point;
    const double e = error(piece.segment);
    const auto x = widened_range(p.x, q.x, e), y = widened_range(p.y, q.y, e);
    return {x.first, y.first, x.second, y.second};
  }
  [[nodiscard]] Curve_place place_at(std::uint32_t segment, double t) const {
    return {place(segment).curve, place(segment).bezier, t};
  }
  /// The tree over the boxes of the segments.
  [[nodiscard]] const internal::Box_tree& boxes() const { return boxes_; }

 private:
  struct Segment {
    Spiral_piece_2 piece;
    Fat_arc_2 fat;
    double error;
    Segment_place place;
    std::uint32_t bezier;
    bool is_straight;
  };

  struct As_it_is {};
  Curve_index_2(Drawing_2<double> drawing, Query_decisions decisions, As_it_is)
      : drawing_(std::move(drawing)), decisions_(decisions) {
    build_here(nullptr);
  }
  Curve_index_2(const Drawing_2<Exact_rational>& drawing, Query_decisions decisions, As_it_is);

  void build(const Drawing_2<Exact_rational>* exact);
  void build_here(const Drawing_2<Exact_rational>* exact);
  [[nodiscard]] std::shared_ptr<const Curve_index_2> made_in(const internal::Unit& unit,
                                                             const Drawing_2<Exact_rational>* exact) const;
  [[nodiscard]] Drawing_2<Exact_rational> exact_drawing() const;
  void add_segments(const Bezier_curve_2<double>& curve, std::uint32_t bezier, const Segment_place& place);
  [[nodiscard]] Spiral_sample sample_of(std::uint32_t bezier, double t, const internal::Curve_jet& jet) const;
  void mend_ends(const Bezier_curve_2<double>& curve, std::size_t first);
  static void straighten(Segment& s);
  void separate_cuts(std::size_t segment, double cut_error);

  Drawing_2<double> drawing_;
  Query_decisions decisions_;
  internal::Unit unit_;
  std::shared_ptr<const Curve_index_2> in_unit_;  // where the drawing is scaled
  std::vector<internal::Bezier_evaluator> evaluators_;
  std::vector<std::uint32_t> first_bezier_;
  std::vector<Exact_bezier> exact_;  // where the drawing is not of doubles
  std::vector<double> roundings_;
  std::vector<Segment> segments_;
  internal::Box_tree boxes_;
};

/// Two halves of a piece, cut in the middle of its parameters.
struct Spiral_halves_2 {
  Spiral_piece_2 first, second;
};
/// \return nothing where there is no double between the ends
[[nodiscard]] inline std::optional<Spiral_halves_2> halves(const Curve_index_2& index, const Spiral_piece_2& piece) {
  const double t = piece.first.t + (piece.last.t - piece.first.t) / 2;
  if (!(piece.first.t < t && t < piece.last.t)) return std::nullopt;
  const Spiral_sample middle = index.sample(piece.segment, t);
  return Spiral_halves_2{{piece.segment, piece.first, middle}, {piece.segment, middle, piece.last}};
}

}  // namespace CGAL::Bounding_arcs

#ifndef BOUNDING_ARCS_KERNELS
#include <CGAL/Bounding_arcs_2/internal/query/Curve_index_2_impl.h>
#endif

#endif
