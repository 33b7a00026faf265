// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Families of spirals on which constructions of bounding regions lose digits: nearly straight, nearly circular, short,
// random; and what families of one's own are made of.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_STABILITY_FAMILIES_H
#define CGAL_BOUNDING_ARCS_2_STUDY_STABILITY_FAMILIES_H

#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>

#include <cstddef>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A piece of a spiral segment as a member of a family, whose parameter is delta.
struct Study_piece {
  std::string family;
  double delta;
  Bezier_spiral_2<double> spiral;
  double t0, t1;
  std::size_t number = 0;      ///< its place in the family, from 0
  std::string placement = {};  ///< how the family's curve was placed, as add_placed tells it
};

/// Adds a member to a family of one's own: the longest spiral segment of a curve, in five placements. They are "as
/// given", "reversed", "turned", "moved", and "turned, moved, reversed". Turning and moving round the control points,
/// which are exact again then.
/// \code
/// std::vector<Study_piece> flat;
/// for (double delta = 1; delta > 1e-9; delta /= 10)
///   add_placed(flat, "flat", delta, Bezier_curve_2<double>({{0, 0}, {1, delta}, {2, 3 * delta}}));
/// \endcode
/// \throws std::invalid_argument for curves out of the range that is served (served_range.h)
void add_placed(std::vector<Study_piece>& pieces, const std::string& family, double delta,
                const Bezier_curve_2<double>& curve);

/// Returns a share of what follows a third, or another part, of a piece.
[[nodiscard]] Study_piece shortened(Study_piece piece, double share, double start = 1.0 / 3);

/// Returns the spiral segment with all of [t0, t1], or nothing where the curve is cut within.
/// \throws std::invalid_argument for curves out of the range that is served (served_range.h)
[[nodiscard]] std::optional<Bezier_spiral_2<double>> spiral_holding(const Bezier_curve_2<double>& curve, double t0,
                                                                    double t1);

/// The longest spiral of (t, delta t^2) and of (3t, delta (3t^2 + t^3)) on [0, 1] for delta = 1, 1e-1, ... 1e-30,
/// 1e-35, ... 1e-300, and of both reversed, turned and moved.
[[nodiscard]] std::vector<Study_piece> near_linear_family();

/// The longest spiral of the quarter of an ellipse with axes 1 and 1 + delta, and of the quarter of the unit circle
/// with its middle control point moved by delta, for delta = 1, 1/2, ... 2^-52, and of both reversed, turned and moved;
/// each whole, and the share delta of it (at least 2^-40) from six places on: in a tree pieces get shorter as they get
/// rounder.
[[nodiscard]] std::vector<Study_piece> near_circular_family();

/// The longest spiral of a polynomial and of a rational cubic, and of both reversed, turned and moved, from a third of
/// its parameter interval on, halved up to forty times: delta is the share that is left.
[[nodiscard]] std::vector<Study_piece> subdivision_family();

/// A Bezier curve with control points in the square [-1, 1]^2, and for rational ones weights between 1/4 and 4.
[[nodiscard]] Bezier_curve_2<double> random_bezier_curve(std::mt19937& random, int degree, bool is_rational);
/// A curve of degree 2 to 9, every other one rational.
[[nodiscard]] Bezier_curve_2<double> random_bezier_curve(std::mt19937& random);

/// Pieces of random curves, one after the other: of log-uniform size 1e-12 to 1e12, moved by 1e-8 to 1e8 times their
/// size and shortened up to 2^20 times. Delta counts them from 0.
/// \code
/// Random_spirals spirals(7);
/// const Study_piece piece = spirals.next();
/// \endcode
class Random_spirals {
 public:
  explicit Random_spirals(unsigned seed) : random_(seed) {}

  [[nodiscard]] Study_piece next();

 private:
  void cut_another();

  std::mt19937 random_;
  std::vector<Bezier_spiral_2<double>> spirals_;  // of one curve
  std::size_t next_ = 0, count_ = 0;
};

/// The first `count` of the Random_spirals with that seed.
[[nodiscard]] std::vector<Study_piece> random_family(std::size_t count, unsigned seed);

}  // namespace CGAL::Bounding_arcs

#endif
