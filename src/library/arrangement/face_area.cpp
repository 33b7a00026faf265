// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The area of a face: of the parts of curves along its boundaries, by Green's theorem. Polynomial parts are summed up
// exactly, rational ones as their chords and what is between chord and curve.
//
// A part is taken between doubles in the middle of the brackets of its ends' parameters. At a vertex, segments lead
// from one part to the next. What that changes at a vertex is the area within a closed curve: along the first part to
// its double, straight to that of the next part, along this back to the vertex. With w the width of a bracket and D a
// bound of |C'|, its length is at most 2 (w1 D1 + w2 D2), and the area within a closed curve of length L, each part
// counted as often as it is run round, is at most L^2 / (4 pi) (Banchoff and Pohl 1971): less than a third of the
// square of the sum in brackets.

#include "../curve/exact_b_splines.h"

#include <CGAL/Bounding_arcs_2/arrangement/internal/Arranged_curve.h>
#include <CGAL/Bounding_arcs_2/arrangement/internal/boundary_area.h>
#include <CGAL/Bounding_arcs_2/curve/green.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include <CGAL/Bounding_arcs_2/query/query_units.h>
#include <CGAL/Bounding_arcs_2/tree/Drawing_hierarchy.h>

#include <cstddef>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

namespace {

class Boundary_sum {
 public:
  void add(const std::vector<Boundary_part>& boundary) {
    double open_before = open_of(boundary.back());
    Xy<Exact_rational> first, last;
    for (std::size_t i = 0; i < boundary.size(); ++i) {
      const double open = open_of(boundary[i]), sum = open_before + open;
      open_ += sum * sum / 2;
      open_before = open;
      const auto [from, to] = add(boundary[i]);
      if (i == 0) first = from;
      else add_segment(last, from);
      last = to;
    }
    add_segment(last, first);
  }

  [[nodiscard]] Measure_bounds bounds(double eps) const {
    Measure_bounds lenses{0, 0};
    if (!lenses_.curves().empty()) lenses = area(Drawing_hierarchy(lenses_), eps);
    const Exact_rational lower = exact_ + Exact_rational(lenses.lower) - Exact_rational(open_),
                         upper = exact_ + Exact_rational(lenses.upper) + Exact_rational(open_);
    Measure_bounds result{CGAL::to_interval(lower).first, CGAL::to_interval(upper).second, lenses.status};
    if (result.status == Query_status::COMPLETE && result.upper - result.lower > eps)
      result.status = Query_status::RESOLUTION_REACHED;
    return result;
  }

 private:
  using Point = Xy<Exact_rational>;

  // How far the part goes between doubles and the ends that they stand for, at most.
  [[nodiscard]] static double open_of(const Boundary_part& p) {
    return (p.curve.left_parameter().width() + p.curve.right_parameter().width()) * p.curve.data()->first_bound();
  }

  /// \return where the part starts and ends
  std::pair<Point, Point> add(const Boundary_part& p) {
    const Exact_rational left(p.curve.left_parameter().middle()), right(p.curve.right_parameter().middle());
    const Exact_rational &from = p.is_to_right ? left : right, &to = p.is_to_right ? right : left;
    const Bezier_curve_2<Exact_rational> whole = exact_chain({p.curve.data()->bezier()}).front();
    if (from == to) return {whole.point(from), whole.point(to)};
    const Bezier_curve_2<Exact_rational> part =
        from < to ? whole.subcurve(from, to) : whole.subcurve(to, from).reversed();
    const Point &start = part.control_points().front(), &end = part.control_points().back();
    if (part.is_rational()) {
      add_segment(start, end);
      std::vector<Bezier_curve_2<Exact_rational>> lens{part};
      if (!(start == end)) lens.push_back(Bezier_curve_2<Exact_rational>({end, start}));
      lenses_.add(std::move(lens));
    } else {
      exact_ += moments_along(part, origin_, false).area;
    }
    return {start, end};
  }
  void add_segment(const Point& from, const Point& to) { exact_ += moments_along(from, to, origin_).area; }

  Exact_rational exact_{0};
  Point origin_{Exact_rational(0), Exact_rational(0)};
  double open_ = 0;
  Drawing_2<Exact_rational> lenses_;  // between rational parts and their chords
};

}  // namespace

Measure_bounds boundary_area(const std::vector<std::vector<Boundary_part>>& boundaries, double eps) {
  check_tolerance(eps);
  Boundary_sum sum;
  for (const auto& boundary : boundaries) sum.add(boundary);
  return sum.bounds(eps);
}

}  // namespace CGAL::Bounding_arcs::internal
