// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Queries, once for all programs.

#include <CGAL/Bounding_arcs_2/internal/query/Location_impl.h>
#include <CGAL/Bounding_arcs_2/internal/query/closest_point_impl.h>
#include <CGAL/Bounding_arcs_2/internal/query/closest_points_impl.h>
#include <CGAL/Bounding_arcs_2/internal/query/convex_hull_impl.h>
#include <CGAL/Bounding_arcs_2/internal/query/distance_impl.h>
#include <CGAL/Bounding_arcs_2/internal/query/enclosing_circle_impl.h>
#include <CGAL/Bounding_arcs_2/internal/query/hausdorff_distance_impl.h>
#include <CGAL/Bounding_arcs_2/internal/query/intersections_impl.h>
#include <CGAL/Bounding_arcs_2/internal/query/measures_impl.h>
#include <CGAL/Bounding_arcs_2/internal/query/piece_pair_intersections_impl.h>
#include <CGAL/Bounding_arcs_2/internal/query/ray_hits_impl.h>
#include <CGAL/Bounding_arcs_2/internal/query/shapes_impl.h>
#include <CGAL/Bounding_arcs_2/internal/tree/Drawing_hierarchy_impl.h>
