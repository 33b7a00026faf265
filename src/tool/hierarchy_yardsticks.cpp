// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hierarchy_implementation.h"

#include <CGAL/Bounding_arcs_2/study/Search_study.h>
#include <CGAL/Bounding_arcs_2/study/boxes_and_hulls.h>
#include <CGAL/Bounding_arcs_2/study/fat_arcs.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

namespace bounding_arcs_tool::detail {
namespace {

using Spirals = std::vector<ba::Bezier_spiral_2<double>>;

template <class Construction> struct Type { using type = Construction; };

// visit(Type<Construction>()) for the construction of a method.
template <class Visit> auto with_construction(Method method, const Visit& visit) {
  switch (method) {
    case Method::BCA:
      return visit(Type<ba::Bca>());
    case Method::SFA:
      return visit(Type<ba::Spiral_fat_arc>());
    case Method::BILENS:
      return visit(Type<ba::Bilens>());
    case Method::FAT_ARC:
      return visit(Type<ba::Three_point_fat_arc>());
    case Method::FAT_BIARC:
      return visit(Type<ba::Fat_biarc>());
    case Method::BOX:
      return visit(Type<ba::Axis_box>());
    case Method::ORIENTED_BOX:
      return visit(Type<ba::Oriented_box>());
    case Method::HULL:
      break;
  }
  return visit(Type<ba::Control_hull>());
}

// Halvings of a segment that are left out, as more than the first term counts, and those that the slope is fitted over.
constexpr int COARSE = 12, FITTED = 13;

template <class Construction> std::optional<Fitted_order> fitted_order(const ba::Bezier_spiral_2<double>& spiral) {
  const double length = spiral.last() - spiral.first(), middle = spiral.first() + length / 2;
  const auto sizes = ba::piece_sizes(Construction(), spiral, middle, std::ldexp(length, -COARSE), FITTED);
  const auto is_usable = [](const ba::Piece_size& s) { return s.size > 0 && s.thickness > 0; };
  if (sizes.size() < 2 || !std::all_of(sizes.begin(), sizes.end(), is_usable)) return std::nullopt;
  return Fitted_order{ba::convergence_order(sizes), sizes.back().size, sizes.front().size};
}

}  // namespace

std::unique_ptr<Curve_hierarchy> build_yardstick(Method method, const Spirals& spirals, double eps,
                                                 const ba::Build_options& options) {
  return with_construction(method, [&](auto type) -> std::unique_ptr<Curve_hierarchy> {
    using Construction = typename decltype(type)::type;
    if constexpr (ba::has_outline_v<Construction>) {
      using Traits = ba::Bounding_region_traits_2<Circular<CGAL::Simple_cartesian<double>>, Construction>;
      using Tree = ba::Region_hierarchy_2<Traits, ba::Bezier_spiral_2<double>>;
      return std::make_unique<Hierarchy_of<Tree>>(spirals, eps, options);
    } else {
      throw std::logic_error(std::string(name_of(method)) + " is no yardstick");
    }
  });
}

std::vector<Fitted_order> fitted_orders(Method method, const Spirals& spirals) {
  std::vector<Fitted_order> orders;
  for (const auto& spiral : spirals)
    if (!spiral.is_straight())
      if (const auto order =
              with_construction(method, [&](auto type) { return fitted_order<typename decltype(type)::type>(spiral); }))
        orders.push_back(*order);
  return orders;
}

}  // namespace bounding_arcs_tool::detail
