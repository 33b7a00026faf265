// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Polygon_offset.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bounding_arcs_benchmark {
namespace {

using namespace ClipperLib;
using Point = ba::Xy<double>;
using Bezier = ba::Bezier_curve_2<double>;

double distance_of_segment(const Point& p, const Point& q, const Point& x) {
  const Point along = q - p, to = x - p;
  const double square = dot(along, along), share = square > 0 ? dot(along, to) / square : 0;
  const Point rest = to - (std::min)((std::max)(share, 0.0), 1.0) * along;
  return std::sqrt(dot(rest, rest));
}

// Chords whose curves' control points are within `error` of them: so is the curve, and it passes every one of their
// points as near as that, as it goes from one end to the other.
void add_chords(const Bezier& curve, double error, const Clipper_grid& grid, Path& line) {
  const auto& p = curve.control_points();
  const auto is_near = [&](const Point& x) { return distance_of_segment(p.front(), p.back(), x) <= error; };
  if (!std::all_of(p.begin(), p.end(), is_near)) {
    const auto halves = curve.split(0.5);
    add_chords(halves.first, error, grid, line);
    add_chords(halves.second, error, grid, line);
    return;
  }
  const IntPoint end = grid(p.back());
  if (line.back() != end) line.push_back(end);
}

Paths united(const Paths& a, PolyFillType rule, const Paths& b) {
  Clipper clipper;
  clipper.AddPaths(a, ptSubject, true);
  clipper.AddPaths(b, ptClip, true);
  Paths result;
  clipper.Execute(ctUnion, result, rule, pftNonZero);
  return result;
}

double length_of(const Path& loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const IntPoint &p = loop[i], &q = loop[(i + 1) % loop.size()];
    length += std::hypot(double(q.X - p.X), double(q.Y - p.Y));
  }
  return length;
}

}  // namespace

double length_of(const Paths& loops) {
  double length = 0;
  for (const Path& loop : loops) length += length_of(loop);
  return length;
}
double area_of(const Paths& loops) {
  double area = 0;
  for (const Path& loop : loops) area += Area(loop);
  return area;
}

IntPoint Clipper_grid::operator()(const Point& p) const {
  return {std::llround((p.x - center.x) / unit), std::llround((p.y - center.y) / unit)};
}

Clipper_grid clipper_grid(const ba::Drawing_2<double>& drawing, double room) {
  CGAL::Bbox_2 box;
  for (const auto& curve : drawing.curves())
    for (const Bezier& piece : curve.beziers)
      for (const Point& p : piece.control_points()) box += CGAL::Bbox_2(p.x, p.y, p.x, p.y);
  const double half = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin()) / 2;
  constexpr double LARGEST = 0x1p30 - 64;  // Clipper's limit of plain products is 2^30 - 1
  return {{(box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2}, (half + room) / LARGEST};
}

Polygon_offset::Polygon_offset(const ba::Drawing_2<double>& drawing, const Clipper_grid& grid, ba::Fill_rule rule,
                               double error, double thin)
    : grid_(grid), rule_(rule == ba::Fill_rule::NONZERO ? pftNonZero : pftEvenOdd), error_(error) {
  for (const auto& curve : drawing.curves()) {
    Path line{grid(curve.beziers.front().control_points().front())};
    for (const Bezier& piece : curve.beziers) add_chords(piece, error, grid, line);
    const bool is_point = line.size() == 1;
    (curve.is_closed && !is_point ? closed_ : open_).push_back(std::move(line));
  }
  // Twice, as loops that come from curves which cancel each other may still have a common edge after once.
  for (Path& loop : united(united(closed_, rule_, {}), pftNonZero, {})) {
    if (2 * std::fabs(Area(loop)) <= thin / grid.unit * bounding_arcs_benchmark::length_of(Paths{loop})) continue;
    loop.push_back(loop.front());
    outline_.push_back(std::move(loop));
  }
}

Paths Polygon_offset::band(const Paths& lines, double d) {
  constexpr std::size_t STRETCH = 48;
  std::vector<Paths> bands;
  for (const Path& line : lines)
    for (std::size_t i = 0; i == 0 || i + 1 < line.size(); i += STRETCH) {
      const auto begin = line.begin() + static_cast<std::ptrdiff_t>(i),
                 end = line.begin() + static_cast<std::ptrdiff_t>((std::min)(i + STRETCH + 1, line.size()));
      ClipperOffset offset(2, error_ / 4 / grid_.unit);
      offset.AddPath(Path(begin, end), jtRound, etOpenRound);
      offset.Execute(bands.emplace_back(), d / grid_.unit);
    }
  std::size_t levels = 0;
  for (; bands.size() > 1; ++levels) {
    const std::size_t half = (bands.size() + 1) / 2;
    for (std::size_t i = 0; i < half; ++i) {
      Paths& into = bands[i];
      into = 2 * i + 1 < bands.size() ? united(bands[2 * i], pftNonZero, bands[2 * i + 1]) : std::move(bands[2 * i]);
    }
    bands.resize(half);
  }
  levels_ = (std::max)(levels_, levels);
  return bands.empty() ? Paths() : std::move(bands.front());
}

Polygon_regions Polygon_offset::at(double d) {
  if (d > 0) {
    Paths lines = closed_;
    lines.insert(lines.end(), open_.begin(), open_.end());
    return {united(closed_, rule_, band(lines, d)), {}};
  }
  Clipper clipper;
  clipper.AddPaths(outline_, ptSubject, true);
  clipper.AddPaths(band(outline_, -d), ptClip, true);
  Polygon_regions result;
  clipper.Execute(ctDifference, result.of_closed, pftNonZero, pftNonZero);
  result.of_open = band(open_, -d);
  return result;
}

// Chords are within `error` of curves. Where a join turns by less than 3/2 steps Clipper makes one step of it, whose
// chord is within (3/2)^2 of the error of round joins, a quarter. Points are rounded to the grid as what is given, what
// is offset and in each union.
double Polygon_offset::error() const {
  constexpr double OF_JOINS = 2.25 / 4, ROUNDING = 0.71;  // half of a square's diagonal
  return (1 + OF_JOINS) * error_ + ROUNDING * static_cast<double>(levels_ + 4) * grid_.unit;
}

}  // namespace bounding_arcs_benchmark
