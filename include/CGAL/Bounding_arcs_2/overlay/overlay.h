// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the curves of drawings cut the plane into, decided exactly, and the areas of faces.

#ifndef CGAL_BOUNDING_ARCS_2_OVERLAY_OVERLAY_H
#define CGAL_BOUNDING_ARCS_2_OVERLAY_OVERLAY_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <vector>

namespace CGAL::Bounding_arcs {

/// What curves cut the plane into: vertices, edges and faces, decided exactly. Face 0 is around all curves.
/// \code
/// const Overlay_2 cells = overlay(tree, other);  // overlay.h
/// cells.for_each_face([&](std::uint32_t face, const std::vector<int>& windings) {
///   if (windings[0] != 0 && windings[1] == 0) std::cout << cells.faces[face].boundaries.size() << '\n';
/// });
/// \endcode
/// Vertices, edges and faces name each other by numbers from 0. An edge runs between two vertices, has a face on either
/// side, and knows all curves that run along it. A face has its boundaries, the outer one first. Winding numbers tell
/// which operands a face is inside of: for_each_face() visits all faces with theirs, windings() has those of one face.
/// face_area() has two bounds of an area.
///
/// Curves may be open. They may touch, run together, fold back, or be points. With Overlay_2::Options::at_joints edges
/// also end where Bezier pieces join, so that each is a part of one piece.
///
/// Take boolean_operation() where you want one region and not all faces. Take Arr_curve_traits_2 where you need an
/// algorithm of CGAL's arrangements; it is slower.
struct Overlay_2 {
  /// What an overlay, an outline or parts of clipped curves are known to be.
  enum class Status : std::uint8_t {
    COMPLETE,  ///< exactly what was asked for; always so with exact decisions
    UNDECIDED  ///< doubles left something open, and nothing else decides: there is no more than this
  };

  /// Where two curves meet in a way that was not decided.
  struct Undecided {
    /// A Bezier piece of one of the drawings.
    struct Of {
      std::uint32_t operand = 0, curve = 0, bezier = 0;
    };
    Xy<double> at;  ///< about
    Of a, b;
  };

  /// Says where an overlay cuts curves, beside the places where they meet.
  struct Options {
    bool at_joints = false;  ///< where Bezier pieces join, too: each source of an edge has one part then
  };

  /// A point where curves meet or end, or are a point.
  struct Vertex {
    Xy<double> point;                   ///< the vertex but for rounding
    Bracket x, y;                       ///< hold its coordinates
    std::optional<std::uint32_t> face;  ///< the face that it is in, of a vertex without edges

    /// Writes the members in their order, with a blank between.
    friend std::ostream& operator<<(std::ostream& out, const Vertex& answer) {
      return out << answer.x << ' ' << answer.y;
    }
  };

  /// A part of a Bezier piece.
  struct Part {
    std::uint32_t bezier = 0;  ///< of its curve
    Bracket from, to;          ///< hold the parameters of start and end, which may be nearer than doubles tell

    /// Writes the members in their order, with a blank between.
    friend std::ostream& operator<<(std::ostream& out, const Part& answer) {
      return out << answer.bezier << ' ' << answer.from << ' ' << answer.to;
    }
  };

  /// A curve that runs along an edge.
  struct Source {
    std::uint32_t operand = 0;  ///< the number of the drawing, in the order in which they were given
    std::uint32_t curve = 0;    ///< of that drawing
    bool is_closed = false;     ///< whether the curve is; an open one runs round nothing
    bool is_reversed = false;   ///< whether it runs against the edge: `from` of parts is above `to`
    std::vector<Part> parts;    ///< in the direction of the edge
  };

  /// A part of curves between two vertices, with none inside. It may be shorter than doubles tell.
  struct Edge {
    std::optional<std::uint32_t> from, to;  ///< vertices; none of a closed curve without any
    std::uint32_t left = 0, right = 0;      ///< faces
    std::vector<Source> sources;            ///< all curves that run along it; the edge runs as the first one does
  };

  /// An edge as it is run through along the boundary of a face.
  struct Side {
    std::uint32_t edge = 0;
    bool is_reversed = false;  ///< against the edge
  };

  /// A connected part of the plane without the curves.
  struct Face {
    bool is_bounded = true;  ///< all but face 0 are
    /// Closed ways along edges, with the face on the left. The outer one comes first; face 0 has none such. Both sides
    /// of an edge are in them where that has the face on both.
    std::vector<std::vector<Side>> boundaries;
    /// A side with the face on its left, and a face of a lesser number on its right; none of face 0.
    std::optional<Side> way_out;
  };

  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  std::vector<Face> faces;
  std::size_t number_of_operands = 0;
  Status status = Status::COMPLETE;
  std::optional<Undecided> undecided;  ///< where `status` is UNDECIDED; then there is nothing else

  /// Returns how often the closed curves of each operand run round a face, counterclockwise more than 0.
  /// \complexity that of the edges on a way to face 0
  [[nodiscard]] std::vector<int> windings(std::uint32_t face) const {
    std::vector<int> result(number_of_operands, 0);
    for (; faces[face].way_out; face = out_of(face)) go_in(face, 1, result);
    return result;
  }
  /// Visits all faces in their order, with these numbers. Between two visits they change by what is crossed.
  /// \param visit is called with each face and these numbers: visit(std::uint32_t, const std::vector<int>&)
  /// \complexity that of all edges; a winding number for each operand is all that is kept
  template <class Visit> void for_each_face(const Visit& visit) const {
    std::vector<int> numbers(number_of_operands, 0);
    std::uint32_t at = 0;
    for (std::uint32_t face = 0; face < faces.size(); ++face) {
      if (face > 0) {
        // faces are in such an order that the way goes on from one around the face before
        for (; at != out_of(face); at = out_of(at)) go_in(at, -1, numbers);
        go_in(face, 1, numbers);
        at = face;
      }
      visit(face, static_cast<const std::vector<int>&>(numbers));
    }
  }

  /// Returns the area of a face, without what lies in its holes.
  /// \code
  /// const Overlay_2 cells = overlay(tree);
  /// for (std::uint32_t face = 1; face < cells.faces.size(); ++face)
  ///   std::cout << cells.face_area({&tree}, face, 1e-9).lower << '\n';
  /// \endcode
  /// \param face the number of a face, bounded
  /// \param trees those that the overlay was made of, in their order
  /// \param eps how far the bounds may be apart; they are farther where doubles tell no more of rational curves, or of
  ///   the parameters of vertices
  /// \guarantee certified; for polynomial curves the nearest doubles, but for what parameters of vertices leave open
  /// \complexity some tens of microseconds an edge
  /// \throws std::invalid_argument if the face is unbounded, or eps below 0
  [[nodiscard]] Measure_bounds face_area(const std::vector<const Bounding_arc_tree_2*>& trees, std::uint32_t face,
                                         double eps) const;

 private:
  [[nodiscard]] std::uint32_t out_of(std::uint32_t face) const {
    const Side& side = *faces[face].way_out;
    return side.is_reversed ? edges[side.edge].left : edges[side.edge].right;
  }
  // The left of a closed curve has one more than its right.
  void go_in(std::uint32_t face, int sign, std::vector<int>& windings) const {
    const Side& side = *faces[face].way_out;
    for (const Source& s : edges[side.edge].sources)
      if (s.is_closed) windings[s.operand] += s.is_reversed == side.is_reversed ? sign : -sign;
  }
};

/// Returns what the curves of several trees, open ones and closed ones, cut the plane into.
/// \param options what is cut beside places where curves meet
/// \return vertices, edges and faces. Curves that run together are one edge. A curve that is a point is a vertex
/// \guarantee with exact decisions vertices, edges and faces are those of the exact curves: no two are made one,
///   however near they are. If a tree has others, the status tells whether doubles left something open
/// \throws std::invalid_argument for curves out of the range of queries
/// \complexity (n + k) log n for n Bezier pieces and k common points, and exact arithmetic where curves touch or
///   overlap
[[nodiscard]] Overlay_2 overlay(const std::vector<const Bounding_arc_tree_2*>& trees,
                                const Overlay_2::Options& options = {});

/// Returns what a tree's curves cut the plane into. See above.
[[nodiscard]] inline Overlay_2 overlay(const Bounding_arc_tree_2& tree, const Overlay_2::Options& options = {}) {
  return overlay({&tree}, options);
}
/// Returns what the curves of two trees cut the plane into. See above.
[[nodiscard]] inline Overlay_2 overlay(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b,
                                       const Overlay_2::Options& options = {}) {
  return overlay({&a, &b}, options);
}

}  // namespace CGAL::Bounding_arcs

#endif
