// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of boolean/clip.h.
//
//   common points and overlaps -> cuts of each Bezier piece -> parts between them -> a point of each: which side

#include <CGAL/Bounding_arcs_2/boolean/internal/Cut_places.h>
#include <CGAL/Bounding_arcs_2/boolean/internal/compiled_clip.h>
#include <CGAL/Bounding_arcs_2/query/Intersection_search.h>
#include <CGAL/Bounding_arcs_2/query/Winding_search.h>
#include <CGAL/Bounding_arcs_2/query/closed_curves.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

class Clipper {
 public:
  Clipper(const Segment_hierarchy& curves, const Segment_hierarchy& region, const Unit& unit, Fill_rule rule)
      : curves_(curves), region_(region), unit_(unit), rule_(rule) {
    const Intersections_2<> common = Intersection_search(curves, region).all(false);
    for (std::uint32_t b = 0; b < curves.number_of_beziers(); ++b)
      cuts_.push_back({{{b, {0, 0}}, NOTHING}, {{b, {1, 1}}, NOTHING}});
    overlaps_.resize(curves.number_of_beziers());
    const auto place = [](const Segment_hierarchy& of, const Curve_range& r) {
      return Joint_place{of.number_of_bezier(r.curve, r.bezier), r.t};
    };
    const auto add = [&](const Curve_range& a, const Curve_range& b, bool is_overlap_end) {
      const Joint_place at = place(curves, a);
      cuts_[at.bezier].push_back({at, place(region, b), is_overlap_end});
    };
    for (const Intersection_2<>& p : common.points) {
      if (p.kind == Intersection_kind::UNDECIDED && is_decided_) {
        is_decided_ = false;
        undecided_ = {unit_.out(p.point), {0, p.a.curve, p.a.bezier}, {1, p.b.curve, p.b.bezier}};
      }
      add(p.a, p.b, false);
    }
    for (const Overlap_2& o : common.overlaps) {
      add(o.a_from, o.b_from, true);
      add(o.a_to, o.b_to, true);
      overlaps_[place(curves, o.a_from).bezier].emplace_back(o.a_from.t, o.a_to.t);
    }
  }

  [[nodiscard]] Clipped_2 result() {
    Clipped_2 result;
    const auto& drawn = curves_.drawing().curves();
    for (std::uint32_t c = 0; c < drawn.size(); ++c)
      for (std::uint32_t b = 0; b < drawn[c].beziers.size(); ++b)
        add_parts({c, b, {}}, curves_.number_of_bezier(c, b), result);
    if (!is_decided_) return {{}, Outline_status::UNDECIDED, undecided_};
    if (!is_resolved_) result.status = Outline_status::RESOLUTION_REACHED;
    return result;
  }

 private:
  void add_parts(const Curve_range& of, std::uint32_t bezier, Clipped_2& result) {
    const std::vector<Bracket> cuts = joined(cuts_[bezier]);
    for (std::size_t i = 0; i + 1 < cuts.size() && is_decided_; ++i) {
      Clipped_part part{
          of.curve,      of.bezier, cuts[i], cuts[i + 1], point(bezier, cuts[i]), point(bezier, cuts[i + 1]),
          Point_side::ON};
      const double t = cuts[i].upper + (cuts[i + 1].lower - cuts[i].upper) / 2;
      const bool is_along = std::any_of(overlaps_[bezier].begin(), overlaps_[bezier].end(),
                                        [t](const auto& o) { return o.first.lower < t && t < o.second.upper; });
      if (!is_along) part.side = side_at(bezier, t);
      result.parts.push_back(part);
    }
  }
  // Cuts in order.  Those that no double lies between are one; exact arithmetic tells whether they are one place.
  [[nodiscard]] std::vector<Bracket> joined(std::vector<Meeting_place>& cuts) {
    std::sort(cuts.begin(), cuts.end(),
              [](const Meeting_place& p, const Meeting_place& q) { return p.place < q.place; });
    std::vector<Bracket> result;
    const Meeting_place* first = nullptr;  // of the last cut
    for (const Meeting_place& cut : cuts) {
      const Bracket& t = cut.place.t;
      if (result.empty() || t.lower - result.back().upper > NEAREST_CUTS) {
        result.push_back(t);
        first = &cut;
        continue;
      }
      const bool is_end = cut.other.bezier == NOTHING.bezier;
      is_resolved_ = is_resolved_ && first->place.touches(cut.place) &&
                     (is_end ? are_same(curves_, region_, cut, *first) : are_same(curves_, region_, *first, cut));
      result.back().upper = (std::max)(result.back().upper, t.upper);
    }
    return result;
  }
  [[nodiscard]] Xy<double> point(std::uint32_t bezier, const Bracket& t) const {
    return unit_.out(curves_.evaluator(bezier)(t.middle()).point);
  }
  // Asks for the exact point of the curve: in doubles first, which count how far the computed one is from it.
  [[nodiscard]] Point_side side_at(std::uint32_t bezier, double t) {
    const auto side = [this](const Winding_search& search) {
      return is_filled(rule_, search.number()) ? Point_side::INSIDE : Point_side::OUTSIDE;
    };
    constexpr double OF_PARAMETER = 4 * HALF_ULP;
    const Bezier_evaluator& curve = curves_.evaluator(bezier);
    Asked_point q(curve(t).point);
    q.error = curve.point_error() + OF_PARAMETER * curve.coordinate_size() + curves_.rounding(bezier);
    Winding_search quick(region_, q, Decisions::DOUBLE);
    quick.search();
    if (!quick.is_undecided()) return side(quick);
    if (curves_.decisions() == Decisions::EXACT && region_.decisions() == Decisions::EXACT) {
      Winding_search exact(region_, Asked_point(curves_.exact_bezier(bezier).point(Exact_rational(t))),
                           Decisions::EXACT);
      exact.search();
      if (!exact.is_on()) return side(exact);
    }
    is_decided_ = false;
    return Point_side::ON;
  }

  static constexpr Joint_place NOTHING{(std::numeric_limits<std::uint32_t>::max)(), {-1, 2}};  // met at an end

  const Segment_hierarchy &curves_, &region_;
  const Unit& unit_;
  Fill_rule rule_;
  std::vector<std::vector<Meeting_place>> cuts_;                    // by Bezier piece
  std::vector<std::vector<std::pair<Bracket, Bracket>>> overlaps_;  // by Bezier piece
  bool is_decided_ = true, is_resolved_ = true;
  std::optional<Undecided_meeting> undecided_;
};

}  // namespace

Clipped_2 clip(const Drawing_hierarchy& curves, const Drawing_hierarchy& region, Fill_rule rule) {
  check_closed(region.drawing());
  const Common_unit both(curves, region);
  return Clipper(both.a(), both.b(), both.unit(), rule).result();
}

}  // namespace CGAL::Bounding_arcs::internal
