// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawings in frames (medial_axis/medial_axis.h).

#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>

#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

Drawing_2<double> framed(Drawing_2<double> drawing, const CGAL::Bbox_2& box) {
  const Xy<double> p[4] = {
      {box.xmin(), box.ymin()}, {box.xmax(), box.ymin()}, {box.xmax(), box.ymax()}, {box.xmin(), box.ymax()}};
  std::vector<Bezier_curve_2<double>> sides;
  for (std::size_t i = 0; i < 4; ++i)
    sides.push_back(Bezier_curve_2<double>(std::vector<Xy<double>>{p[i], p[(i + 1) % 4]}));
  drawing.add(std::move(sides), "frame");
  return drawing;
}

CGAL::Bbox_2 control_box(const Drawing_2<double>& drawing) {
  CGAL::Bbox_2 box;
  for (const auto& curve : drawing.curves())
    for (const auto& piece : curve.beziers)
      for (const Xy<double>& p : piece.control_points()) box += CGAL::Bbox_2(p.x, p.y, p.x, p.y);
  return box;
}

Drawing_2<double> framed(Drawing_2<double> drawing, double margin) {
  const CGAL::Bbox_2 box = control_box(drawing);
  if (drawing.curves().empty())
    throw std::invalid_argument(expected("drawing", "at least one curve to be framed", "none"));
  const CGAL::Bbox_2 wide(box.xmin() - margin, box.ymin() - margin, box.xmax() + margin, box.ymax() + margin);
  if (!(wide.xmin() < box.xmin() && box.xmax() < wide.xmax() && wide.ymin() < box.ymin() && box.ymax() < wide.ymax()))
    throw std::invalid_argument(expected("margin", "a number above 0 that coordinates resolve", margin));
  return framed(std::move(drawing), wide);
}

void internal::check_frame(const Drawing_2<double>& drawing) {
  if (drawing.curves().empty()) return;
  Drawing_2<double> frame;
  frame.add(drawing.curves().back().beziers, drawing.curves().back().name);
  if (!frame.curves().front().is_closed)
    throw std::invalid_argument(expected("last curve", "a closed frame", "an open curve"));
  const Bounding_arc_tree_2 curves(frame);
  const Point_location_2 location(curves);
  for (std::size_t i = 0; i + 1 < drawing.curves().size(); ++i) {
    const Xy<double>& p = drawing.curves()[i].beziers.front().control_points().front();
    if (!certainly(location.locate(p) == ON_BOUNDED_SIDE))
      throw std::invalid_argument(expected("curve " + text_of(i), "a curve within the last one, the frame",
                                           "one that starts at " + text_of(p)));
  }
}

}  // namespace CGAL::Bounding_arcs
