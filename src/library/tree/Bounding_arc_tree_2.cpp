// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of Bounding_arc_tree_2.h.

#include <CGAL/Bounding_arcs_2/curve/served_range.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include <CGAL/Bounding_arcs_2/tree/internal/check_tree.h>
#include <CGAL/Bounding_arcs_2/tree/tree_spirals.h>
#include "Segment_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

// \param largest of a coordinate
// \throws std::invalid_argument for curves out of the ranges of served_range.h
static void check_curves(const Drawing_2<double>& drawing, double largest) {
  for (const auto& curve : drawing.curves())
    for (const Bezier_curve_2<double>& piece : curve.beziers) {
      internal::check_served(piece);
      internal::check_queried(piece, largest);
    }
}

Bounding_arc_tree_2::Bounding_arc_tree_2(std::shared_ptr<const Drawing_2<double>> drawing, Decisions decisions) {
  check_curves(*drawing, LARGEST_QUERIED);
  unit_ = internal::Unit::of_size(drawing->coordinate_size());
  if (internal::is_ordinary(unit_, *drawing)) {
    segments_ = std::make_shared<Segment_hierarchy>(std::move(drawing), decisions);
    return;
  }
  given_ = std::move(drawing);
  segments_ = made_in(unit_, nullptr, decisions);
}
Bounding_arc_tree_2::Bounding_arc_tree_2(const Drawing_2<Exact_rational>& drawing, Decisions decisions) {
  Drawing_2<double> rounded = drawing.over<double>();
  check_curves(rounded, LARGEST_SHAPE);
  unit_ = internal::Unit::of_size(rounded.coordinate_size());
  if (!internal::is_ordinary(unit_, rounded)) given_ = std::make_shared<const Drawing_2<double>>(std::move(rounded));
  segments_ = given_ ? made_in(unit_, &drawing, decisions) : std::make_shared<Segment_hierarchy>(drawing, decisions);
}

// Where a coordinate is so small beside the largest one that scaling loses of it, the drawing is one of exact numbers.
std::shared_ptr<Segment_hierarchy> Bounding_arc_tree_2::made_in(const internal::Unit& unit,
                                                                const Drawing_2<Exact_rational>* exact,
                                                                Decisions decisions) const {
  const auto made = [&](const auto& drawing) { return std::make_shared<Segment_hierarchy>(drawing, decisions); };
  if (exact != nullptr) return made(internal::scaled(*exact, unit));
  if (internal::keeps(unit, drawing()))
    return made(std::make_shared<const Drawing_2<double>>(internal::scaled(drawing(), unit)));
  return made(internal::scaled(drawing().over<Exact_rational>(), unit));
}
std::shared_ptr<const Segment_hierarchy> Bounding_arc_tree_2::in_unit(const internal::Unit& unit) const {
  if (unit == unit_) return segments_;
  if (!segments_->is_rounded()) {
    if (!internal::keeps(unit, drawing())) return made_in(unit, nullptr, segments_->decisions());
    auto in_other = std::make_shared<const Drawing_2<double>>(internal::scaled(drawing(), unit));
    return std::make_shared<const Segment_hierarchy>(std::move(in_other), *segments_);
  }
  const Drawing_2<Exact_rational> exact = exact_drawing();
  return made_in(unit, &exact, segments_->decisions());
}

const Drawing_2<double>& Bounding_arc_tree_2::drawing() const { return given_ ? *given_ : segments_->drawing(); }
bool Bounding_arc_tree_2::empty() const { return segments_->empty(); }
Decisions Bounding_arc_tree_2::decisions() const { return segments_->decisions(); }

Bezier_curve_2<Exact_rational> Bounding_arc_tree_2::exact_bezier(std::size_t curve, std::size_t bezier) const {
  const Bezier_curve_2<Exact_rational> scaled = segments_->exact_bezier(segments_->number_of_bezier(curve, bezier));
  std::vector<Xy<Exact_rational>> points;
  for (const Xy<Exact_rational>& p : scaled.control_points())
    points.push_back({unit_.exactly_out(p.x), unit_.exactly_out(p.y)});
  return Bezier_curve_2<Exact_rational>(std::move(points), scaled.weights());
}

Drawing_2<Exact_rational> Bounding_arc_tree_2::exact_drawing() const {
  if (!segments_->is_rounded()) return drawing().over<Exact_rational>();
  Drawing_2<Exact_rational> result;
  const auto& curves = drawing().curves();
  for (std::size_t i = 0; i < curves.size(); ++i) {
    std::vector<Bezier_curve_2<Exact_rational>> chain;
    for (std::size_t j = 0; j < curves[i].beziers.size(); ++j) chain.push_back(exact_bezier(i, j));
    result.add(std::move(chain), curves[i].name);
  }
  return result;
}

void Bounding_arc_tree_2::replace(std::size_t first, std::size_t last, Drawing_2<double> curves) {
  const std::size_t count = drawing().curves().size();
  if (first > last || last > count)
    throw std::out_of_range(expected("first, last", "a range within 0, " + text_of(count) + " of the curves",
                                     text_of(first) + ", " + text_of(last)));
  check_curves(curves, LARGEST_QUERIED);
  const auto largest = [](const Segment_hierarchy& all) {
    if (!all.has_boxes()) return all.drawing().coordinate_size();
    const CGAL::Bbox_2& b = all.boxes().box();
    return (std::max)({std::fabs(b.xmin()), std::fabs(b.xmax()), std::fabs(b.ymin()), std::fabs(b.ymax())});
  };
  const bool is_cut_alone = !given_ && !segments_->is_rounded() && internal::is_ordinary(internal::Unit(), curves) &&
                            last - first < count && internal::Unit::of_size(curves.coordinate_size()).is_one();
  if (is_cut_alone) {
    auto changed = segments_.use_count() == 1 ? segments_ : std::make_shared<Segment_hierarchy>(*segments_);
    changed->replace(first, last, curves);
    segments_ = std::move(changed);
    if (internal::Unit::of_size(largest(*segments_)).is_one()) return;
    *this = Bounding_arc_tree_2(Drawing_2<double>(drawing()), decisions());
    return;
  }
  if (segments_->is_rounded()) {
    Drawing_2<Exact_rational> all = exact_drawing();
    all.replace(first, last, curves.over<Exact_rational>());
    *this = Bounding_arc_tree_2(all, decisions());
    return;
  }
  Drawing_2<double> all = drawing();
  all.replace(first, last, std::move(curves));
  *this = Bounding_arc_tree_2(std::move(all), decisions());
}

bool Bounding_arc_tree_2::is_valid() const {
  if (!internal::has_shared_samples(*segments_)) return false;
  std::vector<int> seen(segments_->number_of_segments(), 0);
  bool are_in_boxes = true;
  for_each_item(
      segments_->boxes(), [](const Box_tree::Node&, std::size_t) { return true; },
      [&](const Box_tree::Node& node, std::size_t k) {
        ++seen[node.child[k]];
        are_in_boxes = are_in_boxes && internal::holds(segments_->boxes().box(), node.box(k)) &&
                       internal::holds(node.box(k), segments_->box(segments_->piece(node.child[k])));
        return true;
      });
  return are_in_boxes && std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; });
}

double Bounding_arc_tree_2::rounding() const {
  double most = 0;
  for (std::uint32_t i = 0; i < segments_->number_of_beziers(); ++i) most = (std::max)(most, segments_->rounding(i));
  return unit_.out(most);
}

CGAL::Bbox_2 Bounding_arc_tree_2::box() const {
  if (empty()) return {};
  const CGAL::Bbox_2& b = segments_->boxes().box();
  const Bracket x = unit_.bounds_out(Bracket{b.xmin(), b.xmax()}), y = unit_.bounds_out(Bracket{b.ymin(), b.ymax()});
  return {x.lower, y.lower, x.upper, y.upper};
}

namespace internal {

bool are_cuts_rounded(const Bounding_arc_tree_2& tree) { return tree.in_unit().is_rounded(); }
bool are_cuts_in_own_lengths(const Bounding_arc_tree_2& tree) { return &tree.drawing() == &tree.in_unit().drawing(); }
Spiral_parameters cuts_of(const Bounding_arc_tree_2& tree, std::size_t curve, std::size_t bezier) {
  const Segment_hierarchy& segments = tree.in_unit();
  return segments.cuts(segments.number_of_bezier(curve, bezier));
}

}  // namespace internal

}  // namespace CGAL::Bounding_arcs
