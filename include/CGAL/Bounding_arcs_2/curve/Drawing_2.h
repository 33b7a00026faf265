// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawings: several curves with names.

#ifndef CGAL_BOUNDING_ARCS_2_CURVE_DRAWING_2_H
#define CGAL_BOUNDING_ARCS_2_CURVE_DRAWING_2_H

#include <CGAL/Bounding_arcs_2/curve/B_spline_curve_2.h>
#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/number/convert.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Several curves with names, closed or open, in an order. Trees are made of a drawing, and all questions are asked of
/// trees.
/// \code
/// Drawing_2<double> drawing;
/// drawing.add(Bezier_curve_2<double>({{0, 0}, {1, 2}, {2, 0}}), "arch");
/// drawing.add(B_spline_curve_2<double>::periodic(3, {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}), "ring");
/// const Bounding_arc_tree_2 tree(drawing);
/// \endcode
/// A curve is a chain of Bezier pieces that share their ends. add() takes a Bezier curve, a B-spline or NURBS curve, or
/// a chain. read_drawing() of curve/Curve_file.h makes a drawing of an SVG, DXF or JSON file.
///
/// Answers name places by numbers from 0: the curve in the drawing, the Bezier piece in the curve, and the parameter in
/// [0, 1] of that piece. parameter() translates such a place to the curve's own parameter. Names are for people, and
/// need not be unique. A curve is closed if its last point is its first one, to the last bit.
///
/// Take NT = double where coordinates are doubles, as those of files are. Take Exact_rational where they are exact
/// numbers that doubles do not hold: verdicts are then those of the exact curves.
/// \tparam NT the number type of coordinates, weights and parameters: double, a rational, CORE::Expr
template <class NT> class Drawing_2 {
 public:
  using Number_type = NT;

  /// A chain of Bezier pieces with a name.
  struct Curve {
    std::string name;                         ///< need not be unique
    std::vector<Bezier_curve_2<NT>> beziers;  ///< at least one; each starts where the one before ends
    std::vector<NT> parameters;  ///< one more than there are pieces: piece i is over [parameters[i], parameters[i + 1]]
    bool is_closed;              ///< the last point is the first one
    std::shared_ptr<const B_spline_curve_2<NT>> b_spline = nullptr;  ///< of a curve that was added as one: its pieces
                                                                     ///< are rounded where NT is not exact
  };

  Drawing_2() = default;

  /// Appends a curve over [0, 1].
  void add(Bezier_curve_2<NT> curve, std::string name = {}) {
    std::vector<Bezier_curve_2<NT>> chain;  // a list of initial values would be copied
    chain.push_back(std::move(curve));
    add(std::move(chain), std::move(name));
  }
  /// Appends a B-spline curve; parameters are its knots in the domain. After an exception the drawing is as it was.
  void add(const B_spline_curve_2<NT>& curve, std::string name = {}) {
    std::vector<NT> parameters;
    const auto domain = curve.domain();
    for (const NT& knot : curve.knots())
      if (!(knot < domain.lower) && !(domain.upper < knot) && (parameters.empty() || parameters.back() < knot))
        parameters.push_back(knot);
    auto given = std::make_shared<const B_spline_curve_2<NT>>(curve);  // throws before the drawing is changed
    add(curve.bezier_pieces(), std::move(name), std::move(parameters));
    curves_.back().b_spline = std::move(given);
  }
  /// Appends a chain of Bezier curves; without parameters piece i is over [i, i + 1].
  /// \throws std::invalid_argument if there is none, if a piece does not start where the one before ends, or unless
  ///   there is one more parameter than there are pieces
  void add(std::vector<Bezier_curve_2<NT>> chain, std::string name = {}, std::vector<NT> parameters = {}) {
    if (chain.empty()) throw std::invalid_argument(expected("chain", "at least one Bezier piece", "none"));
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      if (!(end(chain[i]) == start(chain[i + 1])))
        throw std::invalid_argument(
            expected("Bezier piece " + text_of(i + 1), "a start where the piece before ends", "another place"));
    if (parameters.empty()) {
      parameters.reserve(chain.size() + 1);
      for (std::size_t i = 0; i <= chain.size(); ++i) parameters.push_back(NT(static_cast<int>(i)));
    }
    if (parameters.size() != chain.size() + 1)
      throw std::invalid_argument(
          expected("parameters", "one more than pieces, " + text_of(chain.size() + 1), parameters.size()));
    const bool is_closed = start(chain.front()) == end(chain.back());
    curves_.push_back({std::move(name), std::move(chain), std::move(parameters), is_closed, nullptr});
  }

  /// Appends the curves of another drawing.
  void add(const Drawing_2& other) { curves_.insert(curves_.end(), other.curves_.begin(), other.curves_.end()); }

  /// Puts the curves of another drawing in the place of curves first, ..., last - 1.
  /// \pre first <= last <= the number of curves
  void replace(std::size_t first, std::size_t last, Drawing_2 others) {
    const auto at = [&](std::size_t i) { return curves_.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::size_t count = (std::min)(last - first, others.curves_.size());
    const auto rest = others.curves_.begin() + static_cast<std::ptrdiff_t>(count);
    curves_.reserve(curves_.size() + others.curves_.size());  // nothing below throws
    std::move(others.curves_.begin(), rest, at(first));
    curves_.erase(at(first + count), at(last));
    curves_.insert(at(first + count), std::make_move_iterator(rest), std::make_move_iterator(others.curves_.end()));
  }

  [[nodiscard]] const std::vector<Curve>& curves() const& { return curves_; }
  /// Returns the curves by value, so that a loop over those of a drawing without a name keeps them.
  [[nodiscard]] std::vector<Curve> curves() && { return std::move(curves_); }
  /// The parameter of a curve at t of one of its Bezier pieces; of a B-spline that of its knots.
  [[nodiscard]] NT parameter(std::size_t curve, std::size_t bezier, const NT& t) const {
    const NT &first = curves_[curve].parameters[bezier], &last = curves_[curve].parameters[bezier + 1];
    return NT(first + t * (last - first));
  }

  /// Converts to another number type: each number exactly where Target holds it, else rounded.
  template <class Target> [[nodiscard]] Drawing_2<Target> over() const {
    const auto number = [](const NT& x) {
      if constexpr (std::is_same_v<NT, long double> && !std::is_floating_point_v<Target>)
        return convert<Target>(Exact_number<NT>::make(x));
      else return convert<Target>(x);
    };
    const auto numbers = [&](const std::vector<NT>& all) {
      std::vector<Target> result;
      result.reserve(all.size());
      for (const NT& x : all) result.push_back(number(x));
      return result;
    };
    Drawing_2<Target> result;
    for (const Curve& curve : curves_) {
      std::vector<Bezier_curve_2<Target>> chain;
      for (const auto& piece : curve.beziers) {
        std::vector<Xy<Target>> points;
        for (const auto& p : piece.control_points()) points.push_back({number(p.x), number(p.y)});
        chain.emplace_back(std::move(points), numbers(piece.weights()));
      }
      result.add(std::move(chain), curve.name, numbers(curve.parameters));
    }
    return result;
  }

  /// The largest |coordinate| of a control point; 0 without curves.
  [[nodiscard]] NT coordinate_size() const {
    NT size(0);
    for (const Curve& curve : curves_)
      for (const Bezier_curve_2<NT>& piece : curve.beziers) size = (std::max)(size, piece.coordinate_size());
    return size;
  }
  /// The box of all control points; CGAL::Bbox_2(), which holds no point, without curves.
  [[nodiscard]] CGAL::Bbox_2 control_box() const {
    CGAL::Bbox_2 box;
    for (const Curve& curve : curves_)
      for (const Bezier_curve_2<NT>& piece : curve.beziers)
        for (const Xy<NT>& p : piece.control_points()) {
          const auto x = CGAL::to_interval(p.x), y = CGAL::to_interval(p.y);
          box += CGAL::Bbox_2(x.first, y.first, x.second, y.second);
        }
    return box;
  }

  /// Writes the control points of all Bezier pieces, with an empty line behind each piece.
  friend std::ostream& operator<<(std::ostream& out, const Drawing_2& drawing) {
    for (const Curve& curve : drawing.curves())
      for (const Bezier_curve_2<NT>& piece : curve.beziers) out << piece << '\n';
    return out;
  }

 private:
  [[nodiscard]] static const Xy<NT>& start(const Bezier_curve_2<NT>& c) { return c.control_points().front(); }
  [[nodiscard]] static const Xy<NT>& end(const Bezier_curve_2<NT>& c) { return c.control_points().back(); }

  std::vector<Curve> curves_;
};

}  // namespace CGAL::Bounding_arcs

#endif
