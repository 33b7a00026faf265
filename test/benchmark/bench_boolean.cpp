// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Unions beside those of lib2geom, which has curves, too, and of Clipper, which has polylines: from control points to
// the Bezier curves or polygons that the user holds. Clipper's polylines are within eps of the curves.
// Usage: boolean_peers EPS A B | boolean_peers EPS A | boolean_peers EPS | boolean_peers PIECES
//   Without a file the unions of 2000 pairs of rectangles with small integer corners are held against their areas.
//   With one file a drawing is united with a copy of itself, moved by a thirtieth of its size to the right and upwards.
//   A number of pieces above 1 stands for that many in random closed splines, side by side: how time and memory grow.

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#ifdef BOUNDING_ARCS_CLIPPER
#include "Polygon_offset.h"
#endif
#ifdef BOUNDING_ARCS_LIB2GEOM
#include <2geom/bezier-curve.h>
#include <2geom/intersection-graph.h>
#include <2geom/path.h>
#include <2geom/pathvector.h>
#endif

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace ba = CGAL::Bounding_arcs;
using Drawing = ba::Drawing_2<double>;
using Point = ba::Xy<double>;

struct Timed {
  double milliseconds = HUGE_VAL, area = 0;
};

/// The least CPU time of several runs, as the machine may have other work, and what the last one tells of its result.
template <class Run, class Area> Timed least_time(int runs, const Run& run, const Area& area) {
  Timed best;
  for (int i = 0; i < runs; ++i) {
    const std::clock_t start = std::clock();
    const auto result = run();
    best.milliseconds =
        (std::min)(best.milliseconds, 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    if (i + 1 == runs) best.area = area(result);
  }
  return best;
}

template <class Visit> void for_each_piece(const Drawing& drawing, const Visit& visit) {
  for (const auto& curve : drawing.curves())
    for (const auto& piece : curve.beziers) visit(piece);
}

double size_of(const Drawing& drawing) {
  CGAL::Bbox_2 box;
  for_each_piece(drawing, [&box](const auto& piece) {
    for (const Point& p : piece.control_points()) box += CGAL::Bbox_2(p.x, p.y, p.x, p.y);
  });
  return (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
}

Drawing moved(const Drawing& drawing, double by) {
  Drawing result;
  for (const auto& curve : drawing.curves()) {
    std::vector<ba::Bezier_curve_2<double>> chain;
    for (const auto& piece : curve.beziers) {
      std::vector<Point> points;
      for (const Point& p : piece.control_points()) points.push_back({p.x + by, p.y + by});
      chain.emplace_back(std::move(points), piece.weights());
    }
    result.add(std::move(chain), curve.name);
  }
  return result;
}

Timed ours(const Drawing& a, const Drawing& b, int runs) {
  const auto unite = [&] {
    const ba::Bounding_arc_tree_2 tree_a(a), tree_b(b);
    return ba::drawn_outline({&tree_a, &tree_b}, ba::unite(tree_a, tree_b)).drawing;
  };
  return least_time(runs, unite, [](const Drawing& united) {
    const auto bounds = ba::area(ba::Bounding_arc_tree_2(united), 1e-9);
    return bounds.lower + (bounds.upper - bounds.lower) / 2;
  });
}

#ifdef BOUNDING_ARCS_CLIPPER
// Chords of a piece: one of n parts of a polynomial is within max |C''| / (8 n^2) of it.
void add_chords(const ba::Bezier_curve_2<double>& piece, double eps, const bounding_arcs_benchmark::Clipper_grid& grid,
                ClipperLib::Path& loop) {
  const auto& p = piece.control_points();
  double second = 0;
  for (std::size_t i = 2; i < p.size(); ++i)
    second = (std::max)(second, ba::euclidean_norm(p[i] - p[i - 1] - (p[i - 1] - p[i - 2])));
  second *= piece.degree() * (piece.degree() - 1.0);
  const double count = (std::max)(1.0, std::ceil(std::sqrt(second / (8 * eps))));
  for (double k = 0; k < count; ++k) loop.push_back(grid(piece.point(k / count)));
}

Timed clipper(const Drawing& a, const Drawing& b, double eps, double size, int runs) {
  Drawing both = a;
  for (const auto& curve : b.curves()) both.add(curve.beziers, curve.name);
  const auto grid = bounding_arcs_benchmark::clipper_grid(both, 0);
  const auto unite = [&] {
    ClipperLib::Clipper engine;
    for (const Drawing* d : {&a, &b})
      for (const auto& curve : d->curves()) {
        ClipperLib::Path loop;
        for (const auto& piece : curve.beziers) add_chords(piece, eps * size, grid, loop);
        engine.AddPath(loop, d == &a ? ClipperLib::ptSubject : ClipperLib::ptClip, true);
      }
    ClipperLib::Paths result;
    engine.Execute(ClipperLib::ctUnion, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    return result;
  };
  return least_time(runs, unite, [&](const ClipperLib::Paths& result) {
    double area = 0;
    for (const auto& path : result) area += ClipperLib::Area(path);
    return area * grid.unit * grid.unit;
  });
}
#endif

#ifdef BOUNDING_ARCS_LIB2GEOM
Geom::PathVector paths_of(const Drawing& drawing) {
  Geom::PathVector paths;
  for (const auto& curve : drawing.curves()) {
    const auto point = [](const Point& p) { return Geom::Point(p.x, p.y); };
    Geom::Path path(point(curve.beziers.front().control_points().front()));
    for (const auto& piece : curve.beziers) {
      const auto& p = piece.control_points();
      if (p.size() == 2) path.append(Geom::LineSegment(point(p[0]), point(p[1])));
      else if (p.size() == 3) path.append(Geom::QuadraticBezier(point(p[0]), point(p[1]), point(p[2])));
      else path.append(Geom::CubicBezier(point(p[0]), point(p[1]), point(p[2]), point(p[3])));
    }
    path.close();
    paths.push_back(path);
  }
  return paths;
}

Timed lib2geom(const Drawing& a, const Drawing& b, int runs) {
  const auto unite = [&] {
    return Geom::PathIntersectionGraph(paths_of(a), paths_of(b), 1e-9 * size_of(a)).getUnion();
  };
  return least_time(runs, unite, [](const Geom::PathVector& result) {
    double area = 0;
    for (const Geom::Path& path : result) {  // by chords: what its own area needs is no part of it
      constexpr int PARTS = 200;
      for (const Geom::Curve& curve : path)
        for (int k = 0; k < PARTS; ++k)
          area += 0.5 * Geom::cross(curve.pointAt(double(k) / PARTS), curve.pointAt(double(k + 1) / PARTS));
    }
    return area;
  });
}
#endif

/// A rectangle with integer corners: its lower left one, width and height.
struct Rectangle {
  int x, y, width, height;
  [[nodiscard]] Drawing drawing() const {
    const double x0 = x, y0 = y, x1 = x + width, y1 = y + height;
    const std::vector<Point> corners{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    std::vector<ba::Bezier_curve_2<double>> chain;
    for (std::size_t i = 0; i < corners.size(); ++i)
      chain.emplace_back(std::vector<Point>{corners[i], corners[(i + 1) % corners.size()]});
    Drawing result;
    result.add(std::move(chain));
    return result;
  }
};

/// Prints how many unions of rectangles have another area than they should.
int count_wrong_rectangles() {
  constexpr int PAIRS = 2000;
  std::mt19937 random(1);
  const auto below = [&random](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto rectangle = [&] {
    const int x = below(4), y = below(4), width = 1 + below(3), height = 1 + below(3);
    return Rectangle{x, y, width, height};
  };
  int of_ours = 0;
  [[maybe_unused]] int of_theirs = 0, refused = 0;
  for (int i = 0; i < PAIRS; ++i) {
    const Rectangle r = rectangle(), s = rectangle();
    const int width = (std::min)(r.x + r.width, s.x + s.width) - (std::max)(r.x, s.x),
              height = (std::min)(r.y + r.height, s.y + s.height) - (std::max)(r.y, s.y);
    const int both = (std::max)(0, width) * (std::max)(0, height);
    const int area = r.width * r.height + s.width * s.height - both;
    const auto is_wrong = [area](double told) { return !(std::fabs(std::fabs(told) - area) < 1e-6); };
    of_ours += int(is_wrong(ours(r.drawing(), s.drawing(), 1).area));
#ifdef BOUNDING_ARCS_LIB2GEOM
    try {
      of_theirs += int(is_wrong(lib2geom(r.drawing(), s.drawing(), 1).area));
    } catch (...) {  // it throws what is no std::exception
      ++refused;
    }
#endif
  }
  std::printf("%d unions of rectangles: ours wrong %d", PAIRS, of_ours);
#ifdef BOUNDING_ARCS_LIB2GEOM
  std::printf(", lib2geom wrong %d and refused %d", of_theirs, refused);
#endif
  std::printf("\n");
  return of_ours == 0 ? 0 : 1;
}

/// As many closed splines of 10 pieces as make half of `pieces`, in cells of a square.
Drawing islands(int pieces, const Point& corner, unsigned seed) {
  constexpr int OF_ONE = 10;
  constexpr double TURN = 6.283185307179586;
  std::mt19937 random(seed);
  std::uniform_real_distribution<> radius(0.25, 0.45);
  const int side = static_cast<int>(std::ceil(std::sqrt(pieces / 2 / OF_ONE)));
  Drawing result;
  for (int cell = 0; cell < side * side; ++cell) {
    std::vector<Point> p;
    for (int i = 0; i < OF_ONE; ++i) {
      const double angle = TURN * i / OF_ONE, r = radius(random);
      p.push_back({corner.x + cell % side + r * std::cos(angle), corner.y + cell / side + r * std::sin(angle)});
    }
    const auto joint = [&p](std::size_t i) {  // of a uniform cubic B-spline
      return (1.0 / 6) * (p[i % OF_ONE] + 4.0 * p[(i + 1) % OF_ONE] + p[(i + 2) % OF_ONE]);
    };
    std::vector<ba::Bezier_curve_2<double>> chain;
    for (std::size_t i = 0; i < OF_ONE; ++i) {
      const Point &q = p[(i + 1) % OF_ONE], &r = p[(i + 2) % OF_ONE];
      chain.emplace_back(
          std::vector<Point>{joint(i), (1.0 / 3) * (2.0 * q + r), (1.0 / 3) * (q + 2.0 * r), joint((i + 1) % OF_ONE)});
    }
    result.add(std::move(chain));
  }
  return result;
}

/// Prints what a union of so many pieces takes, above the memory of the drawings.
void print_growth(int pieces) {
  const auto peak = [] {
    rusage use;
    getrusage(RUSAGE_SELF, &use);
    return 1024.0 * static_cast<double>(use.ru_maxrss);
  };
  const Drawing a = islands(pieces, {0, 0}, 1), b = islands(pieces, {0.21, 0.17}, 2);
  const double before = peak();
  const Timed t = ours(a, b, 1);
  std::size_t count = 0;
  for (const Drawing* d : {&a, &b}) for_each_piece(*d, [&count](const auto&) { ++count; });
  const auto n = static_cast<double>(count);
  std::printf("%zu pieces: %.2f us and %.0f bytes a piece\n", count, 1000 * t.milliseconds / n, (peak() - before) / n);
}

void print(const char* name, const Timed& t, const Timed& base) {
  std::printf("  %-9s %10.3f ms, %7.1f times ours, areas differ by %.1e\n", name, t.milliseconds,
              t.milliseconds / base.milliseconds, std::fabs(std::fabs(t.area) - std::fabs(base.area)));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 4) return std::fputs("usage: boolean_peers EPS [A [B]] | boolean_peers PIECES\n", stderr), 2;
  if (argc == 2 && std::atof(argv[1]) > 1) return print_growth(std::atoi(argv[1])), 0;
  if (argc == 2) return count_wrong_rectangles();
  const double eps = std::atof(argv[1]);
  const Drawing a = ba::read_drawing(argv[2]);
  const double size = size_of(a);
  const Drawing b = argc == 4 ? ba::read_drawing(argv[3]) : moved(a, size / 30);
  std::size_t pieces = 0;
  for (const Drawing* d : {&a, &b}) for_each_piece(*d, [&pieces](const auto&) { ++pieces; });
  constexpr int FEW = 5, MANY = 200;
  const int runs = pieces > 1000 ? FEW : MANY;
  const Timed base = ours(a, b, runs);
  std::printf("%zu pieces: ours %.3f ms, area %.12g\n", pieces, base.milliseconds, base.area);
#ifdef BOUNDING_ARCS_CLIPPER
  print("Clipper", clipper(a, b, eps, size, FEW), base);
#endif
#ifdef BOUNDING_ARCS_LIB2GEOM
  try {
    print("lib2geom", lib2geom(a, b, FEW), base);
  } catch (...) {  // it throws what is no std::exception
    std::printf("  lib2geom  fails\n");
  }
#endif
  return 0;
}
