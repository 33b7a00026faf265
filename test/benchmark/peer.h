// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What each library beside ours is asked, and what each answers it by.
// A case is a number; what a peer needs of it, a curve in its own form, it makes ready before anything is timed, but
// for single cubics, which it makes of control points each time.

#ifndef BOUNDING_ARCS_TEST_BENCHMARK_PEER_H
#define BOUNDING_ARCS_TEST_BENCHMARK_PEER_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace bounding_arcs_benchmark {

namespace ba = CGAL::Bounding_arcs;
using Point = ba::Xy<double>;
using Cubic_points = std::array<Point, 4>;
using Chain = std::vector<ba::Bezier_curve_2<double>>;  ///< closed, of cubics, twice continuously differentiable

struct Peer_cases {
  struct Curve_and_point {
    std::size_t curve;
    Point point;
  };
  struct Two_curves {
    std::size_t a, b;
  };
  struct Two_cubics {
    Cubic_points a, b;
  };
  std::vector<Chain> curves;  ///< as they are bundled, then those that are moved apart from another one
  std::size_t bundled = 0;
  std::vector<Curve_and_point> closest;
  std::vector<Two_cubics> cubics;
  std::vector<Two_curves> crossing, apart;
};

/// The same whenever it is called. \param pairs of cubics
[[nodiscard]] Peer_cases make_cases(std::size_t pairs);

enum Task { CLOSEST, CUBICS, CURVES, DISTANCE, HAUSDORFF, AXIS, TASKS };

/// What a case was answered with, a number of points or a distance; for no answer what is no number.
using Answer = std::function<double(std::size_t)>;
inline constexpr double NO_ANSWER = std::numeric_limits<double>::quiet_NaN();

/// One way to answer one task.
struct Peer {
  std::string name;
  Task task;
  Answer answer;
  std::size_t most_cases = std::numeric_limits<std::size_t>::max();  ///< of a slow one not all are asked
};
using Peers = std::vector<Peer>;

/// \pre the cases outlive the peers
[[nodiscard]] Peers our_peers(const Peer_cases& cases);
[[nodiscard]] Peers cgal_peers(const Peer_cases& cases);
[[nodiscard]] Peers cgal_bezier_peers(const Peer_cases& cases);
[[nodiscard]] Peers boost_peers(const Peer_cases& cases);
[[nodiscard]] Peers voronoi_peers(const Peer_cases& cases);
[[nodiscard]] Peers lib2geom_peers(const Peer_cases& cases);
[[nodiscard]] Peers occt_peers(const Peer_cases& cases);
[[nodiscard]] Peers sisl_peers(const Peer_cases& cases);

/// A chain of n cubics over [i, i + 1] as one B-spline over [0, n], n + 3 control points to knots of multiplicity four
/// at both ends and simple ones between.
[[nodiscard]] std::vector<Point> b_spline_points(const Chain& chain);

/// Vertices of a polyline within `error` of the chain, the first one again at its end.
[[nodiscard]] std::vector<Point> polyline(const Chain& chain, double error);

}  // namespace bounding_arcs_benchmark

#endif
