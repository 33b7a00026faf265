// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/medial_axis.h, but for clearance_path(), and of medial_axis/Medial_axis_2.h.
//
//   curves -> parts that bound regions -> boundary of segments and corners -> parts between discs -> vertices and edges

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>
#include "../query/Closest_search.h"
#include "../tree/Segment_hierarchy.h"
#include "Axis_boundary.h"
#include "Axis_builder.h"
#include "Axis_editor.h"
#include "Bounding_parts.h"
#include "near_origin.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

/// What is asked for, in the unit of the segments.
struct Asked_axis {
  Medial_axis_2::Options options;
  double eps;   // how far the axis, and its radius together, may be from the lines between samples
  double size;  // of coordinates as they were given, which tells how far curves may be moved
  Index_loop loop;
};

// What is checked of an axis that is made.

// Leaves wrong vertices and edges out, and tells where they were.
void leave_out(const std::vector<char>& is_wrong_vertex, const std::vector<char>& is_wrong_edge, Medial_axis_2& axis) {
  const auto is_any = [](const std::vector<char>& all) { return std::find(all.begin(), all.end(), 1) != all.end(); };
  if (!is_any(is_wrong_vertex) && !is_any(is_wrong_edge)) return;
  Axis_editor editor(std::move(axis));
  std::vector<Xy<double>> places;
  for (std::size_t i = 0; i < is_wrong_edge.size(); ++i) {
    if (is_wrong_edge[i] == 0) continue;
    const Medial_axis_2::Edge& e = editor.axis().edges[i];
    places.push_back(e.samples[e.samples.size() / 2].center);
    editor.remove_edge(i);
  }
  for (std::size_t i = 0; i < is_wrong_vertex.size(); ++i) {
    if (is_wrong_vertex[i] == 0) continue;
    places.push_back(editor.axis().vertices[i].center);
    editor.remove_vertex(i);
  }
  axis = std::move(editor).edited();
  axis.unresolved.insert(axis.unresolved.end(), places.begin(), places.end());
  axis.status = Medial_axis_2::Status::UNRESOLVED;
}

// Where a disc nearly touches a whole arc, places of the samples beside it are of rounding. Where those within a
// sixteenth of eps of one beside them have a curve in their disc, they have the disc of that if it touches both feet,
// as ends of curves are to have one, or are left out.
template <class Is_good, class Touches>
void leave_samples_out(const Is_good& is_good, const Touches& touches, double eps,
                       std::vector<Medial_axis_2::Sample>& samples) {
  std::size_t kept = 1;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    Medial_axis_2::Sample s = samples[i];
    const Medial_axis_2::Sample* const beside[] = {&samples[kept - 1], i + 1 < samples.size() ? &samples[i + 1] : &s};
    const auto is_near = [&](const Medial_axis_2::Sample* b) {
      return euclidean_norm(s.center - b->center) <= eps / 16;
    };
    bool is_kept = i + 1 == samples.size() || !(is_near(beside[0]) || is_near(beside[1])) || is_good(s);
    for (const Medial_axis_2::Sample* b : beside) {
      if (is_kept || !is_near(b) || !touches(*b, s.left) || !touches(*b, s.right) || !is_good(*b)) continue;
      s.center = b->center, s.radius = b->radius;
      is_kept = true;
    }
    if (is_kept) samples[kept++] = s;
  }
  samples.resize(kept);
}

// Whether a sample is far from the chord of those beside it, as places of rounding are.
[[nodiscard]] bool is_outlier(const std::vector<Medial_axis_2::Sample>& samples, std::size_t i, double eps) {
  if (i == 0 || i + 1 == samples.size()) return false;
  constexpr double FAR = 16;  // times eps; a chord over two parts is off by four times as much as one over each
  const Xy<double> a = samples[i - 1].center, way = samples[i + 1].center - a, to = samples[i].center - a;
  const double square = dot(way, way), t = square > 0 ? std::clamp(dot(to, way) / square, 0.0, 1.0) : 0;
  return euclidean_norm(to - t * way) > FAR * eps;
}

// Brackets of all vertices. Where a disc of one of these, or of any of many samples, has a curve in it, it is left out:
// what rounding may have made of decisions would be seen there. The first and the last ones of an edge are the
// vertices. The error is the most by which a vertex's disc misses one of its touches, or its center's distance from all
// curves.
void check_discs(const Segment_hierarchy& curves, const Axis_boundary& boundary, Index_loop loop, Medial_axis_2& axis) {
  constexpr double ROUNDING = 64;  // times the resolution
  const auto is_empty = [&](const Xy<double>& center, double radius, double rounding) {
    Closest_search search(curves, center, radius - rounding * boundary.resolution());
    search.search();
    return !search.result().has_value();
  };
  // samples that may be left out are to be better
  const auto is_good = [&](const Medial_axis_2::Sample& s) { return is_empty(s.center, s.radius, ROUNDING / 2); };
  const auto touches = [&](const Medial_axis_2::Sample& s, const Curve_place& p) {
    return std::fabs(euclidean_norm(point_at(curves, p) - s.center) - s.radius) <= ROUNDING / 2 * boundary.resolution();
  };
  const bool has_hidden_turns = boundary.hidden_height() > 0;
  std::vector<char> is_wrong_edge(axis.edges.size(), 0), is_wrong_vertex(axis.vertices.size(), 0);
  const auto check_edge = [&](std::size_t edge) {
    constexpr std::size_t STEP = 8;
    std::vector<Medial_axis_2::Sample>& samples = axis.edges[edge].samples;
    leave_samples_out(is_good, touches, axis.eps, samples);
    for (std::size_t i = 1; i + 1 < samples.size() && is_wrong_edge[edge] == 0; ++i) {
      const bool is_looked_at = i == 1 || i + 2 == samples.size() || i % STEP == samples.size() / 2 % STEP ||
                                has_hidden_turns || is_outlier(samples, i, axis.eps);
      if (is_looked_at && !is_empty(samples[i].center, samples[i].radius, ROUNDING)) is_wrong_edge[edge] = 1;
    }
    // beside hidden turns slopes tell less of what is between
    for (std::size_t i = 1; has_hidden_turns && i < samples.size() && is_wrong_edge[edge] == 0; ++i) {
      const Medial_axis_2::Sample &a = samples[i - 1], &b = samples[i];
      if (!is_empty(0.5 * (a.center + b.center), 0.5 * (a.radius + b.radius) - axis.eps, ROUNDING))
        is_wrong_edge[edge] = 1;
    }
  };
  for_each_by_place(
      loop, RANGE_SIZE, axis.edges.size(), [&](std::size_t i) { return axis.edges[i].samples.front().center; },
      check_edge);
  const auto check_vertex = [&](std::size_t vertex) {
    Medial_axis_2::Vertex& v = axis.vertices[vertex];
    v.clearance =
        (v.touches.empty() ? closest_point(curves, v.center) : closest_point(curves, v.center, v.touches.front()))
            ->distance;
    const bool is_known_empty = v.clearance.lower >= v.radius - ROUNDING * boundary.resolution();
    if (!is_known_empty && !is_empty(v.center, v.radius, ROUNDING)) is_wrong_vertex[vertex] = 1;
  };
  for_each_by_place(
      loop, RANGE_SIZE, axis.vertices.size(), [&](std::size_t i) { return axis.vertices[i].center; }, check_vertex);
  leave_out(is_wrong_vertex, is_wrong_edge, axis);
  for (const Medial_axis_2::Vertex& v : axis.vertices) {
    axis.error = (std::max)({axis.error, v.clearance.upper - v.radius, v.radius - v.clearance.lower});
    for (const Curve_place& p : v.touches)
      axis.error = (std::max)(axis.error, std::fabs(euclidean_norm(point_at(curves, p) - v.center) - v.radius));
  }
}

// An axis that has another number of branches than Euler's relation is not whole, whatever its discs are; and discs
// that lie in each other are not those of one.
[[nodiscard]] bool is_whole(const Medial_axis_2& axis) {
  return axis.status == Medial_axis_2::Status::COMPLETE && axis.is_valid();
}

[[nodiscard]] Medial_axis_2 axis_of(const Bounding_parts& parts, const Asked_axis& asked, double hidden) {
  const Axis_boundary boundary(parts, hidden);
  constexpr double LEAST = 0x1p-36;  // of the size: a finer polyline would be of roundings, and endless
  const double eps = (std::max)(asked.eps, LEAST * boundary.size());
  const auto made = [&](bool is_joining) {
    Medial_axis_2 axis = Axis_builder(boundary, eps, is_joining, asked.loop).build();
    axis.eps = eps;
    check_discs(parts.segments, boundary, asked.loop, axis);
    return axis;
  };
  Medial_axis_2 axis = made(false);
  constexpr double ROOM = 8;  // times the resolution: vertices miss what they touch by less
  if (is_whole(axis) && axis.error <= ROOM * boundary.resolution() + parts.moved) return axis;
  // nearly equal discs were told apart by rounding
  Medial_axis_2 joined = made(true);
  const bool is_better = is_whole(joined) && (!is_whole(axis) || joined.error < axis.error);
  return is_better ? joined : axis;
}

/// The axis, with what it was made of.
/// \param close how close walls are that meet
/// \param hidden how far curves may be beside what is seen of them, in sizes
[[nodiscard]] Medial_axis_2 bounded_axis(const Segment_hierarchy& curves, const Asked_axis& asked, double close,
                                         double hidden) {
  const auto bounds = std::make_shared<const Bounding_parts>(bounding_parts(curves, asked.options, close));
  Medial_axis_2 axis = axis_of(*bounds, asked, hidden);
  axis.moved += bounds->moved;
  if (bounds->undecided) {
    axis.status = Medial_axis_2::Status::UNRESOLVED;
    axis.unresolved = {*bounds->undecided};
  }
  axis.left_out = bounds->left_out;
  axis.options = asked.options;
  axis.bounds = bounds;
  return axis;
}

/// How curves are moved, in sizes.
struct Move {
  double by, close;                              // the latter is how close walls are that meet
  bool are_bent = false;                         // inner control points have ways of their own
  double hidden = Axis_boundary::HIDDEN_HEIGHT;  // how far curves may be beside what is seen of them
};

/// Each curve elsewhere, in a direction of its own.
[[nodiscard]] Segment_hierarchy moved_curves(const Segment_hierarchy& curves, const Move& move, double size,
                                             std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto way = [&] {
    const auto share = [&] { return 2 * (static_cast<double>(random()) / std::mt19937::max()) - 1; };
    const double x = move.by * size * share();
    return Xy<double>{x, move.by * size * share()};
  };
  Drawing_2<double> drawing;
  for (const auto& curve : curves.drawing().curves()) {
    const Xy<double> of_curve = way();
    std::vector<Bezier_curve_2<double>> beziers;
    for (const auto& b : curve.beziers) {
      std::vector<Xy<double>> points = b.control_points();
      for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = points[i] + (move.are_bent && i > 0 && i + 1 < points.size() ? way() : of_curve);
      beziers.emplace_back(std::move(points), b.weights());
    }
    drawing.add(std::move(beziers), curve.name);
  }
  return {std::make_shared<const Drawing_2<double>>(std::move(drawing)), curves.decisions()};
}

/// Where rounding left discs open, the axis is that of curves that are moved by less than is told of it: what met at
/// one place by chance, or by symmetry, meets there no more. Small moves keep close walls joined, larger ones part
/// them. Turns at ends of curves are hidden farther from these.
[[nodiscard]] Medial_axis_2 resolved_axis(const Segment_hierarchy& curves, const Asked_axis& asked) {
  constexpr Move MOVES[] = {{0x1p-43, CLOSE_WALLS},
                            {0x1p-42, 0x1p-43},
                            {0x1p-42, CLOSE_WALLS},
                            {0x1p-42, CLOSE_WALLS, true},
                            {0x1p-44, CLOSE_WALLS, false, 0x1p-42},
                            {0x1p-44, 0x1p-44, false, 0x1p-41}};
  constexpr std::size_t KINDS = sizeof(MOVES) / sizeof(*MOVES), MANY = 64, SEGMENTS = 1 << 14;  // of all tries
  const std::size_t tries =
      std::clamp(SEGMENTS / (std::max)(std::size_t{1}, std::size_t{curves.number_of_segments()}), KINDS, MANY);
  const double size = asked.size;
  Medial_axis_2 axis = bounded_axis(curves, asked, CLOSE_WALLS * size, Axis_boundary::HIDDEN_HEIGHT);
  for (std::uint32_t seed = 0; seed < tries && !is_whole(axis) && !axis.bounds->undecided; ++seed) {
    const Move& move = MOVES[seed % KINDS];
    Medial_axis_2 moved = bounded_axis(moved_curves(curves, move, size, seed), asked, move.close * size, move.hidden);
    constexpr double MOST = 0x1p-40, OF_SQUARE = 1.5;  // half its diagonal, with what rounding adds
    moved.moved += OF_SQUARE * move.by * size;
    if (is_whole(moved) && moved.moved <= MOST * size) axis = std::move(moved);
  }
  if (!is_whole(axis)) axis.status = Medial_axis_2::Status::UNRESOLVED;
  return axis;
}

}  // namespace

}  // namespace CGAL::Bounding_arcs::internal

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

Drawing_2<double> framed(Drawing_2<double> drawing, double margin) {
  const CGAL::Bbox_2 box = drawing.control_box();
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

Medial_axis_2 internal::medial_axis(const Bounding_arc_tree_2& curves, double eps,
                                    const Medial_axis_2::Options& options, Index_loop loop) {
  check_above_zero("eps", eps);
  if (options.is_framed) check_frame(curves.drawing());
  else internal::check_closed(curves.drawing());
  const Segment_hierarchy& segments = curves.in_unit();
  const double size = segments.drawing().coordinate_size();
  const Asked_axis asked{options, curves.unit().tolerance_in(eps), size, loop};
  const Xy<double> origin = segments.is_rounded() ? Xy<double>{0, 0} : near_origin(segments.drawing());
  if (origin == Xy<double>{0, 0}) return out(curves.unit(), resolved_axis(segments, asked));
  const Segment_hierarchy near(std::make_shared<const Drawing_2<double>>(moved_along(segments.drawing(), -origin)),
                               segments.decisions());
  return out(curves.unit(), moved_along(resolved_axis(near, asked), origin, size));
}

// Whether an axis is in order.

[[nodiscard]] static bool is_disc(const Xy<double>& center, double radius) {
  return std::isfinite(center.x) && std::isfinite(center.y) && std::isfinite(radius) && radius >= 0;
}
[[nodiscard]] static bool is_on_curve(const Curve_place& p) { return p.t >= 0 && p.t <= 1; }

[[nodiscard]] static bool is_valid(const Medial_axis_2::Vertex& v, double error) {
  return is_disc(v.center, v.radius) && std::all_of(v.touches.begin(), v.touches.end(), is_on_curve) &&
         v.clearance.lower <= v.clearance.upper && v.clearance.upper - v.radius <= error &&
         v.radius - v.clearance.lower <= error;
}

// No disc of an edge lies in the one before or behind it: the axis is of discs in no larger ones.
[[nodiscard]] static bool is_valid(const Medial_axis_2::Edge& e, double eps) {
  for (std::size_t i = 0; i < e.samples.size(); ++i) {
    const Medial_axis_2::Sample& s = e.samples[i];
    if (!is_disc(s.center, s.radius) || !is_on_curve(s.left) || !is_on_curve(s.right)) return false;
    if (i == 0) continue;
    const Medial_axis_2::Sample& before = e.samples[i - 1];
    if (!(std::fabs(s.radius - before.radius) <= euclidean_norm(s.center - before.center) + eps)) return false;
  }
  return e.samples.size() >= 2;
}

bool Medial_axis_2::is_valid() const {
  if (!(eps >= 0) || !(error >= 0)) return false;
  const auto is_sound = [this](const Medial_axis_2::Vertex& v) { return Bounding_arcs::is_valid(v, error); };
  if (!std::all_of(vertices.begin(), vertices.end(), is_sound)) return false;
  for (const Medial_axis_2::Edge& e : edges) {
    if (!Bounding_arcs::is_valid(e, eps) || e.from >= vertices.size() || e.to >= vertices.size()) return false;
    const auto is_at = [](const Medial_axis_2::Sample& s, const Medial_axis_2::Vertex& v) {
      return s.center == v.center && s.radius == v.radius;
    };
    if (!is_at(e.samples.front(), vertices[e.from]) || !is_at(e.samples.back(), vertices[e.to])) return false;
  }
  return status != Medial_axis_2::Status::COMPLETE || vertices.size() + holes == edges.size() + regions;
}

}  // namespace CGAL::Bounding_arcs
