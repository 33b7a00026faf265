// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/study/Search_study.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include "../library/query/Closest_search.h"
#include "../library/query/Distance_search.h"
#include "../library/query/Hausdorff_search.h"
#include "../library/query/Intersection_search.h"
#include "../library/query/query_units.h"
#include "../library/tree/Segment_hierarchy.h"
#include "least_seconds.h"
#include "regions_in_hand.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {
namespace study {

/// The closest point by regions alone: pieces are halved until the bracket is as narrow as asked. The library's own
/// search ends as soon as a piece has one nearest point for certain, by Newton's steps, whatever region it has; here
/// the region does all, so that the order of its thickness tells.
template <class Curves> class Region_descent {
 public:
  /// \param eps how wide the bracket may be, beside what doubles leave open; it is wider where that takes more than
  ///   2^16 halvings
  Region_descent(const Curves& curves, const Xy<double>& q, double eps) : curves_(curves), q_(q), eps_(eps) {}

  [[nodiscard]] Bracket search() {
    for_each_near(curves_.boxes(), *this);
    return {(std::min)(lower_, upper_), upper_};
  }

  // What boxes are asked for, see for_each_near.
  [[nodiscard]] const Xy<double>& point() const { return q_; }
  [[nodiscard]] double squared_reach() const { return most_square(upper_); }
  [[nodiscard]] bool goes_on(double squared_distance) const { return squared_distance <= squared_reach(); }
  void look_at(std::uint32_t segment) { look_at(curves_.piece(segment), distance_bounds(q_, curves_.region(segment))); }

 private:
  void look_at(const Spiral_piece_2& piece, const Bracket& d) {
    upper_ = (std::min)(upper_, d.upper);
    const double enough = (std::max)(eps_, distance_resolution(curves_.error(piece.segment), upper_));
    const bool goes_on = d.lower < upper_ - enough && limit_.spend();
    const auto parts = goes_on ? halves(curves_, piece) : std::nullopt;
    if (!parts) {
      lower_ = (std::min)(lower_, d.lower);
      return;
    }
    const Bracket first = distance_bounds(q_, curves_.region(parts->first)),
                  second = distance_bounds(q_, curves_.region(parts->second));
    const bool is_first_nearer = first.lower <= second.lower;
    if (is_first_nearer) look_at(parts->first, first);
    look_at(parts->second, second);
    if (!is_first_nearer) look_at(parts->first, first);
  }

  const Curves& curves_;
  Xy<double> q_;
  double eps_, upper_ = HUGE_VAL, lower_ = HUGE_VAL;
  Work_limit limit_{std::size_t(1) << 16};  // halvings, far more than a box needs at 1e-6
};

}  // namespace study

namespace internal {

template <class Region>
[[nodiscard]] Search_report report_of_searches(Region (*make)(const Segment_hierarchy&, const Spiral_piece_2&),
                                               const Search_tasks& tasks, std::size_t repeat) {
  using Curves = study::Region_hierarchy<Region>;
  const Bounding_arc_tree_2 curves(tasks.curves), crossing(tasks.crossing), apart(tasks.apart);
  if (curves.empty() || crossing.empty() || apart.empty())
    throw std::invalid_argument(expected("tasks", "curves in each drawing", "none"));
  const Common_unit with_crossing(curves, crossing), with_apart(curves, apart);
  const Curves own(curves.in_unit(), make), a(with_crossing.a(), make), b(with_crossing.b(), make),
      c(with_apart.a(), make), d(with_apart.b(), make);
  Search_report report;
  const auto take = [&](Search_cost& cost, const Curves& p, const Curves& q, const auto& work) {
    const std::size_t before = p.asked() + q.asked();
    work();
    cost.regions = p.asked() + q.asked() - before;
    cost.seconds = least_seconds(repeat, work);
  };
  std::vector<Region> made(own.number_of_segments());
  report.regions.regions = made.size();
  report.regions.seconds = least_seconds(repeat, [&] {
    for (std::uint32_t i = 0; i < made.size(); ++i) made[i] = make(own, own.piece(i));
  });
  report.bytes = made.size() * sizeof(Region);

  std::vector<Bracket> of_points(tasks.points.size());
  take(report.closest, own, own, [&] {
    for (std::size_t i = 0; i < tasks.points.size(); ++i) {
      Closest_search search(own, point_in(curves.unit(), tasks.points[i]), std::numeric_limits<double>::infinity());
      search.search();
      of_points[i] = out(curves.unit(), *search.result()).distance;
    }
  });
  report.distances = of_points;
  take(report.descent, own, own, [&] {
    for (std::size_t i = 0; i < tasks.points.size(); ++i) {
      const Xy<double> q = point_in(curves.unit(), tasks.points[i]);
      of_points[i] =
          curves.unit().bounds_out(study::Region_descent(own, q, curves.unit().tolerance_in(tasks.eps)).search());
    }
  });
  report.distances.insert(report.distances.end(), of_points.begin(), of_points.end());
  for (Search_cost* cost : {&report.closest, &report.descent}) cost->regions /= 2;  // of one hierarchy, not of two
  take(report.intersections, a, b, [&] { report.common = out(with_crossing.unit(), Intersection_search(a, b).all()); });
  Bracket least{}, hausdorff{};
  take(report.distance, c, d, [&] {
    Distance_search search(c, d, with_apart.unit().tolerance_in(tasks.eps), 0);
    search.search();
    least = out(with_apart.unit(), *search.result()).distance;
  });
  take(report.hausdorff, a, b, [&] {
    Hausdorff_search search(a, b, with_crossing.unit().tolerance_in(tasks.eps));
    search.search();
    hausdorff = out(with_crossing.unit(), search.result()).distance;
  });
  report.distances.push_back(least);
  report.distances.push_back(hausdorff);
  return report;
}

}  // namespace internal

Search_report search_report(Region_kind kind, const Search_tasks& tasks, std::size_t repeat) {
  const auto report = [&](auto make) { return internal::report_of_searches(make, tasks, repeat); };
  switch (kind) {
    case Region_kind::BCA:
      return report(&study::region_in_hand<Bca>);
    case Region_kind::SFA:
      return report(&study::region_in_hand<Spiral_fat_arc>);
    case Region_kind::BILENS:
      return report(&study::region_in_hand<Bilens>);
    case Region_kind::FAT_ARC:
      return report(&study::region_in_hand<Three_point_fat_arc>);
    case Region_kind::FAT_BIARC:
      return report(&study::region_in_hand<Fat_biarc>);
    case Region_kind::BOX:
      return report(&study::region_in_hand<Axis_box>);
    case Region_kind::ORIENTED_BOX:
      return report(&study::region_in_hand<Oriented_box>);
    case Region_kind::HULL:
      break;
  }
  return report(&study::region_in_hand<Control_hull>);
}

Search_tasks search_tasks(const Drawing_2<double>& curves, std::size_t points, double eps) {
  const CGAL::Bbox_2 box = Bounding_arc_tree_2(curves).box();
  const double width = box.xmax() - box.xmin(), height = box.ymax() - box.ymin(), size = (std::max)(width, height);
  const Xy<double> low{box.xmin(), box.ymin()}, middle = low + Xy<double>{width / 2, height / 2};
  Search_tasks tasks{curves, {}, {}, {}, eps};
  const auto moved = [&](const auto& place) {
    Drawing_2<double> drawing;
    for (const auto& curve : curves.curves()) {
      std::vector<Bezier_curve_2<double>> pieces;
      for (const Bezier_curve_2<double>& piece : curve.beziers) {
        std::vector<Xy<double>> control_points = piece.control_points();
        for (Xy<double>& p : control_points) p = place(p);
        pieces.emplace_back(std::move(control_points), piece.weights());
      }
      drawing.add(std::move(pieces));
    }
    return drawing;
  };
  constexpr double OF_SIZE = 0.0625;  // so that symmetric curves do not lie on themselves
  tasks.crossing = moved([&](const Xy<double>& p) {
    return middle + perp(p - middle) + Xy<double>{OF_SIZE * size, OF_SIZE * size / 2};
  });
  tasks.apart = moved([&](const Xy<double>& p) { return p + Xy<double>{2 * width + size, OF_SIZE * size}; });
  const Xy<double> corner = middle - Xy<double>{size, size};
  for (std::size_t i = 0; i < points; ++i)
    for (std::size_t j = 0; j < points; ++j)
      tasks.points.push_back(corner + (2 * size / static_cast<double>(points)) *
                                          Xy<double>{static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5});
  return tasks;
}

bool have_same_answers(const Search_report& a, const Search_report& b) {
  if (a.distances.size() != b.distances.size() || a.common.points.size() != b.common.points.size() ||
      a.common.overlaps.size() != b.common.overlaps.size())
    return false;
  for (std::size_t i = 0; i < a.distances.size(); ++i)
    if (a.distances[i].lower > b.distances[i].upper || b.distances[i].lower > a.distances[i].upper) return false;
  for (std::size_t i = 0; i < a.common.points.size(); ++i) {
    const auto &p = a.common.points[i], &q = b.common.points[i];
    const auto agree = [](const Curve_range& s, const Curve_range& t) {
      return s.curve == t.curve && s.bezier == t.bezier && s.t.lower <= t.t.upper && t.t.lower <= s.t.upper;
    };
    if (p.kind != q.kind || !agree(p.a, q.a) || !agree(p.b, q.b)) return false;
  }
  return true;
}

}  // namespace CGAL::Bounding_arcs
