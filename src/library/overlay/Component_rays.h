// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a ray crosses: from a point of each connected part of the curves to the right.
//
//   a segment that is beside the point's height, or clearly crosses it: in doubles
//   a piece with a segment that doubles leave open: its crossings as roots of a polynomial, compared with its cuts
//
// Points at the ray's height count as below it, as if the ray was higher by less than any number.

#ifndef BOUNDING_ARCS_LIBRARY_OVERLAY_COMPONENT_RAYS_H
#define BOUNDING_ARCS_LIBRARY_OVERLAY_COMPONENT_RAYS_H

#include "Cut_curves.h"

#include "../query/Winding_search.h"
#include "../tree/Box_tree.h"

#include <CGAL/Bbox_2.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// An edge that a ray crosses.
struct Edge_hit {
  std::uint32_t edge;  ///< the representative of its class
  int number;          ///< crossings upwards less those downwards
};
/// A ray from a point of an edge, but for what it crosses there.
struct Edge_ray {
  std::uint32_t edge = 0;    ///< the representative of its class
  bool starts_left = false;  ///< whether the ray is on the left of it, where it starts
  std::vector<Edge_hit> hits;
};

class Component_rays {
 public:
  explicit Component_rays(const Cut_curves& cut);

  [[nodiscard]] std::size_t number_of_components() const { return boxes_.size(); }
  [[nodiscard]] std::uint32_t component_of(std::uint32_t curve) const { return component_[curve]; }
  /// A ray from a component's curves.
  /// \return nothing where doubles leave it open and there are no exact decisions
  [[nodiscard]] std::optional<Edge_ray> from(std::uint32_t component) const;

 private:
  /// Where a ray starts.
  struct Origin {
    std::uint32_t bezier = 0, edge = 0;
    std::uint32_t segment = NO_NUMBER;  ///< whose samples are the ends of a part with the parameter in it
    double t = 0;
    std::optional<Exact_rational> exact_t;  ///< where it is no double
  };
  struct Segment_hit {
    std::uint32_t bezier, edge;
    int number;
  };

  [[nodiscard]] std::optional<Origin> origin_on(std::uint32_t segment) const;
  [[nodiscard]] Origin origin_between_cuts(std::uint32_t component) const;
  /// The sign of the rise at the origin where that is clear, along the whole segment.
  [[nodiscard]] int clear_rise(const Origin& o, const Asked_point& q) const;
  void add_clear_hits(const Asked_point& q, std::uint32_t own_segment, std::vector<Segment_hit>& hits,
                      std::vector<std::uint32_t>& open) const;
  [[nodiscard]] std::optional<std::uint32_t> edge_of_crossing(const Asked_point& q, std::uint32_t segment) const;
  void add_exact_hits(const Exact_point& q, std::uint32_t bezier, Edge_ray& ray) const;
  void set_start(int rise, int level, std::uint32_t edge, Edge_ray& ray) const;

  const Cut_curves& cut_;
  const Segment_hierarchy& curves_;
  std::vector<std::uint32_t> component_;  // by curve
  std::vector<CGAL::Bbox_2> boxes_;       // by component
  std::vector<std::uint32_t> longest_;    // segment, by component
  Box_tree box_tree_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
