// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "peer.h"

#include <CGAL/Arr_Bezier_curve_traits_2.h>
#include <CGAL/CORE_algebraic_number_traits.h>
#include <CGAL/Cartesian.h>

#include <boost/variant.hpp>

#include <exception>
#include <iterator>
#include <utility>

namespace bounding_arcs_benchmark {
namespace {

using Numbers = CGAL::CORE_algebraic_number_traits;
using Rational_kernel = CGAL::Cartesian<Numbers::Rational>;
using Traits = CGAL::Arr_Bezier_curve_traits_2<Rational_kernel, CGAL::Cartesian<Numbers::Algebraic>, Numbers>;
using Part = Traits::X_monotone_curve_2;

std::vector<Part> monotone_parts(const Traits& traits, const std::vector<Point>& controls) {
  std::vector<Rational_kernel::Point_2> points;
  for (const Point& p : controls) points.emplace_back(Numbers::Rational(p.x), Numbers::Rational(p.y));
  const Traits::Curve_2 curve(points.begin(), points.end());
  std::vector<boost::variant<Traits::Point_2, Part>> objects;
  traits.make_x_monotone_2_object()(curve, std::back_inserter(objects));
  std::vector<Part> parts;
  for (const auto& object : objects)
    if (const Part* part = boost::get<Part>(&object)) parts.push_back(*part);
  return parts;
}

double intersections(const std::vector<Point>& a, const std::vector<Point>& b) {
  const Traits traits;  // with no memory of what was asked before
  std::vector<boost::variant<std::pair<Traits::Point_2, Traits::Multiplicity>, Part>> found;
  const std::vector<Part> parts_a = monotone_parts(traits, a), parts_b = monotone_parts(traits, b);
  for (const Part& p : parts_a)
    for (const Part& q : parts_b) traits.intersect_2_object()(p, q, std::back_inserter(found));
  return static_cast<double>(found.size());
}

}  // namespace

Peers cgal_bezier_peers(const Peer_cases& cases) {
  constexpr std::size_t FEW = 200;
  const Answer answer = [&cases](std::size_t i) {
    const auto& c = cases.cubics[i];
    try {
      return intersections({c.a.begin(), c.a.end()}, {c.b.begin(), c.b.end()});
    } catch (const std::exception&) {
      return NO_ANSWER;  // an assertion, say
    }
  };
  return {{"CGAL, Bezier traits", CUBICS, answer, FEW}};
}

}  // namespace bounding_arcs_benchmark
