// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces of plane_faces.h.
//
//   curves -> common points -> edges -> order round vertices -> rings of edges -> rings of segments

#include "plane_faces.h"

#include <CGAL/Bounding_arcs_2/boolean/internal/Face_rings.h>
#include <CGAL/Bounding_arcs_2/boolean/internal/United_curves.h>
#include <CGAL/Bounding_arcs_2/query/Intersection_search.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

[[nodiscard]] std::optional<Plane_faces> plane_faces(const United_curves& united, const Intersections_2<>& common,
                                                     double nearest) {
  const Segment_hierarchy& curves = united.curves.in_unit();
  const Cut_curves cut(curves, common, nearest);
  if (!cut.is_consistent()) return std::nullopt;
  const Edge_pieces pieces(cut);
  const Face_rings faces(pieces, nearest > NEAREST_CUTS);
  if (!faces.is_decided()) return std::nullopt;

  std::vector<Segment_part> parts;
  std::vector<std::uint32_t> first_part;  // by segment
  for (std::uint32_t s = 0; s < curves.number_of_segments(); ++s) {
    first_part.push_back(static_cast<std::uint32_t>(parts.size()));
    pieces.for_each_of_segment(s, [&](const Edge_piece& p) { parts.push_back({p.piece, p.error}); });
  }
  Plane_faces result{united.curves.unit(), curves.parted(parts), {}, {}};
  for (const Operand_bezier& b : united.beziers) result.places.push_back({b.curve, b.bezier});
  const auto part_of = [&](const Spiral_piece_2& piece) {
    std::uint32_t part = first_part[piece.segment];
    while (parts[part].piece.first.t < piece.first.t) ++part;
    return part;
  };
  for (const std::vector<Directed_edge>& ring : faces.rings()) {
    std::vector<Directed_segment> segments;
    for (const Directed_edge& e : ring) {
      const auto begin = static_cast<std::ptrdiff_t>(segments.size());
      pieces.for_each_of_edge(e.edge, [&](const Edge_piece& p) {
        segments.push_back({part_of(p.piece), e.is_reversed});
        return true;
      });
      if (e.is_reversed) std::reverse(segments.begin() + begin, segments.end());
    }
    result.rings.push_back(std::move(segments));
  }
  return result;
}

}  // namespace

std::optional<Plane_faces> plane_faces(const Outline_operand& operand, Decisions decisions) {
  const United_curves united = united_curves({operand}, Lone_points::KEPT, decisions);
  const Intersections_2<> common = Intersection_search(united.curves.in_unit()).all(false);
  const auto is_open = [](const Intersection_2<>& p) { return p.kind == Intersection_kind::UNDECIDED; };
  if (std::any_of(common.points.begin(), common.points.end(), is_open)) return std::nullopt;
  std::optional<Plane_faces> faces;
  try_nearest_cuts([&](double nearest) {
    faces = plane_faces(united, common, nearest);
    return faces.has_value();
  });
  return faces;
}

}  // namespace CGAL::Bounding_arcs::internal
