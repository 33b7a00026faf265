// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "dxf_entity_curves.h"

#include "Dxf_digits.h"
#include "Input_text.h"
#include "dxf_hatch.h"
#include "dxf_multiline.h"
#include "fit_spline.h"

#include <CGAL/Bounding_arcs_2/curve/B_spline_curve_2.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>

namespace bounding_arcs_tool {
namespace {

using CGAL::Bounding_arcs::B_spline_curve_2;

constexpr int CLOSED = 1;  // of group 70 of polylines

double radius(double r) {
  if (r == 0) throw Dxf_left_out("radius 0");
  if (r < 0) throw Dxf_left_out("radius below 0");
  return r;
}

// What stands in coordinates of its own plane.
Dxf_curve placed(const Dxf_item& item, const Dxf_curve& curve) {
  return transformed(curve, svg_scaling(is_seen_from_below(item) ? -1 : 1, 1));
}

// Ends of a LINE are in the world's coordinates, whatever its extrusion.
Dxf_curve line(const Dxf_item& item) { return polyline_curve({{point(item, 10), 0}, {point(item, 11), 0}}, false); }

constexpr double TURN = 360;

// What is told of a range that was made a turn; as many digits as that are rounding of radians that are whole turns.
std::string fault_of_range(double from, double to, double read_as) {
  constexpr double ROUNDING = 1e-9;
  const double off = std::fabs(read_as - from - std::fabs(to - from));
  return off > ROUNDING && read_as == from + TURN ? "nearly a full turn, read as one" : "";
}

Dxf_curve circular(const Dxf_item& item, double from, double to) {
  const double r = radius(item.real(40));
  const Xy<double> center = point(item, 10);
  return placed(item, conic_curve({r, 0, 0, r, center.x, center.y}, from, to));
}

Dxf_drawn arc(const Dxf_item& item) {
  const double from = item.real(50), to = item.real(51);
  const double end = end_of_range(from, to, last_place_of_angles(item, 50, 51));
  return {{circular(item, from, end)}, fault_of_range(from, to, end)};
}

// Center and axis are in the world's coordinates; seen from below it runs clockwise.
Dxf_drawn ellipse(const Dxf_item& item) {
  constexpr double DEGREES = 57.295779513082320877;
  const Xy<double> center = point(item, 10), axis = point(item, 11);
  const double ratio = item.real(40) * (is_seen_from_below(item) ? -1 : 1);
  if ((axis.x == 0 && axis.y == 0) || ratio == 0) throw Dxf_left_out("an axis of length 0");
  const double from = item.real(41, 0) * DEGREES, to = item.real(42, TURN / DEGREES) * DEGREES;
  const double end = end_of_range(from, to, last_place_of_angles(item, 41, 42) * DEGREES);
  return {{conic_curve({axis.x, axis.y, -ratio * axis.y, ratio * axis.x, center.x, center.y}, from, end)},
          fault_of_range(from, to, end)};
}

// Vertices of a light polyline follow each other among its groups.
Dxf_drawn light_polyline(const Dxf_item& item) {
  std::vector<Dxf_vertex> vertices;
  std::size_t heights = 0;
  for (const Dxf_group& group : item.groups) {
    if (group.code == 10) vertices.push_back({{real_value(group), 0}, 0});
    if (vertices.empty()) continue;
    if (group.code == 20) vertices.back().point.y = real_value(group), ++heights;
    if (group.code == 42) vertices.back().bulge = real_value(group);
  }
  if (heights != vertices.size()) throw Dxf_left_out("a vertex with x or y alone");
  const auto size = static_cast<long long>(vertices.size());
  const bool is_counted = item.integer(90, size) == size;
  return {{placed(item, polyline_curve(vertices, (item.integer(70, 0) & CLOSED) != 0))},
          is_counted ? "" : "its count of vertices is wrong"};
}

// One in space is seen from above. Vertices that a spline was made of are not on it.
Dxf_curve polyline(const Dxf_item& item, const std::vector<Dxf_item>& items) {
  constexpr int IN_SPACE = 8, MESH = 16, FACES = 64, FRAME = 16;
  const long long flags = item.integer(70, 0);
  if ((flags & MESH) != 0) throw Dxf_left_out("a mesh");
  if ((flags & FACES) != 0) throw Dxf_left_out("a mesh of faces");
  const bool is_in_space = (flags & IN_SPACE) != 0;
  std::vector<Dxf_vertex> vertices;
  for (const Dxf_item& vertex : items)
    if ((vertex.integer(70, 0) & FRAME) == 0)
      vertices.push_back({point(vertex, 10), is_in_space ? 0 : vertex.real(42, 0)});
  const Dxf_curve curve = polyline_curve(vertices, (flags & CLOSED) != 0);
  return is_in_space ? curve : placed(item, curve);
}

// The outline of a filled triangle or quadrilateral, whose last two corners are told in the order of its diagonals.
Dxf_curve solid(const Dxf_item& item) {
  std::vector<Dxf_vertex> corners{{point(item, 10), 0}, {point(item, 11), 0}};
  if (item.find(13) != nullptr) corners.push_back({point(item, 13), 0});
  corners.push_back({point(item, 12), 0});
  return placed(item, polyline_curve(corners, true));
}

Dxf_drawn hatch(const Dxf_item& item) {
  Dxf_drawn drawn{dxf_hatch(item), ""};
  for (Dxf_curve& curve : drawn.curves) curve = placed(item, curve);
  return drawn;
}

struct Dxf_spline {
  std::size_t degree = 0;
  std::vector<double> knots, weights;
  std::vector<Xy<double>> points;
};

// A weight and how many points stand in front of it.
struct Dxf_weight {
  double value;
  std::size_t points;
};

// Weights are there for all points, in any place, or behind those that have one; others are 1.
std::vector<double> weights_of(const std::vector<Dxf_weight>& given, std::size_t count) {
  const bool is_of_all = given.size() == count;
  std::vector<double> weights(count, 1);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const bool is_behind_one = given[i].points > 0 && (i == 0 || given[i - 1].points < given[i].points);
    if (!is_of_all && !is_behind_one) throw Dxf_left_out("a wrong number of weights");
    const double w = given[i].value;
    if (!(w >= 1 / MAXIMUM_WEIGHT && w <= MAXIMUM_WEIGHT)) throw Dxf_left_out("a weight that is not above 0, or huge");
    weights[is_of_all ? i : given[i].points - 1] = w;
  }
  return weights;
}

Dxf_spline spline_groups(const Dxf_item& item) {
  constexpr long long LARGEST_DEGREE = 32;
  Dxf_spline spline;
  const long long degree = item.integer(71, 0);
  if (degree < 1 || degree > LARGEST_DEGREE) throw Dxf_left_out("no degree from 1 to 32");
  spline.degree = static_cast<std::size_t>(degree);
  std::size_t heights = 0;
  std::vector<Dxf_weight> weights;
  std::vector<Xy<double>>& points = spline.points;
  for (const Dxf_group& group : item.groups) {
    if (group.code == 40) spline.knots.push_back(real_value(group));
    if (group.code == 10) points.push_back({real_value(group), 0});
    if (group.code == 20 && !points.empty()) points.back().y = real_value(group), ++heights;
    if (group.code == 41) weights.push_back({real_value(group), points.size()});
  }
  if (points.empty()) throw Dxf_left_out("no control points");
  if (heights != points.size()) throw Dxf_left_out("a control point with x or y alone");
  if (spline.knots.size() != points.size() + spline.degree + 1) throw Dxf_left_out("a wrong number of knots");
  spline.weights = weights_of(weights, points.size());
  return spline;
}

// A direction that may be there; 0 0 stands for none.
std::optional<Xy<double>> tangent(const Dxf_item& item, int x) {
  if (item.find(x) == nullptr) return std::nullopt;
  const Xy<double> t = point(item, x);
  const double length = std::hypot(t.x, t.y);
  if (!(length > 0)) return std::nullopt;
  return 1 / length * t;
}

// Points that a spline without control points runs through.
Dxf_curve spline_through(const Dxf_item& item) {
  constexpr int FIT_X = 11, FIT_Y = 21, START = 12, END = 13;
  std::vector<Xy<double>> points;
  std::size_t heights = 0;
  for (const Dxf_group& group : item.groups) {
    if (group.code == FIT_X) points.push_back({real_value(group), 0});
    if (group.code == FIT_Y && !points.empty()) points.back().y = real_value(group), ++heights;
  }
  if (heights != points.size()) throw Dxf_left_out("a fit point with x or y alone");
  return fit_spline(std::move(points), tangent(item, START), tangent(item, END), (item.integer(70, 0) & CLOSED) != 0);
}

Dxf_curve spline_part(const Dxf_spline& spline, std::size_t first, std::size_t end) {
  const auto part = [&](const auto& all, std::size_t more) {
    using Items = std::decay_t<decltype(all)>;
    const auto at = [&](std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(i); };
    return Items(at(first), at(end + more));
  };
  std::vector<double> weights = part(spline.weights, 0);
  const bool is_rational = std::any_of(weights.begin(), weights.end(), [&](double w) { return w != weights.front(); });
  if (!is_rational) weights.clear();
  return B_spline_curve_2<double>(static_cast<int>(spline.degree), part(spline.points, 0),
                                  part(spline.knots, spline.degree + 1), std::move(weights))
      .bezier_pieces();
}

// A knot that is there degree + 1 times cuts the spline: points in front of it play no part behind it.
std::vector<Dxf_curve> spline(const Dxf_item& item) {
  const Dxf_spline all = spline_groups(item);
  const std::size_t order = all.degree + 1;
  std::vector<Dxf_curve> curves;
  const auto add = [&](std::size_t first, std::size_t end) {
    if (end <= first) return;
    Dxf_curve curve = spline_part(all, first, end);
    const bool goes_on =
        !curves.empty() && curves.back().back().control_points().back() == curve.front().control_points().front();
    if (!goes_on) curves.emplace_back();
    std::move(curve.begin(), curve.end(), std::back_inserter(curves.back()));
  };
  std::size_t first = 0;  // of the knots and points of the part
  for (std::size_t i = 0, same = 0; i < all.knots.size(); i = same) {
    while (same < all.knots.size() && all.knots[same] == all.knots[i]) ++same;
    if (same - i < order) continue;
    add(first, i);
    first = same - order;
  }
  add(first, all.points.size());
  return curves;
}

Dxf_drawn drawn(const Dxf_item& entity, const std::vector<Dxf_item>& vertices) {
  if (entity.kind == "LINE") return {{line(entity)}, ""};
  if (entity.kind == "ARC") return arc(entity);
  if (entity.kind == "CIRCLE") return {{circular(entity, 0, TURN)}, ""};
  if (entity.kind == "ELLIPSE") return ellipse(entity);
  if (entity.kind == "LWPOLYLINE") return light_polyline(entity);
  if (entity.kind == "POLYLINE") return {{polyline(entity, vertices)}, ""};
  if (entity.kind == "SPLINE" && entity.find(10) == nullptr && entity.find(11) != nullptr)
    return {{spline_through(entity)}, "through fit points, interpolated by chord lengths"};
  if (entity.kind == "SPLINE") return {spline(entity), ""};
  if (entity.kind == "MLINE") return dxf_multiline(entity);
  if (entity.kind == "HATCH") return hatch(entity);
  if (entity.kind == "SOLID" || entity.kind == "TRACE") return {{solid(entity)}, ""};
  static const std::set<std::string_view> CURVELESS{"3DFACE", "ATTDEF", "ATTRIB", "DIMENSION", "IMAGE",
                                                    "MTEXT",  "POINT",  "TEXT",   "WIPEOUT"};
  throw Dxf_left_out(CURVELESS.count(entity.kind) > 0 ? "no curve" : "a kind that is not read");
}

}  // namespace

Xy<double> point(const Dxf_item& item, int x) { return {item.real(x), item.real(x + 10)}; }

bool is_seen_from_below(const Dxf_item& entity) {
  // Components of a normal come rounded. Seen at such an angle, lengths are shorter by a factor of 1 - 5e-19: far below
  // half an ulp. Ten times more would be below it, too; planes that are meant to be tilted are so by far more.
  constexpr double ASIDE = 1e-9;
  const double x = entity.real(210, 0), y = entity.real(220, 0), z = entity.real(230, 1);
  if (x == 0 && y == 0 && z == 0) throw Dxf_left_out("extrusion 0 0 0");
  if (!(std::max(std::abs(x), std::abs(y)) <= ASIDE * std::abs(z))) throw Dxf_left_out("in a tilted plane");
  return z < 0;
}

Dxf_drawn dxf_entity_curves(const Dxf_item& entity, const std::vector<Dxf_item>& vertices) {
  try {
    Dxf_drawn result = drawn(entity, vertices);
    for (const Dxf_curve& curve : result.curves)
      if (curve.empty()) throw Dxf_left_out("length 0");
    return result;
  } catch (const std::invalid_argument& error) {  // of B-splines, and of coordinates beyond what is served
    throw Dxf_left_out(error.what());
  }
}

}  // namespace bounding_arcs_tool
