// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/local_thickness.h.

#include <CGAL/Bounding_arcs_2/medial_axis/local_thickness.h>
#include "Axis_editor.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Bounding_arcs {

namespace {

constexpr std::size_t FEW = 4;  // steps of a leaf

}  // namespace

Local_thickness_2::Local_thickness_2(const Medial_axis_2& axis) : unit_(internal::unit_of(axis)) {
  const auto disc = [this](const auto& of) { return Disc{unit_.in(of.center), unit_.in(of.radius)}; };
  for (const Medial_axis_2::Vertex& v : axis.vertices) steps_.push_back({disc(v), disc(v)});
  for (const Medial_axis_2::Edge& e : axis.edges)
    for (std::size_t i = 1; i < e.samples.size(); ++i) steps_.push_back({disc(e.samples[i - 1]), disc(e.samples[i])});
  nodes_.resize(2 * steps_.size());
  if (!steps_.empty()) make(1, 0, steps_.size());
}

double Local_thickness_2::operator()(const Xy<double>& q) const {
  double best = 0;
  if (!steps_.empty()) look_at(1, 0, steps_.size(), unit_.in(q), best);
  return unit_.out(2 * best);
}

void Local_thickness_2::make(std::size_t node, std::size_t begin, std::size_t end) {
  constexpr double INFINITE = std::numeric_limits<double>::infinity();
  Node n{INFINITE, -INFINITE, INFINITE, -INFINITE, 0};
  for (std::size_t i = begin; i < end; ++i)
    for (const Disc& d : {steps_[i].from, steps_[i].to}) {
      n.x_low = (std::min)(n.x_low, d.center.x - d.radius), n.x_high = (std::max)(n.x_high, d.center.x + d.radius);
      n.y_low = (std::min)(n.y_low, d.center.y - d.radius), n.y_high = (std::max)(n.y_high, d.center.y + d.radius);
      n.most = (std::max)(n.most, d.radius);
    }
  if (node >= nodes_.size()) nodes_.resize(2 * node);
  nodes_[node] = n;
  if (end - begin <= FEW) return;
  const bool is_wide = n.x_high - n.x_low > n.y_high - n.y_low;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return steps_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](const Step& a, const Step& b) {
    return is_wide ? a.from.center.x < b.from.center.x : a.from.center.y < b.from.center.y;
  });
  make(2 * node, begin, middle);
  make(2 * node + 1, middle, end);
}

// The largest radius between both discs that covers q, or 0: where |q - c|^2 = r^2 on the way from the larger one.
double Local_thickness_2::radius(const Step& step, const Xy<double>& q) {
  const bool is_first = step.from.radius >= step.to.radius;
  const Disc &large = is_first ? step.from : step.to, &small = is_first ? step.to : step.from;
  if (large.covers(q)) return large.radius;
  const Xy<double> way = small.center - large.center, off = q - large.center;
  const double fall = large.radius - small.radius;
  // a t^2 - 2 b t + c <= 0
  const double a = dot(way, way) - fall * fall, b = dot(way, off) - large.radius * fall,
               c = dot(off, off) - large.radius * large.radius, discriminant = b * b - a * c;
  if (b > 0 && discriminant >= 0) {
    const double t = c / (b + std::sqrt(discriminant));  // the first of both zeros
    if (t <= 1) return large.radius - t * fall;
  }
  return small.covers(q) ? small.radius : 0;
}

void Local_thickness_2::look_at(std::size_t node, std::size_t begin, std::size_t end, const Xy<double>& q,
                                double& best) const {
  const Node& n = nodes_[node];
  if (!(n.most > best) || q.x < n.x_low || q.x > n.x_high || q.y < n.y_low || q.y > n.y_high) return;
  if (end - begin <= FEW) {
    for (std::size_t i = begin; i < end; ++i) best = (std::max)(best, radius(steps_[i], q));
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const bool is_second_larger = nodes_[2 * node + 1].most > nodes_[2 * node].most;
  if (is_second_larger) look_at(2 * node + 1, middle, end, q, best);
  look_at(2 * node, begin, middle, q, best);
  if (!is_second_larger) look_at(2 * node + 1, middle, end, q, best);
}

}  // namespace CGAL::Bounding_arcs
