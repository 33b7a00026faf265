// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pairs of closed drawings that differ by rounding, as programs make them: tiles at i w + w, copies that were turned
// and turned back, corners an ulp from where they belong, results that were read again.

#ifndef BOUNDING_ARCS_TEST_NUDGED_DRAWINGS_H
#define BOUNDING_ARCS_TEST_NUDGED_DRAWINGS_H

#include "closed_drawings.h"

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <random>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

struct Drawing_pair {
  Lattice_drawing a, b;
};

inline bool one_in(std::mt19937& random, unsigned n) { return random() % n == 0; }
/// A whole number from low to high.
inline int whole(std::mt19937& random, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(random);
}
template <class List> const auto& one_of(std::mt19937& random, const List& list) {
  return list[random() % std::size(list)];
}

/// A number that many drawings are multiples of; hardly any of those is a double.
inline double random_unit(std::mt19937& random) {
  constexpr double UNITS[] = {0.1, 1.0 / 3, 0.74, 3.7};
  return one_of(random, UNITS);
}

/// x, so many ulp away. Next to 0 an ulp is that of 1, as sums have it, or hardly anything.
inline double moved_by_ulps(std::mt19937& random, double x, int ulps) {
  if (x == 0) return ulps * (one_in(random, 4) ? 0x1p-200 : 0x1p-52);
  for (int i = 0; i < std::abs(ulps); ++i) x = std::nextafter(x, ulps < 0 ? -HUGE_VAL : HUGE_VAL);
  return x;
}
inline CGAL::Bounding_arcs::Xy<double> nudged(std::mt19937& random, const CGAL::Bounding_arcs::Xy<double>& p,
                                              int most = 2) {
  const double x = moved_by_ulps(random, p.x, whole(random, -most, most));
  return {x, moved_by_ulps(random, p.y, whole(random, -most, most))};
}

/// Maps all control points. Those that pieces share are mapped once, so that chains stay closed.
template <class Map> std::vector<Lattice_curve> mapped_chain(const std::vector<Lattice_curve>& chain, const Map& map) {
  std::vector<Lattice_curve> result;
  const auto start = map(chain.front().control_points().front());
  auto last = start;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    Lattice_points points = chain[i].control_points();
    points.front() = last;
    for (std::size_t k = 1; k + 1 < points.size(); ++k) points[k] = map(points[k]);
    points.back() = last = i + 1 == chain.size() ? start : map(points.back());
    result.emplace_back(std::move(points), chain[i].weights());
  }
  return result;
}
template <class Map> Lattice_drawing mapped(const Lattice_drawing& drawing, const Map& map) {
  Lattice_drawing result;
  for (const auto& curve : drawing.curves()) result.add(mapped_chain(curve.beziers, map), curve.name);
  return result;
}
inline Lattice_drawing nudged(std::mt19937& random, const Lattice_drawing& drawing, int most = 2) {
  return mapped(drawing, [&](const auto& p) { return nudged(random, p, most); });
}
inline Lattice_drawing placed(const Lattice_drawing& drawing, const Placing& at) {
  return mapped(drawing, [&](const auto& p) { return at(p.x, p.y); });
}
inline void add_all(Lattice_drawing& drawing, const Lattice_drawing& others) {
  for (const auto& curve : others.curves()) drawing.add(curve.beziers, curve.name);
}

/// Another drawing on the same lattice, or one of the same pieces, some of them cut.
inline Lattice_drawing lattice_partner(std::mt19937& random, const Lattice_drawing& drawing) {
  switch (random() % 3) {
    case 0:
      return random_lattice_drawing(random, 3);
    case 1:
      return drawing;
    default:
      return related_drawing(drawing, random, 3, true);
  }
}

/// Nothing is rounded, and all that is common is exactly that.
inline Drawing_pair whole_pair(std::mt19937& random) {
  const Lattice_drawing a = random_lattice_drawing(random, 3);
  return {a, one_in(random, 2) ? random_lattice_drawing(random, 3) : related_drawing(a, random, 3, false)};
}
inline Drawing_pair lattice_pair(std::mt19937& random, const Placing& at = {}) {
  const Lattice_drawing a = random_lattice_drawing(random, 3), b = lattice_partner(random, a);
  const Lattice_drawing placed_a = placed(a, at), placed_b = placed(b, at);
  const Lattice_drawing nudged_a = nudged(random, placed_a);
  return {nudged_a, nudged(random, placed_b)};
}
inline Drawing_pair scaled_pair(std::mt19937& random) {
  const double unit = random_unit(random);
  return lattice_pair(random, {unit});
}

/// Details of a thousandth, a million away.
inline Drawing_pair far_pair(std::mt19937& random) {
  const Placing far{1e-3 * random_unit(random), 1e6, one_in(random, 2) ? -1e6 : 1e6 / 3};
  return lattice_pair(random, far);
}

/// A fraction that tiles are wide: 1/10, 37/50.
struct Tile_width {
  int over, under;
  [[nodiscard]] double value() const { return double(over) / under; }
};
inline Tile_width random_width(std::mt19937& random) {
  constexpr Tile_width WIDTHS[] = {{1, 10}, {1, 3}, {37, 50}, {37, 10}, {1, 7}, {3, 10}};
  return one_of(random, WIDTHS);
}
/// i times a width, in one of the ways that programs have to it.
inline double tile_corner(std::mt19937& random, int i, const Tile_width& width) {
  const double w = width.value();
  double sum = 0;
  switch (random() % 5) {
    case 0:
      return i * w;
    case 1:
      return (i - 1) * w + w;
    case 2:
      return (i - 2) * w + 2 * w;
    case 3:
      for (int k = 0; k < i; ++k) sum += w;
      return sum;
    default:
      return double(i * width.over) / width.under;
  }
}
inline std::vector<Lattice_curve> tile(std::mt19937& random, int i, int j, int columns, int rows,
                                       const Tile_width& width) {
  const double left = tile_corner(random, i, width), low = tile_corner(random, j, width),
               right = tile_corner(random, i + columns, width), high = tile_corner(random, j + rows, width);
  Lattice_points corners{{left, low}, {right, low}, {right, high}, {left, high}};
  if (one_in(random, 8)) std::reverse(corners.begin(), corners.end());
  return polygon(corners);
}
/// Some tiles of two columns and five rows, and others of them, some larger.
inline Drawing_pair tile_pair(std::mt19937& random) {
  const Tile_width width = random_width(random);
  const int first = whole(random, 0, 6);
  Drawing_pair pair;
  for (Lattice_drawing* drawing : {&pair.a, &pair.b})
    for (int k = whole(random, 1, 4); k > 0; --k) {
      const int size = one_in(random, 4) ? 2 : 1, i = first + whole(random, 0, 2 - size),
                j = first + whole(random, 0, 5 - size);
      drawing->add(tile(random, i, j, size, size, width));
    }
  return pair;
}
/// Columns and rows of one grid, or of one with its copy.
inline Drawing_pair grid_pair(std::mt19937& random) {
  const Tile_width width = random_width(random);
  const int count = whole(random, 2, 3), first = whole(random, 0, 6);
  Drawing_pair pair;
  for (Lattice_drawing* drawing : {&pair.a, &pair.b}) {
    const bool are_columns = one_in(random, 2);
    drawing->add(tile(random, first, first, are_columns ? 1 : count, are_columns ? count : 1, width));
    for (int k = first + 1; k < first + count; ++k)
      if (!one_in(random, 4))
        drawing->add(tile(random, are_columns ? k : first, are_columns ? first : k, are_columns ? 1 : count,
                          are_columns ? count : 1, width));
  }
  return pair;
}

/// A circle, but for rounding, of rational pieces that turn by the same angle each.
/// \param pieces 2 of degree 3 with four control points each, or 3 or more of degree 2; 4 of these have 9 in all
/// \param turn where the first piece begins
inline std::vector<Lattice_curve> circle_of(int pieces, const CGAL::Bounding_arcs::Xy<double>& center, double radius,
                                            double turn) {
  constexpr double FULL = 6.283185307179586;
  const auto at = [&](double angle, double r) -> CGAL::Bounding_arcs::Xy<double> {
    return {center.x + r * std::cos(turn + angle), center.y + r * std::sin(turn + angle)};
  };
  std::vector<Lattice_curve> chain;
  const double step = FULL / pieces;
  const auto start = at(0, radius);
  auto last = start;
  for (int i = 0; i < pieces; ++i) {
    const auto next = i + 1 == pieces ? start : at((i + 1) * step, radius);
    if (pieces == 2) {
      const auto out = at((i + 0.5) * step, 2 * radius) - center;
      chain.emplace_back(Lattice_points{last, last + out, next + out, next}, std::vector<double>{3, 1, 1, 3});
    } else {
      const double half = std::cos(step / 2);
      chain.emplace_back(Lattice_points{last, at((i + 0.5) * step, radius / half), next},
                         std::vector<double>{1, half, 1});
    }
    last = next;
  }
  return chain;
}
/// A circle and another or the same one, of other pieces: about the same center, or touching from inside or outside.
inline Drawing_pair circle_pair(std::mt19937& random) {
  constexpr int PIECES[] = {2, 3, 4};
  const double unit = one_in(random, 3) ? 1 : random_unit(random);
  const CGAL::Bounding_arcs::Xy<double> center{unit * whole(random, -2, 2), unit * whole(random, -2, 2)};
  const double radius = unit * whole(random, 1, 3);
  const auto turn = [&] { return whole(random, 0, 23) * (6.283185307179586 / 24); };
  double other_radius = radius, away = 0;
  if (one_in(random, 3)) {
    other_radius = unit * whole(random, 1, 3);
    away = one_in(random, 2) ? radius + other_radius : radius - other_radius;
  }
  const double direction = turn(), turn_a = turn(), turn_b = turn();
  const CGAL::Bounding_arcs::Xy<double> other_center{center.x + away * std::cos(direction),
                                                     center.y + away * std::sin(direction)};
  Drawing_pair pair;
  pair.a.add(circle_of(one_of(random, PIECES), center, radius, turn_a));
  pair.b.add(circle_of(one_of(random, PIECES), other_center, other_radius, turn_b));
  if (one_in(random, 2)) pair.b = nudged(random, pair.b);
  if (one_in(random, 4)) add_all(pair.b, placed(random_lattice_drawing(random, 3), {unit}));
  return pair;
}

/// A lattice drawing or circle, and a copy that was turned by 90 degrees, or four times that, and maybe back.
inline Drawing_pair turned_pair(std::mt19937& random) {
  const double unit = random_unit(random);
  Lattice_drawing a = placed(random_lattice_drawing(random, 3), {unit});
  if (one_in(random, 3)) a.add(circle_of(whole(random, 2, 4), {0.5, 0.5}, unit, 0));
  constexpr double TURNS[] = {1.5707963267948966, -1.5707963267948966, 0.5235987755982988};
  const double turn = one_of(random, TURNS), x = whole(random, -2, 2) * 0.3, y = whole(random, -2, 2) * 0.7;
  const auto turned = [&](const Lattice_drawing& drawing, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return mapped(drawing, [&](const auto& p) -> CGAL::Bounding_arcs::Xy<double> {
      return {x + (c * (p.x - x) - s * (p.y - y)), y + (s * (p.x - x) + c * (p.y - y))};
    });
  };
  Lattice_drawing b = turned(a, turn);
  switch (random() % 3) {
    case 0:
      for (int k = 0; k < 3; ++k) b = turned(b, turn);
      break;
    case 1:
      break;
    default:
      b = turned(b, -turn);
  }
  return {std::move(a), std::move(b)};
}

/// Curves through the origin, of sizes up to 2^60 apart in one drawing.
inline Drawing_pair size_pair(std::mt19937& random) {
  const auto through_origin = [&](double scale) {
    const auto chain = random_lattice_chain(random, 3);
    const auto start = chain.front().control_points().front();
    return mapped_chain(chain, [&](const auto& p) {
      return CGAL::Bounding_arcs::Xy<double>{scale * (p.x - start.x), scale * (p.y - start.y)};
    });
  };
  constexpr int EXPONENTS[] = {20, 30, 45, 60};
  const double small = std::exp2(-one_of(random, EXPONENTS)), scale = one_in(random, 2) ? 1 : 1 / small;
  Drawing_pair pair;
  for (Lattice_drawing* drawing : {&pair.a, &pair.b}) {
    drawing->add(through_origin(scale));
    drawing->add(through_origin(scale * small));
  }
  if (one_in(random, 3)) pair.b = pair.a;
  if (one_in(random, 2)) pair.b = nudged(random, pair.b);
  return pair;
}

/// A drawing and itself, all of it or a single point moved by an ulp.
inline Drawing_pair ulp_pair(std::mt19937& random) {
  const double unit = one_in(random, 3) ? 1 : random_unit(random);
  const Lattice_drawing a = placed(random_lattice_drawing(random, 3), {unit});
  if (one_in(random, 2)) {
    const double x = whole(random, -1, 1) * 0x1p-52, y = whole(random, -1, 1) * 0x1p-52;
    return {a, placed(a, {1, x, y})};
  }
  const auto& chain = a.curves().front().beziers;
  const auto p = one_of(random, one_of(random, chain).control_points()), q = nudged(random, p, 1);
  return {a, mapped(a, [&](const auto& r) { return r == p ? q : r; })};
}

/// What is there already, and beside it slivers and corners smaller than points are rounded by.
inline std::vector<Lattice_curve> sliver(std::mt19937& random, double unit) {
  const auto point = [&] {
    const double x = unit * whole(random, -2, 2);
    return CGAL::Bounding_arcs::Xy<double>{x, unit * whole(random, -2, 2)};
  };
  const auto p = point(), q = point(), r = point(), beside = nudged(random, p, 8);
  switch (random() % 5) {
    case 0:  // a needle
      return polygon({p, q, beside});
    case 1:  // a line that is folded, but for an ulp
      return polygon({p, q, nudged(random, {p.x + (q.x - p.x) / 3, p.y + (q.y - p.y) / 3}, 1)});
    case 2:  // a corner cut off
      return polygon({q, p, beside, r});
    case 3:  // a hairpin
      return {Lattice_curve({p, q, beside}), Lattice_curve({beside, r}), Lattice_curve({r, p})};
    default:
      return {Lattice_curve({p, q, r, beside}), Lattice_curve({beside, p})};
  }
}
inline Drawing_pair sliver_pair(std::mt19937& random) {
  const double unit = one_in(random, 2) ? 1 : random_unit(random);
  Drawing_pair pair;
  pair.a.add(sliver(random, unit));
  if (one_in(random, 2)) pair.a.add(sliver(random, unit));
  if (one_in(random, 2)) {
    pair.b.add(sliver(random, unit));
  } else if (one_in(random, 2)) {
    pair.b = nudged(random, pair.a);
  } else {
    pair.b = placed(random_lattice_drawing(random, 2), {unit});
  }
  return pair;
}

/// Cusps in the middle of a cubic, and triangles with a corner or an edge there.
inline Drawing_pair cusp_pair(std::mt19937& random) {
  const double unit = random_unit(random);
  const auto cusp = [&](double x, double y) {
    const double w = unit * whole(random, 1, 3), h = unit * (one_in(random, 2) ? 1 : -1);
    const CGAL::Bounding_arcs::Xy<double> start{x - w / 2, y - 0.75 * h}, end{x + w / 2, y - 0.75 * h};
    return std::vector<Lattice_curve>{
        Lattice_curve({start, {end.x, start.y + h}, {start.x, start.y + h}, end}),
        Lattice_curve({end, {unit * whole(random, -3, 3), unit * whole(random, -3, 3)}, start})};
  };
  const double x = unit * whole(random, -2, 2), y = unit * whole(random, -2, 2);
  Drawing_pair pair;
  pair.a.add(cusp(x, y));
  if (one_in(random, 2)) {
    pair.b.add(cusp(x, y));
  } else {
    const double dx = unit * whole(random, -3, 3), dy = unit * whole(random, -3, 3);
    pair.b.add(polygon({{x - (one_in(random, 2) ? dx : 0), y - dy}, {x + dx, y + dy}, {x, unit * 4}}));
  }
  if (one_in(random, 2)) pair.b = nudged(random, pair.b, 1);
  return pair;
}

inline double moved_by_least(std::mt19937& random, double x) {
  for (int i = whole(random, 0, 2); i > 0; --i) x = std::nextafter(x, one_in(random, 2) ? -HUGE_VAL : HUGE_VAL);
  return x;
}
/// Two to four closed polygons, some of which are others. Next to 0 an ulp is the least number that there is.
inline Lattice_drawing nudged_polygons(std::mt19937& random) {
  const double unit = one_in(random, 5) ? 1 : random_unit(random);
  std::vector<Lattice_points> polygons;
  Lattice_drawing drawing;
  for (int count = whole(random, 2, 4); count > 0; --count) {
    Lattice_points corners;
    if (!polygons.empty() && one_in(random, 2)) corners = one_of(random, polygons);
    else
      for (int k = whole(random, 2, 4); k > 0; --k) {
        const double x = unit * whole(random, -4, 4);
        corners.push_back({x, unit * whole(random, -4, 4)});
      }
    polygons.push_back(corners);
    for (auto& p : corners) {
      p.x = moved_by_least(random, p.x);
      p.y = moved_by_least(random, p.y);
    }
    if (one_in(random, 2)) std::reverse(corners.begin(), corners.end());
    std::vector<Lattice_curve> sides;
    for (const Lattice_curve& side : polygon(corners))
      if (side.control_points().front() != side.control_points().back()) sides.push_back(side);
    if (!sides.empty()) drawing.add(sides);
  }
  return drawing;
}

/// A kind of pairs.
struct Nudged_kind {
  const char* name;
  Drawing_pair (*pair)(std::mt19937& random);

  friend std::ostream& operator<<(std::ostream& out, const Nudged_kind& kind) { return out << kind.name; }
};
inline constexpr Nudged_kind NUDGED_KINDS[] = {
    {"Whole", whole_pair},    {"Lattice", [](std::mt19937& random) { return lattice_pair(random); }},
    {"Scaled", scaled_pair},  {"Far", far_pair},
    {"Tiles", tile_pair},     {"Grids", grid_pair},
    {"Circles", circle_pair}, {"Turned", turned_pair},
    {"Sizes", size_pair},     {"Ulp", ulp_pair},
    {"Slivers", sliver_pair}, {"Cusps", cusp_pair},
};

}  // namespace bounding_arcs_test

#endif
