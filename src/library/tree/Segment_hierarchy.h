// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of the hierarchy that no kernel changes: the spiral segments of a drawing, each with a sample at both ends
// and its fat arc, under a tree of boxes.  What is below a segment is made as a search goes there: a sample in the
// middle gives two pieces with fat arcs of their own.
//
// Everything is in doubles with bounds of what that misses.  Where numbers of the drawing are no doubles, segments are
// those of rounded curves and their error bounds count the rounding.  exact_bezier() has the curves as they are, for
// questions that doubles leave open.
//
// Lengths are taken for numbers near 1: Bounding_arc_tree_2 scales other drawings.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_SEGMENT_HIERARCHY_H
#define BOUNDING_ARCS_LIBRARY_TREE_SEGMENT_HIERARCHY_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/number/Made_once.h>
#include <CGAL/Bounding_arcs_2/region/box_between.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>
#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>
#include <CGAL/Bounding_arcs_2/tree/Bezier_evaluator.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include "Box_tree.h"
#include "Spiral_piece_2.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A part of a segment, with how far it may be from the exact curve.
struct Segment_part {
  Spiral_piece_2 piece;
  double error;
  std::optional<Bezier_curve_2<double>> moved{};  ///< the curve that it is of now, about where it was
};

/// The spiral segments of a drawing, each with a sample at both ends and its fat arc, under a tree of boxes.
class Segment_hierarchy {
 public:
  using Exact_bezier = Bezier_curve_2<Exact_rational>;
  using Region = Fat_arc_2;  ///< what searches ask: distance_bounds, least_distance, are_apart

  /// \pre all curves are served
  /// \complexity n log n in the number of Bezier pieces, a few microseconds each
  Segment_hierarchy(std::shared_ptr<const Drawing_2<double>> drawing, Decisions decisions)
      : drawing_(std::move(drawing)), decisions_(decisions) {
    // A program with other exact numbers than the library's has no build(): it does not link.
    build(nullptr, nullptr);
  }
  /// Takes the curves of another hierarchy in another unit, and cuts them where the other hierarchy cuts.
  /// \pre the curves are the same but for a power of two, and scaling loses no digit; `cut` is no forest, nor parted
  Segment_hierarchy(std::shared_ptr<const Drawing_2<double>> drawing, const Segment_hierarchy& cut)
      : drawing_(std::move(drawing)), decisions_(cut.decisions_) {
    build(nullptr, &cut);
  }
  /// Takes curves over numbers that need not be doubles.
  Segment_hierarchy(const Drawing_2<Exact_rational>& drawing, Decisions decisions);

  /// Returns a hierarchy of the same curves whose segments are parts of these.
  /// \param parts of all segments, in their order; each cut between two parts is a joint
  /// \pre this is no forest
  [[nodiscard]] Segment_hierarchy parted(const std::vector<Segment_part>& parts) const;

  /// Takes hierarchies in one unit as one, a forest: curves, Bezier pieces and segments are numbered through, and stay
  /// where they are. None of them is a forest.
  /// \complexity linear in the number of segments, without a copy of them
  explicit Segment_hierarchy(const std::vector<std::shared_ptr<const Segment_hierarchy>>& members);
  /// Returns a hierarchy of some of the Bezier pieces, with the segments of these pieces.
  /// \param kept numbers of pieces, growing; each chain stays connected when the other pieces are gone
  /// \pre this is no forest
  [[nodiscard]] Segment_hierarchy of_pieces(const std::vector<std::uint32_t>& kept) const;

  /// Puts other curves in the place of curves first, ..., last - 1, and cuts the new curves alone. After an exception
  /// the hierarchy is as it was.
  /// \pre the curves of this hierarchy are of doubles; there are curves first, ..., last - 1; this is no forest
  void replace(std::size_t first, std::size_t last, Drawing_2<double> curves);

  /// The curves, rounded to doubles where they had other numbers.
  [[nodiscard]] const Drawing_2<double>& drawing() const { return *drawing_; }
  [[nodiscard]] Decisions decisions() const { return decisions_; }
  [[nodiscard]] bool empty() const { return number_of_segments() == 0; }

  /// Segments in the order of their curves, each whole; those that are a point are among them.
  [[nodiscard]] std::size_t number_of_segments() const {
    return is_forest() ? member_of_segment_.size() : segments_.size();
  }
  [[nodiscard]] Spiral_piece_2 piece(std::uint32_t segment) const {
    const Segment& s = at(segment);
    return {segment, s.first, s.last};
  }
  [[nodiscard]] Region region(std::uint32_t segment) const {
    const Segment& s = at(segment);
    return {{s.first.point, s.last.point, s.bulge}, s.radius};
  }
  [[nodiscard]] Segment_place place(std::uint32_t segment) const {
    Segment_place place = at(segment).place;
    if (is_forest()) place.curve += members_[member_of_segment_[segment]].first_curve;
    return place;
  }
  [[nodiscard]] bool is_straight(std::uint32_t segment) const { return at(segment).is_straight; }
  /// Bezier pieces of all curves, numbered through.
  [[nodiscard]] std::uint32_t bezier_of(std::uint32_t segment) const {
    const std::uint32_t own = at(segment).bezier;
    return is_forest() ? own + members_[member_of_segment_[segment]].first_bezier : own;
  }
  [[nodiscard]] std::size_t number_of_beziers() const {
    return is_forest() ? member_of_bezier_.size() : evaluators_.size();
  }
  [[nodiscard]] std::uint32_t number_of_bezier(std::size_t curve, std::size_t bezier) const {
    return first_bezier_[curve] + static_cast<std::uint32_t>(bezier);
  }
  /// The curve that such a piece is of. \complexity logarithmic in the number of curves
  [[nodiscard]] std::size_t curve_of_bezier(std::uint32_t number) const {
    const auto after = std::upper_bound(first_bezier_.begin(), first_bezier_.end(), number);
    return static_cast<std::size_t>(after - first_bezier_.begin()) - 1;
  }
  [[nodiscard]] const Bezier_evaluator& evaluator(std::uint32_t bezier) const {
    if (!is_forest()) return evaluators_[bezier];
    const Member& member = members_[member_of_bezier_[bezier]];
    return member.of->evaluators_[bezier - member.first_bezier];
  }
  /// Rounded where its numbers were no doubles.
  [[nodiscard]] const Bezier_curve_2<double>& bezier(std::uint32_t number) const { return evaluator(number).curve(); }
  [[nodiscard]] Exact_bezier exact_bezier(std::uint32_t bezier) const;
  /// Whether a Bezier piece, as it is, is a single point.
  [[nodiscard]] bool is_point(std::uint32_t bezier) const;
  /// Whether exact curves are others than those in doubles.
  [[nodiscard]] bool is_rounded() const { return is_rounded_; }

  /// Where a Bezier piece is cut into segments. \pre this is not parted, and no forest
  [[nodiscard]] Spiral_parameters cuts(std::uint32_t bezier) const;

  /// A bound of how far computed points of a segment are from the points of the exact curve at the same parameters. It
  /// also bounds how far pieces of the segment are from their true regions. It counts rounding of evaluation, of the
  /// curve and of cuts.
  [[nodiscard]] double error(std::uint32_t segment) const { return at(segment).error; }
  /// How far exact control points are from the rounded ones.
  [[nodiscard]] double rounding(std::uint32_t bezier) const {
    if (!is_rounded_) return 0;
    if (!is_forest()) return roundings_[bezier];
    const Member& member = members_[member_of_bezier_[bezier]];
    return member.of->rounding(bezier - member.first_bezier);
  }

  /// Bezier pieces with a turn that no cut is made at: it is too near to an end, or to another turn. Directions are not
  /// known there, and such a piece may meet itself.
  [[nodiscard]] const std::vector<std::uint32_t>& hidden_tips() const { return hidden_tips_; }

  /// The sample at a parameter inside a segment.
  [[nodiscard]] Spiral_sample sample(std::uint32_t segment, double t) const {
    const Segment& s = at(segment);
    const std::uint32_t bezier = bezier_of(segment);
    const internal::Curve_jet jet = evaluator(bezier)(t);
    if (!s.is_straight) return sample_of(bezier, t, jet);
    Spiral_sample sample = s.first;  // derivatives have no direction where a line turns back
    sample.t = t;
    sample.point = jet.point;
    return sample;
  }
  [[nodiscard]] Region region(const Spiral_piece_2& piece) const { return fat_arc(piece, error(piece.segment)); }
  [[nodiscard]] CGAL::Bbox_2 box(const Spiral_piece_2& piece) const { return box(piece, error(piece.segment)); }
  /// A box of a piece whose ends are off the curve by up to e.
  [[nodiscard]] static CGAL::Bbox_2 box(const Spiral_piece_2& piece, double e) {
    return internal::box_between(piece.first.point, piece.last.point, e);
  }
  [[nodiscard]] Curve_place place_at(std::uint32_t segment, double t) const {
    const Segment_place at = place(segment);
    return {at.curve, at.bezier, t};
  }
  /// The tree over the boxes of the segments. \complexity made when first asked for, n log n
  [[nodiscard]] const Box_tree& boxes() const {
    return (*boxes_)([this] { return Box_tree(number_of_segments(), [this](std::size_t i) { return box_at(i); }); });
  }
  /// Drops the boxes until boxes() is called again: boxes of a large drawing take much memory.
  void drop_boxes() { boxes_ = std::make_shared<internal::Made_once<Box_tree>>(); }
  /// Whether the boxes are made.
  [[nodiscard]] bool has_boxes() const { return boxes_->made() != nullptr; }

 private:
  // Less than three cache lines, of which a large drawing has the most: a region's ends are those of its piece.
  struct Segment {
    Spiral_sample first, last;
    double error, bulge = 0, radius = 0;
    Segment_place place;
    std::uint32_t bezier : 31;
    bool is_straight : 1;

    void set_region(const Region& fat) {
      bulge = fat.arc.bulge;
      radius = fat.radius;
    }
  };
  // Where curves, Bezier pieces and segments of a hierarchy are among those of a forest.
  struct Member {
    std::shared_ptr<const Segment_hierarchy> of;
    std::uint32_t first_curve, first_bezier, first_segment;
  };

  Segment_hierarchy() = default;
  void build(const Drawing_2<Exact_rational>* exact, const Segment_hierarchy* cut);
  [[nodiscard]] bool is_forest() const { return is_forest_; }
  [[nodiscard]] const Segment& at(std::uint32_t segment) const {
    if (!is_forest()) return segments_[segment];
    const Member& member = members_[member_of_segment_[segment]];
    return member.of->segments_[segment - member.first_segment];
  }
  [[nodiscard]] static Region fat_of(const Segment& s) { return fat_arc({0, s.first, s.last}, s.error); }
  [[nodiscard]] CGAL::Bbox_2 box_at(std::size_t segment) const {
    const Segment& s = at(static_cast<std::uint32_t>(segment));
    return internal::box_between(s.first.point, s.last.point, s.error);
  }
  void add_segments(const Bezier_curve_2<double>& curve, const Spiral_parameters& cuts, std::uint32_t bezier,
                    const Segment_place& place);
  [[nodiscard]] Spiral_sample sample_of(std::uint32_t bezier, double t, const internal::Curve_jet& jet) const;
  void mend_ends(const Bezier_curve_2<double>& curve, const Spiral_parameters& cuts, std::size_t first);
  void add_copies(const Segment_hierarchy& of, std::uint32_t number, const Segment_place& place);
  [[nodiscard]] std::vector<Segment>::const_iterator first_segment(std::uint32_t bezier) const;
  static void straighten(Segment& s);
  void move(Segment& s, const Bezier_curve_2<double>& curve);
  [[nodiscard]] bool may_turn_beside_end(const Segment& s, bool at_start) const;
  void separate_cuts(std::size_t segment, double cut_error);

  std::shared_ptr<const Drawing_2<double>> drawing_;
  std::shared_ptr<Drawing_2<double>> own_drawing_;  // the same, where curves were replaced
  Decisions decisions_ = Decisions::EXACT;
  bool is_rounded_ = false, is_forest_ = false;
  std::vector<Bezier_evaluator> evaluators_;
  std::vector<std::uint32_t> first_bezier_;
  std::vector<Exact_bezier> exact_;  // where the drawing is not of doubles
  std::vector<double> roundings_;
  std::vector<Segment> segments_;
  std::vector<std::uint32_t> hidden_tips_;
  std::map<std::uint32_t, Spiral_parameters> coarse_cuts_;  // of pieces whose segments have others, too
  std::vector<Member> members_;  // of a forest, which has no segments and evaluators of its own
  std::vector<std::uint32_t> member_of_bezier_, member_of_segment_;
  std::shared_ptr<internal::Made_once<Box_tree>> boxes_ = std::make_shared<internal::Made_once<Box_tree>>();
};

inline Spiral_sample Segment_hierarchy::sample_of(std::uint32_t bezier, double t,
                                                  const internal::Curve_jet& jet) const {
  const Bezier_evaluator& curve = evaluator(bezier);
  const double speed = euclidean_norm(jet.first);
  Spiral_sample s;
  s.t = t;
  s.point = jet.point;
  const internal::Jet_errors errors = curve.errors_at(t, jet);
  const double error = errors.first + curve.first_change(rounding(bezier), errors.first);
  constexpr double CERTAIN = 4;  // times its error: a direction within a quarter
  if (!(speed >= CERTAIN * error)) {
    s.tangent_error = s.most_curvature = std::numeric_limits<double>::infinity();
    if (speed > 0) s.tangent = (1 / speed) * jet.first;
    return s;
  }
  s.tangent = (1 / speed) * jet.first;
  s.tangent_error = error / speed + 4 * HALF_ULP;
  // |C' x C''| / |C'|^3, each factor with its error
  const double second = errors.second + curve.second_change(rounding(bezier), errors.second);
  const double across = std::fabs(cross(jet.first, jet.second)),
               unsure = (speed * second + error * (euclidean_norm(jet.second) + second)) +
                        8 * HALF_ULP * speed * euclidean_norm(jet.second);
  const double least = speed - error, most = speed + error;
  s.most_curvature = (across + unsure) / (least * least * least) * ROUNDED_UP<16>;
  s.least_curvature = (std::max)(0.0, across - unsure) / (most * most * most) * ROUNDED_DOWN<16>;
  return s;
}

/// A piece with its region.
template <class Region> struct Piece_in_hand {
  Spiral_piece_2 piece;
  Region region;
};

/// Two halves of a piece, cut in the middle of its parameters.
struct Spiral_halves_2 {
  Spiral_piece_2 first, second;
};
/// \return nothing where there is no double between the ends
[[nodiscard]] inline std::optional<Spiral_halves_2> halves(const Segment_hierarchy& curves,
                                                           const Spiral_piece_2& piece) {
  const double t = piece.first.t + (piece.last.t - piece.first.t) / 2;
  if (!(piece.first.t < t && t < piece.last.t)) return std::nullopt;
  const Spiral_sample middle = curves.sample(piece.segment, t);
  return Spiral_halves_2{{piece.segment, piece.first, middle}, {piece.segment, middle, piece.last}};
}

/// Returns the spiral segments of some curves of a hierarchy, cut where it has cut them.
/// \param drawing the same curves, over other numbers or in another unit
template <class NT>
[[nodiscard]] std::vector<Bezier_spiral_2<NT>> spiral_segments(
    const Segment_hierarchy& segments, const Drawing_2<NT>& drawing, std::size_t first = 0,
    std::size_t last = (std::numeric_limits<std::size_t>::max)()) {
  return internal::spirals_between(drawing, first, last, [&](std::size_t curve, std::size_t bezier) {
    return segments.cuts(segments.number_of_bezier(curve, bezier));
  });
}

/// The segments of two trees in the unit of the larger one.
class Common_unit {
 public:
  Common_unit(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b)
      : unit_((std::max)(a.unit(), b.unit())), a_(a.in_unit(unit_)), b_(b.in_unit(unit_)) {}

  [[nodiscard]] const internal::Unit& unit() const { return unit_; }
  [[nodiscard]] const Segment_hierarchy& a() const { return *a_; }
  [[nodiscard]] const Segment_hierarchy& b() const { return *b_; }

 private:
  internal::Unit unit_;
  std::shared_ptr<const Segment_hierarchy> a_, b_;
};

namespace internal {

/// Tells whether segments of one Bezier piece share the sample between them bit for bit, and samples are numbers.
/// \param curves as Segment_hierarchy
template <class Curves> [[nodiscard]] bool has_shared_samples(const Curves& curves) {
  const auto is_number = [](const Spiral_sample& s) {
    return s.t >= 0 && s.t <= 1 && std::isfinite(s.point.x) && std::isfinite(s.point.y);
  };
  for (std::uint32_t i = 0; i < curves.number_of_segments(); ++i) {
    const Spiral_piece_2 piece = curves.piece(i);
    if (!is_number(piece.first) || !is_number(piece.last) || piece.segment != i) return false;
    if (i == 0 || curves.bezier_of(i) != curves.bezier_of(i - 1)) continue;
    const Spiral_sample before = curves.piece(i - 1).last;
    if (before.t != piece.first.t || before.point != piece.first.point) return false;
  }
  return true;
}

}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
