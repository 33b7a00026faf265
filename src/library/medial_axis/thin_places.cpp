// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/thin_places.h.

#include <CGAL/Bounding_arcs_2/medial_axis/thin_places.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include "Axis_editor.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL::Bounding_arcs {

namespace {

/// An axis without what runs into corners: steps from ends along which radii rise by that share of the way or more.
[[nodiscard]] Medial_axis_2 without_corners(Medial_axis_2 axis, double rise, double room) {
  internal::Axis_editor editor(std::move(axis));
  editor.shorten([&](const Medial_axis_2::Edge& e, bool) {
    const auto& samples = e.samples;
    const auto rises = [&](const Medial_axis_2::Sample& s, const Medial_axis_2::Sample& t) {
      return t.radius - s.radius + room >= rise * euclidean_norm(t.center - s.center);
    };
    std::size_t first = 0;
    while (first + 1 < samples.size() && rises(samples[first], samples[first + 1])) ++first;
    return first;
  });
  return std::move(editor).edited();
}

[[nodiscard]] std::vector<Medial_axis_2::Thin_stretch> stretches_of(Medial_axis_2 axis) {
  internal::Axis_editor editor(std::move(axis));
  for (std::size_t v = 0; v < editor.axis().vertices.size(); ++v) editor.pass(v);
  Medial_axis_2 ways = std::move(editor).edited();
  std::vector<Medial_axis_2::Thin_stretch> result;
  const std::vector<std::size_t> degree = ways.degrees();
  for (std::size_t v = 0; v < degree.size(); ++v)
    if (degree[v] == 0) result.push_back({{internal::disc_of(ways.vertices[v])}, 0, 0});
  const auto is_smaller = [](const Medial_axis_2::Sample& s, const Medial_axis_2::Sample& t) {
    return s.radius < t.radius;
  };
  for (Medial_axis_2::Edge& e : ways.edges) {
    const auto least = std::min_element(e.samples.begin(), e.samples.end(), is_smaller) - e.samples.begin();
    const double length = internal::length_of(e.samples);
    result.push_back({std::move(e.samples), static_cast<std::size_t>(least), length});
  }
  return result;
}

}  // namespace

std::vector<Medial_axis_2::Thin_stretch> thin_stretches(const Medial_axis_2& axis, double limit, double corner) {
  constexpr double HALF_TURN = 3.14159265358979323846;
  if (!(limit > 0)) throw std::invalid_argument(expected("limit", "a length above 0", limit));
  if (!(corner > 0 && corner <= HALF_TURN))
    throw std::invalid_argument(expected("corner", "an angle above 0 and at most pi", corner));
  constexpr double SAME = 0x1p-20;  // radians: corners of this angle are told by rounded discs
  constexpr double ROOM = 0x1p-40;  // of the size: what discs are checked within
  const internal::Unit unit = internal::unit_of(axis);
  Medial_axis_2 scaled = internal::in(unit, axis);
  double size = 0;
  for (const Medial_axis_2::Vertex& v : scaled.vertices)
    size = (std::max)({size, std::fabs(v.center.x) + v.radius, std::fabs(v.center.y) + v.radius});
  const double room = ROOM * size, most = unit.in(limit) / 2;
  scaled = without_corners(std::move(scaled), std::sin((std::max)(corner - SAME, 0.0) / 2), room);
  std::vector<Medial_axis_2::Thin_stretch> result =
      stretches_of(internal::with_discs_up_to(most - room, most, std::move(scaled)));
  for (Medial_axis_2::Thin_stretch& stretch : result) {
    stretch.length = unit.out(stretch.length);
    for (Medial_axis_2::Sample& s : stretch.samples) s.center = unit.out(s.center), s.radius = unit.out(s.radius);
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Medial_axis_2::Thin_stretch& a, const Medial_axis_2::Thin_stretch& b) {
                     return a.disc().radius < b.disc().radius;
                   });
  return result;
}

std::vector<Medial_axis_2::Neck> necks(const Medial_axis_2& axis, double least_prominence) {
  struct Disc {
    double radius;
    std::size_t edge, sample, steps;
  };
  struct Step {
    std::size_t from, to;
    double radius;  // the larger one
  };
  std::vector<Disc> discs;  // vertices, then the samples between them
  std::vector<Step> steps;
  for (const Medial_axis_2::Vertex& v : axis.vertices) discs.push_back({v.radius, 0, 0, 0});
  for (std::size_t e = 0; e < axis.edges.size(); ++e) {
    const Medial_axis_2::Edge& edge = axis.edges[e];
    for (std::size_t i = 0, before = edge.from; i < edge.samples.size(); ++i) {
      const bool is_first = i == 0, is_last = i + 1 == edge.samples.size();
      const std::size_t disc = is_first ? edge.from : (is_last ? edge.to : discs.size());
      if (disc == discs.size()) discs.push_back({edge.samples[i].radius, e, i, 0});
      discs[disc].edge = e, discs[disc].sample = i;
      if (is_first) continue;
      ++discs[before].steps, ++discs[disc].steps;
      steps.push_back({before, disc, (std::max)(discs[before].radius, discs[disc].radius)});
      before = disc;
    }
  }
  std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.radius < b.radius; });

  std::vector<Medial_axis_2::Neck> result;
  const double least = (std::max)(least_prominence, axis.eps);
  const auto end_pool = [&](std::size_t bottom, double prominence) {
    const Disc& disc = discs[bottom];
    if (disc.steps > 1 && prominence > least)
      result.push_back({axis.edges[disc.edge].samples[disc.sample], disc.edge, prominence});
  };
  boost::disjoint_sets_with_storage<> pools(discs.size());
  std::vector<std::size_t> bottom(discs.size());  // of the pool that is found by this disc
  std::iota(bottom.begin(), bottom.end(), std::size_t(0));
  for (const Step& step : steps) {
    const std::size_t a = pools.find_set(step.from), b = pools.find_set(step.to);
    if (a == b) continue;
    const bool is_first_lower =
        std::pair(discs[bottom[a]].radius, bottom[a]) < std::pair(discs[bottom[b]].radius, bottom[b]);
    const std::size_t lower = bottom[is_first_lower ? a : b], higher = bottom[is_first_lower ? b : a];
    end_pool(higher, step.radius - discs[higher].radius);
    pools.link(a, b);
    bottom[pools.find_set(a)] = lower;
  }
  for (std::size_t i = 0; i < discs.size(); ++i)
    if (pools.find_set(i) == i) end_pool(bottom[i], std::numeric_limits<double>::infinity());
  std::stable_sort(result.begin(), result.end(), [](const Medial_axis_2::Neck& a, const Medial_axis_2::Neck& b) {
    return a.disc.radius < b.disc.radius;
  });
  return result;
}

}  // namespace CGAL::Bounding_arcs
