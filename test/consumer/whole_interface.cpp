// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Instantiates the public interface over one number type of each kind, as a user's program might: it is compiled with
// many warnings, and no header of the library may give one.

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/exchange/svg_path.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include <CGAL/Bounding_arcs_2/region/region_bounds.h>
#include <CGAL/Bounding_arcs_2/study/Formula_study.h>
#include <CGAL/Bounding_arcs_2/study/Randomly_rounded.h>
#include <CGAL/Bounding_arcs_2/study/Search_study.h>
#include <CGAL/Bounding_arcs_2/study/Stability_study.h>
#include <CGAL/Bounding_arcs_2/study/Textbook.h>
#include <CGAL/Bounding_arcs_2/study/Worst_case_hunt.h>
#include <CGAL/Bounding_arcs_2/study/boxes_and_hulls.h>
#include <CGAL/Bounding_arcs_2/study/fat_arcs.h>
#include <CGAL/Bounding_arcs_2/study/stability_families.h>
#include <CGAL/Bounding_arcs_2/tree/Region_columns.h>
#include <CGAL/Bounding_arcs_2/tree/Region_reader.h>
#include <CGAL/Bounding_arcs_2/verify/Certified_traits_2.h>
#include <CGAL/Bounding_arcs_2/verify/verify_region.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <vector>

namespace {

using namespace CGAL::Bounding_arcs;

template <class LinearKernel>
using Circular =
    CGAL::Circular_kernel_2<LinearKernel, CGAL::Algebraic_kernel_for_circles_2_2<typename LinearKernel::FT>>;

template <class NT> std::vector<Bezier_spiral_2<NT>> spirals() {
  const Bezier_curve_2<NT> curve({{NT(0), NT(0)}, {NT(1), NT(2)}, {NT(3), NT(-1)}}, {NT(1), NT(2), NT(1)});
  const auto halves = curve.reversed().split(NT(1) / NT(2));
  return spiral_segments(halves.first.subcurve(NT(0), NT(1)));
}

template <class Tree> std::size_t traverse(const Tree& tree) {
  std::size_t count = tree.number_of_boxes() + tree.spirals().size();
  tree.for_each_child(tree.root(), [&](const auto& child) { count += tree.is_leaf(child) ? 1u : 2u; });
  tree.traverse([&](const auto& h) {
    if (h.is_region) static_cast<void>(tree.region(h));
    return tree.box(h).xmin() < 1;
  });
  tree.for_each_leaf([&](const Node_handle& h) {
    const Region_node n = tree.node(h);
    count += n.spiral;
  });
  return count;
}
template <class Tree> std::size_t sizes(const Tree& tree) {
  const bool is_complete = tree.status() == Build_status::COMPLETE && tree.bound() < 1;
  return tree.number_of_leaves() + tree.number_of_nodes() + tree.number_of_arcs() + tree.bytes() +
         tree.decisions().all() + (is_complete ? 1u : 0u);
}

Build_options kind_of_nodes(Build_options::Nodes kind) {
  Build_options options;
  options.nodes = kind;
  return options;
}

template <class Traits, class NT> std::size_t trees() {
  using Spiral = Bezier_spiral_2<NT>;
  Region_hierarchy_2<Traits, Spiral> tree(spirals<NT>(), 1e-2);
  tree.replace(0, 1, {});
  const Region_hierarchy_2<Traits, Spiral> lazy(spirals<NT>(), 1e-2, kind_of_nodes(Build_options::Nodes::LAZY));
  const Region_hierarchy_2<Traits, Spiral> optimal(spirals<NT>(), 1e-2, kind_of_nodes(Build_options::Nodes::EQUALIZED));
  return traverse(tree) + traverse(lazy) + traverse(optimal) + sizes(tree) + sizes(optimal);
}

template <class Traits, class NT> typename Traits::Bounding_region_2 region_of(const Traits& traits) {
  const Bezier_spiral_2<NT> spiral = spirals<NT>().front();
  return traits.construct_bounding_region_2_object()(spiral.template frame<typename Traits::FT>(0, 1));
}
template <class Traits, class NT> std::size_t boundaries() {
  const Traits traits;
  const auto region = region_of<Traits, NT>(traits);
  const auto boundary = traits.construct_boundary_2_object()(region);
  static_cast<void>(traits.compute_thickness_2_object()(region));
  const bool is_thin = traits.compare_thickness_2_object()(region, 1.0) == CGAL::SMALLER;
  return boundary.inner.size() + boundary.outer.size() + (is_thin ? 1u : 0u);
}
template <class Traits, class NT> std::size_t own_boundaries() {
  const Traits traits;
  const auto region = region_of<Traits, NT>(traits);
  const auto boundary = traits.construct_region_boundary_2_object()(region);
  const typename Traits::Kernel::Point_2 origin(0, 0);
  const bool is_inside = traits.bounded_side_2_object()(region, origin) == CGAL::ON_BOUNDED_SIDE;
  const bool is_left = traits.construct_bbox_2_object()(region).xmin() < 0;
  return boundary.inner.size() + (is_inside ? 1u : 0u) + (is_left ? 1u : 0u);
}
template <class Traits, class NT = typename Traits::FT> std::size_t everything() {
  return trees<Traits, NT>() + boundaries<Traits, NT>() + own_boundaries<Traits, NT>();
}

template <class Kernel, class NT = typename Kernel::FT> std::size_t all_methods() {
  return everything<Bca_traits_2<Kernel>, NT>() + everything<Spiral_fat_arc_traits_2<Kernel>, NT>() +
         everything<Bilens_traits_2<Kernel>, NT>();
}

template <class Traits> std::size_t certified() {
  const Certified_traits_2<Traits> traits;
  const auto s = spirals<double>();
  const auto region = traits.construct_certified_region_2_object()(s.front(), s.front().first(), s.front().last());
  std::size_t thin = 0;
  traits.construct_certified_region_2_object()(
      s.front(), s.front().first(), s.front().last(), 1,
      [&](double, double, const auto& part) { thin += part.thickness <= 1 ? 1 : 0; });
  return region.widening > 0 ? thin : 0;
}
struct Chord_length {
  template <class NT> Named_figures<NT> operator()(const Formula_piece<NT>& piece) const {
    const Xy<NT> chord = piece.frame().p1 - piece.frame().p0;
    return {{"length", square_root(dot(chord, chord))}, {"chord", chord}, {"side", Verdict{piece.shape.turn}}};
  }
};
std::size_t studies() {
  Formula_study<Chord_length> study("chord", Chord_length(), random_family(1, 1));
  study.add<float>("float");
  study.add<Randomly_rounded>("random");
  Worst_case_hunt hunt({{"bca"}, {"stable"}, {"double"}, {"thickness"}}, 7);
  hunt.step();
  return study.rows().size() + study.undecided() + hunt.worst().rows().size() +
         (spiral_holding(spirals<double>().front().curve(), 0, 1) ? 1u : 0u);
}
std::size_t proofs() {
  const auto s = spirals<double>().front();
  const auto exact = spirals<CGAL::Exact_rational>().front();
  const bool proven = verify_region<Bca>(s, 0, 1).containment == Containment::PROVEN &&
                      verify_region<Bilens>(s, 0, 1).containment == Containment::PROVEN &&
                      verify_region<Spiral_fat_arc>(exact, 0, 1, 1e-3).containment == Containment::PROVEN;
  return (proven ? 1u : 0u) + stability_rows(s, 0, 1).size() + near_linear_family().size() +
         near_circular_family().size() + subdivision_family().size() + random_family(1, 1).size();
}
std::size_t chains() {
  const Bounding_arc_tree_2 tree(Bezier_curve_2<double>({{0, 0}, {1, 2}, {3, -1}}));
  const Arc_chain chain = arc_chain(tree, 1e-3, {Arc_chain::Continuity::TANGENT, Arc_chain::Side::LEFT});
  const Arc_chain::Arc& arc = chain.arcs.front();
  return chain.arcs.size() + (radius(arc) > 0 && center(arc) != reversed(arc).from ? 1u : 0u);
}

// What descends the tree and is no query; these are in query/test_tree_queries.cpp.
std::size_t offsets_and_axes() {
  Drawing_2<double> drawing;
  drawing.add(Bezier_curve_2<double>({{0, 0}, {4, 4}, {-4, 4}, {0, 0}}), "a drop");
  const Bounding_arc_tree_2 tree(drawing);
  const Offset_source_2 source(tree, 1e-3);
  const Offset grown = source.at(0.1);
  std::size_t count = source.number_of_arcs() + source.at({0.1, 0.2}).size() + source.outline().chains.size() +
                      offset(tree, -0.1, 1e-3).chains.size() + insets(tree, 0.2, 1e-3).size() +
                      Offset_source_2(grown.chains, 1e-3).at(0.1).chains.size() +
                      opening(tree, 0.1, 1e-3).chains.size() + closing(tree, 0.1, 1e-3).chains.size() +
                      offset_bracket(tree, 0.1, 1e-2).inside.chains.size() + svg_path(grown).size();
  if (const auto error = offset_error(tree, grown, 1e-3)) count += error->farthest.upper > 0 ? 1u : 0u;
  Medial_axis_2 axis = medial_axis(tree, 1e-3);
  count += (largest_inscribed_disc(tree, axis) ? 1u : 0u) + (clearance_path(tree, axis, {0, 1}, {0, 2}) ? 1u : 0u) +
           (Maximal_discs_2(tree)({0, 0, 0.25}) ? 1u : 0u) +
           Bisector_2(drawing.curves()[0].beziers[0], tree, 1).sample(0.1).size();
  return count + trimmed(tree, std::move(axis), {0.5, 0}).edges.size() +
         intersections(tree, Bounding_arc_tree_2(line_drawing(tree, {0, 1}, {1, 0}))).points.size() +
         (do_intersect(tree, Bounding_arc_tree_2(ray_drawing(tree, {0, 1}, {1, 0}))) ? 1u : 0u);
}

template <class Construction> std::size_t compared() {
  const auto s = spirals<double>().front();
  const auto outline = Construction::boundary(s.frame<double>(0, 1, shape_parts<Construction>()));
  return (verify_region<Construction>(s, 0, 1).holds() && verify_thickness<Construction>(s, 0, 1, 1) ? 1u : 0u) +
         (bounded_side(outline, Xy<double>{1, 1}) == CGAL::ON_BOUNDED_SIDE ? 1u : 0u) +
         piece_sizes(Construction(), s, 0, 1, 2).size();
}

struct Parabola {
  [[nodiscard]] End_jet_2<double> jet(double t) const { return {{t, t * t}, {1, 2 * t}, {0, 2}}; }
};
template <class Traits> std::size_t own_curve() {
  const std::vector<Jet_spiral_2<Parabola>> jets{Jet_spiral_2<Parabola>({}, 0, 1, 1e-15)};
  return traverse(Region_hierarchy_2<Traits, Jet_spiral_2<Parabola>>(jets, 1e-3));
}
std::size_t b_splines() {
  const B_spline_curve_2<double> clamped(2, {{0, 0}, {1, 1}, {2, 0}, {3, 1}}, {0, 0, 0, 1, 2, 2, 2});
  return clamped.bezier_pieces().size();
}
std::size_t files() {
  const std::vector<Curve_record> records = read_curve_file("-").curves;
  return drawing<CGAL::Exact_rational>(records).curves().size() + read_drawing("-").curves().size();
}

std::size_t ask(const Arc_region_2& region) {
  const Xy<double> q{0.1, 0.2};
  const Arc_2 arc = arc_of(region, region.outer, 0);
  const bool is_near = squared_distance(q, arc) < 1 && length(arc) < 1 && curvature(arc) < 1 && box(arc).xmin() < 1 &&
                       point(arc, 0.5) != nearest_point(q, arc) && tangent(arc, 0) != normal(arc, 1) &&
                       tangent_at(q, arc) != normal_at(q, arc);
  const bool is_bounded = distance_bounds(q, region).lower < 1 && !are_apart(region, region) && thickness(region) < 1;
  return (is_near ? 1u : 0u) + (is_bounded && tangent_cone(region) && box(region).xmin() < 1 ? 1u : 0u);
}
template <class Traits> std::size_t regions_in_hand() {
  const Region_hierarchy_2<Traits, Bezier_spiral_2<double>> tree(spirals<double>(), 1e-2);
  Region_columns columns;
  make_regions(tree, columns);
  Region_reader reader(tree);
  std::size_t count = columns.number_of_regions() + ask(columns.region(0)) + ask(reader.region(tree.segment_root(0)));
  reader.for_each_child(tree.segment_root(0),
                        [&](const Node_handle&, const Arc_region_2& r) { count += r.inner.size; });
  reader.for_each_leaf([&](const Node_handle& h, const Arc_region_2&) { count += columns.row_of(tree.node(h)); });
  return count;
}
template <class Kernel> std::size_t certified_methods() {
  return certified<Bca_traits_2<Kernel>>() + certified<Spiral_fat_arc_traits_2<Kernel>>() +
         certified<Bilens_traits_2<Kernel>>();
}
std::size_t over_doubles() {
  using Double = Circular<CGAL::Simple_cartesian<double>>;
#ifdef CGAL_LINKED_WITH_TBB
  using Parallel_tree = Region_hierarchy_2<Bca_traits_2<Double>, Bezier_spiral_2<double>>;
  static_cast<void>(traverse(Parallel_tree(spirals<double>(), 1e-3, {}, Bca_traits_2<Double>(), CGAL::Parallel_tag())));
#endif
  return all_methods<Double>() + certified_methods<Double>() + regions_in_hand<Bca_traits_2<Double>>() +
         regions_in_hand<Bilens_traits_2<Double>>() + own_curve<Bca_traits_2<Double>>() +
         own_curve<Bilens_traits_2<Double>>() + everything<Bca_traits_2<Double, Near_linear_to_chord>>() +
         everything<Spiral_fat_arc_traits_2<Double, Near_circular_to_bca<Spiral_fat_arc>>>();
}
std::size_t over_other_floating_numbers() {
  using Filtered = Circular<CGAL::Exact_predicates_inexact_constructions_kernel>;
  using Float = Circular<CGAL::Simple_cartesian<float>>;
  using Long = Circular<CGAL::Simple_cartesian<long double>>;
  return all_methods<Filtered>() + everything<Bca_traits_2<Filtered>, CGAL::Exact_rational>() +
         certified_methods<Filtered>() + all_methods<Float>() + all_methods<Long>();
}
std::size_t over_exact_numbers() {
  using Rational = Circular<CGAL::Simple_cartesian<CGAL::Exact_rational>>;
  using Lazy = Circular<CGAL::Exact_predicates_exact_constructions_kernel>;
  using Roots = Circular<CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt>;
  return everything<Bca_traits_2<Rational>>() + everything<Bca_traits_2<Lazy>, double>() +
         trees<Spiral_fat_arc_traits_2<Rational>, double>() + boundaries<Spiral_fat_arc_traits_2<Rational>, double>() +
         boundaries<Spiral_fat_arc_traits_2<Lazy>, double>() + all_methods<Roots, double>() +
         trees<Bca_traits_2<Roots>, CORE::Expr>();
}

}  // namespace

int main() {
  const std::size_t count = over_doubles() + over_other_floating_numbers() + over_exact_numbers() + studies() +
                            proofs() + compared<Fat_biarc>() + compared<Control_hull>() + chains() +
                            offsets_and_axes() + b_splines() + files();
  return count > 0 ? 0 : 1;
}
