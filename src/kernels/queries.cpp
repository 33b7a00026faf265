// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Queries, once for all programs.

#include <CGAL/Bounding_arcs_2/query/internal/Location_impl.h>
#include <CGAL/Bounding_arcs_2/query/internal/closest_point_impl.h>
#include <CGAL/Bounding_arcs_2/query/internal/closest_points_impl.h>
#include <CGAL/Bounding_arcs_2/query/internal/convex_hull_impl.h>
#include <CGAL/Bounding_arcs_2/query/internal/distance_impl.h>
#include <CGAL/Bounding_arcs_2/query/internal/enclosing_circle_impl.h>
#include <CGAL/Bounding_arcs_2/query/internal/hausdorff_distance_impl.h>
#include <CGAL/Bounding_arcs_2/query/internal/intersections_impl.h>
#include <CGAL/Bounding_arcs_2/query/internal/measures_impl.h>
#include <CGAL/Bounding_arcs_2/query/internal/piece_pair_intersections_impl.h>
#include <CGAL/Bounding_arcs_2/query/internal/ray_hits_impl.h>
#include <CGAL/Bounding_arcs_2/query/internal/shapes_impl.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Drawing_hierarchy_impl.h>
