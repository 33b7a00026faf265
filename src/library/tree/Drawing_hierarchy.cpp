// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of Drawing_hierarchy.h.

#include <CGAL/Bounding_arcs_2/curve/exact_bezier.h>
#include <CGAL/Bounding_arcs_2/tree/Drawing_hierarchy.h>

#include <CGAL/Bounding_arcs_2/curve/exact_bezier.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The exact curves of segments in a unit, without it.
[[nodiscard]] static Drawing_2<Exact_rational> exact_drawing(const Segment_hierarchy& segments, const Unit& unit) {
  Drawing_2<Exact_rational> result;
  std::uint32_t number = 0;
  for (const auto& curve : segments.drawing().curves()) {
    std::vector<Segment_hierarchy::Exact_bezier> chain;
    for (std::size_t i = 0; i < curve.beziers.size(); ++i) {
      const Segment_hierarchy::Exact_bezier scaled = segments.exact_bezier(number++);
      std::vector<Xy<Exact_rational>> points;
      for (const Xy<Exact_rational>& p : scaled.control_points())
        points.push_back({unit.exactly_out(p.x), unit.exactly_out(p.y)});
      chain.emplace_back(std::move(points), scaled.weights());
    }
    result.add(std::move(chain), curve.name);
  }
  return result;
}

Drawing_hierarchy::Drawing_hierarchy(std::shared_ptr<const Drawing_2<double>> drawing, Decisions decisions) {
  check_curves(*drawing, LARGEST_QUERIED);
  unit_ = Unit::of_size(coordinate_size(*drawing));
  if (is_ordinary(unit_, *drawing)) {
    segments_ = std::make_shared<Segment_hierarchy>(std::move(drawing), decisions);
    return;
  }
  given_ = std::move(drawing);
  segments_ = made_in(unit_, nullptr, decisions);
}
Drawing_hierarchy::Drawing_hierarchy(const Drawing_2<Exact_rational>& drawing, Decisions decisions) {
  Drawing_2<double> rounded = converted<double>(drawing);
  check_curves(rounded, LARGEST_SHAPE);
  unit_ = Unit::of_size(coordinate_size(rounded));
  if (!is_ordinary(unit_, rounded)) given_ = std::make_shared<const Drawing_2<double>>(std::move(rounded));
  segments_ = given_ ? made_in(unit_, &drawing, decisions) : std::make_shared<Segment_hierarchy>(drawing, decisions);
}

// Where a coordinate is so small beside the largest one that scaling loses of it, the drawing is one of exact numbers.
std::shared_ptr<Segment_hierarchy> Drawing_hierarchy::made_in(const Unit& unit, const Drawing_2<Exact_rational>* exact,
                                                              Decisions decisions) const {
  const auto made = [&](const auto& drawing) { return std::make_shared<Segment_hierarchy>(drawing, decisions); };
  if (exact != nullptr) return made(scaled(*exact, unit));
  if (keeps(unit, drawing())) return made(std::make_shared<const Drawing_2<double>>(scaled(drawing(), unit)));
  Drawing_2<Exact_rational> of_doubles;
  for (const auto& curve : drawing().curves()) {
    std::vector<Segment_hierarchy::Exact_bezier> chain;
    for (const Bezier_curve_2<double>& piece : curve.beziers) chain.push_back(exact_bezier(piece));
    of_doubles.add(std::move(chain), curve.name);
  }
  return made(scaled(of_doubles, unit));
}
std::shared_ptr<const Segment_hierarchy> Drawing_hierarchy::in_unit(const Unit& unit) const {
  if (unit == unit_) return segments_;
  if (!segments_->is_rounded()) return made_in(unit, nullptr, segments_->decisions());
  const Drawing_2<Exact_rational> exact = exact_drawing(*segments_, unit_);
  return made_in(unit, &exact, segments_->decisions());
}

double Drawing_hierarchy::rounding() const {
  double most = 0;
  for (std::uint32_t i = 0; i < segments_->number_of_beziers(); ++i) most = (std::max)(most, segments_->rounding(i));
  return unit_.out(most);
}

CGAL::Bbox_2 Drawing_hierarchy::box() const {
  const CGAL::Bbox_2& b = segments_->boxes().box();
  const Bracket x = unit_.bounds_out(Bracket{b.xmin(), b.xmax()}), y = unit_.bounds_out(Bracket{b.ymin(), b.ymax()});
  return {x.lower, y.lower, x.upper, y.upper};
}

}  // namespace CGAL::Bounding_arcs
