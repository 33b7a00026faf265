// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The templates behind Hierarchy.h, included by one source file a kernel.

#ifndef BOUNDING_ARCS_TOOL_HIERARCHY_IMPLEMENTATION_H
#define BOUNDING_ARCS_TOOL_HIERARCHY_IMPLEMENTATION_H

#include "Hierarchy.h"
#include "number_text.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/tree/Region_columns.h>
#include <CGAL/Bounding_arcs_2/tree/Region_reader.h>
#include <CGAL/Bounding_arcs_2/verify/Certified_traits_2.h>
#include <CGAL/Bounding_arcs_2/verify/verify_region.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace bounding_arcs_tool::detail {

namespace ba = CGAL::Bounding_arcs;

template <class LinearKernel>
using Circular =
    CGAL::Circular_kernel_2<LinearKernel, CGAL::Algebraic_kernel_for_circles_2_2<typename LinearKernel::FT>>;

/// One side of an outline seen from the piece's start, in units of `unit`, as it is written.
[[nodiscard]] inline Output_chain output_chain(const std::vector<ba::Boundary_piece_2<double>>& chain, double unit,
                                               const Xy<double>& from, const Xy<double>& to) {
  Output_chain pieces;
  for (const auto& piece : chain) {
    const Xy<double> start = pieces.empty() ? from : pieces.back().to;
    pieces.push_back({start, &piece == &chain.back() ? to : from + unit * piece.to, ba::bulge(piece)});
  }
  return pieces;
}

/// One side of a region as it is written.
[[nodiscard]] inline Output_chain output_chain(const ba::Arc_region_2& region, const ba::Arc_region_2::Side& side) {
  const auto bulge = [&](std::size_t i) { return side.bulges[i] == 0 ? 0 : side.bulges[i]; };  // not -0
  if (side.size == 1) return {{region.from, region.to, bulge(0)}};
  return {{region.from, side.joint, bulge(0)}, {side.joint, region.to, bulge(1)}};
}

template <class Tree> class Hierarchy_of final : public Curve_hierarchy {
 public:
  using Traits = typename Tree::Traits;
  using Spiral = typename Tree::Spiral;

  Hierarchy_of(std::vector<Spiral> spirals, double eps, const ba::Build_options& options)
      : eps_(eps), max_regions_(options.max_nodes), tree_(std::move(spirals), eps, options) {}

  [[nodiscard]] Status status() const override { return static_cast<Status>(tree_.status()); }
  [[nodiscard]] double bound() const override { return tree_.bound(); }
  [[nodiscard]] Hierarchy_size size() const override {
    return {tree_.number_of_leaves(), tree_.number_of_arcs(), tree_.number_of_nodes(), tree_.number_of_boxes(),
            tree_.bytes()};
  }

  void for_each_region(const std::function<void(const Output_region&)>& visit) const override {
    for_each_written_leaf([&](const Leaf&, const Output_region& region) { visit(region); });
  }
  void for_each_node(const std::function<void(std::size_t, const Output_region&)>& visit) const override {
    const auto visit_all = [&](const auto& write) {
      for (std::uint32_t i = 0; i < tree_.spirals().size(); ++i)
        tree_.traverse(tree_.segment_root(i), [&](const ba::Node_handle& h) {
          visit(static_cast<std::size_t>(h.level), write(h));
          return true;
        });
    };
    if constexpr (HAS_BATCHES) {
      ba::Region_reader<Tree> reader(tree_);
      visit_all([&](const ba::Node_handle& h) { return written(leaf(h), reader.region(h)); });
    } else {
      visit_all([&](const ba::Node_handle& h) { return written(leaf(h)); });
    }
  }
  void for_each_certified_region(const std::function<void(const Output_region&)>& visit) const override {
    for_each_certified_piece([&](const Leaf& piece, const ba::Certified_arcs_2& certified, bool has_room) {
      if (certified.is_certified && certified.thickness > eps_) throw std::invalid_argument(too_thick(piece, has_room));
      Output_region region = written(piece, certified.region);
      region.widening = certified.widening;
      visit(region);
    });
  }

  void make_arcs() override {
    if constexpr (HAS_OUTLINES) {
      arcs_.clear();
      for_each_leaf([&](const Leaf& node) { arcs_.push_back(outline_of(node).first); });
    } else if constexpr (IS_DOUBLE) {
      ba::make_regions(tree_, arcs_);
    } else {
      arcs_.clear();
      tree_.for_each_leaf([&](const ba::Node_handle& h) { arcs_.push_back(tree_.region(h)); });
    }
  }

  struct Leaf : ba::Region_node {  // or a node above
    double thickness;
  };
  [[nodiscard]] Leaf leaf(const ba::Node_handle& h) const { return {tree_.node(h), tree_.thickness(h)}; }
  template <class Visit> void for_each_leaf(const Visit& visit) const {
    tree_.for_each_leaf([&](const ba::Node_handle& h) { visit(leaf(h)); });
  }
  /// visit(leaf, region as it is written)
  template <class Visit> void for_each_written_leaf(const Visit& visit) const {
    if constexpr (HAS_BATCHES) {
      ba::Region_reader<Tree>(tree_).for_each_leaf([&](const ba::Node_handle& h, const ba::Arc_region_2& region) {
        const Leaf node = leaf(h);
        visit(node, written(node, region));
      });
    } else {
      for_each_leaf([&](const Leaf& node) { visit(node, written(node)); });
    }
  }
  [[nodiscard]] const Spiral& spiral_of(const ba::Region_node& node) const { return tree_.spirals()[node.spiral]; }

  template <class Construction>
  [[nodiscard]] ba::Arc_region_2 arcs_of(const Construction& construction, const ba::Region_node& node) const {
    const Spiral& spiral = spiral_of(node);
    const Xy<double> from = spiral.template point<double>(node.t0), to = spiral.template point<double>(node.t1);
    if constexpr (IS_DOUBLE) return ba::arc_region(construction, spiral, node.t0, node.t1, from, to);
    else return ba::rounded_region(construction, spiral, node.t0, node.t1, from, to);
  }
  [[nodiscard]] Output_region written(const Leaf& node, const ba::Arc_region_2& region) const {
    return {bezier(node),
            node.t0,
            node.t1,
            node.thickness,
            node.t0 == spiral_of(node).first(),
            output_chain(region, region.inner),
            output_chain(region, region.outer)};
  }
  [[nodiscard]] Output_region written(const Leaf& node) const {
    if constexpr (HAS_OUTLINES) {
      const Spiral& spiral = spiral_of(node);
      const Xy<double> from = spiral.template point<double>(node.t0), to = spiral.template point<double>(node.t1);
      const auto [outline, unit] = outline_of(node);
      Output_region region = written(node, ba::Arc_region_2());
      region.inner = output_chain(outline.inner, unit, from, to);
      region.outer = output_chain(outline.outer, unit, from, to);
      return region;
    } else {
      return written(node, arcs_of(tree_.traits().construction(), node));
    }
  }
  /// From the piece's start, and the unit of its lengths.
  [[nodiscard]] auto outline_of(const ba::Region_node& node) const {
    using Construction = typename Traits::Construction;
    auto shape = spiral_of(node).accurate_shape(node.t0, node.t1, ba::shape_parts<Construction>());
    const double unit = std::exchange(shape.unit, 1.0);
    return std::pair(tree_.traits().construction().boundary(shape.at_origin()), unit);
  }
  /// visit(piece, certified region, whether there may be more regions) for all leaves or, where the region that another
  /// one steps back to is thicker than eps, for parts of them
  template <class Visit> void for_each_certified_piece(const Visit& visit) const {
    if constexpr (HAS_OUTLINES) {
      throw std::logic_error("only bca, sfa and bilens have certified regions");
    } else {
      const std::size_t nodes = tree_.number_of_nodes();
      std::size_t room = (max_regions_ - (std::min)(max_regions_, nodes)) / 2;  // for two halves each
      for_each_leaf([&](const Leaf& leaf) {
        ba::for_each_thin_piece(
            leaf.t0, leaf.t1, eps_, room, [&](double t0, double t1) { return certify(leaf, t0, t1); },
            [&](double t0, double t1, const ba::Certified_arcs_2& certified) {
              visit(Leaf{{t0, t1, leaf.spiral, true}, certified.thickness}, certified, room > 0);
            });
      });
    }
  }
  [[nodiscard]] ba::Certified_arcs_2 certify(const Leaf& leaf, double t0, double t1) const {
    const auto& construction = tree_.traits().construction();
    const Spiral& spiral = spiral_of(leaf);
    const bool is_whole = t0 == leaf.t0 && t1 == leaf.t1;
    const double thickness = is_whole ? leaf.thickness : ba::certified_thickness(construction, spiral, t0, t1, eps_);
    const auto arcs = [&](const auto& c) { return arcs_of(c, {t0, t1, leaf.spiral, true}); };
    return ba::certified_arcs(construction, spiral, t0, t1, eps_, thickness, arcs);
  }

  [[nodiscard]] Verification verify(const Progress& progress) const override {
    Verification result;
    for_each_written_leaf([&](const Leaf& node, const Output_region& region) {
      const ba::Region_proof proof =
          ba::verify_region<typename Traits::Construction>(spiral_of(node), node.t0, node.t1, eps_);
      const std::string reason =
          proof.holds() ? thickness_reason(node, region) : containment_reason(node, proof.containment);
      if (reason.empty()) ++result.proven;
      else result.failed.push_back({bezier(node), node.t0, node.t1, reason});
      result.slivers += proof.containment == ba::Containment::PROVEN_AS_SLIVER;
      result.slack = (std::max)(result.slack, proof.slack);
      ++result.regions;
      if (progress) progress(result.regions, tree_.number_of_leaves());
    });
    return result;
  }

  [[nodiscard]] Verification verify_certified(const Progress& progress) const override {
    Verification result;
    for_each_certified_piece([&](const Leaf& piece, const ba::Certified_arcs_2& certified, bool has_room) {
      const std::string reason = certified_reason(piece, certified, has_room);
      if (reason.empty()) {
        ++result.proven;
        result.widening = (std::max)(result.widening, certified.widening);
      } else {
        result.failed.push_back({bezier(piece), piece.t0, piece.t1, reason});
      }
      ++result.regions;
      if (progress) progress((std::min)(result.regions, tree_.number_of_leaves()), tree_.number_of_leaves());
    });
    result.widening_ulps = result.widening / ulp_of_coordinates();
    return result;
  }

 private:
  [[nodiscard]] std::size_t bezier(const ba::Region_node& node) const {
    return tree_.spirals()[node.spiral].place().bezier;
  }
  [[nodiscard]] double ulp_of_coordinates() const {
    double largest = 0;
    for (const Spiral& spiral : tree_.spirals()) largest = (std::max)(largest, spiral.coordinate_size());
    return (std::max)(ba::ulp_of(largest), ba::LEAST_ULP);
  }

  [[nodiscard]] std::string containment_reason(const Leaf& node, ba::Containment containment) const {
    if (containment == ba::Containment::UNDECIDED) return "not decided within 4096 bits";
    const Spiral& spiral = tree_.spirals()[node.spiral];
    const bool at_cut = node.t0 == spiral.first() || node.t1 == spiral.last();
    return at_cut ? "beside a cut whose parameter is rounded the curve leaves the region by more than half of eps"
                  : "the curve leaves the region";
  }
  [[nodiscard]] std::string too_thick(const ba::Region_node& piece, bool has_room) const {
    if (!has_room)
      return "--max-regions: expected as many as certified regions need, found less at eps " + number(eps_);
    return "t in [" + number(piece.t0) + ", " + number(piece.t1) + "]: expected a certified region as thin as eps " +
           number(eps_) + ", found none";
  }
  // Empty where the region as it is written is proven to hold the curve with its widening, and to be thin.
  [[nodiscard]] std::string certified_reason(const Leaf& piece, const ba::Certified_arcs_2& certified,
                                             bool has_room) const {
    if (!certified.is_certified)
      return "no region is proven to hold the curve with a widening of 64 ulp of the coordinates";
    if (certified.thickness > eps_) return too_thick(piece, has_room);
    const Spiral& spiral = spiral_of(piece);
    if (!ba::is_within(spiral, piece.t0, piece.t1, boundary_of(certified.region), certified.widening))
      return "the widened region is not proven to hold the curve";
    if (!has_written_thickness(written(piece, certified.region), spiral.point_error() + certified.widening))
      return "as written its boundaries are not proven to be as near to each other as its thickness tells";
    return "";
  }
  // Empty where the thickness is proven, of the exact region and of the one that is written.
  [[nodiscard]] std::string thickness_reason(const Leaf& node, const Output_region& region) const {
    if (!ba::verify_thickness<typename Traits::Construction>(spiral_of(node), node.t0, node.t1, node.thickness))
      return "its boundaries are not proven to be as near to each other as its thickness tells";
    if (!HAS_OUTLINES && !has_written_thickness(region, spiral_of(node).point_error()))
      return "as written its boundaries are not proven to be as near to each other as its thickness tells";
    return "";
  }

  static constexpr bool IS_DOUBLE = std::is_same_v<typename Traits::FT, double>;
  static constexpr bool HAS_OUTLINES = ba::has_outline_v<typename Traits::Construction>;
  static constexpr bool HAS_BATCHES = IS_DOUBLE && !HAS_OUTLINES;

  double eps_;
  std::size_t max_regions_;
  Tree tree_;
  std::conditional_t<HAS_OUTLINES, std::vector<ba::Region_outline_2<double>>,
                     std::conditional_t<IS_DOUBLE, ba::Region_columns, std::vector<typename Tree::Region>>>
      arcs_;
};

/// Builds the tree of a yardstick, compiled once for all of them.
[[nodiscard]] std::unique_ptr<Curve_hierarchy> build_yardstick(Method method,
                                                               const std::vector<ba::Bezier_spiral_2<double>>& spirals,
                                                               double eps, const ba::Build_options& options);
/// See Segmented_curve.
[[nodiscard]] std::vector<Fitted_order> fitted_orders(Method method,
                                                      const std::vector<ba::Bezier_spiral_2<double>>& spirals);

/// \tparam NT the number type of the curves \tparam Bca_, Sfa_, Bilens_ the traits of the three methods
template <class NT, class Bca_, class Sfa_, class Bilens_> class Segmented_curve_of final : public Segmented_curve {
 public:
  explicit Segmented_curve_of(const Curve_record& record) {
    ba::Drawing_2<NT> drawing;
    drawing.add(record.bezier_pieces<NT>(), record.name);
    number_of_beziers_ = drawing.curves().front().beziers.size();
    spirals_ = ba::spiral_segments(drawing);
  }

  [[nodiscard]] std::size_t number_of_beziers() const override { return number_of_beziers_; }
  [[nodiscard]] std::size_t number_of_spirals() const override { return spirals_.size(); }
  [[nodiscard]] std::unique_ptr<Curve_hierarchy> build(Method method, Split split, double eps, std::size_t max_regions,
                                                       const Progress& progress) const override {
    ba::Build_options options;
    options.nodes = split == Split::OPTIMAL ? ba::Build_options::Nodes::EQUALIZED : ba::Build_options::Nodes::STORED;
    options.max_nodes = max_regions;
    options.progress = progress;
    if (is_yardstick(method)) {
      if constexpr (std::is_same_v<NT, double>) return build_yardstick(method, spirals_, eps, options);
      else
        throw std::invalid_argument(std::string("kernel: expected double for ") + name_of(method) +
                                    ", found another one");
    }
    if (method == Method::BCA) return build<Bca_>(eps, options);
    if (method == Method::SFA) return build<Sfa_>(eps, options);
    return build<Bilens_>(eps, options);
  }
  [[nodiscard]] std::vector<Fitted_order> orders(Method method) const override {
    if constexpr (std::is_same_v<NT, double>) return fitted_orders(method, spirals_);
    else throw std::invalid_argument("kernel: expected double for orders, found another one");
  }

 private:
  template <class Traits>
  [[nodiscard]] std::unique_ptr<Curve_hierarchy> build(double eps, const ba::Build_options& options) const {
    using Tree = ba::Region_hierarchy_2<Traits, ba::Bezier_spiral_2<NT>>;
    return std::make_unique<Hierarchy_of<Tree>>(spirals_, eps, options);
  }

  std::size_t number_of_beziers_ = 0;
  std::vector<ba::Bezier_spiral_2<NT>> spirals_;
};

}  // namespace bounding_arcs_tool::detail

#endif
