// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An axis that is taken into a unit and back (curve/Unit.h), shortened from its leaves, parted and joined.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_EDITOR_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_EDITOR_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// The unit of an axis, as that of a drawing.
[[nodiscard]] inline Unit unit_of(const Medial_axis_2& axis) {
  double size = 0;
  for (const Medial_axis_2::Vertex& v : axis.vertices)
    size = (std::max)({size, std::fabs(v.center.x), std::fabs(v.center.y), v.radius});
  for (const Medial_axis_2::Edge& e : axis.edges)
    for (const Medial_axis_2::Sample& s : e.samples)
      size = (std::max)({size, std::fabs(s.center.x), std::fabs(s.center.y), s.radius});
  return Unit::of_size(size);
}

template <class Lengths, class Bounds>
[[nodiscard]] Medial_axis_2 with_lengths(Medial_axis_2 axis, const Lengths& scaled, const Bounds& bounds) {
  for (Medial_axis_2::Vertex& v : axis.vertices)
    v.center = {scaled(v.center.x), scaled(v.center.y)}, v.radius = scaled(v.radius), v.clearance = bounds(v.clearance);
  for (Medial_axis_2::Edge& e : axis.edges)
    for (Medial_axis_2::Sample& s : e.samples)
      s.center = {scaled(s.center.x), scaled(s.center.y)}, s.radius = scaled(s.radius);
  for (Xy<double>& p : axis.unresolved) p = {scaled(p.x), scaled(p.y)};
  axis.eps = bounds(Bracket{0, axis.eps}).upper;
  axis.error = bounds(Bracket{0, axis.error}).upper;
  axis.moved = bounds(Bracket{0, axis.moved}).upper;
  return axis;
}
[[nodiscard]] inline Medial_axis_2 in(const Unit& unit, Medial_axis_2 axis) {
  if (unit.is_one()) return axis;
  return with_lengths(
      std::move(axis), [&](double x) { return unit.in(x); },
      [&](const Bracket& b) {
        return Bracket{unit.in(b.lower), unit.in(b.upper)};
      });
}
[[nodiscard]] inline Medial_axis_2 out(const Unit& unit, Medial_axis_2 axis) {
  if (unit.is_one()) return axis;
  return with_lengths(
      std::move(axis), [&](double x) { return unit.out(x); }, [&](const Bracket& b) { return unit.bounds_out(b); });
}

inline void reverse(std::vector<Medial_axis_2::Sample>& samples) {
  std::reverse(samples.begin(), samples.end());
  for (Medial_axis_2::Sample& s : samples) std::swap(s.left, s.right);
}
/// The length of the lines between samples.
[[nodiscard]] inline double length_of(const std::vector<Medial_axis_2::Sample>& samples) {
  double length = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) length += euclidean_norm(samples[i].center - samples[i - 1].center);
  return length;
}
/// A vertex as a sample, with the first and the last one of the places that it touches.
[[nodiscard]] inline Medial_axis_2::Sample disc_of(const Medial_axis_2::Vertex& v) {
  Medial_axis_2::Sample disc{v.center, v.radius, {}, {}};
  if (!v.touches.empty()) disc.left = v.touches.front(), disc.right = v.touches.back();
  return disc;
}

/// Edges and vertices of an axis, of which some are taken away.
class Axis_editor {
 public:
  explicit Axis_editor(Medial_axis_2 axis)
      : axis_(std::move(axis)), at_(axis_.vertices.size()), is_edge_left_(axis_.edges.size(), true),
        is_vertex_left_(axis_.vertices.size(), true) {
    for (std::size_t i = 0; i < axis_.edges.size(); ++i)
      for (const std::size_t v : {axis_.edges[i].from, axis_.edges[i].to}) at_[v].push_back(i);
  }

  /// The axis with all that it had; vertices may be changed.
  [[nodiscard]] Medial_axis_2& axis() { return axis_; }
  [[nodiscard]] const Medial_axis_2& axis() const { return axis_; }
  [[nodiscard]] bool is_edge_left(std::size_t edge) const { return is_edge_left_[edge]; }
  [[nodiscard]] std::size_t degree(std::size_t vertex) const { return at_[vertex].size(); }

  void remove_edge(std::size_t edge) {
    is_edge_left_[edge] = false;
    for (const std::size_t v : {axis_.edges[edge].from, axis_.edges[edge].to})
      at_[v].erase(std::remove(at_[v].begin(), at_[v].end(), edge), at_[v].end());
  }
  /// Takes a vertex away with its edges.
  void remove_vertex(std::size_t vertex) {
    while (!at_[vertex].empty()) remove_edge(at_[vertex].back());
    is_vertex_left_[vertex] = false;
  }
  /// Makes one edge of two that meet in a vertex, which is none any more. One that comes back to it stays.
  /// \return the edge, if there are two
  std::optional<std::size_t> pass(std::size_t vertex) {
    if (at_[vertex].size() != 2 || at_[vertex][0] == at_[vertex][1]) return std::nullopt;
    const std::size_t first = (std::min)(at_[vertex][0], at_[vertex][1]),
                      second = (std::max)(at_[vertex][0], at_[vertex][1]);
    Medial_axis_2::Edge &e = axis_.edges[first], &f = axis_.edges[second];
    if (e.to != vertex) turn(e);
    if (f.from != vertex) turn(f);
    e.samples.insert(e.samples.end(), f.samples.begin() + 1, f.samples.end());
    e.to = f.to;
    std::replace(at_[e.to].begin(), at_[e.to].end(), second, first);
    at_[vertex].clear();
    is_edge_left_[second] = is_vertex_left_[vertex] = false;
    return first;
  }
  /// Shortens the axis from its leaves on, and from those that come of it. Where one edge is left of two or more at a
  /// vertex, that goes on as it did before.
  /// \param first tells of an edge the sample that is its leaf from now on; where that is the last one all of it goes
  /// \return vertices that are elsewhere; the brackets of their clearance are those of before
  template <class First_of> std::vector<std::size_t> shorten(const First_of& first_of) {
    std::vector<std::size_t> leaves, bases, moved;
    for (std::size_t v = 0; v < at_.size(); ++v)
      if (degree(v) == 1) leaves.push_back(v);
    while (!leaves.empty()) {
      const std::size_t leaf = leaves.back();
      leaves.pop_back();
      if (degree(leaf) != 1) continue;  // its edge is gone
      Medial_axis_2::Edge& e = axis_.edges[at_[leaf].front()];
      if (e.from != leaf) turn(e);
      const std::size_t first = first_of(e, degree(e.to) == 1);
      if (first + 1 == e.samples.size()) {
        bases.push_back(e.to);
        remove_vertex(leaf);
        if (degree(e.to) == 1) leaves.push_back(e.to);
      } else if (first > 0) {
        e.samples.erase(e.samples.begin(), e.samples.begin() + static_cast<std::ptrdiff_t>(first));
        const Medial_axis_2::Sample& s = e.samples.front();
        Medial_axis_2::Vertex& v = axis_.vertices[leaf];
        v.center = s.center, v.radius = s.radius, v.touches = {s.left, s.right};
        moved.push_back(leaf);
      }
    }
    for (const std::size_t base : bases) pass(base);
    return moved;
  }

  /// Returns what is left. Vertices come in the order of edges, and those without edges last.
  [[nodiscard]] Medial_axis_2 edited() && {
    constexpr auto NONE = static_cast<std::size_t>(-1);
    std::vector<std::size_t> number(axis_.vertices.size(), NONE);
    std::vector<Medial_axis_2::Vertex> vertices;
    const auto number_of = [&](std::size_t v) {
      if (number[v] == NONE) number[v] = vertices.size(), vertices.push_back(std::move(axis_.vertices[v]));
      return number[v];
    };
    std::size_t left = 0;
    for (std::size_t i = 0; i < axis_.edges.size(); ++i) {
      if (!is_edge_left_[i]) continue;
      if (left != i) axis_.edges[left] = std::move(axis_.edges[i]);
      Medial_axis_2::Edge& e = axis_.edges[left++];
      e.from = number_of(e.from);
      e.to = number_of(e.to);
    }
    axis_.edges.resize(left);
    for (std::size_t v = 0; v < number.size(); ++v)
      if (is_vertex_left_[v]) (void)number_of(v);
    axis_.vertices = std::move(vertices);
    return std::move(axis_);
  }

 private:
  static void turn(Medial_axis_2::Edge& e) {
    reverse(e.samples);
    std::swap(e.from, e.to);
  }

  Medial_axis_2 axis_;
  std::vector<std::vector<std::size_t>> at_;  // the edges of each vertex, one that comes back twice
  std::vector<bool> is_edge_left_, is_vertex_left_;
};

/// The place of a radius, or the last one, on the way from one sample to another one with a larger disc.
[[nodiscard]] inline Medial_axis_2::Sample sample_of(double radius, const Medial_axis_2::Sample& s,
                                                     const Medial_axis_2::Sample& t) {
  if (radius >= t.radius) return t;
  const double share = (radius - s.radius) / (t.radius - s.radius);
  const auto place = [&](const Curve_place& p, const Curve_place& q) {
    if (p.curve != q.curve || p.bezier != q.bezier) return share < 0.5 ? p : q;
    return Curve_place{p.curve, p.bezier, p.t + share * (q.t - p.t)};
  };
  return {s.center + share * (t.center - s.center), radius, place(s.left, t.left), place(s.right, t.right)};
}
/// Returns what of an axis has no larger discs.
/// \param most not less: where discs get larger, an edge ends at this radius, or at the first larger disc
[[nodiscard]] inline Medial_axis_2 with_discs_up_to(double largest, double most, Medial_axis_2 axis) {
  std::vector<Medial_axis_2::Edge> edges;
  const auto add_end = [&](Medial_axis_2::Edge& run, const Medial_axis_2::Sample& s, const Medial_axis_2::Sample& t) {
    const Medial_axis_2::Sample end = sample_of(most, s, t);
    run.samples.push_back(end);
    axis.vertices.push_back({end.center, end.radius, {end.left, end.right}, {}});
    return axis.vertices.size() - 1;
  };
  const std::size_t given = axis.vertices.size();
  for (const Medial_axis_2::Edge& e : axis.edges) {
    Medial_axis_2::Edge run{e.from, e.to, {}};
    for (std::size_t i = 0; i < e.samples.size(); ++i) {
      const Medial_axis_2::Sample& s = e.samples[i];
      if (s.radius <= largest) {
        if (i > 0 && run.samples.empty()) run.from = add_end(run, s, e.samples[i - 1]);
        run.samples.push_back(s);
      } else if (!run.samples.empty()) {
        run.to = add_end(run, e.samples[i - 1], s);
        edges.push_back(std::move(run));
        run = {0, e.to, {}};
      }
    }
    if (!run.samples.empty()) edges.push_back(std::move(run));
  }
  std::vector<std::size_t> number(axis.vertices.size());
  std::size_t kept = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (v < given && axis.vertices[v].radius > largest) continue;
    number[v] = kept;
    if (kept++ != v) axis.vertices[number[v]] = std::move(axis.vertices[v]);
  }
  axis.vertices.resize(kept);
  for (Medial_axis_2::Edge& e : edges) e.from = number[e.from], e.to = number[e.to];
  axis.edges = std::move(edges);
  return axis;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
