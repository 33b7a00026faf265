// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's arrangements of random cubics over our traits and over CGAL's own traits of Bezier curves, and overlays: the
// same program, from control points to vertices, edges and faces. CPU time, the least of several runs.
// Usage: arrangement_peers COUNT... | arrangement_peers --ours COUNT...

#include <CGAL/Arr_Bezier_curve_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Bounding_arcs_2/arrangement/Arr_curve_traits_2.h>
#include <CGAL/Bounding_arcs_2/overlay/overlay.h>
#include <CGAL/CORE_algebraic_number_traits.h>
#include <CGAL/Cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <random>
#include <string>
#include <vector>

namespace {

namespace ba = CGAL::Bounding_arcs;
using Controls = std::vector<ba::Xy<double>>;

/// Cubics whose size is that of a grid of as many cells, so that each meets a few others however many there are.
std::vector<Controls> random_cubics(int count, double size) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<Controls> all;
  for (int i = 0; i < count; ++i) {
    const double x = place(random), y = place(random);
    Controls points;
    for (int k = 0; k < 4; ++k) {
      const double dx = size * place(random), dy = size * place(random);
      points.push_back({x + dx, y + dy});
    }
    all.push_back(std::move(points));
  }
  return all;
}

struct Counts {
  std::size_t vertices = 0, edges = 0, faces = 0;
};

/// \param count makes what is counted, from control points on
/// \return milliseconds
template <class Count> double run(const char* name, const Count& count) {
  constexpr int RUNS = 5;
  constexpr double MILLISECOND = CLOCKS_PER_SEC / 1000.0;
  double least = HUGE_VAL;
  Counts found;
  for (int i = 0; i < RUNS; ++i) {
    const std::clock_t start = std::clock();
    try {
      found = count();
    } catch (const std::exception& error) {
      std::printf("  %-22s ended by an exception: %.60s\n", name, error.what());
    }
    least = (std::min)(least, static_cast<double>(std::clock() - start) / MILLISECOND);
  }
  std::printf("  %-22s %10.2f ms: %zu vertices, %zu edges, %zu faces\n", name, least, found.vertices, found.edges,
              found.faces);
  return least;
}

template <class Traits, class MakeCurve>
double run_arrangement(const char* name, const std::vector<Controls>& cubics, const MakeCurve& make_curve) {
  return run(name, [&] {
    std::vector<typename Traits::Curve_2> curves;
    for (const Controls& c : cubics) curves.push_back(make_curve(c));
    CGAL::Arrangement_2<Traits> arrangement;
    CGAL::insert(arrangement, curves.begin(), curves.end());
    return Counts{arrangement.number_of_vertices(), arrangement.number_of_edges(), arrangement.number_of_faces()};
  });
}

/// An overlay has no vertices where x turns.
double run_overlay(const std::vector<Controls>& cubics) {
  return run("Bounding Arcs, overlay", [&] {
    ba::Drawing_2<double> drawing;
    for (const Controls& c : cubics) drawing.add(ba::Bezier_curve_2<double>(c));
    const ba::Overlay_2 cells = ba::overlay(ba::Bounding_arc_tree_2(drawing));
    return Counts{cells.vertices.size(), cells.edges.size(), cells.faces.size()};
  });
}
double run_ours(const std::vector<Controls>& cubics) {
  return run_arrangement<ba::Arr_curve_traits_2>("Bounding Arcs, traits", cubics, [](const Controls& c) {
    return ba::Arr_curve_2(ba::Bezier_curve_2<double>(c));
  });
}
double run_cgal(const std::vector<Controls>& cubics) {
  using Numbers = CGAL::CORE_algebraic_number_traits;
  using Rational_kernel = CGAL::Cartesian<Numbers::Rational>;
  using Traits = CGAL::Arr_Bezier_curve_traits_2<Rational_kernel, CGAL::Cartesian<Numbers::Algebraic>, Numbers>;
  return run_arrangement<Traits>("CGAL, Bezier traits", cubics, [](const Controls& c) {
    std::vector<Rational_kernel::Point_2> points;
    for (const auto& p : c) points.emplace_back(Numbers::Rational(p.x), Numbers::Rational(p.y));
    return Traits::Curve_2(points.begin(), points.end());
  });
}

}  // namespace

int main(int argc, char** argv) {
  bool is_ours_alone = false;
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) == "--ours") {
      is_ours_alone = true;
      continue;
    }
    const int count = std::atoi(argv[i]);
    for (const bool is_sparse : {false, true}) {
      const auto cubics = random_cubics(count, is_sparse ? 2 / std::sqrt(count) : 1);
      std::printf("%d random cubics, each meets %s\n", count, is_sparse ? "a few others" : "most others");
      if (is_ours_alone && !is_sparse) continue;
      const double of_traits = run_ours(cubics), of_overlay = run_overlay(cubics);
      if (is_ours_alone) continue;
      const double cgal = run_cgal(cubics);
      std::printf("  over traits %.1f, over an overlay %.1f\n", cgal / of_traits, cgal / of_overlay);
    }
  }
}
