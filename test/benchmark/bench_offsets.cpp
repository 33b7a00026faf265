// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Outward offsets of the bundled curves at a twentieth of their size, from control points to trimmed loops, beside
// those of polygons within half the tolerance: Clipper's, which are polygons again, and CGAL's approximated_offset_2.
// Usage: offset_peers [LEAST eps of Clipper] [LEAST eps of CGAL]
//
// Milliseconds of processor time, the least of some repetitions; the factor is theirs over ours in the same run, and
// areas tell that all offset the same. Then how ours grows.

#include "peer.h"

#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/approximated_offset_2.h>

#ifdef BOUNDING_ARCS_CLIPPER
#include <polyclipping/clipper.hpp>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

namespace {

using namespace bounding_arcs_benchmark;

constexpr double DISTANCE = 0.1;

struct Timed {
  double milliseconds, area;
};

template <class Run> Timed timed(int repetitions, const Run& run) {
  Timed best{HUGE_VAL, 0};
  for (int k = 0; k < repetitions; ++k) {
    const std::clock_t start = std::clock();
    best.area = run();
    best.milliseconds = (std::min)(best.milliseconds, 1e3 * double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

Timed ours(const Chain& chain, double eps, int repetitions = 20) {
  return timed(repetitions, [&] {
    ba::Drawing_2<double> drawing;
    drawing.add(chain);
    double area = 0;
    for (const auto& c : ba::offset(ba::Bounding_arc_tree_2(std::move(drawing)), DISTANCE, eps).chains) area += c.area;
    return area;
  });
}

#ifdef BOUNDING_ARCS_CLIPPER
Timed clipper(const Chain& chain, double eps) {
  constexpr double SCALE = 0x1p28;  // coordinates below the range in which products fit
  return timed(eps < 1e-5 ? 1 : 3, [&] {
    ClipperLib::Path path;
    for (const Point& p : polyline(chain, eps / 2))
      path.emplace_back(std::llround(SCALE * p.x), std::llround(SCALE * p.y));
    path.pop_back();
    ClipperLib::ClipperOffset offset(2, eps / 2 * SCALE);
    offset.AddPath(path, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
    ClipperLib::Paths result;
    offset.Execute(result, DISTANCE * SCALE);
    double area = 0;
    for (const auto& p : result) area += ClipperLib::Area(p) / (SCALE * SCALE);
    return area;
  });
}
#endif

Timed cgal(const Chain& chain, double eps) {
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  return timed(1, [&] {
    CGAL::Polygon_2<Kernel> polygon;
    std::vector<Point> points = polyline(chain, eps / 2);
    points.pop_back();
    for (const Point& p : points) polygon.push_back({p.x, p.y});
    const auto result = CGAL::approximated_offset_2(polygon, Kernel::FT(DISTANCE), eps / 2);
    double area = 0;  // of chords
    const auto add = [&area](const auto& loop) {
      for (auto c = loop.curves_begin(); c != loop.curves_end(); ++c) {
        const auto &p = c->source(), &q = c->target();
        area += (CGAL::to_double(p.x()) * CGAL::to_double(q.y()) - CGAL::to_double(p.y()) * CGAL::to_double(q.x())) / 2;
      }
    };
    add(result.outer_boundary());
    for (auto hole = result.holes_begin(); hole != result.holes_end(); ++hole) add(*hole);
    return area;
  });
}

// The exponent p of time ~ eps^-p by least squares, for eps from 1e-4 to 1e-10. Tolerances take turns, so that a slow
// minute of the machine meets all of them alike.
double growth(const Chain& chain) {
  constexpr int FINEST = 10, REPETITIONS = 10;
  std::vector<double> decades, times;
  for (int k = 4; k <= FINEST; ++k) decades.push_back(k);
  times.assign(decades.size(), HUGE_VAL);
  for (int r = 0; r < REPETITIONS; ++r)
    for (std::size_t k = 0; k < decades.size(); ++k)
      times[k] = (std::min)(times[k], ours(chain, std::pow(10, -decades[k]), 3).milliseconds);
  double middle = 0, above = 0, below = 0;
  for (const double k : decades) middle += k / double(decades.size());
  for (std::size_t k = 0; k < decades.size(); ++k) {
    above += (decades[k] - middle) * std::log10(times[k]);
    below += (decades[k] - middle) * (decades[k] - middle);
  }
  return above / below;
}

void print(const char* name, const Timed& a, const Timed& base) {
  std::printf("  %s %.2f ms (%.0f times ours, areas differ by %.1e)", name, a.milliseconds,
              a.milliseconds / base.milliseconds, std::fabs(a.area - base.area));
}

}  // namespace

int main(int argc, char** argv) {
  [[maybe_unused]] const double least_of_clipper = argc > 1 ? std::atof(argv[1]) : 1e-6;
  const double least_of_cgal = argc > 2 ? std::atof(argv[2]) : 1e-6;
  constexpr double SLACK = 0.999;  // powers of ten are rounded
  std::vector<Chain> curves = make_cases(1).curves;
  curves.resize(8);  // without those that are moved
  for (const double eps : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    std::printf("eps %g\n", eps);
    for (const Chain& chain : curves) {
      const Timed base = ours(chain, eps);
      std::printf("%zu pieces: ours %.3f ms", chain.size(), base.milliseconds);
#ifdef BOUNDING_ARCS_CLIPPER
      if (eps >= SLACK * least_of_clipper) print("Clipper", clipper(chain, eps), base);
#endif
      if (eps >= SLACK * least_of_cgal) print("CGAL", cgal(chain, eps), base);
      std::printf("\n");
      std::fflush(stdout);
    }
  }
  std::printf("ours grow from 1e-4 to 1e-10 as eps to the power of\n");
  for (const Chain& chain : curves) std::printf("%zu pieces: -%.3f\n", chain.size(), growth(chain));
}
