// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces of plane_faces.h.
//
//   curves -> overlay -> rings of edges -> rings of segments

#include "plane_faces.h"

#include "../overlay/Overlay.h"
#include "../overlay/United_curves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

/// Segments, cut in doubles where curves are. All parts at a vertex have one point there, so that rings are closed. An
/// edge that doubles do not tell from a point has no part; its vertices are one.
class Parted_segments {
 public:
  explicit Parted_segments(const Overlay& overlay)
      : overlay_(overlay), cut_(overlay.cut()), curves_(overlay.curves()), parts_of_(cut_.edges().size()),
        joined_(cut_.number_of_vertices()) {
    for (std::uint32_t s = 0; s < curves_.number_of_segments(); ++s)
      for_each_part(s, [&](const Spiral_piece_2&, std::uint32_t edge, std::uint32_t, std::uint32_t) {
        parts_of_[edge].push_back(static_cast<std::uint32_t>(count_++));
      });
    for (std::uint32_t e = 0; e < cut_.edges().size(); ++e)
      if (parts_of_[e].empty() && cut_.edges()[e].first != NO_NUMBER)
        joined_.join(overlay.vertex_at(e, true), overlay.vertex_at(e, false));
    parts_.reserve(count_);
    for (std::uint32_t s = 0; s < curves_.number_of_segments(); ++s)
      for_each_part(s, [&](Spiral_piece_2 piece, std::uint32_t, std::uint32_t from, std::uint32_t to) {
        const double moved = (std::max)(move(piece.first, from), move(piece.last, to));
        parts_.push_back({piece, curves_.error(s) + moved});
      });
    put_starts_last();
  }
  [[nodiscard]] const std::vector<Segment_part>& parts() const { return parts_; }
  /// Numbers of the parts of an edge, in its direction.
  [[nodiscard]] const std::vector<std::uint32_t>& parts_of(std::uint32_t edge) const { return parts_of_[edge]; }

 private:
  // Calls visit(piece, edge, cut at its start, cut at its end), in the order of the segment.
  template <class Visit> void for_each_part(std::uint32_t segment, const Visit& visit) const {
    const Spiral_piece_2& whole = curves_.piece(segment);
    const std::size_t curve = curves_.place(segment).curve;
    const auto [first, end] = cut_.cuts_of_bezier(curves_.bezier_of(segment));
    std::uint32_t cut = first;
    double t = 0;  // cuts are in order; the middles of their brackets need not be
    const auto parameter = [&] { return (std::max)(t, cut_.cuts()[cut].at.t.middle()); };
    while (cut < end && parameter() < whole.first.t) t = parameter(), ++cut;
    Spiral_piece_2 part{segment, whole.first, whole.first};
    std::uint32_t from = NO_NUMBER;
    while (cut < end && parameter() == whole.first.t) from = cut++;
    while (cut < end && parameter() < whole.last.t) {
      t = parameter();
      part.last = curves_.sample(segment, t);
      visit(part, cut_.edge_at(curve, cut), from, cut);
      part.first = part.last;
      while (cut < end && parameter() == t) from = cut++;
    }
    const bool is_cut_there = cut < end && parameter() == whole.last.t;
    part.last = whole.last;
    visit(part, cut_.edge_at(curve, cut), from, is_cut_there ? cut : NO_NUMBER);
  }
  // How far a sample's point was moved to that of its vertex.
  [[nodiscard]] double move(Spiral_sample& sample, std::uint32_t cut) {
    if (cut == NO_NUMBER) return 0;
    const Xy<double>& to = overlay_.points()[joined_.find(cut_.cuts()[cut].vertex)];
    const Xy<double> way = to - sample.point;
    sample.point = to;
    return std::fabs(way.x) + std::fabs(way.y);
  }
  // An edge through the start of its curve has its last parts there.
  void put_starts_last() {
    for (std::uint32_t e = 0; e < cut_.edges().size(); ++e) {
      const Cut_edge& edge = cut_.edges()[e];
      if (edge.first == NO_NUMBER || edge.last > edge.first) continue;
      const Joint_place& from = cut_.cuts()[edge.first].at;
      std::vector<std::uint32_t>& parts = parts_of_[e];
      const auto is_at_start = [&](std::uint32_t p) {
        const std::uint32_t bezier = curves_.bezier_of(parts_[p].piece.segment);
        return bezier < from.bezier || (bezier == from.bezier && parts_[p].piece.first.t < from.t.middle());
      };
      std::stable_partition(parts.begin(), parts.end(), [&](std::uint32_t p) { return !is_at_start(p); });
    }
  }

  const Overlay& overlay_;
  const Cut_curves& cut_;
  const Segment_hierarchy& curves_;
  std::vector<std::vector<std::uint32_t>> parts_of_;  // by edge
  Joined_sets joined_;                                // vertices
  std::vector<Segment_part> parts_;
  std::size_t count_ = 0;
};

}  // namespace

std::optional<Plane_faces> plane_faces(const Outline_operand& operand, Decisions decisions) {
  const United_curves united = united_curves({operand}, Lone_points::KEPT, decisions);
  const Segment_hierarchy& curves = united.curves.in_unit();
  const Overlay overlay(curves);
  if (overlay.open()) return std::nullopt;
  const Parted_segments parted(overlay);
  Plane_faces result{united.curves.unit(), curves.parted(parted.parts()), {}, {}};
  for (const Operand_bezier& b : united.beziers) result.places.push_back({b.curve, b.bezier});
  for (std::uint32_t ring = 0; ring < overlay.number_of_rings(); ++ring) {
    std::vector<Directed_segment> segments;
    for (const Edge_side s : overlay.sides_of_ring(ring)) {
      const auto begin = static_cast<std::ptrdiff_t>(segments.size());
      for (const std::uint32_t part : parted.parts_of(edge_of(s))) segments.push_back({part, is_reversed(s)});
      if (is_reversed(s)) std::reverse(segments.begin() + begin, segments.end());
    }
    if (!segments.empty()) result.rings.push_back(std::move(segments));
  }
  return result;
}

}  // namespace CGAL::Bounding_arcs::internal
