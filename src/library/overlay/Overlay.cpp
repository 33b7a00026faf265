// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of Overlay.h.

#include "Overlay.h"
#include "Component_rays.h"

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include "../tree/Segment_hierarchy.h"

#include <CGAL/FPU.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace CGAL::Bounding_arcs::internal {

Overlay::Overlay(const Segment_hierarchy& curves, bool at_joints) : curves_(curves), cut_(curves, at_joints) {
  if (const std::optional<Place_number>& p = cut_.undecided()) {
    const Meeting_places& places = cut_.places();
    open_at(places.bezier_of(*p), places.bracket(*p), places.bezier_of(*p ^ 1U));
    return;
  }
  find_points();
  if (!link()) return;
  trace();
  nest();
}

void Overlay::open_at(std::uint32_t bezier, const Bracket& t, std::uint32_t other) {
  open_ = {curves_.evaluator(bezier)(t.middle()).point, bezier, other};
}

std::uint32_t Overlay::vertex_at(std::uint32_t edge, bool at_start) const {
  const Cut_edge& e = cut_.edges()[edge];
  return cut_.cuts()[at_start ? e.first : e.last].vertex;
}

// A point is computed on that curve at a vertex on which it errs least, by rounding and by the width of its bracket;
// control points do not err.
void Overlay::find_points() {
  points_.resize(cut_.number_of_vertices());
  std::vector<double> error(points_.size(), std::numeric_limits<double>::infinity());
  for (const Curve_cut& c : cut_.cuts()) {
    const Bezier_evaluator& curve = curves_.evaluator(c.at.bezier);
    double own = curves_.rounding(c.at.bezier) + (c.place == NO_NUMBER ? 0 : curve.point_error());
    if (!(own < error[c.vertex])) continue;
    const Curve_jet jet = curve(c.at.t.middle());
    own += c.at.t.width() * euclidean_norm(jet.first);
    if (!(own < error[c.vertex])) continue;
    error[c.vertex] = own;
    points_[c.vertex] = jet.point;
  }
}

namespace {

// The order of edges round a vertex, counterclockwise. Directions in doubles tell it where they are apart by more than
// their errors; of those that are not, ways are compared exactly (Exact_curve.h).

/// An end of an edge.
struct Edge_end {
  std::uint32_t edge;
  bool is_start;
};
/// The direction in which an edge leaves its end, as an angle; an error of PI says that it is open.
struct Direction {
  Edge_end end;
  double angle, error;
};
using Directions = std::vector<Direction>;
constexpr double PI = 3.141592653589793, TURN = 6.283185307179586;

// The part of the edge on the Bezier piece at its end.
[[nodiscard]] Bezier_span span_at(const Cut_curves& cut, const Edge_end& end) {
  const std::vector<Bezier_span> spans = cut.spans_of(end.edge);
  return end.is_start ? spans.front() : spans.back();
}

[[nodiscard]] Direction direction_at(const Cut_curves& cut, const Edge_end& end) {
  const Bezier_span span = span_at(cut, end);
  const Bracket& range = end.is_start ? span.from : span.to;
  const Derivative_in_range along =
      derivative_in(cut.curves().evaluator(span.bezier), range, cut.curves().rounding(span.bezier));
  const double speed = euclidean_norm(along.value);
  constexpr double CERTAIN = 4, ROUNDING = 16 * HALF_ULP;
  const Xy<double> way = end.is_start ? along.value : -along.value;
  // the sine of the angle between it and the true one is at most error / speed, a quarter
  const bool is_certain = speed > CERTAIN * along.error;
  return {end, std::atan2(way.y, way.x), is_certain ? 2 * along.error / speed + ROUNDING : PI};
}

// Whether doubles do not tell q from p, the one before it.
[[nodiscard]] bool are_close(const Direction& p, const Direction& q, bool is_past_turn) {
  return q.angle - p.angle + (is_past_turn ? TURN : 0) <= p.error + q.error;
}

[[nodiscard]] Exact_way exact_way_of(const Cut_curves& cut, const Edge_end& end) {
  const Bezier_span span = span_at(cut, end);
  const Exact_parameter &from = cut.start_of(span), &to = cut.end_of(span);
  Exact_curve& curve = cut.places().curve(cut.curves(), span.bezier);
  return end.is_start ? exact_way(curve, from, to) : exact_way(curve, to, from);
}

// Ways by sector from the first one's, and within a sector by which is above.  Those that are close in directions are
// within less than half a turn; all of them are in order from anywhere.
void sort_exactly(const Cut_curves& cut, Directions::iterator first, Directions::iterator last, bool is_whole_turn) {
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  struct Exact {
    Edge_end end;
    Exact_way way;
    int sector;
  };
  std::vector<Exact> exact;
  for (auto w = first; w != last; ++w) {
    Exact_way way = exact_way_of(cut, w->end);
    const int sector = way.sector();
    exact.push_back({w->end, std::move(way), sector});
  }
  constexpr int SECTORS = 8;
  // from well before the first one, which directions tell about; or from anywhere
  const int start = is_whole_turn ? 0 : exact.front().sector + SECTORS - 2;
  const auto is_before = [&](const Exact& p, const Exact& q) {
    const int a = (p.sector - start + 2 * SECTORS) % SECTORS, b = (q.sector - start + 2 * SECTORS) % SECTORS;
    return a != b ? a < b : is_counterclockwise_of(q.way, p.way);
  };
  for (std::size_t i = 1; i < exact.size(); ++i)  // few of them: by insertion
    for (std::size_t k = i; k > 0 && is_before(exact[k], exact[k - 1]); --k) std::swap(exact[k], exact[k - 1]);
  for (const Exact& e : exact) first++->end = e.end;
}

/// Sorts ends at one vertex counterclockwise. \pre no two are of one class
/// \return false where that is not decided
[[nodiscard]] bool sort_counterclockwise(const Cut_curves& cut, std::vector<Edge_end>& ends) {
  Directions ways;
  for (const Edge_end& e : ends) ways.push_back(direction_at(cut, e));
  std::sort(ways.begin(), ways.end(), [](const Direction& p, const Direction& q) { return p.angle < q.angle; });
  const std::size_t n = ways.size();
  // One whose direction is open, as at a cusp, may be anywhere.
  const bool are_certain = std::all_of(ways.begin(), ways.end(), [](const Direction& w) { return w.error < PI; });
  std::size_t first = are_certain ? 0 : n;  // behind a gap
  while (first < n && are_close(ways[(first + n - 1) % n], ways[first], first == 0)) ++first;
  const bool has_gap = first < n;
  if (has_gap) std::rotate(ways.begin(), ways.begin() + static_cast<std::ptrdiff_t>(first), ways.end());
  for (std::size_t i = 0, j = 0; i < n; i = j) {
    for (j = has_gap ? i + 1 : n; j < n && are_close(ways[j - 1], ways[j], j == n - first);) ++j;
    if (j - i == 1) continue;
    if (cut.curves().decisions() != Decisions::EXACT) return false;
    sort_exactly(cut, ways.begin() + static_cast<std::ptrdiff_t>(i), ways.begin() + static_cast<std::ptrdiff_t>(j),
                 j - i == n);
  }
  for (std::size_t i = 0; i < n; ++i) ends[i] = ways[i].end;
  return true;
}

}  // namespace

bool Overlay::link() {
  next_.assign(2 * cut_.edges().size(), NO_NUMBER);
  for (std::uint32_t v = 0; v < cut_.number_of_vertices(); ++v)
    if (!link_at(v)) return false;
  for (std::uint32_t e = 0; e < cut_.edges().size(); ++e) {
    if (cut_.edges()[e].first != NO_NUMBER || !cut_.is_representative(e)) continue;
    const bool is_lone_point = cut_.is_point(curves_.number_of_bezier(cut_.edges()[e].curve, 0));
    for (const bool is_reversed : {false, true})
      next_[side_of(e, is_reversed)] = side_of(e, is_reversed != is_lone_point);
  }
  return true;
}

bool Overlay::link_at(std::uint32_t vertex) {
  std::vector<Edge_end> ends;
  const auto add = [&](std::uint32_t edge, bool is_start) {
    if (edge != NO_NUMBER && cut_.is_representative(edge)) ends.push_back({edge, is_start});
  };
  for (std::uint32_t i = cut_.first_at(vertex); i < cut_.first_at(vertex + 1); ++i) {
    const std::uint32_t cut = cut_.cuts_by_vertex()[i];
    add(cut_.edge_after(cut), true);
    add(cut_.edge_before(cut), false);
  }
  const std::size_t n = ends.size();
  if (n > 2 && !sort_counterclockwise(cut_, ends)) {
    const auto bezier = [&](std::size_t i) { return cut_.spans_of(ends[i].edge).front().bezier; };
    open_ = {points_[vertex], bezier(0), bezier(1)};
    return false;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Edge_end& on = ends[(i + n - 1) % n];
    next_[side_of(ends[i].edge, ends[i].is_start)] = side_of(on.edge, !on.is_start);
  }
  return true;
}

void Overlay::trace() {
  ring_.assign(next_.size(), NO_NUMBER);
  for (Edge_side first = 0; first < next_.size(); ++first) {
    if (next_[first] == NO_NUMBER || ring_[first] != NO_NUMBER) continue;
    const auto ring = static_cast<std::uint32_t>(first_of_ring_.size());
    first_of_ring_.push_back(static_cast<std::uint32_t>(sides_.size()));
    for (Edge_side s = first; ring_[s] == NO_NUMBER; s = next_[s]) {
      ring_[s] = ring;
      sides_.push_back(s);
    }
  }
  first_of_ring_.push_back(static_cast<std::uint32_t>(sides_.size()));
}

// A ray from each component.  How often a ring runs round its start, just beside the edge there:
//   once counterclockwise for that ring of each component which bounds the face that the start is in;
//   once clockwise for the outer ring of a component that the start is inside of, not for another one.
void Overlay::nest() {
  const Component_rays rays(cut_);
  const auto components = static_cast<std::uint32_t>(rays.number_of_components());
  struct Around {
    std::uint32_t component, ring;
  };
  std::vector<std::vector<Around>> around(components);
  std::vector<std::uint32_t> outer(components, NO_NUMBER);  // rings
  std::vector<int> number(number_of_rings(), 0);
  const auto component_of_ring = [&](std::uint32_t ring) {
    return rays.component_of(cut_.edges()[edge_of(sides_[first_of_ring_[ring]])].curve);
  };
  for (std::uint32_t ring = 0; ring < number_of_rings(); ++ring) outer[component_of_ring(ring)] = ring;
  for (std::uint32_t c = 0; c < components; ++c) {
    const std::optional<Edge_ray> ray = rays.from(c);
    if (!ray) {
      const auto& edges = cut_.edges();
      const auto own =
          std::find_if(edges.begin(), edges.end(), [&](const Cut_edge& e) { return rays.component_of(e.curve) == c; });
      const std::uint32_t bezier = curves_.number_of_bezier(own->curve, 0);
      return open_at(bezier, {0, 0}, bezier);
    }
    std::vector<std::uint32_t> met;
    for (const Edge_hit& h : ray->hits)
      for (const bool is_reversed : {false, true}) {
        const std::uint32_t ring = ring_[side_of(h.edge, is_reversed)];
        number[ring] += is_reversed ? -h.number : h.number;
        met.push_back(ring);
      }
    const bool is_point = outer[c] == NO_NUMBER;  // on no curve, and none itself where it is cut
    if (!is_point) outer[c] = ring_[side_of(ray->edge, !ray->starts_left)];
    for (const std::uint32_t ring : met) {
      const std::uint32_t of = component_of_ring(ring);
      if (number[ring] < -1 || number[ring] > 1)
        throw std::logic_error(
            expected("ring of edges", "to run round a point once at most", std::to_string(number[ring]) + " times"));
      if (number[ring] < 0 && of == c) outer[c] = ring;
      if (number[ring] > 0 && of != c) around[c].push_back({of, ring});
      number[ring] = 0;
    }
  }
  face_of_ring_.assign(number_of_rings(), NO_NUMBER);
  std::vector<char> is_outer(number_of_rings(), 0);
  for (const std::uint32_t ring : outer)
    if (ring != NO_NUMBER) is_outer[ring] = 1;
  for (std::uint32_t ring = 0; ring < number_of_rings(); ++ring)
    if (is_outer[ring] == 0) face_of_ring_[ring] = faces_++;
  std::vector<std::uint32_t> face_around(components, 0);
  for (std::uint32_t c = 0; c < components; ++c) {
    const Around* innermost = nullptr;
    for (const Around& a : around[c])
      if (innermost == nullptr || around[innermost->component].size() < around[a.component].size()) innermost = &a;
    if (innermost != nullptr) face_around[c] = face_of_ring_[innermost->ring];
    if (outer[c] != NO_NUMBER) face_of_ring_[outer[c]] = face_around[c];
  }
  for (std::uint32_t curve = 0; curve < curves_.drawing().curves().size(); ++curve)
    face_around_.push_back(face_around[rays.component_of(curve)]);
  first_of_face_.assign(faces_ + 1, 0);
  for (const std::uint32_t face : face_of_ring_) ++first_of_face_[face + 1];
  for (std::size_t f = 0; f < faces_; ++f) first_of_face_[f + 1] += first_of_face_[f];
  rings_.resize(number_of_rings());
  std::vector<std::uint32_t> next(first_of_face_.begin(), first_of_face_.end() - 1);
  for (const char pass : {0, 1})  // outer boundaries of faces first
    for (std::uint32_t ring = 0; ring < number_of_rings(); ++ring)
      if (is_outer[ring] == pass) rings_[next[face_of_ring_[ring]]++] = ring;
}

}  // namespace CGAL::Bounding_arcs::internal
