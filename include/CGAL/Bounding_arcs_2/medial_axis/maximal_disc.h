// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The largest disc that touches a curve at a place, on one side of it, and has no curve in it; and the largest disc of
// all, by the medial axis.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_MAXIMAL_DISC_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_MAXIMAL_DISC_H

#include <CGAL/Bounding_arcs_2/internal/medial_axis/Disc_search.h>
#include <CGAL/Bounding_arcs_2/internal/medial_axis/make_axis_boundary.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>

namespace CGAL::Bounding_arcs {

/// The largest disc inside that touches the curves in a given place.
struct Maximal_disc {
  Xy<double> centre;
  double radius = 0;
  std::optional<Curve_place> touches;  ///< nothing where the radius is that of the place's curvature
};

/// Maximal discs of the regions that closed curves enclose.
class Maximal_discs_2 {
 public:
  /// \param index must outlive this
  /// \throws std::invalid_argument if a curve is open
  explicit Maximal_discs_2(const Curve_index_2& index, Fill_rule rule = Fill_rule::NONZERO)
      : index_(index), boundary_(made(index, rule)) {}

  /// The one that touches at a place, from the left of the curve where a region is on both sides.
  /// \return nothing where no region is
  /// \throws std::invalid_argument if there is no such place
  /// \complexity about logarithmic in the number of segments
  [[nodiscard]] std::optional<Maximal_disc> operator()(const Curve_place& place) const {
    const std::uint32_t segment = segment_of(place);
    for (const std::uint32_t e : boundary_.sides(segment).of)
      if (e != internal::Axis_boundary::NONE) return at(boundary_.place(e, place.t));
    return std::nullopt;
  }

 private:
  // Along a spiral segment no disc touches twice: another place is on another segment.
  struct Not_segment {
    const internal::Axis_boundary& boundary;
    std::uint32_t segment;
    template <class Visit> void for_each(std::uint32_t e, const Visit& visit) const {
      const internal::Boundary_element& element = boundary.element(e);
      if (element.segment != segment) visit(element.first, element.last);
    }
  };
  [[nodiscard]] static internal::Axis_boundary made(const Curve_index_2& index, Fill_rule rule) {
    check_closed(index.drawing());
    return internal::Axis_boundary_maker(index, rule).boundary();
  }
  [[nodiscard]] std::uint32_t segment_of(const Curve_place& place) const {
    const auto count = static_cast<std::uint32_t>(index_.number_of_segments());
    std::uint32_t low = 0, high = count;  // the first one that does not end before the place
    while (low < high) {
      const std::uint32_t middle = low + (high - low) / 2;
      const Segment_place& p = index_.place(middle);
      const bool is_before =
          p.curve != place.curve
              ? p.curve < place.curve
              : (p.bezier != place.bezier ? p.bezier < place.bezier : index_.piece(middle).last.t < place.t);
      if (is_before) low = middle + 1;
      else high = middle;
    }
    if (low == count || index_.place(low).curve != place.curve || index_.place(low).bezier != place.bezier ||
        !(place.t >= 0))
      throw std::invalid_argument("the drawing has no such place");
    return low;
  }
  [[nodiscard]] Maximal_disc at(const internal::Boundary_place& p) const {
    const internal::Boundary_jet jet = boundary_(p);
    const double curvature = jet.speed > 0 ? jet.turn / jet.speed : 0;
    double most = boundary_.largest_radius();
    if (curvature * most > 1) most = 1 / curvature;
    const Not_segment others{boundary_, boundary_.element(p.element).segment};
    internal::Disc_search<Not_segment> search(boundary_, others, jet.point, jet.normal(), most);
    search.search();
    Maximal_disc disc{search.centre(), search.radius(), std::nullopt};
    if (search.is_found()) disc.touches = boundary_.curve_place(search.place());
    return disc;
  }

  const Curve_index_2& index_;
  internal::Axis_boundary boundary_;
};

/// The largest disc inside, with a bracket of its radius.
struct Inscribed_disc {
  Xy<double> centre;
  Distance_bounds radius{};
};
/// \return nothing of an axis without vertices
/// \guarantee the disc with radius.lower about the centre is certified to have no curve in it; that none is larger than
///   radius.upper is as good as the axis
/// \complexity linear in the samples
[[nodiscard]] inline std::optional<Inscribed_disc> largest_inscribed_disc(const Curve_index_2& index,
                                                                          const Medial_axis_2& axis) {
  if (axis.vertices.empty()) return std::nullopt;
  const Medial_vertex* vertex = &axis.vertices.front();
  for (const Medial_vertex& v : axis.vertices)
    if (v.radius > vertex->radius) vertex = &v;
  Xy<double> centre = vertex->centre;
  double most = vertex->radius;
  for (const Medial_edge& e : axis.edges)
    for (const Medial_sample& s : e.samples)
      if (s.radius > most) most = s.radius, centre = s.centre;
  const Distance_bounds found = closest_point(index, centre)->distance;
  return Inscribed_disc{centre, {found.lower, (std::max)(found.upper, most + axis.eps)}};
}

}  // namespace CGAL::Bounding_arcs

#endif
