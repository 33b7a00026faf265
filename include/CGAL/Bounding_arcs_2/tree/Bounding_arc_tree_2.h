// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hierarchy: boxes over spiral segments, and under each segment a binary tree of bounding regions, halved at the
// parameter midpoint until the thickness is at most eps.  A node keeps its parameters and its thickness; its region is
// made again from the curve when asked for, so a node is 32 bytes whatever the method.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_BOUNDING_ARC_TREE_2_H
#define CGAL_BOUNDING_ARCS_2_TREE_BOUNDING_ARC_TREE_2_H

#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>
#include <CGAL/Bounding_arcs_2/tree/Box_hierarchy.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// How a build ended.
enum class Build_status {
  COMPLETE,            ///< every leaf's thickness is at most eps
  RESOLUTION_REACHED,  ///< eps is below what coordinates or parameters resolve; see Bounding_arc_tree_2::bound
  REGION_LIMIT         ///< more regions than allowed would be needed; the tree is empty
};

struct Build_options {
  std::size_t max_regions = 20'000'000;               ///< nodes of all subtrees together; memory is 32 bytes a node
  std::function<void(std::size_t, std::size_t)> progress;  ///< called with spirals done and spirals in all
};

/// One node of a subtree: a piece [t0, t1] of a spiral segment.
struct Region_node {
  double t0, t1;
  double thickness;      ///< at least the thickness of the piece's region
  std::uint32_t right;   ///< the offset from this node to its right child, 0 for a leaf; the left child is the next node
  std::uint32_t spiral;  ///< the index of the spiral segment
};
static_assert(sizeof(Region_node) == 32, "four nodes are to fit two cache lines");

/// \tparam Traits a model of BoundingRegionTraits_2
/// \tparam Spiral a model of SpiralSegment_2 over Traits::FT, such as Bezier_spiral_2<double>
template <class Traits_, class Spiral_>
class Bounding_arc_tree_2 {
 public:
  using Traits = Traits_;
  using Spiral = Spiral_;
  using Region = typename Traits::Bounding_region_2;

  /// A place in the hierarchy: a box over spirals, or a region node.
  struct Handle {
    bool is_region;
    std::size_t level;  ///< of a box
    std::size_t index;  ///< of a box in its level, or of a region node
  };

  /// \param eps the largest thickness of a leaf, in units of the coordinates, positive
  /// \throws std::invalid_argument for an eps that is not positive
  /// \complexity linear in the number of nodes, about 1.4 N*(eps) leaves
  Bounding_arc_tree_2(std::vector<Spiral> spirals, double eps, const Traits& traits = Traits(),
                      const Build_options& options = {})
      : traits_(traits), spirals_(std::move(spirals)) {
    if (!(eps > 0)) throw std::invalid_argument("eps must be positive");
    if (is_hopeless(eps, options.max_regions)) {
      status_ = Build_status::REGION_LIMIT;
      return;
    }
    std::vector<CGAL::Bbox_2> boxes;
    for (std::size_t i = 0; i < spirals_.size(); ++i) {
      const Spiral& s = spirals_[i];
      boxes.push_back(box_of(s, s.first(), s.last()));
      const double resolution = RESOLUTION_PER_ERROR * s.point_error();
      if (eps < resolution) status_ = Build_status::RESOLUTION_REACHED;
      roots_.push_back(nodes_.size());
      subdivide(i, s.first(), s.last(), (std::max)(eps, resolution), options.max_regions);
      if (nodes_.size() > options.max_regions) {
        *this = Bounding_arc_tree_2(traits, Build_status::REGION_LIMIT);
        return;
      }
      if (options.progress) options.progress(i + 1, spirals_.size());
    }
    roots_.push_back(nodes_.size());
    boxes_ = Box_hierarchy(std::move(boxes));
  }

  [[nodiscard]] Build_status status() const { return status_; }
  /// The largest thickness of a leaf: what the build reached.
  [[nodiscard]] double bound() const { return bound_; }
  [[nodiscard]] const Traits& traits() const { return traits_; }
  [[nodiscard]] const std::vector<Spiral>& spirals() const { return spirals_; }
  /// All region nodes, spiral by spiral, each subtree in preorder: leaves come in curve order.
  [[nodiscard]] const std::vector<Region_node>& nodes() const { return nodes_; }

  [[nodiscard]] std::size_t number_of_leaves() const { return leaves_; }
  [[nodiscard]] std::size_t number_of_nodes() const { return nodes_.size(); }
  [[nodiscard]] std::size_t number_of_boxes() const { return boxes_.size(); }
  /// Arcs of all leaves, as the paper's Table 1 counts them: 2 a region for BCA and SFA, 4 for bilens.
  [[nodiscard]] std::size_t number_of_arcs() const { return leaves_ * Traits::Construction::ARCS_PER_REGION; }
  /// Bytes held by nodes, boxes and roots, without the curves.
  [[nodiscard]] std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Region_node) + boxes_.bytes() + roots_.capacity() * sizeof(std::size_t);
  }

  /// \pre there is at least one spiral
  [[nodiscard]] Handle root() const { return {false, boxes_.levels() - 1, 0}; }
  [[nodiscard]] bool is_leaf(const Handle& h) const { return h.is_region && nodes_[h.index].right == 0; }
  /// \pre h.is_region
  [[nodiscard]] const Region_node& node(const Handle& h) const { return nodes_[h.index]; }
  /// Calls visit(child) for each of the one or two children in curve order.
  template <class Visit>
  void for_each_child(const Handle& h, Visit&& visit) const {
    if (h.is_region) {
      if (is_leaf(h)) return;
      visit(Handle{true, 0, h.index + 1});
      visit(Handle{true, 0, h.index + nodes_[h.index].right});
    } else if (h.level == 0) {
      visit(Handle{true, 0, roots_[h.index]});
    } else {
      visit(Handle{false, h.level - 1, 2 * h.index});
      if (2 * h.index + 1 < boxes_.size_of_level(h.level - 1)) visit(Handle{false, h.level - 1, 2 * h.index + 1});
    }
  }

  /// A box that holds the curve below h: as spirals are monotone in x and y, the box of two end points.
  [[nodiscard]] CGAL::Bbox_2 box(const Handle& h) const {
    if (!h.is_region) return boxes_.box(h.level, h.index);
    const Region_node& n = nodes_[h.index];
    return box_of(spirals_[n.spiral], n.t0, n.t1);
  }
  /// The bounding region of a region node. \pre h.is_region
  [[nodiscard]] Region region(const Handle& h) const { return region(nodes_[h.index]); }
  [[nodiscard]] Region region(const Region_node& n) const {
    return traits_.construct_bounding_region_2_object()(
        spirals_[n.spiral].template frame<typename Traits::FT>(n.t0, n.t1, internal::shape_parts<typename Traits::Construction>()));
  }

  /// Depth first in curve order: descend(handle) says whether to go below, and sees leaves too.
  template <class Descend>
  void traverse(Descend&& descend) const {
    if (!spirals_.empty()) traverse_from(root(), descend);
  }
  /// Calls visit(node) for every leaf in curve order.
  template <class Visit>
  void for_each_leaf(Visit&& visit) const {
    for (const Region_node& n : nodes_)
      if (n.right == 0) visit(n);
  }

 private:
  // A thickness this many times the error of a point still means something; below it regions of neighbours overlap
  // by rounding alone. Ten times less and leaves would be of the size of the rounding itself.
  static constexpr double RESOLUTION_PER_ERROR = 2;

  Bounding_arc_tree_2(const Traits& traits, Build_status status) : traits_(traits), status_(status) {}

  struct Piece {  // a model of ChordShapeSource
    using Exact_number_type = typename Spiral::Exact_number_type;
    const Spiral& spiral;
    double t0, t1;
    template <class NT>
    [[nodiscard]] Chord_shape_2<NT> shape(const Shape_parts& parts) const {
      return spiral.template shape<NT>(t0, t1, parts);
    }
  };

  // Thickness falls with the cube of length, so about the cube root of the whole segment's over eps pieces are needed:
  // true only if that is far above the limit, so that no time is spent on what would end there.
  [[nodiscard]] bool is_hopeless(double eps, std::size_t limit) const {
    constexpr double FAR_ABOVE = 8;
    double expected = 0;
    for (const Spiral& s : spirals_) {
      const double reachable = (std::max)(eps, RESOLUTION_PER_ERROR * s.point_error());
      expected += std::cbrt(traits_.bound_thickness_2_object()(Piece{s, s.first(), s.last()}, eps).upper / reachable);
    }
    return expected > FAR_ABOVE * static_cast<double>(limit);
  }

  void subdivide(std::size_t spiral, double t0, double t1, double eps, std::size_t limit) {
    const std::size_t at = nodes_.size();
    if (at > limit) return;
    const Thickness_bound decision = traits_.bound_thickness_2_object()(Piece{spirals_[spiral], t0, t1}, eps);
    nodes_.push_back({t0, t1, decision.upper, 0, static_cast<std::uint32_t>(spiral)});
    const double middle = t0 + (t1 - t0) / 2;
    if (decision.within || !(t0 < middle && middle < t1)) {
      if (!decision.within) status_ = Build_status::RESOLUTION_REACHED;
      bound_ = (std::max)(bound_, decision.upper);
      ++leaves_;
      return;
    }
    subdivide(spiral, t0, middle, eps, limit);
    const std::size_t right = nodes_.size();
    subdivide(spiral, middle, t1, eps, limit);
    nodes_[at].right = static_cast<std::uint32_t>(right - at);
  }

  static CGAL::Bbox_2 box_of(const Spiral& s, double t0, double t1) {
    using Interval = CGAL::Interval_nt<true>;
    const auto p = s.point(t0), q = s.point(t1);
    const Interval error(-s.point_error(), s.point_error());
    const Interval x0 = internal::convert<Interval>(p.x) + error, y0 = internal::convert<Interval>(p.y) + error;
    const Interval x1 = internal::convert<Interval>(q.x) + error, y1 = internal::convert<Interval>(q.y) + error;
    return CGAL::Bbox_2(x0.inf(), y0.inf(), x0.sup(), y0.sup()) + CGAL::Bbox_2(x1.inf(), y1.inf(), x1.sup(), y1.sup());
  }

  template <class Descend>
  void traverse_from(const Handle& h, Descend& descend) const {
    if (!descend(h)) return;
    for_each_child(h, [&](const Handle& child) { traverse_from(child, descend); });
  }

  Traits traits_;
  std::vector<Spiral> spirals_;
  std::vector<Region_node> nodes_;
  std::vector<std::size_t> roots_;
  Box_hierarchy boxes_;
  std::size_t leaves_ = 0;
  double bound_ = 0;
  Build_status status_ = Build_status::COMPLETE;
};

}  // namespace CGAL::Bounding_arcs

#endif
