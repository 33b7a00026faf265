// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of boolean/clip.h.
//
//   common points and overlaps -> places on each Bezier piece -> parts between them -> a point of each: which side

#include "../overlay/Meeting_places.h"

#include <CGAL/Bounding_arcs_2/boolean/clip.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>
#include "../query/Intersection_search.h"
#include "../query/Winding_search.h"
#include "../tree/Segment_hierarchy.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

class Clipper {
 public:
  Clipper(const Segment_hierarchy& curves, const Segment_hierarchy& region, const Unit& unit, Fill_rule rule,
          const Numbered_intersections& found)
      : curves_(curves), region_(region), unit_(unit), rule_(rule), places_(curves, region, found),
        places_of_(curves.number_of_beziers()) {
    for (std::size_t i = 0; i < places_.meetings().size(); ++i)
      places_of_[places_.meetings()[i].bezier[0]].push_back(static_cast<Place_number>(2 * i));
    if (places_.undecided()) leave_open(*places_.undecided());
  }

  [[nodiscard]] Clipped_2 result() {
    Clipped_2 result;
    const auto& drawn = curves_.drawing().curves();
    for (std::uint32_t c = 0; c < drawn.size() && !undecided_; ++c)
      for (std::uint32_t b = 0; b < drawn[c].beziers.size() && !undecided_; ++b)
        add_parts(c, b, curves_.number_of_bezier(c, b), result);
    if (undecided_) return {{}, Clipped_2::Status::UNDECIDED, undecided_};
    return result;
  }

 private:
  void leave_open(Place_number p) {
    const auto of = [](const Segment_hierarchy& h, std::uint32_t operand, std::uint32_t bezier) {
      const auto curve = static_cast<std::uint32_t>(h.curve_of_bezier(bezier));
      return Overlay_2::Undecided::Of{operand, curve, bezier - h.number_of_bezier(curve, 0)};
    };
    const std::uint32_t own = places_.bezier_of(p), other = places_.bezier_of(p ^ 1U);
    undecided_ = {point(own, places_.bracket(p)), of(curves_, 0, own), of(region_, 1, other)};
  }

  /// Where a piece is cut: the first place of a class of equal ones, or nothing at its ends.
  struct Cut {
    Bracket t;
    std::optional<Place_number> place;
    int overlaps;  ///< that run along the part behind it
  };
  [[nodiscard]] Exact_parameter parameter(const Cut& cut) {
    return cut.place ? places_.parameter(*cut.place) : Exact_parameter(Exact_rational(cut.t.lower));
  }

  void add_parts(std::uint32_t curve, std::uint32_t number, std::uint32_t bezier, Clipped_2& result) {
    const Sorted_places sorted = places_.sorted(places_of_[bezier]);
    if (sorted.undecided) return leave_open(*sorted.undecided);
    std::vector<Cut> cuts{{{0, 0}, std::nullopt, 0}};
    int overlaps = 0;  // that the piece is on behind a class
    for (const auto& equal : sorted.classes) {
      for (const Place_number p : equal) overlaps += places_.overlaps_begun(p);
      const Bracket& t = places_.bracket(equal.front());
      if (t.is_single() && t.lower == 0) cuts.front().overlaps = overlaps;
      else if (!(t.is_single() && t.lower == 1)) cuts.push_back({t, equal.front(), overlaps});
    }
    cuts.push_back({{1, 1}, std::nullopt, 0});
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const Cut &from = cuts[i], &to = cuts[i + 1];
      Clipped_2::Part part{curve, number, from.t, to.t, point(bezier, from.t), point(bezier, to.t), ON_BOUNDARY};
      if (from.overlaps == 0) {
        const std::optional<Bounded_side> side = side_between(bezier, from, to);
        if (!side) {
          undecided_ = {part.start, {0, curve, number}, {1, 0, 0}};
          return;
        }
        part.side = *side;
      }
      result.parts.push_back(part);
    }
  }
  [[nodiscard]] Xy<double> point(std::uint32_t bezier, const Bracket& t) const {
    return unit_.out(curves_.evaluator(bezier)(t.middle()).point);
  }

  // Asks for a point of the curve: in doubles first, which count how far the computed one is from it.
  [[nodiscard]] std::optional<Bounded_side> side_between(std::uint32_t bezier, const Cut& from, const Cut& to) {
    const auto side = [this](const Winding_search& search) {
      return is_filled(rule_, search.number()) ? ON_BOUNDED_SIDE : ON_UNBOUNDED_SIDE;
    };
    const double t = from.t.upper + (to.t.lower - from.t.upper) / 2;
    const bool has_double = from.t.upper < t && t < to.t.lower;
    if (has_double) {
      constexpr double OF_PARAMETER = 4 * HALF_ULP;
      const Bezier_evaluator& curve = curves_.evaluator(bezier);
      Asked_point q(curve(t).point);
      q.error = curve.point_error() + OF_PARAMETER * curve.coordinate_size() + curves_.rounding(bezier);
      Winding_search quick(region_, q, Decisions::DOUBLE);
      quick.search();
      if (!quick.is_undecided()) return side(quick);
    }
    if (curves_.decisions() == Decisions::DOUBLE || region_.decisions() == Decisions::DOUBLE) return std::nullopt;
    const Exact_rational at = has_double ? Exact_rational(t) : number_between(parameter(from), parameter(to));
    Winding_search exact(region_, Asked_point(curves_.exact_bezier(bezier).point(at)), Decisions::EXACT);
    exact.search();
    return side(exact);
  }

  const Segment_hierarchy &curves_, &region_;
  const Unit& unit_;
  Fill_rule rule_;
  Meeting_places places_;
  std::vector<std::vector<Place_number>> places_of_;  // by Bezier piece
  std::optional<Overlay_2::Undecided> undecided_;
};

}  // namespace

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

Clipped_2 clip(const Bounding_arc_tree_2& curves, const Bounding_arc_tree_2& region, Fill_rule rule) {
  internal::check_closed(region.drawing());
  const Common_unit both(curves, region);
  const Numbered_intersections found = Intersection_search(both.a(), both.b()).by_pieces();
  return internal::Clipper(both.a(), both.b(), both.unit(), rule, found).result();
}

}  // namespace CGAL::Bounding_arcs
