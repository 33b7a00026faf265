// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hierarchy_implementation.h"

#include <CGAL/Bounding_arcs_2/study/Axis_box.h>
#include <CGAL/Bounding_arcs_2/study/Control_hull.h>
#include <CGAL/Bounding_arcs_2/study/Fat_arc.h>
#include <CGAL/Bounding_arcs_2/study/Fat_biarc.h>
#include <CGAL/Bounding_arcs_2/study/Oriented_box.h>

#include <CGAL/Simple_cartesian.h>

namespace bounding_arcs_tool::detail {
namespace {

using Spirals = std::vector<ba::Bezier_spiral_2<double>>;

template <class Construction>
std::unique_ptr<Curve_hierarchy> build(const Spirals& spirals, double eps, const ba::Build_options& options) {
  using Traits = ba::Bounding_region_traits_2<Circular<CGAL::Simple_cartesian<double>>, Construction>;
  using Tree = ba::Bounding_arc_tree_2<Traits, ba::Bezier_spiral_2<double>>;
  return std::make_unique<Hierarchy_of<Tree>>(spirals, eps, options);
}

}  // namespace

std::unique_ptr<Curve_hierarchy> build_yardstick(Method method, const Spirals& spirals, double eps,
                                                 const ba::Build_options& options) {
  switch (method) {
    case Method::FAT_ARC:
      return build<ba::Fat_arc>(spirals, eps, options);
    case Method::FAT_BIARC:
      return build<ba::Fat_biarc>(spirals, eps, options);
    case Method::BOX:
      return build<ba::Axis_box>(spirals, eps, options);
    case Method::ORIENTED_BOX:
      return build<ba::Oriented_box>(spirals, eps, options);
    case Method::HULL:
      return build<ba::Control_hull>(spirals, eps, options);
    default:
      throw std::logic_error("no yardstick");
  }
}

}  // namespace bounding_arcs_tool::detail
