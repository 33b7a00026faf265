// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What curves cut the plane into: vertices, edges and faces.
//
//   common points -> equal places -> vertices and edges -> order round vertices -> rings of sides -> faces
//
// A side of an edge is what lies to the left of it, in its direction or against that.  A ring goes along the sides of
// one face, with the face on its left.  Each connected part of the curves has one outer ring, of the face around it; a
// ray tells which ring that is, and which face.  All other rings are the outer boundaries of faces within.

#ifndef BOUNDING_ARCS_LIBRARY_OVERLAY_OVERLAY_H
#define BOUNDING_ARCS_LIBRARY_OVERLAY_OVERLAY_H

#include "Cut_curves.h"

#include "../tree/Segment_hierarchy.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Where doubles left something open: near a point, on two Bezier pieces, numbered through.
struct Open_place {
  Xy<double> point;
  std::uint32_t bezier_a, bezier_b;
};

class Overlay {
 public:
  /// \param at_joints whether curves are cut where Bezier pieces meet, too
  explicit Overlay(const Segment_hierarchy& curves, bool at_joints = false);

  /// What is open. Then there is nothing else.
  [[nodiscard]] const std::optional<Open_place>& open() const { return open_; }

  [[nodiscard]] const Segment_hierarchy& curves() const { return curves_; }
  [[nodiscard]] const Cut_curves& cut() const { return cut_; }
  /// About where vertices are: all edges there have this point.
  [[nodiscard]] const std::vector<Xy<double>>& points() const { return points_; }
  [[nodiscard]] std::uint32_t vertex_at(std::uint32_t edge, bool at_start) const;  ///< \pre it has cuts
  /// The next side of the same face, as a ring goes on; of representatives alone.
  [[nodiscard]] Edge_side next(Edge_side s) const { return next_[s]; }
  [[nodiscard]] std::uint32_t face_of(Edge_side s) const { return face_of_ring_[ring_[s]]; }
  /// The face around a connected part of the curves, which a curve is of; it is told of points on no curve, too.
  [[nodiscard]] std::uint32_t face_around(std::uint32_t curve) const { return face_around_[curve]; }
  /// Face 0 is the one around all.
  [[nodiscard]] std::uint32_t number_of_faces() const { return faces_; }
  [[nodiscard]] std::uint32_t number_of_rings() const { return static_cast<std::uint32_t>(first_of_ring_.size() - 1); }
  [[nodiscard]] List_part<Edge_side> sides_of_ring(std::uint32_t ring) const {
    return {sides_.data() + first_of_ring_[ring], sides_.data() + first_of_ring_[ring + 1]};
  }
  /// The rings of a face; the first one is its outer boundary, but of face 0, which has none.
  [[nodiscard]] List_part<std::uint32_t> rings_of_face(std::uint32_t face) const {
    return {rings_.data() + first_of_face_[face], rings_.data() + first_of_face_[face + 1]};
  }

  /// Visits all faces, from face 0 on from one to a neighbour of it and back.
  /// \param cross(Edge_side s) is called as the way leads from the left of s over its edge
  /// \param visit(std::uint32_t face) is called once for each face
  template <class Cross, class Visit> void for_each_face(const Cross& cross, const Visit& visit) const;

 private:
  void find_points();
  [[nodiscard]] bool link();
  [[nodiscard]] bool link_at(std::uint32_t vertex);
  void trace();
  void nest();
  void open_at(std::uint32_t bezier, const Bracket& t, std::uint32_t other);

  const Segment_hierarchy& curves_;
  Cut_curves cut_;
  std::optional<Open_place> open_;
  std::vector<Xy<double>> points_;            // by vertex
  std::vector<Edge_side> next_;               // by side
  std::vector<std::uint32_t> ring_;           // by side
  std::vector<Edge_side> sides_;              // ring by ring
  std::vector<std::uint32_t> first_of_ring_;  // in sides_
  std::vector<std::uint32_t> face_of_ring_;
  std::vector<std::uint32_t> face_around_;  // by curve
  std::uint32_t faces_ = 1;
  std::vector<std::uint32_t> rings_;          // face by face
  std::vector<std::uint32_t> first_of_face_;  // in rings_
};

template <class Cross, class Visit> void Overlay::for_each_face(const Cross& cross, const Visit& visit) const {
  struct Step {
    std::uint32_t face, ring, place;  // where the way goes on from a face
    Edge_side came_over;              // a side of the face before
  };
  std::vector<char> is_visited(faces_, 0);
  std::vector<Step> way{{0, first_of_face_[0], 0, NO_NUMBER}};
  is_visited[0] = 1;
  visit(std::uint32_t{0});
  while (!way.empty()) {
    Step& at = way.back();
    if (at.ring == first_of_face_[at.face + 1]) {
      const Edge_side came_over = at.came_over;
      way.pop_back();
      if (came_over != NO_NUMBER) cross(other_side(came_over));
      continue;
    }
    const List_part<Edge_side> ring = sides_of_ring(rings_[at.ring]);
    if (ring.first + at.place == ring.last) {
      ++at.ring;
      at.place = 0;
      continue;
    }
    const Edge_side s = ring.first[at.place++];
    const std::uint32_t next = face_of(other_side(s));
    if (is_visited[next] != 0) continue;
    is_visited[next] = 1;
    cross(s);
    visit(next);
    way.push_back({next, first_of_face_[next], 0, s});
  }
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
