// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything at once: curves, spiral segments, bounding regions over Circular_kernel_2, the hierarchy, and all
// that descends it: queries, chains of arcs, overlays, Boolean operations, offsets, medial axes.

#ifndef CGAL_BOUNDING_ARCS_2_H
#define CGAL_BOUNDING_ARCS_2_H

#if __cplusplus < 201703L && !(defined(_MSVC_LANG) && _MSVC_LANG >= 201703L)
#error "Bounding Arcs needs C++17: compile with -std=c++17, or with CMake's target_link_libraries, which says so"
#else

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/boolean/clip.h>
#include <CGAL/Bounding_arcs_2/chain/arc_chain.h>
#include <CGAL/Bounding_arcs_2/chain/arc_chain_of_regions.h>
#include <CGAL/Bounding_arcs_2/curve/B_spline_curve_2.h>
#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/curve/join_curves.h>
#include <CGAL/Bounding_arcs_2/medial_axis/axis_branches.h>
#include <CGAL/Bounding_arcs_2/medial_axis/axis_conics.h>
#include <CGAL/Bounding_arcs_2/medial_axis/bisector.h>
#include <CGAL/Bounding_arcs_2/medial_axis/local_thickness.h>
#include <CGAL/Bounding_arcs_2/medial_axis/maximal_disc.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/medial_axis/pruned.h>
#include <CGAL/Bounding_arcs_2/medial_axis/thin_places.h>
#include <CGAL/Bounding_arcs_2/medial_axis/voronoi_cells.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>
#include <CGAL/Bounding_arcs_2/offset/offset_bracket.h>
#include <CGAL/Bounding_arcs_2/offset/offset_series.h>
#include <CGAL/Bounding_arcs_2/overlay/overlay.h>
#include <CGAL/Bounding_arcs_2/query/closest_on_regions.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/convex_hull.h>
#include <CGAL/Bounding_arcs_2/query/distance.h>
#include <CGAL/Bounding_arcs_2/query/enclosing_circle.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>
#include <CGAL/Bounding_arcs_2/query/ray_hits.h>
#include <CGAL/Bounding_arcs_2/query/shapes.h>
#include <CGAL/Bounding_arcs_2/query/signed_distance.h>
#include <CGAL/Bounding_arcs_2/region/Bca_traits_2.h>
#include <CGAL/Bounding_arcs_2/region/Bilens_traits_2.h>
#include <CGAL/Bounding_arcs_2/region/Fallbacks.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc_traits_2.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/spiral/Jet_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include <CGAL/Bounding_arcs_2/tree/Region_hierarchy_2.h>

#endif

#endif
