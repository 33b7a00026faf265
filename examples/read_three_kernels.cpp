// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same program on three kernels, double, filtered and exact: as many regions, whose cuts, ends and centers are some
// roundings apart. What the filtered kernel adds is not seen in numbers: it decides each cut as the exact one would.

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

using namespace CGAL::Bounding_arcs;
using Exact = CGAL::Exact_rational;

struct Arc_of_region {
  double cut;  // the parameter where its leaf ends
  Xy<Exact> end, center;
};

template <class FT> Xy<Exact> exact(const Xy<FT>& p) { return {Exact(p.x), Exact(p.y)}; }
double length(const Xy<Exact>& v) { return std::hypot(CGAL::to_double(v.x), CGAL::to_double(v.y)); }

template <class Linear_kernel> std::vector<Arc_of_region> arcs_of_regions(const std::vector<Curve_record>& records) {
  using FT = typename Linear_kernel::FT;
  using Traits = Bca_traits_2<CGAL::Circular_kernel_2<Linear_kernel, CGAL::Algebraic_kernel_for_circles_2_2<FT>>>;
  const Region_hierarchy_2<Traits> regions(Bounding_arc_tree_2(drawing<FT>(records)), 1e-3);
  std::vector<Arc_of_region> arcs;
  regions.for_each_leaf([&](const Node_handle& leaf) {
    const auto boundary = regions.traits().construct_region_boundary_2_object()(regions.region(leaf));
    for (const auto& arc : {boundary.inner[0], boundary.outer[0]})
      if (!arc.is_segment()) arcs.push_back({regions.node(leaf).t1, exact(arc.to), exact(arc.support.center())});
  });
  return arcs;
}

int main() {
  const auto records = read_curve_file(BOUNDING_ARCS_EXAMPLE_DATA "/d_rabbit.json").curves;
  const auto right = arcs_of_regions<CGAL::Simple_cartesian<Exact>>(records);
  std::printf("exact: %zu arcs\n", right.size());
  const auto compare = [&](const char* kernel, const std::vector<Arc_of_region>& arcs) {
    double cuts = 0, ends = 0, centers = 0;
    for (std::size_t i = 0; i < (std::min)(arcs.size(), right.size()); ++i) {
      cuts = (std::max)(cuts, std::fabs(arcs[i].cut - right[i].cut));
      ends = (std::max)(ends, length(arcs[i].end - right[i].end));
      centers = (std::max)(centers, length(arcs[i].center - right[i].center) / length(right[i].center - right[i].end));
    }
    std::printf("%s: %zu arcs; cuts within 2^%d, ends within 2^%d, centers within 2^%d radii\n", kernel, arcs.size(),
                std::ilogb(cuts) + 1, std::ilogb(ends) + 1, std::ilogb(centers) + 1);
  };
  compare("double", arcs_of_regions<CGAL::Simple_cartesian<double>>(records));
  compare("filtered", arcs_of_regions<CGAL::Epick>(records));
}
