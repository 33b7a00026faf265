// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A medial axis, and what is asked of it.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_MEDIAL_AXIS_2_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_MEDIAL_AXIS_2_H

#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>
#include <CGAL/Bounding_arcs_2/query/Query_point.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <ostream>
#include <vector>

namespace CGAL::Bounding_arcs {

struct Bounding_parts;  // src/library/medial_axis/Bounding_parts.h

/// The medial axis of what closed curves fill: the centers of all discs inside that lie in no larger one. It is a graph
/// of vertices, and of edges with samples.
/// \code
/// const Medial_axis_2 axis = medial_axis(closed, 1e-4);
/// for (const Medial_axis_2::Edge& edge : axis.edges)
///   for (const Medial_axis_2::Sample& s : edge.samples)
///     std::cout << s.center.x << ' ' << s.center.y << ' ' << s.radius << '\n';
/// \endcode
/// Along an edge each disc touches the boundary twice, and samples name both places. Edges end at vertices: where the
/// axis branches, in convex corners with radius 0, and at maxima of curvature. Vertices are as good as doubles whatever
/// the tolerance. Between samples the axis is within `eps` of a line by an estimate; axis_certificate() proves most
/// axes.
///
/// Look at `status`. UNRESOLVED says that something is missing beside the places in `unresolved`.
///
/// Medial_axis_2::Options has the fill rule. With `is_framed` the last curve is a frame, and all other curves in it are
/// walls, open ones and points, too: the axis is then their Voronoi diagram.
///
/// Functions of the axis answer most questions: thin_stretches() and necks() find narrow places,
/// largest_inscribed_disc() the largest disc, clearance_path() a way with much room, voronoi_cells() what is nearest to
/// each curve. pruned() takes small branches away, axis_branches() joins edges to long ways, and axis_conics() writes
/// few conics for CAD.
struct Medial_axis_2 {
  /// A maximal disc where the axis ends or branches.
  struct Vertex {
    Xy<double> center;
    double radius = 0;
    std::vector<Curve_place> touches;  ///< the places that the disc touches; of arcs that it touches, both ends
    Bracket clearance{};               ///< holds the distance of the center from the boundary: the radius

    /// Writes center and radius, with a blank between.
    friend std::ostream& operator<<(std::ostream& out, const Vertex& answer) {
      return out << answer.center << ' ' << answer.radius;
    }
  };

  /// A maximal disc on an edge, and the two places that it touches: to the left and to the right of the way.
  struct Sample {
    Xy<double> center;
    double radius = 0;
    Curve_place left{}, right{};

    /// Writes the members in their order, with a blank between.
    friend std::ostream& operator<<(std::ostream& out, const Sample& answer) {
      return out << answer.center << ' ' << answer.radius << ' ' << answer.left << ' ' << answer.right;
    }
  };

  /// Maximal discs that touch twice, between two vertices.
  struct Edge {
    std::size_t from = 0, to = 0;  ///< vertices
    std::vector<Sample> samples;   ///< the first and the last ones are the vertices

    /// Whether the edge runs beside a curve: its discs touch the curve on one of their sides.
    [[nodiscard]] bool touches(std::size_t curve) const {
      const Sample& s = samples[samples.size() / 2];
      return s.left.curve == curve || s.right.curve == curve;
    }

    /// Writes a line for each sample.
    friend std::ostream& operator<<(std::ostream& out, const Edge& all) {
      for (const Sample& one : all.samples) out << one << '\n';
      return out;
    }
  };

  /// What came of a medial axis.
  enum class Status : std::uint8_t {
    COMPLETE,
    UNRESOLVED  ///< discs could not be told apart within rounding: beside `unresolved` something is missing
  };

  /// Which medial axis.
  /// \code
  /// Medial_axis_2::Options options;
  /// options.rule = Fill_rule::EVEN_ODD;
  /// const Medial_axis_2 axis = medial_axis(closed, 1e-4, options);
  /// \endcode
  struct Options {
    Fill_rule rule = Fill_rule::NONZERO;  ///< which points are inside
    bool is_framed =
        false;  ///< the last curve is a frame: all points in it are inside, other curves are walls and may cross
  };

  /// A way between two points (medial_axis.h).
  /// \code
  /// const auto path = clearance_path(closed, axis, {0.1, 0}, {-0.1, 0});
  /// if (path) std::cout << "a disc of radius " << path->bottleneck << " gets through\n";
  /// \endcode
  struct Path {
    /// A corner of the way.
    struct Station {
      Xy<double> point;
      double clearance;  ///< from the curves but those of the axis's left_out
    };
    std::vector<Station> stations;  ///< from one point to the other one, in straight lines
    double bottleneck = 0;          ///< the least clearance
    double length = 0;

    /// Writes a line for each station: its point and clearance.
    friend std::ostream& operator<<(std::ostream& out, const Path& path) {
      for (const Station& s : path.stations) out << s.point << ' ' << s.clearance << '\n';
      return out;
    }
  };

  struct Branch;          ///< a long way along edges, axis_branches.h
  struct Conic;           ///< a part of an edge as a conic, axis_conics.h
  struct Cell;            ///< the places that are nearest to a curve, voronoi_cells.h
  struct Thin_stretch;    ///< a way along which a shape is thin, thin_places.h
  struct Neck;            ///< a narrowest place, thin_places.h
  struct Inscribed_disc;  ///< the largest disc, maximal_disc.h
  struct Feet_apart;      ///< what trimmed() leaves, pruned.h
  struct Certificate;     ///< what is proven, axis_certificate.h

  Status status = Status::COMPLETE;
  std::size_t regions = 0;  ///< connected ones
  std::size_t holes = 0;    ///< of all regions together: vertices - edges = regions - holes
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  double eps = 0;    ///< what edges are sampled for: the tolerance, or what coordinates resolve
  double error = 0;  ///< at least |clearance - radius| of all vertices, and what their discs miss touches by
  /// A bound of how far curves were moved where they nearly meet. The axis is that of the moved curves. The bound is at
  /// most 2^-40 of the drawing's size.
  double moved = 0;
  /// Places of an UNRESOLVED axis where a part that was seen to be wrong is left out. An UNRESOLVED axis without places
  /// may be wrong anywhere.
  std::vector<Xy<double>> unresolved;
  std::vector<std::uint32_t> left_out;  ///< curves that bound nothing, as the rule fills both of their sides
  Options options;                      ///< what it is of
  /// Parts of curves that bound the regions. Axes from files, and far from the origin, have none: they are found again.
  std::shared_ptr<const Bounding_parts> bounds;

  /// How many edges end in each vertex; an edge that returns to its vertex counts twice.
  [[nodiscard]] std::vector<std::size_t> degrees() const {
    std::vector<std::size_t> result(vertices.size());
    for (const Edge& e : edges) ++result[e.from], ++result[e.to];
    return result;
  }

  /// Tells whether the axis is in order, without the curves that it is of. Numbers are finite, and parameters are in
  /// [0, 1]. Edges end at vertices, and their first and last samples are those discs bit for bit. A vertex's radius is
  /// within `error` of its clearance. From sample to sample radii change by no more than centers move, but for `eps`.
  /// A complete axis has V - E = regions - holes (Euler).
  /// \complexity linear in the samples
  [[nodiscard]] bool is_valid() const;

  /// Writes a line for each sample of each edge, and an empty line behind the edge.
  friend std::ostream& operator<<(std::ostream& out, const Medial_axis_2& all) {
    for (const Edge& one : all.edges) out << one << '\n';
    return out;
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
