// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of Bounding_parts.h.
//
//   curves -> overlay -> faces inside -> rings of edges -> rings of parts of segments

#include "../boolean/Region_loops.h"
#include "../overlay/Overlay.h"

#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include "../query/Winding_search.h"
#include "../tree/Segment_hierarchy.h"
#include "Bounding_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

/// How often curves wind round points of faces; in a frame that alone.
[[nodiscard]] std::vector<int> windings_of_faces(const Overlay& overlay, const Medial_axis_2::Options& options) {
  const Cut_curves& cut = overlay.cut();
  const std::size_t frame = overlay.curves().drawing().curves().size() - 1;
  std::vector<int> windings(overlay.number_of_faces(), 0);
  int winding = 0;
  overlay.for_each_face(
      [&](Edge_side s) {
        for (std::uint32_t e = edge_of(s); e != NO_NUMBER; e = cut.next_member(e)) {
          const Cut_edge& edge = cut.edges()[e];
          if (options.is_framed && edge.curve != frame) continue;
          winding += edge.is_against == is_reversed(s) ? -1 : 1;  // the left of an edge has one more than its right
        }
      },
      [&](std::uint32_t face) { windings[face] = winding; });
  return windings;
}
[[nodiscard]] bool is_inside(const Medial_axis_2::Options& options, int winding) {
  return is_filled(options.is_framed ? Fill_rule::NONZERO : options.rule, winding);
}

/// In a frame each face is a region, and a curve with one face on both sides is a wall in it.
[[nodiscard]] std::vector<Region_loop> bounding_rings(const Overlay& overlay, const Medial_axis_2::Options& options,
                                                      const std::vector<int>& windings) {
  std::vector<char> are_inside;  // by face
  for (const int w : windings) are_inside.push_back(is_inside(options, w) ? 1 : 0);
  if (!options.is_framed) return region_loops(overlay, are_inside, Loops_at_vertices::GO_ON);
  std::vector<Region_loop> rings;
  for (std::uint32_t face = 1; face < overlay.number_of_faces(); ++face) {
    if (are_inside[face] == 0) continue;
    bool is_outer = true;  // the first one
    for (const std::uint32_t ring : overlay.rings_of_face(face)) {
      const List_part<Edge_side> sides = overlay.sides_of_ring(ring);
      rings.push_back({{sides.begin(), sides.end()}, is_outer, {}});
      is_outer = false;
    }
  }
  return rings;
}

/// Segments, cut in doubles where curves are. All parts at a vertex have one point there, so that rings are closed. An
/// edge that doubles do not tell from a point has no part; its vertices are one.
class Parted_segments {
 public:
  /// \param is_wanted by edge
  Parted_segments(const Overlay& overlay, const std::vector<char>& is_wanted)
      : overlay_(overlay), cut_(overlay.cut()), curves_(overlay.curves()), is_wanted_(is_wanted),
        parts_of_(cut_.edges().size()), joined_(cut_.number_of_vertices()) {
    std::uint32_t count = 0;
    for (std::uint32_t s = 0; s < curves_.number_of_segments(); ++s)
      for_each_part(s, [&](const Spiral_piece_2&, std::uint32_t edge, std::uint32_t, std::uint32_t) {
        parts_of_[edge].push_back(count++);
      });
    for (std::uint32_t e = 0; e < cut_.edges().size(); ++e)
      if (is_wanted_[e] != 0 && parts_of_[e].empty() && cut_.edges()[e].first != NO_NUMBER)
        joined_.join(overlay.vertex_at(e, true), overlay.vertex_at(e, false));
    parts_.reserve(count);
    for (std::uint32_t s = 0; s < curves_.number_of_segments(); ++s)
      for_each_part(s, [&](Spiral_piece_2 piece, std::uint32_t, std::uint32_t from, std::uint32_t to) {
        const double moved = (std::max)(move(piece.first, from), move(piece.last, to));
        moved_ = (std::max)(moved_, moved);
        parts_.push_back({piece, curves_.error(s) + moved});
        for (const std::uint32_t cut : {from, to}) vertices_.push_back(cut == NO_NUMBER ? cut : vertex_of(cut));
      });
    put_starts_last();
  }
  [[nodiscard]] const std::vector<Segment_part>& parts() const { return parts_; }
  [[nodiscard]] double moved() const { return moved_; }
  /// By end of a part, 2 times its number, plus 1 at its last one; NO_NUMBER where it is cut at none.
  [[nodiscard]] const std::vector<std::uint32_t>& vertices() const { return vertices_; }
  /// Numbers of the parts of an edge, in its direction.
  [[nodiscard]] const std::vector<std::uint32_t>& parts_of(std::uint32_t edge) const { return parts_of_[edge]; }

 private:
  // Calls visit(piece, edge, cut at its start, cut at its end), in the order of the segment, of edges that are wanted.
  template <class Visit> void for_each_part(std::uint32_t segment, const Visit& visit) const {
    const Spiral_piece_2 whole = curves_.piece(segment);
    const std::size_t curve = curves_.place(segment).curve;
    const auto [first, end] = cut_.cuts_of_bezier(curves_.bezier_of(segment));
    std::uint32_t cut = first;
    double t = 0;  // cuts are in order; the middles of their brackets need not be
    const auto parameter = [&] { return (std::max)(t, cut_.cuts()[cut].at.t.middle()); };
    while (cut < end && parameter() < whole.first.t) t = parameter(), ++cut;
    Spiral_piece_2 part{segment, whole.first, whole.first};
    std::uint32_t from = NO_NUMBER;
    const auto visit_wanted = [&](std::uint32_t to) {
      const std::uint32_t edge = cut_.edge_at(curve, cut);
      if (is_wanted_[edge] != 0) visit(part, edge, from, to);
    };
    while (cut < end && parameter() == whole.first.t) from = cut++;
    while (cut < end && parameter() < whole.last.t) {
      t = parameter();
      part.last = curves_.sample(segment, t);
      visit_wanted(cut);
      part.first = part.last;
      while (cut < end && parameter() == t) from = cut++;
    }
    const bool is_cut_there = cut < end && parameter() == whole.last.t;
    part.last = whole.last;
    visit_wanted(is_cut_there ? cut : NO_NUMBER);
  }
  [[nodiscard]] std::uint32_t vertex_of(std::uint32_t cut) { return joined_.find(cut_.cuts()[cut].vertex); }
  // How far a sample's point was moved to that of its vertex, which rounding has moved, too, unless it is an end.
  [[nodiscard]] double move(Spiral_sample& sample, std::uint32_t cut) {
    if (cut == NO_NUMBER) return 0;
    const Xy<double>& to = overlay_.points()[vertex_of(cut)];
    const Xy<double> way = to - sample.point;
    sample.point = to;
    constexpr double ROUNDING = 4 * HALF_ULP;
    const bool is_end = sample.t == 0 || sample.t == 1;
    const double rounding = is_end && way.x == 0 && way.y == 0 ? 0 : ROUNDING * (std::fabs(to.x) + std::fabs(to.y));
    return std::fabs(way.x) + std::fabs(way.y) + rounding;
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
  const std::vector<char>& is_wanted_;
  std::vector<std::vector<std::uint32_t>> parts_of_;  // by edge
  Joined_sets joined_;                                // vertices
  std::vector<Segment_part> parts_;
  std::vector<std::uint32_t> vertices_;
  double moved_ = 0;
};

/// Leaves rings out whose parts are that short: a curve that turns in a node may loop there. In a frame only regions
/// within such rings are left out: to those around them they are points of walls.
/// \return whether there are such
[[nodiscard]] bool leave_specks_out(const Parted_segments& parted, double least, bool is_framed,
                                    std::vector<Region_loop>& rings) {
  const auto is_short = [&](Edge_side s) {
    const std::vector<std::uint32_t>& parts = parted.parts_of(edge_of(s));
    return std::all_of(parts.begin(), parts.end(), [&](std::uint32_t p) {
      const Spiral_piece_2& piece = parted.parts()[p].piece;
      return piece.first.t < piece.last.t && euclidean_norm(piece.last.point - piece.first.point) <= least;
    });
  };
  const std::size_t count = rings.size();
  const auto is_speck = [&](const Region_loop& r) {
    return (r.is_ccw || !is_framed) && std::all_of(r.sides.begin(), r.sides.end(), is_short);
  };
  rings.erase(std::remove_if(rings.begin(), rings.end(), is_speck), rings.end());
  return rings.size() < count;
}

/// Bezier pieces but those that are points, which the overlay does not take in longer curves.
[[nodiscard]] std::vector<std::uint32_t> pieces_of_length(const Segment_hierarchy& curves) {
  std::vector<std::uint32_t> kept;
  std::uint32_t bezier = 0;
  for (const auto& curve : curves.drawing().curves())
    for (std::size_t left = curve.beziers.size(), i = left; i > 0; --i, ++bezier)
      if (left == 1 || !curves.is_point(bezier)) kept.push_back(bezier);
      else --left;
  return kept;
}

/// Curves that bound nothing.
[[nodiscard]] std::vector<std::uint32_t> curves_left_out(const Segment_hierarchy& curves,
                                                         const Segment_hierarchy& parts) {
  std::vector<char> is_there(curves.drawing().curves().size(), 0);
  for (std::uint32_t s = 0; s < parts.number_of_segments(); ++s) is_there[parts.place(s).curve] = 1;
  std::vector<std::uint32_t> result;
  for (std::uint32_t c = 0; c < is_there.size(); ++c)
    if (is_there[c] == 0) result.push_back(c);
  return result;
}

}  // namespace

Bounding_parts bounding_parts(const Segment_hierarchy& curves, const Medial_axis_2::Options& options, double close) {
  const std::vector<std::uint32_t> pieces = pieces_of_length(curves);
  std::optional<Segment_hierarchy> of_length;
  if (pieces.size() < curves.number_of_beziers()) of_length = curves.of_pieces(pieces);
  const Overlay overlay(of_length ? *of_length : curves);
  if (overlay.open()) return {curves.parted({}), {}, {}, 0, overlay.open()->point};
  const std::vector<int> windings = windings_of_faces(overlay, options);
  std::vector<Region_loop> rings = bounding_rings(overlay, options, windings);
  const auto are_wanted = [&] {
    std::vector<char> result(overlay.cut().edges().size(), 0);
    for (const Region_loop& ring : rings)
      for (const Edge_side s : ring.sides) result[edge_of(s)] = 1;
    return result;
  };
  std::vector<char> is_wanted = are_wanted();
  auto parted = std::make_unique<const Parted_segments>(overlay, is_wanted);
  const double speck = 2 * (std::max)(close, CLOSE_WALLS * curves.drawing().coordinate_size());
  const bool has_specks = leave_specks_out(*parted, speck, options.is_framed, rings);
  if (has_specks) {
    is_wanted = are_wanted();
    parted = std::make_unique<const Parted_segments>(overlay, is_wanted);
  }
  std::vector<Segment_part> parts = parted->parts();
  if (of_length) {
    std::vector<std::uint32_t> given;  // by segment of those with a length
    for (std::uint32_t i = 0; i < curves.number_of_segments(); ++i)
      if (std::binary_search(pieces.begin(), pieces.end(), curves.bezier_of(i))) given.push_back(i);
    for (Segment_part& p : parts) p.piece.segment = given[p.piece.segment];
  }
  Bounding_parts result{curves.parted(parts), {}, {}, parted->moved() + (has_specks ? speck : 0), {}};
  for (const Region_loop& ring : rings) {
    Bounding_ring made{{}, ring.is_ccw};
    for (const Edge_side s : ring.sides) {
      const auto begin = static_cast<std::ptrdiff_t>(made.way.size());
      for (const std::uint32_t part : parted->parts_of(edge_of(s))) made.way.push_back({part, is_reversed(s)});
      if (is_reversed(s)) std::reverse(made.way.begin() + begin, made.way.end());
    }
    if (!made.way.empty()) result.rings.push_back(std::move(made));
  }
  if (!options.is_framed) result.left_out = curves_left_out(curves, result.segments);
  result.number_joints(parted->vertices());
  std::vector<Side_windings> sides(parts.size());
  for (std::uint32_t e = 0; e < is_wanted.size(); ++e)
    for (const std::uint32_t part : parted->parts_of(e))
      sides[part] = {windings[overlay.face_of(side_of(e, false))], windings[overlay.face_of(side_of(e, true))]};
  const auto is_within = [&](int winding) { return is_inside(options, winding); };
  const auto winding_at = [&](const Xy<double>& p) { return options.is_framed ? 1 : winding_number(curves, p).number; };
  return with_close_walls_joined(std::move(result), sides, is_within, winding_at, close);
}

std::shared_ptr<const Bounding_parts> bounds_of(const Medial_axis_2& axis, const Segment_hierarchy& curves) {
  if (axis.bounds) return axis.bounds;
  const double close = CLOSE_WALLS * curves.drawing().coordinate_size();
  return std::make_shared<const Bounding_parts>(bounding_parts(curves, axis.options, close));
}

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

void Bounding_parts::number_joints(const std::vector<std::uint32_t>& labels) {
  internal::Joined_sets sets(2 * segments.number_of_segments());
  std::unordered_map<std::uint32_t, std::uint32_t> first;  // by label
  for (std::uint32_t e = 0; e < labels.size(); ++e)
    if (labels[e] != NO_LABEL) sets.join(e, first.emplace(labels[e], e).first->second);
  for (const internal::Bounding_ring& ring : rings)
    for (std::size_t i = 0; i < ring.way.size(); ++i) {
      const internal::Directed_segment &s = ring.way[i], &next = ring.way[(i + 1) % ring.way.size()];
      sets.join(s.side() ^ 1U, next.side());  // ends have the numbers of the sides that begin there
    }
  joints.resize(2 * segments.number_of_segments());
  for (std::uint32_t e = 0; e < joints.size(); ++e) joints[e] = sets.find(e);
}

}  // namespace CGAL::Bounding_arcs
