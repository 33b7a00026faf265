// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounding regions of a kind over spiral segments, to a tolerance.  A node is a piece of a segment; box, thickness and
// region are made from the curve when asked for.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_REGION_HIERARCHY_2_H
#define CGAL_BOUNDING_ARCS_2_TREE_REGION_HIERARCHY_2_H

#include <CGAL/Bounding_arcs_2/number/Made_once.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>
#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/box_between.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include <CGAL/Bounding_arcs_2/tree/for_each_index.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Equalized_leaves.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Midpoint_nodes.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Piece_decider.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Segment_boxes.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Segment_regions.h>
#include <CGAL/Bounding_arcs_2/tree/internal/check_tree.h>
#include <CGAL/Bounding_arcs_2/tree/internal/neighbours.h>
#include <CGAL/Bounding_arcs_2/tree/subdivide.h>
#include <CGAL/Bounding_arcs_2/tree/tree_spirals.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

class Default_traits_2;  // region/Bca_traits_2.h

/// Whether a type has what is looked at first of a model of BoundingRegionTraits_2.
template <class T, class = void> inline constexpr bool is_region_traits_v = false;
template <class T>
inline constexpr bool is_region_traits_v<T, std::void_t<typename T::Bounding_region_2, typename T::Construction>> =
    true;

/// The paper's bounding volume hierarchy: bounding regions of one kind over all spiral segments of a tree, none thicker
/// than a tolerance. Take it if you want regions in hand: to draw them, to write them, to search them by your own code.
/// The library's searches do not read it: they descend a Bounding_arc_tree_2.
/// \code
/// const Bounding_arc_tree_2 tree(drawing);
/// const Region_hierarchy_2 regions(tree, 1e-6);  // none is thicker
/// regions.for_each_leaf([&](const Node_handle& leaf) { std::cout << regions.thickness(leaf) << '\n'; });
/// const Region_hierarchy_2<Bilens_traits_2<Kernel>> lenses(tree, 1e-6);
/// \endcode
/// A region node is a piece of a segment; its two children are the halves of the piece. for_each_leaf() goes along the
/// curves. traverse() goes depth first and lets you leave out what is too far. Above the segments stand boxes, up to
/// four below each. Box, thickness and region of a node are made from the curve whenever you ask for them.
///
/// Look at status() after building. COMPLETE says that no leaf is thicker than eps. RESOLUTION_REACHED says that
/// coordinates do not resolve eps; bound() is the thickness that was reached. REGION_LIMIT says that more nodes would
/// be needed than Build_options::max_nodes; there are none then.
///
/// Build_options::nodes says what is kept. The default, STORED, suits most programs. Take LAZY for few queries, or for
/// queries that end early: nodes are then made as a traversal goes below. Take EQUALIZED for the fewest leaves: some 30
/// % fewer at small eps, in several times the time.
///
/// Without Traits the regions are bounding circular arcs over doubles, and they are decided exactly. Take Bca_traits_2,
/// Spiral_fat_arc_traits_2 or Bilens_traits_2 for another kind or another kernel; doc/index.md tells which to choose.
/// \tparam Traits a model of BoundingRegionTraits_2, by default bounding circular arcs over a kernel with exact
///   predicates
/// \tparam Spiral a model of SpiralSegment_2 over Traits::FT
template <class Traits_ = Default_traits_2, class Spiral_ = Bezier_spiral_2<typename Traits_::FT>>
class Region_hierarchy_2 {
  static_assert(is_region_traits_v<Traits_>,
                "Region_hierarchy_2 takes traits of regions, such as Bca_traits_2<Kernel>, in place of a kernel");

 public:
  using Traits = Traits_;
  using Spiral = Spiral_;
  using Handle = Node_handle;
  using Region = typename Traits::Bounding_region_2;
  using FT = typename Traits::FT;

  /// Makes regions of a tree's curves.
  /// \param eps the largest thickness of a leaf, in units of the coordinates, positive
  /// \param concurrency CGAL::Parallel_tag() builds in as many threads as TBB gives; the regions are the same
  /// \throws std::invalid_argument for an eps that is not positive
  /// \guarantee every leaf's thickness is at most bound(), and that at most eps unless status() says otherwise. Regions
  ///   over exact numbers are of the curves as they are, others of their rounding. That equalised leaves are few is
  ///   measured: up to 1.03 N*(eps) and one more a segment, see equalize_breaks
  /// \complexity linear in the number of nodes, about 2.8 N*(eps) of stored ones; in that of segments for lazy ones
  template <class ConcurrencyTag = CGAL::Sequential_tag>
  Region_hierarchy_2(const Bounding_arc_tree_2& tree, double eps, const Build_options& options = {},
                     const Traits& traits = Traits(), ConcurrencyTag concurrency = {})
      : Region_hierarchy_2(spiral_segments<FT>(tree), eps, options, traits, concurrency) {}

  /// Makes regions of spiral segments, which may be of one's own curves or over numbers that no tree takes.
  template <class ConcurrencyTag = CGAL::Sequential_tag>
  Region_hierarchy_2(std::vector<Spiral> spirals, double eps, const Build_options& options = {},
                     const Traits& traits = Traits(), ConcurrencyTag concurrency = {})
      : traits_(traits), eps_(eps), options_(options),
        decide_(traits, options.is_filtered ? options.instruction_set : Build_options::Instruction_set::NONE) {
    check_above_zero("eps", eps);
    midpoints_ = internal::Midpoint_nodes(options_.keep_thickness);
    replace(0, 0, std::move(spirals), concurrency);
    options_.progress = {};
  }

  /// Follows a tree that these are regions of, in which curves first, ..., last - 1 were replaced by as many. All
  /// others keep their subtrees.
  /// \throws std::out_of_range unless first <= last <= the number of curves, std::invalid_argument for a tree of fewer
  ///   or more curves; all is then as it was
  template <class ConcurrencyTag = CGAL::Sequential_tag>
  void follow(const Bounding_arc_tree_2& tree, std::size_t first, std::size_t last, ConcurrencyTag concurrency = {}) {
    const std::size_t count = tree.drawing().curves().size(),
                      own = spirals_.empty() ? 0 : spirals_.back().place().curve + std::size_t(1);
    if (count != own)
      throw std::invalid_argument(
          expected("tree", "as many curves as these regions are of, " + text_of(own), text_of(count)));
    if (first > last || last > count)
      throw std::out_of_range(expected("first, last", "a range within 0, " + text_of(count) + " of the curves",
                                       text_of(first) + ", " + text_of(last)));
    const auto segment_of = [this](std::size_t curve) {
      const auto at = std::partition_point(spirals_.begin(), spirals_.end(),
                                           [&](const Spiral& s) { return s.place().curve < curve; });
      return static_cast<std::size_t>(at - spirals_.begin());
    };
    replace(segment_of(first), segment_of(last), spiral_segments<FT>(tree, first, last), concurrency);
  }

  /// Puts other segments in the place of segments first, ..., last - 1, after control points were moved, say. All
  /// others keep their subtrees. What is then more than allowed leaves the hierarchy empty, as when it is built.
  /// \throws std::out_of_range unless first <= last <= the number of segments; after any exception all is as it was
  template <class ConcurrencyTag = CGAL::Sequential_tag>
  void replace(std::size_t first, std::size_t last, std::vector<Spiral> spirals, ConcurrencyTag = {}) {
    if (first > last || last > spirals_.size())
      throw std::out_of_range(expected("first, last",
                                       "a range within 0, " + text_of(spirals_.size()) + " of the segments",
                                       text_of(first) + ", " + text_of(last)));
    Made made{spirals, counts_, false};
    internal::Midpoint_nodes midpoints(options_.keep_thickness);
    internal::Equalized_leaves leaves;
    if (options_.nodes == Build_options::Nodes::STORED)
      rebuild<ConcurrencyTag>(made, midpoints_, midpoints, first, last);
    if (options_.nodes == Build_options::Nodes::EQUALIZED) rebuild<ConcurrencyTag>(made, leaves_, leaves, first, last);
    auto boxes = std::make_shared<Boxes_later>();
    spirals_.reserve(spirals_.size() + spirals.size());
    // nothing below throws
    if (made.is_over_limit) {
      spirals_.clear();
    } else {
      const auto at = [&](std::size_t i) { return spirals_.begin() + static_cast<std::ptrdiff_t>(i); };
      spirals_.erase(at(first), at(last));
      spirals_.insert(at(first), std::make_move_iterator(spirals.begin()), std::make_move_iterator(spirals.end()));
    }
    midpoints_ = std::move(midpoints);
    leaves_ = std::move(leaves);
    counts_ = made.counts;
    is_over_limit_ = made.is_over_limit;
    boxes_ = std::move(boxes);
  }

  /// COMPLETE where bound() is at most eps.
  [[nodiscard]] Build_status status() const {
    if (is_over_limit_) return Build_status::REGION_LIMIT;
    return bound() <= eps_ ? Build_status::COMPLETE : Build_status::RESOLUTION_REACHED;
  }
  /// No leaf is thicker, and the thickest one is thinner by a few per cent at most, which quick looks do not tell. Of
  /// lazy nodes eps, or the least thickness that coordinates resolve: what leaves will have but where parameters have
  /// no room for as many halvings as that takes. 0 of an empty tree.
  /// \complexity linear in the number of segments
  [[nodiscard]] double bound() const {
    double bound = 0;
    if (options_.nodes == Build_options::Nodes::LAZY)
      for (const Spiral& s : spirals_) bound = (std::max)(bound, internal::reachable(eps_, s));
    for (const auto* bounds : {&midpoints_.bounds(), &leaves_.bounds()})
      for (const double b : *bounds) bound = (std::max)(bound, b);
    return bound;
  }
  /// The stages at which the thickness of the pieces that were tried in building was decided against eps.
  [[nodiscard]] const Decision_counts& decisions() const { return counts_; }

  [[nodiscard]] const Traits& traits() const { return traits_; }
  [[nodiscard]] const std::vector<Spiral>& spirals() const { return spirals_; }
  /// Counts region nodes that are kept: none of lazy ones.
  [[nodiscard]] std::size_t number_of_leaves() const {
    return midpoints_.number_of_leaves() + leaves_.number_of_leaves();
  }
  [[nodiscard]] Build_options::Nodes nodes() const { return options_.nodes; }
  /// Counts the leaves of one segment that are kept.
  [[nodiscard]] std::size_t number_of_leaves(std::size_t spiral) const {
    if (options_.nodes == Build_options::Nodes::STORED) return midpoints_.number_of_leaves(spiral);
    return options_.nodes == Build_options::Nodes::EQUALIZED ? leaves_.number_of_leaves(spiral) : 0;
  }
  using Leaf_room = internal::Leaf_runs;  ///< what write_leaf_ends works in
  /// Writes the parameters in which the leaves of a segment end, in curve order.
  /// \param room to work in \param ends room for as many as there are leaves
  /// \pre nodes() != Build_options::Nodes::LAZY
  void write_leaf_ends(std::size_t spiral, Leaf_room& room, double* ends) const {
    CGAL_precondition(nodes() != Build_options::Nodes::LAZY);
    if (options_.nodes == Build_options::Nodes::EQUALIZED) return leaves_.write_ends(spiral, ends);
    midpoints_.write_ends(spiral, internal::Spiral_grid(spirals_[spiral].first(), spirals_[spiral].last()), room, ends);
  }
  [[nodiscard]] std::size_t number_of_nodes() const { return midpoints_.number_of_nodes() + leaves_.number_of_nodes(); }
  /// Counts the nodes above those of segments.
  [[nodiscard]] std::size_t number_of_boxes() const { return boxes().size(); }
  /// Arcs of all leaves, as the paper's Table 1 counts them: 2 a region for BCA and SFA, 4 for bilens.
  [[nodiscard]] std::size_t number_of_arcs() const {
    return number_of_leaves() * Traits::Construction::ARCS_PER_REGION;
  }
  /// Tells whether all is in order, without a look at curves. Each box holds those below it, and each segment is in one
  /// of them. Kept leaves follow each other from a segment's first parameter to its last one.
  /// \complexity linear in the nodes
  [[nodiscard]] bool is_valid() const { return internal::is_valid_tree(*this); }
  /// Bytes held by region nodes, without the curves and the boxes over segments, which are made when asked for.
  [[nodiscard]] std::size_t bytes() const { return midpoints_.bytes() + leaves_.bytes(); }

  /// The box over everything; of an empty tree it is empty, too, and has no children.
  [[nodiscard]] Node_handle root() const { return {}; }
  /// The region node over a whole segment.
  [[nodiscard]] Node_handle segment_root(std::uint32_t spiral) const {
    if (options_.nodes == Build_options::Nodes::STORED) return midpoints_.root(spiral);
    if (options_.nodes == Build_options::Nodes::EQUALIZED) return leaves_.root(spiral);
    Node_handle root;
    visit_pieces(spiral, 0, 0, 1, [&](const Node_handle& h) { root = h; });
    return root;
  }
  [[nodiscard]] bool is_leaf(const Node_handle& h) const { return h.is_leaf; }
  /// Calls visit(child) for each of the children: up to four of a box, two halves of a piece in curve order, none of a
  /// leaf or an empty tree's root.
  template <class Visit> void for_each_child(const Node_handle& h, Visit&& visit) const {
    if (spirals_.empty() || h.is_leaf) return;
    if (h.is_region) {
      if (options_.nodes == Build_options::Nodes::STORED) midpoints_.for_each_half(h, visit);
      else if (options_.nodes == Build_options::Nodes::EQUALIZED) leaves_.for_each_half(h, visit);
      else visit_pieces(h.spiral, h.level + 1, 2 * h.place, 2, visit);
    } else {
      const auto all = boxes().children(static_cast<std::uint32_t>(h.index));
      for (std::size_t k = 0; k < all.size; ++k) {
        const auto& below = all.child[k];
        Node_handle child;
        child.index = below.number;
        child.place = below.slot;
        if (below.is_segment) visit(segment_root(below.number));
        else visit(child);
      }
    }
  }
  /// Depth first, pieces of a segment in curve order: descend(handle) says whether to go below, and sees leaves too.
  template <class Descend> void traverse(Descend&& descend) const {
    if (!spirals_.empty()) traverse(root(), descend);
  }
  /// Traverses a node and what is below it.
  template <class Descend> void traverse(const Node_handle& h, Descend&& descend) const {
    if (!descend(h)) return;
    for_each_child(h, [&](const Node_handle& child) { traverse(child, descend); });
  }
  /// Calls visit(handle) for every leaf in curve order.
  template <class Visit> void for_each_leaf(Visit&& visit) const {
    const auto visit_leaf = [&](const Node_handle& h) {
      if (h.is_leaf) visit(h);
      return true;
    };
    for (std::size_t i = 0; i < spirals_.size(); ++i) traverse(segment_root(static_cast<std::uint32_t>(i)), visit_leaf);
  }

  /// \pre h.is_region
  [[nodiscard]] Region_node node(const Node_handle& h) const {
    CGAL_precondition(h.is_region);
    if (options_.nodes == Build_options::Nodes::EQUALIZED)
      return {leaves_.begin(h), leaves_.end(h), h.spiral, h.is_leaf};
    const internal::Spiral_grid grid(spirals_[h.spiral].first(), spirals_[h.spiral].last());
    return {grid.parameter(h.level, h.place), grid.parameter(h.level, h.place + 1), h.spiral, h.is_leaf};
  }
  /// Where t of a region node's segment is on the drawing.
  [[nodiscard]] Curve_place place_of(const Region_node& n, double t) const {
    const Segment_place& p = spirals_[n.spiral].place();
    return {p.curve, p.bezier, t};
  }
  /// The leaf that follows one along its curve, over the ends of segments and Bezier pieces; around a closed curve
  /// without end.
  /// \return nothing behind the last leaf of an open curve \pre h.is_leaf
  [[nodiscard]] std::optional<Node_handle> next_leaf(const Node_handle& h) const {
    return internal::next_leaf(*this, h);
  }
  /// The leaf before it, the other way round.
  [[nodiscard]] std::optional<Node_handle> previous_leaf(const Node_handle& h) const {
    return internal::previous_leaf(*this, h);
  }
  /// A box that holds the curve below h: as spirals are monotone in x and y, the box of two end points.
  /// CGAL::Bbox_2(), which holds no point, for the root of an empty tree.
  [[nodiscard]] CGAL::Bbox_2 box(const Node_handle& h) const {
    if (spirals_.empty()) return {};
    if (!h.is_region) return h.index == 0 ? boxes().box() : boxes().box(h.place);
    const Region_node n = node(h);
    return box_of_piece(spirals_[n.spiral], n.t0, n.t1);
  }
  /// The thickness of a region node's exact region rounded up, at most 16 ulp above; what was kept may be 2^-24 above.
  /// \pre h.is_region
  [[nodiscard]] double thickness(const Node_handle& h) const {
    CGAL_precondition(h.is_region);
    if (options_.nodes == Build_options::Nodes::STORED && options_.keep_thickness)
      return midpoints_.nodes().thickness(h.index);
    const Region_node n = node(h);
    const Spiral& s = spirals_[n.spiral];
    const double eps = internal::reachable(eps_, s);
    std::optional<double> sharp;
    if constexpr (has_accurate_shape_v<Spiral>) sharp = sharp_thickness(traits_.construction(), s, n.t0, n.t1);
    const double upper =
        sharp ? *sharp : traits_.bound_thickness_2_object()(Piece_source<Spiral>{s, n.t0, n.t1}, eps).upper;
    return h.is_leaf && is_decided_within(h, eps) ? (std::min)(upper, eps) : upper;
  }
  /// The bounding region of a region node. \pre h.is_region
  [[nodiscard]] Region region(const Node_handle& h) const { return region(node(h)); }
  [[nodiscard]] Region region(const Region_node& n) const {
    return traits_.construct_bounding_region_2_object()(spirals_[n.spiral].template frame<typename Traits::FT>(
        n.t0, n.t1, shape_parts<typename Traits::Construction>()));
  }
  /// Returns bounding circular arcs of any piece of a segment, whatever regions are kept. The exact curve is within the
  /// widening of them. \pre FT is double
  [[nodiscard]] Arc_region_2 bounding_arcs(std::uint32_t segment, double t0, double t1) const {
    const Spiral& s = spirals_[segment];
    Arc_region_2 arcs = arc_region(Bca(), s, t0, t1, s.template point<double>(t0), s.template point<double>(t1));
    arcs.widening = internal::widening_of_single_regions(s);
    return arcs;
  }

 private:
  using Boxes_later = internal::Made_once<internal::Segment_boxes>;

  [[nodiscard]] static CGAL::Bbox_2 box_of_piece(const Spiral& s, double t0, double t1) {
    return internal::box_between(s.point(t0), s.point(t1), s.point_error());
  }
  // The boxes over segments.
  [[nodiscard]] const internal::Segment_boxes& boxes() const {
    return (*boxes_)([this] {
      std::vector<CGAL::Bbox_2> boxes;
      boxes.reserve(spirals_.size());
      for (const Spiral& s : spirals_) boxes.push_back(box_of_piece(s, s.first(), s.last()));
      return internal::Segment_boxes(boxes);
    });
  }

  // Pieces at the last level may be leaves for want of room.
  [[nodiscard]] bool is_decided_within(const Node_handle& h, double eps) const {
    if (options_.nodes == Build_options::Nodes::EQUALIZED) return leaves_.bounds()[h.spiral] <= eps;
    return h.level < internal::Spiral_grid(spirals_[h.spiral].first(), spirals_[h.spiral].last()).levels();
  }
  template <class Visit>
  void visit_pieces(std::uint32_t spiral, int level, std::uint64_t place, unsigned count, const Visit& visit) const {
    const Spiral& s = spirals_[spiral];
    const bool is_last = level == internal::Spiral_grid(s.first(), s.last()).levels();
    const unsigned thick = is_last ? 0 : decide_.are_thick(s, level, place, count, internal::reachable(eps_, s));
    for (unsigned i = 0; i < count; ++i) visit(Node_handle{true, (thick >> i & 1) == 0, level, spiral, 0, place + i});
  }

  // What a change makes, beside what is held until all of it is there.
  struct Made {
    const std::vector<Spiral>& spirals;
    Decision_counts counts;
    bool is_over_limit;
  };
  // Appends the subtrees of the new segments, one after the other or, with TBB, in parallel: segments do not know of
  // each other, so the result is the same. Ends soon where there would be more nodes than allowed.
  // \param empty nodes without any
  template <class ConcurrencyTag, class Nodes> void build(Made& made, const Nodes& empty, Nodes& nodes) const {
    constexpr std::size_t AHEAD = 64;  // segments
    const std::size_t count = made.spirals.size();
    std::mutex mutex;  // of what is told and counted
    std::size_t ready = 0;
    std::atomic<bool> is_over_limit{false};
    const auto add = [&](std::size_t i, std::size_t j, Nodes& to) {
      Piece_decider<Traits, Spiral> decide = decide_;
      Decision_counts counts;
      for (const std::size_t start = i; i < j && !is_over_limit; ++i) {
        const Spiral& s = made.spirals[i];
        if ((i - start) % AHEAD == 0) to.look_ahead(decide, &s, (std::min)(j - i, AHEAD), eps_);
        if (!to.add(decide, s, internal::reachable(eps_, s), options_.max_nodes, counts)) is_over_limit = true;
        if (!options_.progress) continue;
        const std::lock_guard<std::mutex> lock(mutex);
        options_.progress(++ready, count);
      }
      const std::lock_guard<std::mutex> lock(mutex);
      made.counts.add(counts);
    };
    if constexpr (internal::is_parallel_v<ConcurrencyTag>) {
      std::atomic<std::size_t> number{nodes.number_of_nodes()};
      std::vector<Nodes> parts((count + internal::RANGE_SIZE - 1) / internal::RANGE_SIZE, empty);
      internal::for_each_index<ConcurrencyTag>(parts.size(), [&](std::size_t k) {
        add(k * internal::RANGE_SIZE, (std::min)((k + 1) * internal::RANGE_SIZE, count), parts[k]);
        if ((number += parts[k].number_of_nodes()) > options_.max_nodes) is_over_limit = true;
      });
      if (!is_over_limit) nodes.template append_all<ConcurrencyTag>(parts);
    } else {
      add(0, count, nodes);
    }
    made.is_over_limit = is_over_limit;
  }
  // Makes the subtrees of the new segments, and keeps those of the old nodes for what was before `first` and from
  // `last` on. Leaves nothing of more nodes than allowed.
  // \param nodes none; those that are made
  template <class ConcurrencyTag, class Nodes>
  void rebuild(Made& made, const Nodes& old, Nodes& nodes, std::size_t first, std::size_t last) const {
    const Nodes empty = nodes;
    nodes.append(old, 0, first);
    build<ConcurrencyTag>(made, empty, nodes);
    if (!made.is_over_limit) {
      nodes.append(old, last, old.bounds().size());
      made.is_over_limit = nodes.number_of_nodes() > options_.max_nodes;
    }
    if (made.is_over_limit) nodes = empty;
    nodes.complete();
  }

  Traits traits_;
  double eps_;
  Build_options options_;
  Piece_decider<Traits, Spiral> decide_;
  std::vector<Spiral> spirals_;
  std::shared_ptr<const Boxes_later> boxes_ = std::make_shared<Boxes_later>();
  internal::Midpoint_nodes midpoints_;  // empty but for stored nodes
  internal::Equalized_leaves leaves_;   // empty but for equalised nodes
  Decision_counts counts_;
  bool is_over_limit_ = false;
};

}  // namespace CGAL::Bounding_arcs

#endif
