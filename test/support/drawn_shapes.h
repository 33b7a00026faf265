// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shapes that people draw, as an axis finds them hard: symmetric, touching, with ends that nearly meet and fillets that
// are nearly circles.

#ifndef BOUNDING_ARCS_TEST_DRAWN_SHAPES_H
#define BOUNDING_ARCS_TEST_DRAWN_SHAPES_H

#include "machine_parts.h"
#include "near_equal_discs.h"
#include "nudged_drawings.h"

#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <random>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

/// A drawing and which axis of it.
struct Axis_case {
  Drawing drawing;
  ba::Medial_axis_2::Options options;
};

/// A whole number, or a random one of the same range.
struct Number_source {
  std::mt19937& random;
  bool is_whole;
  double operator()(int low, int high) const {
    return is_whole ? whole(random, low, high) : std::uniform_real_distribution<double>(low, high)(random);
  }
};

/// A chain whose points are turned about the origin by (c, s), then moved.
inline std::vector<Bezier> turned(const std::vector<Bezier>& chain, const Point& turn, const Point& by) {
  return mapped_chain(chain, [&](const Point& p) {
    return Point{by.x + (turn.x * p.x - turn.y * p.y), by.y + (turn.y * p.x + turn.x * p.y)};
  });
}
inline std::vector<Bezier> stretched(const std::vector<Bezier>& chain, double x, double y) {
  return mapped_chain(chain, [&](const Point& p) { return Point{x * p.x, y * p.y}; });
}
/// A circle about the origin, of exact quarters or of those that SVG and DXF readers make.
inline std::vector<Bezier> drawn_circle(std::mt19937& random, double radius) {
  if (one_in(random, 2)) return circle({0, 0}, radius);
  return circle_of(one_in(random, 2) ? 4 : whole(random, 2, 5), {0, 0}, radius, 0);
}
inline std::vector<Bezier> rectangle(double width, double height) {
  return polygon(
      {{-width / 2, -height / 2}, {width / 2, -height / 2}, {width / 2, height / 2}, {-width / 2, height / 2}});
}
/// Two half circles and two lines between them.
inline std::vector<Bezier> stadium(double length, double radius) {
  const auto quarters = circle({0, 0}, radius);
  const auto moved_by = [&](const Bezier& b, double x) {
    std::vector<Point> p;
    for (const Point& q : b.control_points()) p.push_back({q.x + x, q.y});
    return Bezier(std::move(p), b.weights());
  };
  const double x = length / 2;
  return {moved_by(quarters[0], x),  segment({x, radius}, {-x, radius}),   moved_by(quarters[1], -x),
          moved_by(quarters[2], -x), segment({-x, -radius}, {x, -radius}), moved_by(quarters[3], x)};
}
inline std::vector<Bezier> regular_polygon(int corners, double radius) {
  std::vector<Point> p;
  for (int k = 0; k < corners; ++k) {
    const double angle = 6.283185307179586 * k / corners;
    p.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return polygon(p);
}

/// A circle, square, rectangle, ellipse, stadium or regular polygon about the origin.
inline std::vector<Bezier> drawn_shape(const Number_source& number) {
  std::mt19937& random = number.random;
  switch (random() % 7) {
    case 0:
    case 1:
      return drawn_circle(random, number(1, 6));
    case 2: {
      const double side = number(1, 9);
      return rectangle(side, side);
    }
    case 3: {
      const double width = number(1, 9);
      return rectangle(width, number(1, 9));
    }
    case 4: {
      const double a = number(1, 6);
      return stretched(circle({0, 0}, 1), a, number(1, 6));
    }
    case 5: {
      const double length = number(1, 8);
      return stadium(length, number(1, 4));
    }
    default:
      return regular_polygon(whole(random, 3, 8), number(1, 6));
  }
}
/// No turn, one by 90 or 45 degrees, or one of 3, 4 and 5.
inline Point drawn_turn(const Number_source& number) {
  constexpr Point TURNS[] = {{1, 0}, {1, 0}, {0, 1}, {0.7071067811865476, 0.7071067811865476}, {0.6, 0.8}};
  if (number.is_whole) return one_of(number.random, TURNS);
  const double angle = number(0, 6);
  return {std::cos(angle), std::sin(angle)};
}

/// Two to four shapes, which cross, touch or lie in each other.
inline Drawing drawn_shapes(const Number_source& number) {
  Drawing drawing;
  for (int k = whole(number.random, 2, 4); k > 0; --k) {
    const auto shape = drawn_shape(number);
    const Point turn = drawn_turn(number);
    const double x = number(-6, 6);
    drawing.add(turned(shape, turn, {x, number(-6, 6)}));
  }
  return drawing;
}
/// Shapes about one center, or at the corners of a regular polygon, in a unit that is no double.
inline Drawing symmetric_shapes(std::mt19937& random) {
  const Number_source number{random, true};
  const double unit = one_in(random, 2) ? 1 : random_unit(random);
  const auto in_units = [&](const std::vector<Bezier>& chain) { return stretched(chain, unit, unit); };
  Drawing drawing;
  drawing.add(in_units(drawn_shape(number)));
  const auto shape = in_units(drawn_shape(number));
  const int copies = one_in(random, 3) ? 1 : whole(random, 2, 6);
  const double away = copies == 1 ? 0 : unit * whole(random, 1, 6);
  const bool are_turned = one_in(random, 2);
  for (int k = 0; k < copies; ++k) {
    const double angle = 6.283185307179586 * k / copies, c = std::cos(angle), s = std::sin(angle);
    drawing.add(turned(shape, are_turned ? Point{c, s} : Point{1, 0}, {away * c, away * s}));
  }
  return drawing;
}
/// Two circles that touch, from inside or outside, and maybe a shape more.
inline Drawing touching_circles(const Number_source& number) {
  constexpr Point WAYS[] = {{1, 0}, {0, -1}, {0.6, 0.8}, {-0.8, 0.6}, {5.0 / 13, 12.0 / 13}};
  std::mt19937& random = number.random;
  const double r = number(1, 5), s = number(1, 5), away = one_in(random, 2) ? r + s : r - s;
  const Point way = number.is_whole ? one_of(random, WAYS) : drawn_turn(number);
  Drawing drawing;
  drawing.add(drawn_circle(random, r));
  drawing.add(turned(drawn_circle(random, s), {1, 0}, away * way));
  if (one_in(random, 3)) drawing.add(drawn_shape(number));
  return drawing;
}

inline Axis_case filled(std::mt19937& random, Drawing drawing) {
  Axis_case made{std::move(drawing), {}};
  if (one_in(random, 3)) made.options.rule = ba::Fill_rule::EVEN_ODD;
  return made;
}
inline Axis_case in_frame(std::mt19937& random, const Drawing& drawing) {
  Axis_case made{ba::framed(drawing, one_in(random, 2) ? 1.0 : 0.37), {}};
  made.options.is_framed = true;
  return made;
}

/// A point, moved by 1e-16 to 1e-9 in a random direction, or not.
inline Point nearly_at(std::mt19937& random, const Point& p) {
  if (one_in(random, 4)) return p;
  std::uniform_real_distribution<double> exponent(-16, -9), angle(0, 6.3);
  const double d = 10 * std::pow(10, exponent(random)), a = angle(random);
  return {p.x + d * std::cos(a), p.y + d * std::sin(a)};
}
/// A polyline or closed polygon of lines and arcs as a CAD program writes it: each by itself, with ends that miss each
/// other.
inline Drawing loose_lines(std::mt19937& random) {
  const Number_source number{random, one_in(random, 2)};
  std::vector<Point> corners;
  for (int k = whole(random, 3, 6); k > 0; --k) {
    const double x = number(-5, 5);
    corners.push_back({x, number(-5, 5)});
  }
  const bool is_closed = one_in(random, 2);
  Drawing drawing;
  for (std::size_t i = 0; i + (is_closed ? 0 : 1) < corners.size(); ++i) {
    const Point p = nearly_at(random, corners[i]), q = nearly_at(random, corners[(i + 1) % corners.size()]);
    if (p == q) continue;
    if (one_in(random, 2)) {
      drawing.add({segment(p, q)});
    } else {  // a quarter of a circle
      const Point middle = 0.5 * (p + q), half = 0.5 * (q - p);
      drawing.add({Bezier({p, middle + Point{-half.y, half.x}, q}, {1, 0.7071067811865476, 1})});
    }
  }
  if (one_in(random, 3)) {  // an end on a line
    const double t = number(1, 8) / 9;
    const Point at = corners[0] + t * (corners[1] - corners[0]);
    const double x = number(-5, 5);
    drawing.add({segment(nearly_at(random, at), {x, number(-5, 5)})});
  }
  return drawing;
}
/// Arcs of one circle that overlap, as far as doubles have them.
inline Drawing arcs_of_a_circle(std::mt19937& random) {
  const Number_source number{random, one_in(random, 2)};
  const Point center{number(-3, 3), number(-3, 3)};
  const double radius = number(1, 5);
  Drawing drawing;
  for (int k = whole(random, 2, 3); k > 0; --k) {
    const double from = number(0, 11) * 0.5235987755982988, sweep = number(1, 5) * 0.2617993877991494,
                 to = from + sweep, half = std::cos(sweep / 2), middle = from + sweep / 2;
    const auto at = [&](double angle, double r) {
      return Point{center.x + r * std::cos(angle), center.y + r * std::sin(angle)};
    };
    drawing.add({Bezier({at(from, radius), at(middle, radius / half), at(to, radius)}, {1, half, 1})});
  }
  return drawing;
}
/// A rectangle with fillets of cubics that are nearly circles, with coordinates of so many digits.
inline Drawing rounded_rectangle(std::mt19937& random) {
  std::uniform_real_distribution<double> side(20, 200), share(0.05, 0.5), place(-50, 50);
  const int digits = whole(random, 2, 6);
  const double unit = std::pow(10, digits), w = side(random), h = side(random), x = place(random), y = place(random),
               r = share(random) * (std::min)(w, h), k = one_in(random, 2) ? 0.5522847498307936 : 0.5522847,
               c = (1 - k) * r;
  const auto at = [&](double px, double py) {
    return Point{std::round((x + px) * unit) / unit, std::round((y + py) * unit) / unit};
  };
  const Point corner[12] = {at(r, 0),     at(w - r, 0), at(w - c, 0), at(w, c), at(w, r), at(w, h - r),
                            at(w, h - c), at(w - c, h), at(w - r, h), at(r, h), at(c, h), at(0, h - c)};
  std::vector<Bezier> chain{segment(corner[0], corner[1]),   Bezier({corner[1], corner[2], corner[3], corner[4]}),
                            segment(corner[4], corner[5]),   Bezier({corner[5], corner[6], corner[7], corner[8]}),
                            segment(corner[8], corner[9]),   Bezier({corner[9], corner[10], corner[11], at(0, h - r)}),
                            segment(at(0, h - r), at(0, r)), Bezier({at(0, r), at(0, c), at(c, 0), corner[0]})};
  chain.erase(std::remove_if(chain.begin(), chain.end(),
                             [](const Bezier& b) { return b.control_points().front() == b.control_points().back(); }),
              chain.end());
  return drawing_of(chain);
}

/// An arc of at most a third of a circle, counterclockwise: as a file has it that tells ends and radius.
inline Bezier arc_of_radius(const Point& p, const Point& q, double radius) {
  const Point way = q - p;
  const double chord = std::hypot(way.x, way.y), sine = (std::min)(chord / (2 * radius), 1.0),
               cosine = std::sqrt(1 - sine * sine), rise = sine / cosine / 2;
  const Point middle{(p.x + q.x) / 2 + rise * way.y, (p.y + q.y) / 2 - rise * way.x};
  return Bezier({p, middle, q}, {1, cosine, 1});
}
/// Smooth shapes from a file with so many decimals, so that their joints turn by as little: circles, stadiums and
/// rounded rectangles of arcs, and splines through points.
inline Drawing with_decimals(std::mt19937& random) {
  constexpr double QUARTER = 1.5707963267948966;
  std::uniform_real_distribution<double> angle(0, 4 * QUARTER), place(-20, 20), size(1, 8);
  const double unit = std::pow(10, whole(random, 3, 10)), turn = angle(random), x = place(random), y = place(random);
  const auto rounded = [&](double v) { return std::round(v * unit) / unit; };
  const auto at = [&](double px, double py) {
    return Point{rounded(x + std::cos(turn) * px - std::sin(turn) * py),
                 rounded(y + std::sin(turn) * px + std::cos(turn) * py)};
  };
  std::vector<Bezier> chain;
  if (one_in(random, 3)) {
    std::vector<Point> points;
    const int n = whole(random, 3, 9);
    for (int i = 0; i < n; ++i) {
      const double to = (4 * i + place(random) / 40) * QUARTER / n, r = 3 + size(random);
      points.push_back({x + r * std::cos(to), y + r * std::sin(to)});
    }
    const auto near = [&](const Point& p) { return Point{rounded(p.x), rounded(p.y)}; };
    for (int i = 0; i < n; ++i) {
      const Point &p = points[(i + n - 1) % n], &q = points[i], &r = points[(i + 1) % n], &s = points[(i + 2) % n];
      chain.push_back(Bezier({near(q), near(q + 1 / 6.0 * (r - p)), near(r - 1 / 6.0 * (s - q)), near(r)}));
    }
    return drawing_of(chain);
  }
  const double radius = rounded(size(random)), w = one_in(random, 3) ? 0 : 3 * size(random),
               h = one_in(random, 2) ? 0 : 3 * size(random);
  const int arcs = whole(random, 1, 2);  // a quarter
  const Point corners[] = {{w, 0}, {w, h}, {0, h}, {0, 0}};
  for (int k = 0; k < 4; ++k) {
    Point from{};
    for (int i = 0; i <= arcs; ++i) {
      const double to = (k - 1 + static_cast<double>(i) / arcs) * QUARTER;
      const Point p = at(corners[k].x + radius * std::cos(to), corners[k].y + radius * std::sin(to));
      if (i > 0) chain.push_back(arc_of_radius(from, p, radius));
      else if (k > 0 && chain.back().control_points().back() != p)
        chain.push_back(segment(chain.back().control_points().back(), p));
      from = p;
    }
  }
  const Point start = chain.front().control_points().front(), end = chain.back().control_points().back();
  if (start != end) chain.push_back(segment(end, start));
  return drawing_of(chain);
}

/// Slots and rounded rectangles as programs convert them from inches or make them in the coordinates of a country: the
/// radius is short of half the width by 1e-4 to 1e-8 of it, so that straight ends as short are between quarter circles.
inline Drawing slots_with_short_ends(std::mt19937& random) {
  const auto one_of = [&](const std::vector<double>& numbers) {
    return numbers[static_cast<std::size_t>(whole(random, 0, static_cast<int>(numbers.size()) - 1))];
  };
  const double scale = std::pow(10, std::uniform_real_distribution<double>(0, 6.5)(random)),
               half = one_of({1, 2, 2.5, 3.175, 4.2333335}), length = one_of({0, 1, 5, 17.25}),
               radius = half * (1 - std::pow(10, std::uniform_real_distribution<double>(-8, -4)(random))),
               x = std::round(scale) + 0.25 * whole(random, 0, 40),
               y = std::round(scale / 2) + 0.25 * whole(random, 0, 40), right = x + length + 2 * half,
               top = y + 2 * half;
  const Point points[] = {{x + radius, y},       {right - radius, y}, {right, y + radius}, {right, top - radius},
                          {right - radius, top}, {x + radius, top},   {x, top - radius},   {x, y + radius}};
  std::vector<Bezier> chain;
  for (int i = 0; i < 8; ++i) {
    const Point &p = points[i], &q = points[(i + 1) % 8];
    if (i % 2 == 1) chain.push_back(arc_of_radius(p, q, radius));
    else if (p != q) chain.push_back(segment(p, q));
  }
  return drawing_of(chain);
}

/// Paths of cubics as they are drawn with a pen, with three decimals: handles are in their nodes, along a line or
/// anywhere, so that curves end with an endless curvature, and corners turn by little.
inline Drawing pen_paths(std::mt19937& random) {
  std::uniform_real_distribution<double> share(0, 1);
  const auto near = [](const Point& p) { return Point{std::round(p.x * 1000) / 1000, std::round(p.y * 1000) / 1000}; };
  Drawing drawing;
  for (int paths = whole(random, 1, 2); paths > 0; --paths) {
    const Point center{40 * share(random), 40 * share(random)};
    const int n = whole(random, 3, 8);
    std::vector<Point> nodes, before, behind;
    for (int i = 0; i < n; ++i) {
      const double angle = 6.283185307179586 * (i + 0.8 * share(random)) / n, r = 20 * (0.3 + share(random));
      nodes.push_back(near(center + r * Point{std::cos(angle), std::sin(angle)}));
    }
    for (int i = 0; i < n; ++i) {
      const Point &q = nodes[i], way = nodes[(i + 1) % n] - nodes[(i + n - 1) % n];
      const auto handle = [&](double sign) {
        const int kind = whole(random, 0, 3);
        if (kind < 2) return q;  // in its node
        const double length = sign * 0.4 * share(random), turn = kind == 2 ? 0 : 0.3 * (share(random) - 0.5);
        return near(q + length * Point{way.x - turn * way.y, way.y + turn * way.x});
      };
      before.push_back(handle(-1));
      behind.push_back(handle(1));
    }
    std::vector<Bezier> chain;
    for (int i = 0; i < n; ++i) {
      const int k = (i + 1) % n;
      if (behind[i] == nodes[i] && before[k] == nodes[k] && one_in(random, 2))
        chain.push_back(segment(nodes[i], nodes[k]));
      else chain.push_back(Bezier({nodes[i], behind[i], before[k], nodes[k]}));
    }
    drawing.add(std::move(chain));
  }
  return drawing;
}

/// Such paths where handles in their nodes are 10^-8 to 10^-15 of the size beside these instead: curves turn there
/// within less than coordinates tell.
inline Drawing paths_with_near_handles(std::mt19937& random) {
  std::uniform_real_distribution<double> share(0, 1);
  Drawing drawing;
  for (const auto& curve : pen_paths(random).curves()) {
    std::vector<Bezier> chain;
    for (const Bezier& piece : curve.beziers) {
      std::vector<Point> p = piece.control_points();
      const auto beside = [&](const Point& node) {
        const double angle = 6.283185307179586 * share(random), length = 6 * std::pow(10, -7 - 7 * share(random));
        return node + length * Point{std::cos(angle), std::sin(angle)};
      };
      if (p.size() == 4 && p[1] == p[0]) p[1] = beside(p[0]);
      if (p.size() == 4 && p[2] == p[3]) p[2] = beside(p[3]);
      chain.push_back(Bezier(std::move(p)));
    }
    drawing.add(std::move(chain));
  }
  return drawing;
}

/// A kind of drawings.
struct Drawn_kind {
  const char* name;
  Axis_case (*make)(std::mt19937& random);
  int proven;  ///< of a hundred axes so many at least are proven at 1e-4 of the size; 0 promises nothing

  friend std::ostream& operator<<(std::ostream& out, const Drawn_kind& kind) { return out << kind.name; }
};
template <bool IS_WHOLE> Axis_case filled_shapes(std::mt19937& random) {
  return filled(random, drawn_shapes({random, IS_WHOLE}));
}
template <bool IS_WHOLE> Axis_case framed_shapes(std::mt19937& random) {
  return in_frame(random, drawn_shapes({random, IS_WHOLE}));
}
inline Drawing any_touching_circles(std::mt19937& random) {
  const bool is_whole = one_in(random, 2);
  return touching_circles({random, is_whole});
}
inline Axis_case machine_part(std::mt19937& random) {
  Axis_case made{any_machine_part(random), {}};
  made.options.rule = ba::Fill_rule::EVEN_ODD;
  return made;
}
// Of loose lines what is left is slivers of straight sides 1e-12 apart, and vertices within rounding of others. Axes of
// drawings with decimals are right, but joints that are rounded off, and circles that are none but for 1e-9, are beyond
// the proof.
inline constexpr Drawn_kind DRAWN_KINDS[] = {
    {"Whole", filled_shapes<true>, 99},
    {"Random", filled_shapes<false>, 99},
    {"Symmetric", [](std::mt19937& random) { return filled(random, symmetric_shapes(random)); }, 99},
    {"Touching", [](std::mt19937& random) { return filled(random, any_touching_circles(random)); }, 99},
    {"FramedWhole", framed_shapes<true>, 98},
    {"FramedRandom", framed_shapes<false>, 99},
    {"FramedSymmetric", [](std::mt19937& random) { return in_frame(random, symmetric_shapes(random)); }, 99},
    {"FramedTouching", [](std::mt19937& random) { return in_frame(random, any_touching_circles(random)); }, 99},
    {"LooseLines", [](std::mt19937& random) { return in_frame(random, loose_lines(random)); }, 99},
    {"ArcsOfACircle", [](std::mt19937& random) { return in_frame(random, arcs_of_a_circle(random)); }, 99},
    {"Fillets", [](std::mt19937& random) { return filled(random, rounded_rectangle(random)); }, 99},
    {"PenPaths", [](std::mt19937& random) { return filled(random, pen_paths(random)); }, 99},
    {"NearHandles", [](std::mt19937& random) { return filled(random, paths_with_near_handles(random)); }, 0},
    {"FramedNearHandles", [](std::mt19937& random) { return in_frame(random, paths_with_near_handles(random)); }, 0},
    {"Decimals", [](std::mt19937& random) { return filled(random, with_decimals(random)); }, 60},
    {"MachineParts", machine_part, 90},
    {"ShortEnds", [](std::mt19937& random) { return filled(random, slots_with_short_ends(random)); }, 0},
};

}  // namespace bounding_arcs_test

#endif
