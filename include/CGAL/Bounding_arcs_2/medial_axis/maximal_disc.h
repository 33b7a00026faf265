// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The largest disc that touches a curve at a place, on one side of it, and has no curve in it; and the largest disc of
// all, by the medial axis.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_MAXIMAL_DISC_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_MAXIMAL_DISC_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <memory>
#include <optional>
#include <ostream>

namespace CGAL::Bounding_arcs {

/// Maximal discs of the regions that closed curves fill, as medial_axis takes them.
/// \code
/// const Maximal_discs_2 discs(closed);
/// const Curve_place place{0, 0, 0.5};  // the middle of the first Bezier piece
/// if (const auto disc = discs(place)) std::cout << disc->radius << '\n';
/// \endcode
class Maximal_discs_2 {
 public:
  /// The largest disc inside that touches the curves in a given place.
  struct Disc {
    Xy<double> center;
    double radius = 0;
    std::optional<Curve_place> touches;  ///< nothing where the radius is that of the place's curvature

    /// Writes center and radius, with a blank between.
    friend std::ostream& operator<<(std::ostream& out, const Disc& answer) {
      return out << answer.center << ' ' << answer.radius;
    }
  };

  /// \param tree must outlive this
  /// \throws std::invalid_argument if a curve is open
  explicit Maximal_discs_2(const Bounding_arc_tree_2& tree, Fill_rule rule = Fill_rule::NONZERO);

  /// The one that touches at a place.
  /// \return nothing where the curve bounds no region
  /// \throws std::invalid_argument if there is no such place
  /// \complexity about logarithmic in the number of segments
  [[nodiscard]] std::optional<Disc> operator()(const Curve_place& place) const;

 private:
  struct Boundary;
  std::shared_ptr<const Boundary> boundary_;  // copies share it
};

/// The largest disc inside, with a bracket of its radius.
/// \code
/// if (const auto disc = largest_inscribed_disc(closed, axis)) std::cout << disc->radius.lower << '\n';
/// \endcode
struct Medial_axis_2::Inscribed_disc {
  Xy<double> center;
  Bracket radius{};

  /// Writes the members in their order, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Inscribed_disc& answer) {
    return out << answer.center << ' ' << answer.radius;
  }
};

/// Returns the largest disc of an axis.
/// \return nothing of an axis without vertices
/// \guarantee the disc with radius.lower about the center is certified to have no curve in it; that none is larger than
///   radius.upper is as good as the axis
/// \complexity linear in the samples
[[nodiscard]] std::optional<Medial_axis_2::Inscribed_disc> largest_inscribed_disc(const Bounding_arc_tree_2& tree,
                                                                                  const Medial_axis_2& axis);

}  // namespace CGAL::Bounding_arcs

#endif
